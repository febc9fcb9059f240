// SPDX-License-Identifier: MIT
#include "experiments/fitting/likelihood.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <thread>
#include <tuple>

namespace impetus::inline fitting {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kImpossible = -std::numeric_limits<double>::infinity();
constexpr double kLeastChance = 1e-300;

/// Nodes and weights for ∫ f(t) exp(−t²) dt.
struct HermiteRule {
  VectorXd nodes;
  VectorXd weights;
};

/// Golub and Welsch 1969: nodes are the eigenvalues of the Hermite polynomials' recurrence.
HermiteRule hermite_rule(Eigen::Index size) {
  MatrixXd recurrence = MatrixXd::Zero(size, size);
  for (Eigen::Index i = 1; i < size; ++i) {
    recurrence(i, i - 1) = std::sqrt(0.5 * static_cast<double>(i));
    recurrence(i - 1, i) = recurrence(i, i - 1);
  }
  const Eigen::SelfAdjointEigenSolver<MatrixXd> parts(recurrence);
  return {parts.eigenvalues(),
          std::sqrt(std::numbers::pi) * parts.eigenvectors().row(0).transpose().cwiseAbs2()};
}

const HermiteRule& rule_for(Eigen::Index traits) {
  static const HermiteRule one = hermite_rule(9);
  static const HermiteRule more = hermite_rule(7);
  return traits <= 1 ? one : more;
}

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

}  // namespace

// ---------------------------------------------------------------- what may be moved

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
  forget_modes();
}

void AnswerLikelihood::forget_modes() {
  judged_by_.reset();
  traits_change_seen_ = model_->outcomes == nullptr &&
                        std::any_of(spreads_.begin(), spreads_.end(), [](const TraitSpread& one) {
                          return one.trait == &Traits::threshold;
                        });
  for (Person& person : people_) {
    person.mode = VectorXd::Zero(static_cast<Eigen::Index>(spreads_.size()));
  }
}

void AnswerLikelihood::forget_trait(const std::string& spread) {
  std::erase_if(spreads_, [&](const TraitSpread& one) { return spread == one.parameter; });
  forget_modes();
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

/// What may have been seen, and the logarithm of the probability of the clicks.
double AnswerLikelihood::look(const AnsweredTrial& trial, const Traits& traits,
                              std::vector<Outcome>& outcomes) const {
  if (model_->outcomes != nullptr) {
    return model_->outcomes(*parameters_, trial.percepts.front(),
                            trial.clicks_s ? &*trial.clicks_s : nullptr, outcomes);
  }
  double clearest = 0.0;  // as Judge::clearest()
  for (const Percept& percept : trial.percepts) {
    clearest = std::max(clearest, model_->seen(*parameters_, traits, percept));
  }
  outcomes.assign(1, {1.0, clearest});
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

double AnswerLikelihood::chance(const AnsweredTrial& trial, const Traits& traits) {
  const double logarithm = look(trial, traits, scratch_);
  double sum = 0.0;
  for (const Outcome& outcome : scratch_) {
    double all = outcome.probability * unrated_chance(trial, outcome.seen);
    if (trial.rating_steps) {
      all *= model_->rating(*parameters_, traits, outcome.seen, *trial.rating_steps,
                            trial.rating_points);
    }
    sum += all;
  }
  return std::exp(logarithm) * sum * choice_chance(trial, traits);
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

/// What no trait changes is computed once for all traits that are tried: all but ratings.
void AnswerLikelihood::judge(Person& person) const {
  std::map<std::tuple<double, std::size_t, std::size_t>, std::size_t> places;
  std::vector<Outcome> outcomes;
  person.ratings.clear();
  person.known_logarithm = 0.0;
  for (Cell& cell : person.cells) {
    const AnsweredTrial& trial = *cell.trial;
    const double clicks_logarithm = look(trial, {}, outcomes);
    const double choice = choice_chance(trial, {});
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

Traits AnswerLikelihood::traits(const VectorXd& z) const {
  Traits traits;
  for (std::size_t i = 0; i < spreads_.size(); ++i) {
    traits.*spreads_[i].trait = z[static_cast<Eigen::Index>(i)];
  }
  return traits;
}

/// The logarithm of P(answers | z) exp(−½ z²).
double AnswerLikelihood::joint(Person& person, const VectorXd& z) {
  const Traits own = traits(z);
  LogarithmOfProduct product;
  if (traits_change_seen_) {
    for (const Cell& cell : person.cells) {
      product.take(chance(*cell.trial, own), cell.count);
    }
    return product.logarithm() - 0.5 * z.squaredNorm();
  }
  for (GivenRating& one : person.ratings) {
    one.chance = model_->rating(*parameters_, own, one.seen, one.steps, one.points);
  }
  for (const Cell& cell : person.cells) {
    double chance = cell.outcomes.empty() ? 1.0 : 0.0;
    for (const RatedOutcome& outcome : cell.outcomes) {
      chance += outcome.chance * person.ratings[outcome.rating].chance;
    }
    product.take(chance, cell.count);
  }
  return product.logarithm() + person.known_logarithm - 0.5 * z.squaredNorm();
}

/// Newton's method from where it was before; returns the curvature there, with its sign turned.
MatrixXd AnswerLikelihood::find_mode(Person& person) {
  constexpr double kStep = 2e-3;
  constexpr double kClose = 1e-4;  ///< in standard deviations over people: the quadrature forgives
  constexpr int kMostSteps = 30;
  const Eigen::Index size = person.mode.size();
  MatrixXd precision = MatrixXd::Identity(size, size);
  double value = joint(person, person.mode);
  for (int count = 0; count < kMostSteps; ++count) {
    VectorXd gradient(size);
    VectorXd near = person.mode;
    for (Eigen::Index i = 0; i < size; ++i) {
      near[i] = person.mode[i] + kStep;
      const double above = joint(person, near);
      near[i] = person.mode[i] - kStep;
      const double below = joint(person, near);
      near[i] = person.mode[i];
      gradient[i] = (above - below) / (2.0 * kStep);
      precision(i, i) = (2.0 * value - above - below) / (kStep * kStep);
      for (Eigen::Index j = 0; j < i; ++j) {
        const auto at = [&](double by_i, double by_j) {
          VectorXd corner = person.mode;
          corner[i] += by_i;
          corner[j] += by_j;
          return joint(person, corner);
        };
        precision(i, j) =
            -(at(kStep, kStep) - at(kStep, -kStep) - at(-kStep, kStep) + at(-kStep, -kStep)) /
            (4.0 * kStep * kStep);
        precision(j, i) = precision(i, j);
      }
    }
    Eigen::LLT<MatrixXd> factor(precision);
    if (factor.info() != Eigen::Success) {
      precision = MatrixXd::Identity(size, size) * (1.0 + precision.cwiseAbs().maxCoeff());
      factor.compute(precision);
    }
    VectorXd step = factor.solve(gradient);
    if (step.norm() < kClose) {
      break;
    }
    double there = joint(person, person.mode + step);
    while (there < value && step.norm() > 1e-6) {
      step *= 0.5;
      there = joint(person, person.mode + step);
    }
    if (!std::isfinite(there)) {
      break;
    }
    person.mode += step;
    value = there;
  }
  return precision;
}

double AnswerLikelihood::integral(Person& person) {
  const Eigen::Index size = person.mode.size();
  if (size == 0) {
    return joint(person, person.mode);
  }
  const MatrixXd precision = find_mode(person);
  // z = mode + √2 L t with L Lᵀ the inverse of the precision.
  const MatrixXd lower = Eigen::LLT<MatrixXd>(precision.inverse()).matrixL();
  const HermiteRule& rule = rule_for(size);
  const double top = joint(person, person.mode);
  double sum = 0.0;
  std::vector<Eigen::Index> digits(static_cast<std::size_t>(size), 0);
  while (true) {
    VectorXd t(size);
    double weight = 1.0;
    for (Eigen::Index i = 0; i < size; ++i) {
      const Eigen::Index node = digits[static_cast<std::size_t>(i)];
      t[i] = rule.nodes[node];
      weight *= rule.weights[node];
    }
    const double at = joint(person, person.mode + std::numbers::sqrt2 * (lower * t));
    sum += weight * std::exp(at - top + t.squaredNorm());
    std::size_t place = 0;
    while (place < digits.size() && ++digits[place] == rule.nodes.size()) {
      digits[place++] = 0;
    }
    if (place == digits.size()) {
      break;
    }
  }
  // (2π)^(−n/2) |√2 L| of the change of variables
  const double scale = static_cast<double>(size) * -0.5 * std::log(std::numbers::pi) +
                       lower.diagonal().array().log().sum();
  return top + std::log(sum) + scale;
}

std::vector<double> AnswerLikelihood::logarithms() {
  if (model_->settle != nullptr) {
    model_->settle(*parameters_);
  }
  if (!can_be()) {
    return std::vector<double>(people_.size(), kImpossible);
  }
  const bool judges = !traits_change_seen_ && must_judge();
  std::vector<double> all(people_.size());
  for_each_person([&](std::size_t i) {
    if (judges) {
      judge(people_[i]);
    }
    all[i] = integral(people_[i]);
  });
  return all;
}

/// Where clicks are explained a person takes a millisecond: people are shared among threads.
void AnswerLikelihood::for_each_person(const std::function<void(std::size_t)>& one) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t jobs = model_->outcomes != nullptr ? std::min(cores, people_.size()) : 1;
  const auto every_nth = [&](std::size_t first) {
    for (std::size_t i = first; i < people_.size(); i += jobs) {
      one(i);
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t job = 1; job < jobs; ++job) {
    threads.emplace_back(every_nth, job);
  }
  every_nth(0);
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
  for (const Person& person : people_) {
    all.push_back(traits(person.mode));
  }
  return all;
}

}  // namespace impetus::inline fitting
