// SPDX-License-Identifier: MIT
#include "experiments/models/mesh_file.hpp"

#include <cstdint>
#include <new>
#include <stdexcept>
#include <string>

#include "experiments/models/child_process.hpp"
#include "experiments/models/mesh_bytes.hpp"
#include "experiments/models/mesh_parsing.hpp"
#include "experiments/models/readable_file.hpp"

namespace impetus::inline models {
namespace {

/// What the largest sensible file of this size could take.
ChildLimits limits_of(const std::filesystem::path& file) {
  constexpr std::uint64_t kLeastS = 10;
  constexpr std::uint64_t kLeastBytesPerS = 1'000'000;
  constexpr std::uint64_t kLeastBytes = 2'000'000'000;
  constexpr std::uint64_t kMostBytesPerByte = 30;
  const std::uint64_t size = std::filesystem::file_size(file);
  return {static_cast<int>(kLeastS + size / kLeastBytesPerS),
          kLeastBytes + size * kMostBytesPerByte};
}

enum class Outcome : std::uint8_t { kMesh, kRefused };

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
  throw std::runtime_error(file.string() + ": " + problem);
}

std::string refused(const std::string& sentence) {
  std::string bytes;
  append_number(bytes, static_cast<std::uint8_t>(Outcome::kRefused));
  return bytes + sentence;
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
  } catch (const std::bad_alloc&) {
    bytes = refused(file.string() +
                    ": cannot be read as a mesh: it needs more memory than a mesh of its size");
  } catch (const std::exception& error) {
    bytes = refused(error.what());
  }
  return bytes;
}

}  // namespace

TriangleMesh load_mesh(const std::filesystem::path& file) {
  if (const std::string problem = reading_problem(file); !problem.empty()) {
    refuse(file, problem);
  }
  const auto bytes = done_by_child([&] { return parsed(file); }, limits_of(file));
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

}  // namespace impetus::inline models
