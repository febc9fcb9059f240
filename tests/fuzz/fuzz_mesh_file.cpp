// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "experiments/files/mesh_file.hpp"
#include "experiments/models/mesh_report.hpp"
#include "tests/fuzz/targets.hpp"

namespace impetus {
namespace {

constexpr std::array<const char*, 5> kExtensions{".obj", ".ply", ".stl", ".off", ".gltf"};
constexpr std::size_t kLargestReported = 2000;  ///< triangles: a report of more is only slow

}  // namespace

void fuzz_mesh_file(std::string_view bytes) {
  if (bytes.empty()) {
    return;
  }
  const std::size_t format = static_cast<unsigned char>(bytes.front()) % kExtensions.size();
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() /
      ("impetus-fuzz-" + std::to_string(getpid()) + kExtensions[format]);
  std::ofstream(file, std::ios::binary)
      .write(bytes.data() + 1, static_cast<std::streamsize>(bytes.size() - 1));
  try {
    const TriangleMesh mesh = load_mesh(file);
    if (mesh.triangles.size() < kLargestReported) {
      report_mesh(mesh);
    }
  } catch (const std::runtime_error& error) {
    if (std::string(error.what()).find(file.string()) == std::string::npos) {
      std::abort();  // a refusal names the file
    }
  }
  std::filesystem::remove(file);
}

}  // namespace impetus
