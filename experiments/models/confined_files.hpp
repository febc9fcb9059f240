// What assimp may open while it reads a mesh: the file, and files that lie in its folder.
//
// An OBJ or a glTF file names others by path; one from elsewhere could name any of the user's.
// SPDX-License-Identifier: MIT
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <filesystem>

namespace impetus::inline models {

class ConfinedFiles : public Assimp::DefaultIOSystem {
 public:
  explicit ConfinedFiles(const std::filesystem::path& file);

  /// What lies elsewhere, or is no regular file, does not exist, and is not opened.
  bool Exists(const char* name) const override;
  Assimp::IOStream* Open(const char* name, const char* mode = "rb") override;

 private:
  [[nodiscard]] bool may_open(const std::filesystem::path& name) const;

  std::filesystem::path file_;
};

}  // namespace impetus::inline models
