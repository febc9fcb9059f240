// SPDX-License-Identifier: MIT
#include "experiments/observers/imagining/imagining_parameters.hpp"

namespace impetus::inline observers {

Imagination ImaginingParameters::imagination() const {
  Imagination by{static_cast<std::int64_t>(runs), heading_noise_deg, step_hz};
  by.in_pairs = false;
  if (level >= 0.0) {
    by.level = static_cast<int>(level);
  }
  if (tests_per_step >= 0.0) {
    by.tests_per_step = static_cast<std::int64_t>(tests_per_step);
  }
  return by;
}

std::vector<ParameterEntry> imagining_entries(ImaginingParameters& own,
                                              const std::vector<ParameterEntry>& beside) {
  std::vector<ParameterEntry> entries{
      {"heading_noise_deg", 0.0, 90.0, &own.heading_noise_deg,
       "Standard deviation of the turn of the imagined heading in each imagined step."},
      {"runs", 1.0, 1e6, &own.runs, "Imagined runs for each clip."},
      {"step_hz", 1.0, 10000.0, &own.step_hz, "Imagined steps a second."},
      {"level", -1.0, 30.0, &own.level,
       "The deepest level of detail imagined; -1, when left out: as the scene has it.", true},
      {"tests_per_step", -1.0, kAny, &own.tests_per_step,
       "Units of work in an imagined step; -1, when left out: no limit.", true}};
  entries.insert(entries.end(), beside.begin(), beside.end());
  return with_answering_entries(own, std::move(entries));
}

}  // namespace impetus::inline observers
