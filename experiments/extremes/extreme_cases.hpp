// Cases at the extremes, by family: what is promised of each, and how it is measured.
//
// Each promise is that one figure, the less the better, is at most a number. Most are figures of
// the courses of scenes, which any engine can be put to; others are asked of this engine alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/extremes/course.hpp"
#include "experiments/extremes/extreme_scene.hpp"

namespace impetus::inline extremes {

/// How long a case may take: all quick ones together half a minute, the usual ones two minutes;
/// long ones as long as they need.
enum class Length { kQuick, kUsual, kLong };

/// That a figure is at most a number.
struct ExtremePromise {
  std::string sentence;  ///< which `at_most` completes
  double at_most{0.0};
  std::string unit{};                              ///< "" of shares and counts
  std::function<double(const Course&)> measure{};  ///< of a scene: the worst scene counts
};

/// Scenes, or a question to the engine, and what is promised of them.
struct ExtremeCase {
  std::string family;  ///< such as "sizes"
  std::string name;    ///< of its own among all cases, such as "sizes-balls"
  std::vector<ExtremePromise> promises;
  std::function<std::vector<ExtremeScene>(Length)> scenes{};
  /// In place of scenes: the figure of each promise.
  std::function<std::vector<double>(Length, const Progress&)> ask{};
};

/// A case of scenes of which one thing is promised.
ExtremeCase single_promise(const std::string& family, const std::string& name,
                           const std::string& sentence, double at_most, const std::string& unit,
                           const std::function<double(const Course&)>& measure,
                           const std::function<std::vector<ExtremeScene>(Length)>& scenes);

/// What became of a promise.
struct ExtremeResult {
  double measured{0.0};
  std::string worst_at{};  ///< the scene that it was measured in; "" where there are none
  bool kept{false};        ///< never, when what was measured is no number
};

/// Runs the case in this engine: a result for each of its promises. `progress` may be empty.
std::vector<ExtremeResult> run_case(const ExtremeCase& extreme, Length length,
                                    const Progress& progress = {});

/// In the order in which they are reported: families together.
const std::vector<ExtremeCase>& extreme_cases();

std::vector<ExtremeCase> size_cases();
std::vector<ExtremeCase> speed_cases();
std::vector<ExtremeCase> spin_cases();
std::vector<ExtremeCase> mass_cases();
std::vector<ExtremeCase> time_step_cases();
std::vector<ExtremeCase> far_place_cases();
std::vector<ExtremeCase> touch_cases();
std::vector<ExtremeCase> crowd_cases();
std::vector<ExtremeCase> budget_cases();
std::vector<ExtremeCase> tunnelling_cases();
std::vector<ExtremeCase> not_finite_cases();
std::vector<ExtremeCase> small_number_cases();
std::vector<ExtremeCase> long_run_cases();

}  // namespace impetus::inline extremes
