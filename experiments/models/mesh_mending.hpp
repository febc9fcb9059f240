// Repairs a mesh file into a new file, and says in words what was changed.
//
//   FILE --load--> mesh --repair--> mesh --write--> OUT --load, check--> fine, or OUT is removed
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "engine/shapes/mending/mesh_repair.hpp"

namespace impetus::inline models {

/// Each change on a line of its own with its count, "changed  nothing" when there was none.
std::string describe_changes(const MeshRepair& repair);

struct Mending {
  MeshRepair repair;
  std::string refusal;  ///< why nothing was written, with the count; empty when OUT was written
};

/// Writes the repaired `file` as `out`, which then passes the check of report_mesh(). Throws
/// std::runtime_error, in one sentence that names the file, when `file` cannot be read, when `out`
/// exists, has an unknown extension or cannot be written.
Mending mend(const std::filesystem::path& file, const std::filesystem::path& out);

}  // namespace impetus::inline models
