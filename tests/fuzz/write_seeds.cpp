// Writes the seeds as files: write_seeds FOLDER makes FOLDER/mesh_file/*, FOLDER/tree_file/* and so
// on.
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
  const std::filesystem::path folder(words[1]);
  write(folder / "lines", impetus::lines_seeds());
  write(folder / "mesh_file", impetus::mesh_seeds());
  write(folder / "protocol", impetus::protocol_seeds());
  write(folder / "scene", impetus::scene_seeds());
  write(folder / "study", impetus::study_seeds());
  write(folder / "tracker", impetus::tracker_seeds());
  write(folder / "tree_file", impetus::tree_seeds());
  return 0;
}
