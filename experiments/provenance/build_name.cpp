// SPDX-License-Identifier: MIT
#include "experiments/provenance/build_name.hpp"

#include "build_info.hpp"
#include "engine/world/world.hpp"
#include "experiments/store/migration.hpp"

namespace impetus::inline provenance {

const char* build_name() {
  return "impetus " IMPETUS_VERSION ", " IMPETUS_COMMIT ", " IMPETUS_COMPILER ", " IMPETUS_FLAGS;
}

std::string version_text() {
  const auto up_to = [](std::int64_t oldest, std::int64_t newest) {
    return std::to_string(oldest) + " to " + std::to_string(newest);
  };
  return "impetus " IMPETUS_VERSION "\ncommit: " IMPETUS_COMMIT "\ncompiler: " IMPETUS_COMPILER
         ", " IMPETUS_FLAGS "\nreplays recordings of format: " +
         up_to(kOldestRecordingFormat, kRecordingFormat) +
         "\nreads studies of schema: " + up_to(kOldestSchemaVersion, kSchemaVersion);
}

}  // namespace impetus::inline provenance
