// SPDX-License-Identifier: MIT
#include "experiments/fitting/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/tables/student_t.hpp"

namespace impetus::inline fitting {
namespace {

/// The same answers to stimuli that all look alike.
ComparedObserver blind_to_all(const ComparedObserver& observer) {
  ComparedObserver blind = observer;
  blind.name = kGoesByNothing;
  const Percept same = blind.people.front().trials.front().percepts.front();
  for (AnsweringPerson& person : blind.people) {
    for (AnsweredTrial& trial : person.trials) {
      for (Percept& percept : trial.percepts) {
        const auto blank = observer.kind->answers.blank;
        percept = blank != nullptr ? blank(percept) : same;
      }
    }
  }
  return blind;
}

/// The people of a fold, or all but these. Of one person: the trials.
std::vector<AnsweringPerson> part_of(const std::vector<AnsweringPerson>& people, std::size_t fold,
                                     std::size_t folds, bool held_out) {
  std::vector<AnsweringPerson> part;
  if (people.size() > 1) {
    for (std::size_t i = 0; i < people.size(); ++i) {
      if ((i % folds == fold) == held_out) {
        part.push_back(people[i]);
      }
    }
    return part;
  }
  part.push_back({people.front().code, {}});
  for (std::size_t i = 0; i < people.front().trials.size(); ++i) {
    if ((i % folds == fold) == held_out) {
      part.front().trials.push_back(people.front().trials[i]);
    }
  }
  return part;
}

/// A person for each trial.
std::vector<AnsweringPerson> trial_by_trial(const AnsweringPerson& person) {
  std::vector<AnsweringPerson> each;
  for (const AnsweredTrial& trial : person.trials) {
    each.push_back({person.code, {trial}});
  }
  return each;
}

/// The logarithm of the probability of each person of a fold, of one person: of each trial.
std::vector<double> foretold(const ComparedObserver& observer, const RatingParameters& start,
                             std::size_t fold, std::size_t folds) {
  const bool as_group = observer.people.size() > 1;
  const std::vector<AnsweringPerson> others = part_of(observer.people, fold, folds, false);
  const ObserverFit fit = fit_observer(*observer.kind, start, others,
                                       {.as_group = as_group, .starts = 1, .intervals = false});
  std::vector<AnsweringPerson> own = part_of(observer.people, fold, folds, true);
  if (!as_group) {
    own = trial_by_trial(own.front());
  }
  return AnswerLikelihood(*observer.kind, *fit.best, own, as_group).logarithms();
}

/// The sum of the differences, and how much of it chance may have made.
void judge_difference(const std::vector<double>& a, const std::vector<double>& b, double& sum,
                      double& by_chance) {
  // An odds of e is not worth more than a bare mention (Kass and Raftery 1995).
  constexpr double kBareMention = 1.0;
  const auto count = static_cast<double>(a.size());
  sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += a[i] - b[i];
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    squares += std::pow(a[i] - b[i] - sum / count, 2.0);
  }
  const double degrees = std::max(count - 1.0, 1.0);
  by_chance = std::max(kBareMention, student_t(degrees) * std::sqrt(count * squares / degrees));
}

/// The best of those that foretell beyond chance.
void choose(ObserverComparison& comparison) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i + 1 < comparison.observers.size(); ++i) {
    const Foretelling& one = comparison.observers[i];
    if (one.gain > one.gain_by_chance &&
        (!best || one.per_trial > comparison.observers[*best].per_trial)) {
      best = i;
    }
  }
  comparison.chosen = best;
  for (std::size_t i = 0; best && i + 1 < comparison.observers.size(); ++i) {
    double lead = 0.0;
    double by_chance = 0.0;
    judge_difference(comparison.observers[*best].parts, comparison.observers[i].parts, lead,
                     by_chance);
    if (i != *best && lead <= by_chance) {
      comparison.not_told_apart.push_back(i);
    }
  }
}

}  // namespace

ObserverComparison compare_observers(const std::vector<ComparedObserver>& observers,
                                     std::size_t most_folds,
                                     const std::function<void(double)>& progress) {
  std::vector<ComparedObserver> all = observers;
  all.push_back(blind_to_all(observers.front()));
  const std::vector<AnsweringPerson>& people = observers.front().people;
  const std::size_t parts = people.size() > 1 ? people.size() : people.front().trials.size();
  ObserverComparison comparison;
  comparison.folds = std::min(most_folds, parts);
  const auto trials = static_cast<double>(trials_of(people));
  double done = 0.0;
  const double steps = static_cast<double>(all.size() * (comparison.folds + 1));
  const auto tell = [&] {
    if (progress) {
      progress(++done / steps);
    }
  };
  for (const ComparedObserver& observer : all) {
    Foretelling& told = comparison.observers.emplace_back();
    told.name = observer.name;
    // The fit of all is where those of the folds begin: they are near it.
    const ObserverFit whole =
        fit_observer(*observer.kind, *observer.start, observer.people,
                     {.as_group = people.size() > 1, .starts = 2, .intervals = false});
    tell();
    for (std::size_t fold = 0; fold < comparison.folds; ++fold) {
      for (const double one : foretold(observer, *whole.best, fold, comparison.folds)) {
        told.parts.push_back(one);
        told.per_trial += one / trials;
      }
      tell();
    }
  }
  for (Foretelling& told : comparison.observers) {
    judge_difference(told.parts, comparison.observers.back().parts, told.gain, told.gain_by_chance);
  }
  choose(comparison);
  return comparison;
}

}  // namespace impetus::inline fitting
