// One study of a parameter recovery: simulated headless, then fitted as people's answers are.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "experiments/commands/running/run_part.hpp"
#include "experiments/power/recovery.hpp"

namespace impetus::inline commands {

/// What a recovery simulates.
struct RecoveryWork {
  RunPart part;  ///< with the observer, whose numbers are planted
  RunOptions run;
  RecoveryQuestion question;
};

/// Study `number`, simulated in `scratch`, of which nothing is left. Its seed is that of the same
/// number in a power analysis. A study that cannot be fitted has a remark.
RecoveredStudy recovered_study(const RecoveryWork& work, std::int64_t number,
                               const std::filesystem::path& scratch);

}  // namespace impetus::inline commands
