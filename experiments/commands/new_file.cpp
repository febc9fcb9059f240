// SPDX-License-Identifier: MIT
#include "experiments/commands/new_file.hpp"

#include "experiments/models/atomic_file.hpp"
#include "experiments/session/input_error.hpp"

namespace impetus {
namespace {

void require_none(const std::filesystem::path& file, const char* unless) {
  if (std::filesystem::exists(file)) {
    throw InputError(file.string() + ": exists already and is not overwritten" + unless);
  }
}

}  // namespace

void require_new_file(const std::filesystem::path& file) {
  require_none(file, "");
  require_writable(file);
}

void require_new_file(const std::filesystem::path& file, bool force) {
  if (!force) {
    require_none(file, " without --force");
  }
  require_writable(file);
}

}  // namespace impetus
