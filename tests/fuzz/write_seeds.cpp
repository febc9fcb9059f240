// Writes the seeds as files: write_seeds FOLDER makes FOLDER/mesh/* and FOLDER/tree/*.
// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include "tests/fuzz/seeds.hpp"

namespace {

void write(const std::filesystem::path& folder, const std::vector<std::string>& seeds) {
  std::filesystem::create_directories(folder);
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    std::ofstream(folder / std::to_string(i), std::ios::binary) << seeds[i];
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    return 2;
  }
  write(std::filesystem::path(words[1]) / "mesh", impetus::mesh_seeds());
  write(std::filesystem::path(words[1]) / "tree", impetus::tree_seeds());
  return 0;
}
