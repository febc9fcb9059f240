// A factorial design as plain data: factors, levels, repetitions, and rules for the order.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace impetus {

using LevelValue = std::variant<double, std::string, bool>;

/// One factor at one level, by name.
struct FactorLevel {
  std::string factor;
  LevelValue value;

  friend bool operator==(const FactorLevel&, const FactorLevel&) = default;
};

/// One cell of the design: a level for every factor, in the design's order of factors.
using Condition = std::vector<FactorLevel>;

struct Factor {
  std::string name;
  std::vector<LevelValue> levels;
};

/// No more than `longest` trials in a row may have the same level of `factor`.
struct LongestRun {
  std::string factor;
  std::int64_t longest{0};
};

struct Design {
  std::vector<Factor> factors;
  std::int64_t repetitions{1};
  std::vector<LongestRun> longest_runs;
  std::vector<Condition> practice;  ///< shown first, in this order
  std::int64_t practice_rounds{1};  ///< planned; later ones are for who needs them
};

/// Every cell of the design, the last factor varying fastest.
std::vector<Condition> cells(const Design& design);

/// "5", "0.5", "tracked", "true": a level as it is printed and stored.
std::string to_text(const LevelValue& value);

}  // namespace impetus
