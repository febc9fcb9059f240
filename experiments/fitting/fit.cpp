// SPDX-License-Identifier: MIT
#include "experiments/fitting/fit.hpp"

#include <algorithm>
#include <cmath>

#include "engine/numerics/random_stream.hpp"
#include "experiments/fitting/minimum.hpp"
#include "experiments/fitting/profiles.hpp"

namespace impetus::inline fitting {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFirstTolerance = 1e-3;  ///< of starts, in the logarithm
constexpr double kTolerance = 1e-5;
constexpr int kMostBetters = 5;  ///< times that a profile may send the search back

constexpr const char* kNotIdentified = "the study does not identify it";

/// One end of an interval, on the scale; none: the profile is open.
using IntervalEnd = std::optional<double>;

/// A fit in progress: which parameters are free, and where they are.
class Fitting {
 public:
  Fitting(const ObserverKind& kind, const RatingParameters& start,
          const std::vector<AnsweringPerson>& people, const FitWish& wish)
      : likelihood_(kind, start, people, wish.as_group), wish_(wish) {
    for (const MovableParameter& one : likelihood_.movable()) {
      assumed_.push_back(*one.place);
      held_because_.emplace_back();
    }
    low_.assign(assumed_.size(), {});
    high_.assign(assumed_.size(), {});
  }

  ObserverFit run() {
    hold_what_is_not_asked();
    list_free();
    search_from_starts();
    while (wish_.intervals && !free_.empty()) {
      if (find_intervals()) {
        search_again();  // a profile found a better place
        continue;
      }
      const std::optional<std::size_t> open = last_open();
      if (!open) {
        break;
      }
      hold(*open, kNotIdentified);
      list_free();
      search_from_starts();
    }
    return result();
  }

 private:
  // ---- parameters as numbers on their scales

  void put(const VectorXd& x) {
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const MovableParameter& one = movable(i);
      *one.place = one.from_scale(x[static_cast<Index>(i)]);
    }
  }
  [[nodiscard]] const MovableParameter& movable(std::size_t free) const {
    return likelihood_.movable()[free_[free]];
  }
  /// Beyond reach it is that of the end, and rises, so that a search has a slope to come back by.
  [[nodiscard]] double cost(const VectorXd& x) {
    VectorXd within = x;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const double reach = movable(i).reach();
      double& one = within[static_cast<Index>(i)];
      one = std::clamp(one, -reach, reach);
    }
    put(within);
    return -likelihood_.logarithm() + (x - within).squaredNorm();
  }
  [[nodiscard]] SmoothFunction cost_function() {
    return [this](const VectorXd& x) { return cost(x); };
  }
  [[nodiscard]] VectorXd assumed() const {
    VectorXd x(static_cast<Index>(free_.size()));
    for (std::size_t i = 0; i < free_.size(); ++i) {
      x[static_cast<Index>(i)] = movable(i).on_scale(assumed_[free_[i]]);
    }
    return x;
  }

  void hold(std::size_t parameter, const std::string& why) {
    held_because_[parameter] = why;
    *likelihood_.movable()[parameter].place = assumed_[parameter];
  }
  void list_free() {
    free_.clear();
    for (std::size_t i = 0; i < assumed_.size(); ++i) {
      if (held_because_[i].empty()) {
        free_.push_back(i);
      }
    }
  }

  // ---- 1: what no answer depends on

  void hold_what_is_not_asked() {
    constexpr double kNothing = 1e-7;
    for (std::size_t i = 0; i < assumed_.size(); ++i) {
      // Anew each time: a person's most probable traits, once they have moved, come back a little
      // elsewhere.
      const double as_assumed = likelihood_.logarithm();
      const MovableParameter& one = likelihood_.movable()[i];
      const double x = one.on_scale(assumed_[i]);
      bool depends = false;
      for (const double by : {-1.0, -0.3, 0.4, 1.5}) {
        *one.place = one.from_scale(x + by);
        const double there = likelihood_.logarithm();
        depends = depends || (std::isfinite(there) && std::abs(there - as_assumed) > kNothing);
      }
      *one.place = assumed_[i];
      if (!depends) {
        hold(i, kNotAsked);
        likelihood_.forget_trait(one.name);
      }
    }
  }

  // ---- 2: the most probable

  void search_from_starts() {
    RandomStream stream(1, "fit/starts");
    const VectorXd first = assumed();
    best_ = find_minimum(cost_function(), first, kFirstTolerance);
    for (int start = 1; start < wish_.starts; ++start) {
      VectorXd x = first;
      for (Index i = 0; i < x.size(); ++i) {
        x[i] += 2.0 * stream.uniform() - 1.0;
      }
      if (!std::isfinite(cost(x))) {
        continue;
      }
      const FoundMinimum found = find_minimum(cost_function(), x, kFirstTolerance);
      if (found.value < best_.value - kFirstTolerance) {
        best_ = found;
      }
    }
    search_again();
  }

  void search_again() {
    best_ = find_minimum(cost_function(), best_.at, kTolerance,
                         inverse_of_curvature(curvature_at(cost_function(), best_.at)));
    if (wish_.intervals) {
      inverse_ = inverse_of_curvature(curvature_at(cost_function(), best_.at));
    }
  }

  // ---- 3: intervals

  /// Never less than before: where something is held the intervals begin anew.
  void tell(double share_of_intervals) {
    constexpr double kOfSearch = 0.2;
    told_ = std::max(told_, kOfSearch + (1.0 - kOfSearch) * share_of_intervals);
    if (wish_.progress) {
      wish_.progress(told_);
    }
  }

  [[nodiscard]] Profiles profiles_of_best() {
    std::vector<ProfiledParameter> parameters;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const MovableParameter& one = movable(i);
      const bool is_share = one.scale == MovableParameter::Scale::kShare;
      parameters.push_back(
          {one.reach(), one.ends_at_zero || is_share, is_share, one.name.starts_with("cut_")});
    }
    return {cost_function(), assumed(), best_, inverse_, std::move(parameters)};
  }

  [[nodiscard]] bool is_wanted(std::size_t free) const {
    return wish_.only.empty() ||
           std::find(wish_.only.begin(), wish_.only.end(), movable(free).name) != wish_.only.end();
  }

  /// True when a profile came upon a better place, which is the best from now on.
  bool find_intervals() {
    Profiles profiles = profiles_of_best();
    for (std::size_t i = 0; i < free_.size(); ++i) {
      tell(static_cast<double>(i) / static_cast<double>(free_.size()));
      if (!is_wanted(i)) {
        continue;
      }
      low_[free_[i]] = profiles.end(i, -1.0);
      if (!profiles.better()) {
        high_[free_[i]] = profiles.end(i, 1.0);
      }
      if (profiles.better() && ++betters_ <= kMostBetters) {
        best_ = *profiles.better();
        return true;
      }
      if (is_open(i)) {
        return false;  // what follows would be given a number that is no part of the fit
      }
    }
    return false;
  }

  /// Whether there is no interval: it has no end, but where the scale itself ends.
  [[nodiscard]] bool is_open(std::size_t free) const {
    const MovableParameter& one = movable(free);
    const bool has_low = low_[free_[free]].has_value();
    const bool has_high = high_[free_[free]].has_value();
    const bool may_be_one = one.scale == MovableParameter::Scale::kShare;
    return is_wanted(free) && ((!has_low && !one.ends_at_zero) || (!has_high && !may_be_one) ||
                               (!has_low && !has_high));
  }

  /// The last in the list, which is the least telling: what it can be traded against comes before.
  [[nodiscard]] std::optional<std::size_t> last_open() {
    Profiles profiles = profiles_of_best();
    std::optional<std::size_t> open;
    bool found = false;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (!is_wanted(i)) {
        continue;
      }
      if (!found) {
        found = is_open(i);
        open = found ? std::optional(free_[i]) : open;
        continue;
      }
      low_[free_[i]] = profiles.end(i, -1.0);
      high_[free_[i]] = profiles.end(i, 1.0);
      open = is_open(i) ? free_[i] : open;
    }
    return open;
  }

  // ---- what came of it

  ObserverFit result() {
    put(best_.at);
    ObserverFit fit;
    fit.logarithm = likelihood_.logarithm();
    for (std::size_t i = 0; i < assumed_.size(); ++i) {
      const MovableParameter& one = likelihood_.movable()[i];
      FittedParameter& told = fit.parameters.emplace_back();
      const double value = std::max(*one.place, one.least);
      told = {one.name, value, value, value, held_because_[i], assumed_[i]};
      *one.place = value;
      if (told.is_fitted() && (low_[i] || high_[i])) {
        told.low = low_[i] ? one.from_scale(*low_[i]) : 0.0;
        told.high = high_[i] ? one.from_scale(*high_[i]) : 1.0;
      }
    }
    fit.best = likelihood_.copy();
    return fit;
  }

  AnswerLikelihood likelihood_;
  FitWish wish_;
  std::vector<double> assumed_;
  std::vector<std::string> held_because_;
  std::vector<std::size_t> free_;  ///< of movable()
  std::vector<IntervalEnd> low_;
  std::vector<IntervalEnd> high_;
  FoundMinimum best_;
  MatrixXd inverse_;
  int betters_{0};
  double told_{0.0};
};

/// Whether two trials have the same answers.
bool answers_alike(const AnsweredTrial& a, const AnsweredTrial& b) {
  return a.rating_steps == b.rating_steps && a.yes == b.yes && a.first == b.first &&
         a.mark == b.mark && a.clicks_s.has_value() == b.clicks_s.has_value() &&
         (!a.clicks_s || a.clicks_s->size() == b.clicks_s->size());
}

}  // namespace

const FittedParameter* ObserverFit::find(const std::string& name) const {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const FittedParameter& one) { return one.name == name; });
  return found == parameters.end() ? nullptr : &*found;
}

std::size_t ObserverFit::count() const {
  return static_cast<std::size_t>(
      std::count_if(parameters.begin(), parameters.end(),
                    [](const FittedParameter& one) { return one.is_fitted(); }));
}

ObserverFit fit_observer(const ObserverKind& kind, const RatingParameters& start,
                         const std::vector<AnsweringPerson>& people, const FitWish& wish) {
  return Fitting(kind, start, people, wish).run();
}

std::optional<std::string> missing_for_fit(const ObserverKind& kind,
                                           const std::vector<AnsweringPerson>& people) {
  const AnsweredTrial* first = nullptr;
  bool answers_differ = false;
  bool percepts_differ = false;
  for (const AnsweringPerson& person : people) {
    for (const AnsweredTrial& trial : person.trials) {
      first = first == nullptr ? &trial : first;
      answers_differ = answers_differ || !answers_alike(trial, *first);
      percepts_differ = percepts_differ || trial.percepts != first->percepts ||
                        trial.percepts.front() != trial.percepts.back();
    }
  }
  const std::string count = std::to_string(trials_of(people)) + " trials";
  if (first == nullptr) {
    return std::string(
               "completed trials with answers that such a participant gives and that can ") +
           "be fitted (a rating, yes or no, a choice of two intervals" +
           (kind.answers.mark != nullptr ? ", a mark on a line" : "") +
           (kind.answers.outcomes != nullptr ? ", clicks" : "") + "), got none";
  }
  if (!percepts_differ) {
    return "trials that differ in what the observer looks at (" + kind.attention.words + "), got " +
           count + " in which it is the same";
  }
  if (!answers_differ) {
    return "answers that differ, got " + count + " with the same one";
  }
  return std::nullopt;
}

}  // namespace impetus::inline fitting
