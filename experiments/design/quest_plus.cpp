// SPDX-License-Identifier: MIT
#include "experiments/design/quest_plus.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline design {
namespace {

/// −p ln p, which at 0 is 0.
double entropy_term(double p) { return p > 0.0 ? -p * log_of(p) : 0.0; }

double entropy_of_answer(double chance) {
  return entropy_term(chance) + entropy_term(1.0 - chance);
}

}  // namespace

PsychometricTable::PsychometricTable(QuestPlus::Function function, QuestPlus::Scale scale,
                                     const std::vector<double>& places,
                                     std::vector<PsychometricParameters> candidates)
    : candidates_(std::move(candidates)) {
  chances_.reserve(places.size() * candidates_.size());
  entropies_.reserve(places.size() * candidates_.size());
  for (const double place : places) {
    for (const PsychometricParameters& candidate : candidates_) {
      chances_.push_back(positive_chance(function, scale, place, candidate));
      entropies_.push_back(entropy_of_answer(chances_.back()));
    }
  }
}

std::vector<PsychometricParameters> candidates_of(const QuestPlus& method) {
  std::vector<PsychometricParameters> candidates;
  for (const double threshold : method.thresholds) {
    for (const double slope : method.slopes) {
      for (const double guess_rate : method.guess_rates) {
        for (const double lapse_rate : method.lapse_rates) {
          candidates.push_back({threshold, slope, guess_rate, lapse_rate});
        }
      }
    }
  }
  return candidates;
}

std::shared_ptr<const PsychometricTable> table_of(const QuestPlus& method,
                                                  const std::vector<double>& levels) {
  std::vector<double> places;
  places.reserve(levels.size());
  for (const double level : levels) {
    places.push_back(on_scale(method.scale, level));
  }
  return std::make_shared<const PsychometricTable>(method.function, method.scale, places,
                                                   candidates_of(method));
}

QuestPlusTrack::QuestPlusTrack(std::shared_ptr<const PsychometricTable> table)
    : table_(std::move(table)),
      posterior_(table_->candidates().size(),
                 1.0 / static_cast<double>(table_->candidates().size())) {}

double QuestPlusTrack::information(std::size_t level) const {
  const double* chances = table_->chances(level);
  const double* entropies = table_->entropies(level);
  double positive = 0.0;
  double known = 0.0;
  for (std::size_t i = 0; i < posterior_.size(); ++i) {
    positive += posterior_[i] * chances[i];
    known += posterior_[i] * entropies[i];
  }
  return entropy_of_answer(positive) - known;
}

std::size_t QuestPlusTrack::level() const {
  std::size_t best = 0;
  double most = information(0);
  for (std::size_t level = 1; level < table_->level_count(); ++level) {
    const double here = information(level);
    if (here > most) {
      best = level;
      most = here;
    }
  }
  return best;
}

void QuestPlusTrack::answer(std::size_t level, bool positive) {
  const double* chances = table_->chances(level);
  std::vector<double> updated(posterior_.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < posterior_.size(); ++i) {
    updated[i] = posterior_[i] * (positive ? chances[i] : 1.0 - chances[i]);
    sum += updated[i];
  }
  if (!(sum > 0.0)) {
    return;
  }
  for (double& probability : updated) {
    probability /= sum;
  }
  posterior_ = std::move(updated);
}

PsychometricParameters QuestPlusTrack::mean() const {
  PsychometricParameters mean{0.0, 0.0, 0.0, 0.0};
  const std::vector<PsychometricParameters>& candidates = table_->candidates();
  for (std::size_t i = 0; i < posterior_.size(); ++i) {
    mean.threshold += posterior_[i] * candidates[i].threshold;
    mean.slope += posterior_[i] * candidates[i].slope;
    mean.guess_rate += posterior_[i] * candidates[i].guess_rate;
    mean.lapse_rate += posterior_[i] * candidates[i].lapse_rate;
  }
  return mean;
}

PsychometricParameters QuestPlusTrack::mode() const {
  const auto greatest = std::max_element(posterior_.begin(), posterior_.end());
  return table_->candidates()[static_cast<std::size_t>(greatest - posterior_.begin())];
}

double QuestPlusTrack::threshold_sd() const {
  const double mean_threshold = mean().threshold;
  double variance = 0.0;
  for (std::size_t i = 0; i < posterior_.size(); ++i) {
    const double apart = table_->candidates()[i].threshold - mean_threshold;
    variance += posterior_[i] * apart * apart;
  }
  return std::sqrt(variance);
}

double QuestPlusTrack::entropy() const {
  double entropy = 0.0;
  for (const double probability : posterior_) {
    entropy += entropy_term(probability);
  }
  return entropy;
}

std::vector<FactorLevel> QuestPlusTrack::state() const {
  const PsychometricParameters estimate = mean();
  return {{"threshold", estimate.threshold},   {"threshold_sd", threshold_sd()},
          {"slope", estimate.slope},           {"guess_rate", estimate.guess_rate},
          {"lapse_rate", estimate.lapse_rate}, {"entropy", entropy()}};
}

}  // namespace impetus::inline design
