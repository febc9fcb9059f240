// SPDX-License-Identifier: MIT
#include "experiments/fitting/likelihood.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>

#include "experiments/fitting/trait_integral.hpp"
#include "experiments/observers/side_by_side.hpp"

namespace impetus::inline fitting {
namespace {

using Eigen::VectorXd;

constexpr double kImpossible = -std::numeric_limits<double>::infinity();
constexpr double kLeastChance = 1e-300;

/// The logarithm of a product of many chances, for few logarithms.
class LogarithmOfProduct {
 public:
  void take(double chance, double count) {
    constexpr double kSmall = 1e-60;  // three such, and a product as small as it may get, are > 0
    if (count > 3.0 || !(chance > kSmall)) {
      sum_ += count * std::log(std::max(chance, kLeastChance));
      return;
    }
    for (double left = count; left > 0.0; left -= 1.0) {
      product_ *= chance;
    }
    if (product_ < kSmall) {
      sum_ += std::log(product_);
      product_ = 1.0;
    }
  }
  [[nodiscard]] double logarithm() const { return sum_ + std::log(product_); }

 private:
  double sum_{0.0};
  double product_{1.0};
};

/// `own` with other traits where these differ.
Traits with(const std::vector<TraitSpread>& differing, Traits own, const VectorXd& z) {
  for (std::size_t i = 0; i < differing.size(); ++i) {
    own.*differing[i].trait = z[static_cast<Eigen::Index>(i)];
  }
  return own;
}

/// True when so many more like one that took so long are worth threads, which a tenth of a
/// millisecond brings to life.
bool takes_long(std::chrono::duration<double, std::milli> one, std::size_t more) {
  constexpr double kWorthThreads_ms = 0.5;
  return one.count() * static_cast<double>(more) > kWorthThreads_ms;
}

}  // namespace

// ---------------------------------------------------------------- what may be moved

double MovableParameter::on_scale(double value) const {
  const double smallest = from_scale(-reach());
  switch (scale) {
    case Scale::kLog:
      return std::log(std::max(value, smallest) / unit);
    case Scale::kShare: {
      const double share = std::clamp(value, smallest, 1.0 - smallest);
      return std::log(share / (1.0 - share));
    }
    default:
      return value / unit;
  }
}

double MovableParameter::from_scale(double x) const {
  switch (scale) {
    case Scale::kLog:
      return unit * std::exp(x);
    case Scale::kShare:
      return 1.0 / (1.0 + std::exp(-x));
    default:
      return unit * x;
  }
}

AnswerLikelihood::AnswerLikelihood(const ObserverKind& kind, const RatingParameters& start,
                                   const std::vector<AnsweringPerson>& people, bool as_group)
    : model_(&kind.answers), parameters_(model_->copy(start)) {
  for (const AnsweringPerson& person : people) {
    Person& own = people_.emplace_back();
    for (const AnsweredTrial& trial : person.trials) {
      const auto same = std::find_if(own.cells.begin(), own.cells.end(),
                                     [&](const Cell& cell) { return *cell.trial == trial; });
      if (same != own.cells.end()) {
        same->count += 1.0;
      } else {
        own.cells.push_back({&trial, 1.0, {}});
      }
    }
  }
  list_spreads(as_group);
  list_movable();
}

void AnswerLikelihood::list_spreads(bool as_group) {
  for (const ParameterEntry& entry : model_->entries(*parameters_)) {
    for (const TraitSpread& spread : model_->spreads) {
      if (entry.name == std::string(spread.parameter) && *entry.place > 0.0) {
        if (as_group) {
          spreads_.push_back(spread);
        } else {
          *entry.place = 0.0;
        }
      }
    }
  }
  tell_thresholds_apart();
}

void AnswerLikelihood::tell_thresholds_apart() {
  judged_by_.reset();
  smooth_ = spreads_;
  threshold_differs_ =
      model_->outcomes == nullptr && std::erase_if(smooth_, [](const TraitSpread& one) {
                                       return one.trait == &Traits::threshold;
                                     }) > 0;
}

void AnswerLikelihood::forget_trait(const std::string& spread) {
  std::erase_if(spreads_, [&](const TraitSpread& one) { return spread == one.parameter; });
  tell_thresholds_apart();
}

void AnswerLikelihood::list_movable() {
  const std::vector<ParameterEntry> entries = model_->entries(*parameters_);
  const auto add = [&](const std::string& name) {
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&](const ParameterEntry& one) { return one.name == name; });
    const bool known = std::any_of(movable_.begin(), movable_.end(),
                                   [&](const MovableParameter& one) { return one.name == name; });
    if (entry == entries.end() || known) {
      return;
    }
    using Scale = MovableParameter::Scale;
    const double value = *entry->place;
    if (name == "effect" && value == 0.0) {
      return;  // who is said to go by nothing is fitted as such
    }
    if (entry->minimum == 0.0 && entry->maximum == 1.0) {
      movable_.push_back({name, entry->place, Scale::kShare, 1.0, true, 0.0});
    } else if (entry->minimum >= 0.0) {
      const double unit = value > 0.0 ? value : 1.0;
      const bool is_width = name.find("width") != std::string::npos;
      movable_.push_back({name, entry->place, Scale::kLog, unit, is_width || entry->minimum == 0.0,
                          entry->minimum});
    } else {
      const double unit = name == "effect" ? 1.0 : std::max(0.25 * std::abs(value), 1e-3);
      movable_.push_back({name, entry->place, Scale::kLinear, unit, false, entry->minimum});
    }
  };
  for (const std::string& name : model_->fitted) {
    add(name);
  }
  if (!parameters_->cuts.empty()) {
    add("effect");
    for (std::size_t cut = 0; cut < parameters_->cuts.size(); ++cut) {
      movable_.push_back({"cut_" + std::to_string(cut + 1) + "_" + std::to_string(cut + 2),
                          &parameters_->cuts[cut], MovableParameter::Scale::kLinear, 1.0, false,
                          -kAny});
    }
    add("lapse_rate");
  }
  for (const TraitSpread& spread : spreads_) {
    add(spread.parameter);
  }
}

bool AnswerLikelihood::can_be() const {
  const RatingParameters& own = *parameters_;
  const bool rising = std::adjacent_find(own.cuts.begin(), own.cuts.end(),
                                         std::greater_equal<>()) == own.cuts.end();
  double blind = 0.0;
  for (const MovableParameter& one : movable_) {
    const bool is_rate = one.name == "guess_rate" || one.name == "miss_rate" ||
                         (one.name == "lapse_rate" && own.cuts.empty());
    blind += is_rate ? *one.place : 0.0;
  }
  return rising && blind < 1.0;
}

// ---------------------------------------------------------------- one trial

/// Of all that was shown, as Judge::clearest(); where chance does not decide it.
double AnswerLikelihood::clearest(const AnsweredTrial& trial, const Traits& traits) const {
  double clearest = 0.0;
  for (const Percept& percept : trial.percepts) {
    clearest = std::max(clearest, model_->seen(*parameters_, traits, percept));
  }
  return clearest;
}

/// What may have been seen, and the logarithm of the probability of the clicks.
double AnswerLikelihood::look(const AnsweredTrial& trial, const Traits& traits,
                              std::vector<Outcome>& outcomes) const {
  if (model_->outcomes != nullptr) {
    return model_->outcomes(*parameters_, trial.percepts.front(),
                            trial.clicks_s ? &*trial.clicks_s : nullptr, outcomes);
  }
  outcomes.assign(1, {1.0, clearest(trial, traits)});
  return 0.0;
}

/// Of the answers that are no rating, where so much was seen.
double AnswerLikelihood::unrated_chance(const AnsweredTrial& trial, double seen) const {
  double chance = 1.0;
  if (trial.yes) {
    const double yes = yes_chance(*parameters_, seen);
    chance *= *trial.yes ? yes : 1.0 - yes;
  }
  if (trial.mark) {
    chance *= model_->mark(*parameters_, seen, *trial.mark);
  }
  return chance;
}

/// Of the choice of an interval; 1: none was asked for.
double AnswerLikelihood::choice_chance(const AnsweredTrial& trial, const Traits& traits) const {
  if (!trial.first) {
    return 1.0;
  }
  const double first =
      first_chance(*parameters_, model_->seen(*parameters_, traits, trial.percepts.front()),
                   model_->seen(*parameters_, traits, trial.percepts.back()));
  return *trial.first ? first : 1.0 - first;
}

/// Of all answers but a choice of an interval, where so much was seen.
double AnswerLikelihood::answered_chance(const AnsweredTrial& trial, const Traits& traits,
                                         double seen) const {
  const double unrated = unrated_chance(trial, seen);
  return trial.rating_steps ? unrated * model_->rating(*parameters_, traits, seen,
                                                       *trial.rating_steps, trial.rating_points)
                            : unrated;
}

double AnswerLikelihood::chance(const AnsweredTrial& trial, const Traits& traits) const {
  const double choice = choice_chance(trial, traits);
  if (model_->outcomes == nullptr) {
    return choice * answered_chance(trial, traits, clearest(trial, traits));
  }
  std::vector<Outcome> outcomes;
  const double logarithm = look(trial, traits, outcomes);
  double sum = 0.0;
  for (const Outcome& outcome : outcomes) {
    sum += outcome.probability * answered_chance(trial, traits, outcome.seen);
  }
  return std::exp(logarithm) * sum * choice;
}

// ---------------------------------------------------------------- one person

/// True when a parameter is not what it was that something else than a rating goes by.
bool AnswerLikelihood::must_judge() {
  const auto is_of_ratings = [&](const std::string& name) {
    const bool is_spread = std::any_of(spreads_.begin(), spreads_.end(), [&](const auto& spread) {
      return name == spread.parameter;
    });
    return is_spread || name == "effect" || name.starts_with("cut_");
  };
  std::vector<double> others;
  for (const MovableParameter& one : movable_) {
    if (!is_of_ratings(one.name)) {
      others.push_back(*one.place);
    }
  }
  const bool moved = !judged_by_ || *judged_by_ != others;
  judged_by_ = std::move(others);
  return moved;
}

/// All that the smooth traits do not change is computed once for all of these that are tried.
void AnswerLikelihood::judge(Person& person, const Traits& own) const {
  std::map<std::tuple<double, std::size_t, std::size_t>, std::size_t> places;
  std::vector<Outcome> outcomes;
  person.ratings.clear();
  person.known_logarithm = 0.0;
  for (Cell& cell : person.cells) {
    const AnsweredTrial& trial = *cell.trial;
    const double clicks_logarithm = look(trial, own, outcomes);
    const double choice = choice_chance(trial, own);
    double unrated = 0.0;
    cell.outcomes.clear();
    for (const Outcome& outcome : outcomes) {
      const double chance = outcome.probability * choice * unrated_chance(trial, outcome.seen);
      unrated += chance;
      if (trial.rating_steps) {
        const GivenRating rating{outcome.seen, *trial.rating_steps, trial.rating_points};
        const auto [at, is_new] =
            places.try_emplace({rating.seen, rating.steps, rating.points}, person.ratings.size());
        if (is_new) {
          person.ratings.push_back(rating);
        }
        cell.outcomes.push_back({chance, at->second});
      }
    }
    const double logarithm = trial.rating_steps ? 0.0 : std::log(std::max(unrated, kLeastChance));
    person.known_logarithm += cell.count * (clicks_logarithm + logarithm);
  }
}

/// The logarithm of P(answers | traits), of somebody who was judged with this threshold.
double AnswerLikelihood::answers_logarithm(Person& person, const Traits& own) const {
  for (GivenRating& one : person.ratings) {
    one.chance = model_->rating(*parameters_, own, one.seen, one.steps, one.points);
  }
  LogarithmOfProduct product;
  for (const Cell& cell : person.cells) {
    double chance = cell.outcomes.empty() ? 1.0 : 0.0;
    for (const RatedOutcome& outcome : cell.outcomes) {
      chance += outcome.chance * person.ratings[outcome.rating].chance;
    }
    product.take(chance, cell.count);
  }
  return product.logarithm() + person.known_logarithm;
}

/// The logarithm of ∫ P(answers | own, z) φ(z) dz over the smooth traits z, begun at `highest`.
double AnswerLikelihood::over_smooth(Person& person, const Traits& own, VectorXd& highest) const {
  if (smooth_.empty()) {
    return answers_logarithm(person, own);
  }
  const auto joint = [&](const VectorXd& z) {
    return answers_logarithm(person, with(smooth_, own, z)) - 0.5 * z.squaredNorm();
  };
  return logarithm_of_integral(joint, highest) -
         0.5 * static_cast<double>(smooth_.size()) * std::log(2.0 * std::numbers::pi);
}

/// The same over all traits. It begins anew each time: what was tried before changes nothing.
double AnswerLikelihood::integral(Person& person) const {
  VectorXd highest = VectorXd::Zero(static_cast<Eigen::Index>(smooth_.size()));
  if (!threshold_differs_) {
    const double logarithm = over_smooth(person, {}, highest);
    person.likely = with(smooth_, {}, highest);
    return logarithm;
  }
  double top = kImpossible;
  const auto slice = [&](double threshold) {
    const Traits own{threshold};
    judge(person, own);
    const double logarithm = over_smooth(person, own, highest) - 0.5 * threshold * threshold;
    if (logarithm > top) {
      top = logarithm;
      person.likely = with(smooth_, own, highest);
    }
    return logarithm;
  };
  return logarithm_of_rough_integral(slice) - 0.5 * std::log(2.0 * std::numbers::pi);
}

std::vector<double> AnswerLikelihood::logarithms() {
  if (model_->settle != nullptr) {
    model_->settle(*parameters_);
  }
  if (!can_be()) {
    return std::vector<double>(people_.size(), kImpossible);
  }
  const bool judges = !threshold_differs_ && must_judge();
  std::vector<double> all(people_.size());
  const auto of_person = [&](std::size_t i) {
    if (judges) {
      judge(people_[i], {});
    }
    all[i] = integral(people_[i]);
  };
  const auto began = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < people_.size(); ++i) {
    of_person(i);
    if (i == 0 && takes_long(std::chrono::steady_clock::now() - began, people_.size() - 1)) {
      do_side_by_side(people_.size() - 1, [&](std::size_t next) { of_person(next + 1); });
      break;
    }
  }
  return all;
}

double AnswerLikelihood::logarithm() {
  double sum = 0.0;
  for (const double one : logarithms()) {
    sum += one;
  }
  return std::isfinite(sum) ? sum : kImpossible;
}

std::vector<Traits> AnswerLikelihood::likely_traits() {
  static_cast<void>(logarithms());
  std::vector<Traits> all;
  for (Person& person : people_) {
    VectorXd z(static_cast<Eigen::Index>(spreads_.size()));
    for (std::size_t i = 0; i < spreads_.size(); ++i) {
      z[static_cast<Eigen::Index>(i)] = person.likely.*spreads_[i].trait;
    }
    const auto joint = [&](const VectorXd& at) {
      const Traits own = with(spreads_, {}, at);
      judge(person, own);
      return answers_logarithm(person, own) - 0.5 * at.squaredNorm();
    };
    climb(joint, z);
    all.push_back(with(spreads_, {}, z));
  }
  return all;
}

}  // namespace impetus::inline fitting
