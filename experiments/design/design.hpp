// A factorial design as plain data: factors, levels, repetitions, and rules for the order.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace impetus::inline design {

using LevelValue = std::variant<double, std::string, bool>;

/// One factor at one level, by name.
struct FactorLevel {
  std::string factor;
  LevelValue value;

  friend bool operator==(const FactorLevel&, const FactorLevel&) = default;
};

/// One cell of the design: a level for every factor, in the design's order of factors.
using Condition = std::vector<FactorLevel>;

/// One factor and all its levels, which are values of the scene or keys of answers.
struct Factor {
  std::string name;
  std::vector<LevelValue> levels;
  std::string pointer{};  ///< JSON Pointer to the value of the scene that it overrides; "": none
  /// In its place, what each of its levels, which are words, sets: a JSON object of values by their
  /// JSON Pointers.
  std::map<std::string, std::string> sets{};
  std::string label{};    ///< for people
  bool between{false};    ///< between participants: each of them has one level of it
  std::string keys_of{};  ///< the question whose answers have its levels as keys; "": none
};

/// No more than `longest` trials in a row may have the same level of `factor`.
struct LongestRun {
  std::string factor;
  std::int64_t longest{0};
};

/// Trials come in blocks, one for each cell of `factors`; within a block the others vary. The order
/// of blocks is drawn, or a row of a Latin square: that of the number the participant's code ends
/// in, so that P01, P02, ... are counterbalanced. Without factors there are `count` blocks alike,
/// each of which has every cell equally often.
struct Blocks {
  /// Drawn, as the levels stand, or a row of the square.
  enum class Order { kRandom, kFixed, kLatinSquare };
  std::vector<std::string> factors;
  Order order{Order::kRandom};
  std::int64_t count{1};
};

/// Trials outside the design, spread among the main ones, whose right answer is known.
struct CatchTrials {
  Condition condition;
  std::int64_t count{0};  ///< in each block
};

/// Trials that nothing is asked of, shown before the main trials whose conditions have the levels
/// of `when`: so many before the first of each block, and before each other one.
struct Adaptation {
  Condition when;
  std::vector<Condition> conditions;  ///< in turn; each with a level for every factor
  std::int64_t first{0};
  std::int64_t before_each{0};
};

/// Up-down (Levitt 1971): `down` positives in a row make the next trial harder, `up` negatives in a
/// row easier. Levels are those of the factor, from hard (first) to easy (last).
struct Staircase {
  std::int64_t up{1};
  std::int64_t down{2};
  std::vector<std::int64_t> steps{1};  ///< in levels; the next one after each reversal
  std::vector<LevelValue> starts;      ///< one interleaved staircase for each
};

/// QUEST+ (Watson 2017): the level whose answer should take away most of the posterior's entropy.
struct QuestPlus {
  /// The form of the curve from guessing to lapsing.
  enum class Function { kWeibull, kNormal };
  /// What the level is counted in: as it is, its decimal logarithm, or decibels (20 log₁₀). Slopes
  /// are exponents (Weibull) or standard deviations (normal). See psychometric.hpp.
  enum class Scale { kLinear, kLog10, kDecibel };
  Function function{Function::kWeibull};
  Scale scale{Scale::kLinear};
  std::vector<double> thresholds;  ///< grids of the prior, uniform over all combinations
  std::vector<double> slopes;
  std::vector<double> guess_rates;
  std::vector<double> lapse_rates;
};

/// One factor's level is chosen trial by trial, in a track for each cell of the others. Tracks are
/// interleaved at random.
struct Adaptive {
  std::string factor;
  std::variant<Staircase, QuestPlus> method;
  std::int64_t trials_per_track{0};
};

/// All of a design.
struct Design {
  std::vector<Factor> factors;
  std::int64_t repetitions{1};
  std::vector<LongestRun> longest_runs;
  std::vector<Condition> practice;  ///< shown first, in this order
  std::int64_t practice_rounds{1};  ///< planned; later ones are for who needs them
  std::optional<Blocks> blocks{};
  std::vector<CatchTrials> catch_trials{};
  std::vector<Adaptation> adaptation{};
  std::optional<Adaptive> adaptive{};    ///< `repetitions` is then 1
  std::int64_t most_practice_trials{0};  ///< the last round may be cut short; 0: it is whole
};

/// The place of the factor of this name among the design's, or one past the last.
std::size_t factor_place(const Design& design, const std::string& name);
/// That factor; null when there is none.
const Factor* find_factor(const Design& design, const std::string& name);

/// Every cell of the design, the last factor varying fastest.
std::vector<Condition> cells(const Design& design);
/// The same of these factors alone.
std::vector<Condition> cells_of(const Design& design, const std::vector<std::string>& factors);

/// What is shown beside the cells and practice, and where a protocol says it, as a JSON Pointer.
struct ConditionBeside {
  std::string place;
  Condition condition;
};
std::vector<ConditionBeside> conditions_beside(const Design& design);

/// Whether all these levels are the condition's.
bool has_levels(const Condition& condition, const Condition& levels);

/// Whether it is one of the factor's.
bool has_level(const Factor& factor, const LevelValue& level);

/// Levels that are all numbers.
/// The condition's level of this factor; null where it has none.
const FactorLevel* find_level(const Condition& condition, const std::string& factor);

std::vector<double> numbers(const std::vector<LevelValue>& levels);

/// "5", "0.5", "tracked", "true": a level as it is printed and stored.
std::string to_text(const LevelValue& value);

/// "delay_ms 300, speed_deg_s 10"
std::string condition_words(const Condition& condition);

}  // namespace impetus::inline design
