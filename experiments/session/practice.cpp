// SPDX-License-Identifier: MIT
#include "experiments/session/practice.hpp"

#include <algorithm>

#include "experiments/questions/rating.hpp"

namespace impetus::inline session {
namespace {

/// What was done in the trials of one level of the rule's factor.
struct LevelTally {
  double ratings{0.0};
  std::int64_t clicks{0};
  std::int64_t rated{0};

  [[nodiscard]] double mean() const { return ratings / static_cast<double>(rated); }
};

LevelTally tally(const std::string& factor, const LevelValue& level,
                 const std::vector<PracticeResult>& round) {
  LevelTally tally;
  for (const PracticeResult& trial : round) {
    if (has_levels(trial.condition, {{factor, level}})) {
      tally.ratings += static_cast<double>(trial.rating.value_or(0));
      tally.rated += trial.rating ? 1 : 0;
      tally.clicks += trial.clicks;
    }
  }
  return tally;
}

}  // namespace

PracticeResult practice_result(const Condition& condition, const AttemptRecord& record) {
  PracticeResult result;
  result.condition = condition;
  if (!record.ratings.empty()) {
    result.rating = record.ratings.front().rating;
  }
  result.clicks = static_cast<std::int64_t>(record.clicks.size());
  result.right = answered_right(record);
  return result;
}

std::vector<std::string> missing_in_practice(const PracticeRule& rule, const Script& script,
                                             const std::vector<PracticeResult>& round) {
  const LevelTally best = tally(rule.factor, rule.best, round);
  const LevelTally worst = tally(rule.factor, rule.worst, round);
  const Language& language = script.language;
  std::vector<std::string> missing;
  if (takes_clicks(script) && worst.clicks == 0) {
    missing.push_back(language.text("did_not_click"));
  }
  const bool both_rated = best.rated > 0 && worst.rated > 0;
  const RatingScale& scale = *find_scale(script);
  const bool high_is_good = scale.best == scale.maximum;
  const double better = high_is_good ? best.mean() - worst.mean() : worst.mean() - best.mean();
  if (!both_rated || better <= 0.0) {
    missing.push_back(language.text("did_not_rate_better", {{"best", std::to_string(scale.best)}}));
  }
  return missing;
}

std::int64_t right_of_last(std::int64_t of, const std::vector<PracticeResult>& results) {
  const auto most = static_cast<std::int64_t>(results.size());
  const auto last = std::min(of, most);
  return std::count_if(results.end() - static_cast<std::ptrdiff_t>(last), results.end(),
                       [](const PracticeResult& trial) { return trial.right.value_or(false); });
}

bool is_trained(const TrainingRule& rule, const std::vector<PracticeResult>& results) {
  return static_cast<std::int64_t>(results.size()) >= rule.of &&
         right_of_last(rule.of, results) >= rule.right;
}

}  // namespace impetus::inline session
