// SPDX-License-Identifier: MIT
#include "experiments/models/confined_files.hpp"

#include "experiments/models/file_place.hpp"
#include "experiments/models/readable_file.hpp"

namespace impetus::inline models {
namespace {

/// glTF names files by URI.
std::string path_of(const std::string& name) { return is_there(name) ? name : decoded_uri(name); }

}  // namespace

ConfinedFiles::ConfinedFiles(const std::filesystem::path& file) : file_(file) {}

bool ConfinedFiles::Exists(const char* name) const { return may_open(path_of(name)); }

Assimp::IOStream* ConfinedFiles::Open(const char* name, const char* mode) {
  const std::string path = path_of(name);
  return may_open(path) ? Assimp::DefaultIOSystem::Open(path.c_str(), mode) : nullptr;
}

bool ConfinedFiles::may_open(const std::filesystem::path& name) const {
  const std::filesystem::path folder = file_.has_parent_path() ? file_.parent_path() : ".";
  return (name == file_ || is_really_within(name, folder)) && reading_problem(name).empty();
}

}  // namespace impetus::inline models
