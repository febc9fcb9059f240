// SPDX-License-Identifier: MIT
#include "experiments/models/confined_files.hpp"

#include "experiments/models/file_place.hpp"

namespace impetus {

ConfinedFiles::ConfinedFiles(const std::filesystem::path& file) : file_(file) {}

bool ConfinedFiles::Exists(const char* name) const {
  return may_open(name) && Assimp::DefaultIOSystem::Exists(name);
}

Assimp::IOStream* ConfinedFiles::Open(const char* name, const char* mode) {
  return may_open(name) ? Assimp::DefaultIOSystem::Open(name, mode) : nullptr;
}

bool ConfinedFiles::may_open(const std::filesystem::path& name) const {
  const std::filesystem::path folder = file_.has_parent_path() ? file_.parent_path() : ".";
  return name == file_ || is_really_within(name, folder);
}

}  // namespace impetus
