// SPDX-License-Identifier: MIT
#include "experiments/fitting/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>

namespace impetus::inline fitting {
namespace {

/// What was expected of a trial and what came.
struct Expectation {
  double mean{0.0};
  double variance{0.0};
  double answered{0.0};
};

/// The trial with another answer to one question, and without all others.
AnsweredTrial asked_alone(const AnsweredTrial& trial) {
  AnsweredTrial alone;
  alone.percepts = trial.percepts;
  alone.rating_points = trial.rating_points;
  return alone;
}

using Expected = std::function<std::optional<Expectation>(const AnsweredTrial&, const Traits&)>;

Expectation of_two(double chance, bool answered) {
  return {chance, chance * (1.0 - chance), answered ? 1.0 : 0.0};
}

std::optional<QuestionResiduals> of_question(const std::string& question, const Expected& expected,
                                             const std::vector<AnsweringPerson>& people,
                                             const std::vector<Traits>& traits,
                                             std::size_t groups) {
  std::vector<Expectation> all;
  for (std::size_t i = 0; i < people.size(); ++i) {
    for (const AnsweredTrial& trial : people[i].trials) {
      if (const auto one = expected(trial, traits[i])) {
        all.push_back(*one);
      }
    }
  }
  if (all.empty()) {
    return std::nullopt;
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Expectation& a, const Expectation& b) { return a.mean < b.mean; });
  QuestionResiduals residuals{question, {}};
  const std::size_t count = std::min(groups, all.size());
  for (std::size_t group = 0; group < count; ++group) {
    const std::size_t begin = group * all.size() / count;
    const std::size_t end = (group + 1) * all.size() / count;
    ResidualGroup told{all[begin].mean, all[end - 1].mean, end - begin};
    double variance = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      told.expected += all[i].mean;
      told.answered += all[i].answered;
      variance += all[i].variance;
    }
    told.z = (told.answered - told.expected) / std::sqrt(std::max(variance, 1e-12));
    told.expected /= static_cast<double>(told.trials);
    told.answered /= static_cast<double>(told.trials);
    residuals.groups.push_back(told);
  }
  return residuals;
}

}  // namespace

std::vector<QuestionResiduals> residuals(AnswerLikelihood& likelihood,
                                         const std::vector<AnsweringPerson>& people,
                                         std::size_t groups) {
  const std::vector<Traits> traits = likelihood.likely_traits();
  const Expected rating = [&](const AnsweredTrial& trial,
                              const Traits& own) -> std::optional<Expectation> {
    if (!trial.rating_steps) {
      return std::nullopt;
    }
    AnsweredTrial alone = asked_alone(trial);
    Expectation expected{0.0, 0.0, static_cast<double>(*trial.rating_steps)};
    double squares = 0.0;
    for (std::size_t steps = 0; steps < trial.rating_points; ++steps) {
      alone.rating_steps = steps;
      const double chance = likelihood.chance(alone, own);
      expected.mean += chance * static_cast<double>(steps);
      squares += chance * static_cast<double>(steps * steps);
    }
    expected.variance = squares - expected.mean * expected.mean;
    return expected;
  };
  const auto one_of_two = [&](std::optional<bool> AnsweredTrial::*answer) -> Expected {
    return [&likelihood, answer](const AnsweredTrial& trial,
                                 const Traits& own) -> std::optional<Expectation> {
      if (!(trial.*answer)) {
        return std::nullopt;
      }
      AnsweredTrial alone = asked_alone(trial);
      alone.*answer = true;
      return of_two(likelihood.chance(alone, own), *(trial.*answer));
    };
  };
  const Expected mark = [&](const AnsweredTrial& trial,
                            const Traits& own) -> std::optional<Expectation> {
    if (!trial.mark) {
      return std::nullopt;
    }
    AnsweredTrial alone = asked_alone(trial);
    const Mark& line = *trial.mark;
    alone.mark = line;
    const auto marks = std::lround((line.most - line.least) / line.grain);
    Expectation expected{0.0, 0.0, line.value};
    double squares = 0.0;
    for (std::int64_t at = 0; at <= marks; ++at) {
      const double value = line.least + line.grain * static_cast<double>(at);
      alone.mark->value = value;
      const double chance = likelihood.chance(alone, own);
      expected.mean += chance * value;
      squares += chance * value * value;
    }
    expected.variance = squares - expected.mean * expected.mean;
    return expected;
  };
  std::vector<QuestionResiduals> all;
  for (const auto& [question, expected] :
       {std::pair<std::string, Expected>{"rating, in steps from the scale's good end", rating},
        {"share of yes", one_of_two(&AnsweredTrial::yes)},
        {"share of the first interval", one_of_two(&AnsweredTrial::first)},
        {"mark, as a share of the line", mark}}) {
    if (auto one = of_question(question, expected, people, traits, groups)) {
      all.push_back(std::move(*one));
    }
  }
  return all;
}

}  // namespace impetus::inline fitting
