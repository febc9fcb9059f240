// SPDX-License-Identifier: MIT
#include "experiments/extremes/extreme_cases.hpp"

#include <cmath>
#include <iterator>

namespace impetus::inline extremes {
namespace {

/// Whether x is worse than y; no number is the worst.
bool is_worse(double x, double y) { return std::isnan(x) ? !std::isnan(y) : x > y; }

void run_scenes(const ExtremeCase& extreme, Length length, const Progress& progress,
                std::vector<ExtremeResult>& results) {
  const std::vector<ExtremeScene> scenes = extreme.scenes(length);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto part = [&](double share) {
      if (progress) {
        progress((static_cast<double>(i) + share) / static_cast<double>(scenes.size()));
      }
    };
    const Course course = run_scene(scenes[i], part);
    for (std::size_t j = 0; j < results.size(); ++j) {
      const double measured = extreme.promises[j].measure(course);
      if (i == 0 || is_worse(measured, results[j].measured)) {
        results[j].measured = measured;
        results[j].worst_at = scenes[i].name;
      }
    }
  }
}

}  // namespace

ExtremeCase single_promise(const std::string& family, const std::string& name,
                           const std::string& sentence, double at_most, const std::string& unit,
                           const std::function<double(const Course&)>& measure,
                           const std::function<std::vector<ExtremeScene>(Length)>& scenes) {
  return {family, name, {{sentence, at_most, unit, measure}}, scenes};
}

std::vector<ExtremeResult> run_case(const ExtremeCase& extreme, Length length,
                                    const Progress& progress) {
  std::vector<ExtremeResult> results(extreme.promises.size());
  if (extreme.ask) {
    const std::vector<double> measured = extreme.ask(length, progress);
    for (std::size_t i = 0; i < results.size(); ++i) {
      results[i].measured = measured.at(i);
    }
  } else {
    run_scenes(extreme, length, progress, results);
  }
  for (std::size_t i = 0; i < results.size(); ++i) {
    results[i].kept = results[i].measured <= extreme.promises[i].at_most;
  }
  return results;
}

const std::vector<ExtremeCase>& extreme_cases() {
  static const std::vector<ExtremeCase> all = [] {
    std::vector<ExtremeCase> cases;
    for (std::vector<ExtremeCase> (*family)() :
         {size_cases, speed_cases, spin_cases, mass_cases, time_step_cases, far_place_cases,
          touch_cases, crowd_cases, budget_cases, tunnelling_cases, not_finite_cases,
          small_number_cases, long_run_cases}) {
      std::vector<ExtremeCase> more = family();
      cases.insert(cases.end(), std::make_move_iterator(more.begin()),
                   std::make_move_iterator(more.end()));
    }
    return cases;
  }();
  return all;
}

}  // namespace impetus::inline extremes
