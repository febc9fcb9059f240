// SPDX-License-Identifier: MIT
#include "experiments/models/mesh_file.hpp"

#include <stdexcept>
#include <string>

#include "experiments/models/child_process.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/mesh_parsing.hpp"

namespace impetus {
namespace {

/// Seconds of computing that the largest sensible file of this size could take.
int longest_reading_s(const std::filesystem::path& file) {
  constexpr double kLeastS = 10.0;
  constexpr double kLeastBytesPerS = 1e6;
  return static_cast<int>(kLeastS +
                          static_cast<double>(std::filesystem::file_size(file)) / kLeastBytesPerS);
}

enum class Outcome : std::uint8_t { kMesh, kRefused };

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
  throw std::runtime_error(file.string() + ": " + problem);
}

/// The outcome, then the mesh or the sentence.
std::string parsed(const std::filesystem::path& file) {
  std::string bytes;
  try {
    const TriangleMesh mesh = parse_mesh(file);
    append_number(bytes, static_cast<std::uint8_t>(Outcome::kMesh));
    append_number(bytes, static_cast<std::uint64_t>(mesh.vertices.size()));
    append_number(bytes, static_cast<std::uint64_t>(mesh.triangles.size()));
    append_mesh(bytes, mesh);
  } catch (const std::exception& error) {
    bytes.clear();
    append_number(bytes, static_cast<std::uint8_t>(Outcome::kRefused));
    bytes += error.what();
  }
  return bytes;
}

}  // namespace

TriangleMesh load_mesh(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) {
    refuse(file, std::filesystem::exists(file) ? "is not a file" : "there is no such file");
  }
  const auto bytes = done_by_child([&] { return parsed(file); }, longest_reading_s(file));
  if (!bytes || bytes->empty()) {
    refuse(file, "cannot be read as a mesh: its reader broke down over it");
  }
  ByteReader reader(*bytes);
  if (reader.take<std::uint8_t>() == static_cast<std::uint8_t>(Outcome::kRefused)) {
    throw std::runtime_error(std::string(reader.take_bytes(reader.left())));
  }
  const auto vertices = reader.take<std::uint64_t>();
  return take_mesh(reader, {vertices, reader.take<std::uint64_t>()});
}

}  // namespace impetus
