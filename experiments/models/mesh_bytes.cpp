// SPDX-License-Identifier: MIT
#include "experiments/models/mesh_bytes.hpp"

#include <xxhash.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace impetus::inline models {
namespace {

constexpr std::uint64_t kBytesOfVertex = 3 * sizeof(double);
constexpr std::uint64_t kBytesOfTriangle = 3 * sizeof(std::uint32_t);

Vector3 take_place(ByteReader& bytes, std::uint64_t vertex) {
  Vector3 place;
  for (int axis = 0; axis < 3; ++axis) {
    place[axis] = bytes.take<double>();
    if (!std::isfinite(place[axis])) {
      throw std::runtime_error("expected finite coordinates of the mesh, got none at vertex " +
                               std::to_string(vertex));
    }
  }
  return place;
}

}  // namespace

void append_mesh(std::string& bytes, const TriangleMesh& mesh) {
  for (const Vector3& vertex : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      append_number(bytes, vertex[axis]);
    }
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      append_number(bytes, corner);
    }
  }
}

TriangleMesh take_mesh(ByteReader& bytes, const MeshCounts& counts) {
  // Asked before any memory is taken: the counts may be anything.
  if (counts.vertices > bytes.left() / kBytesOfVertex ||
      counts.triangles > bytes.left() / kBytesOfTriangle) {
    throw std::out_of_range("expected bytes for " + std::to_string(counts.vertices) +
                            " vertices and " + std::to_string(counts.triangles) +
                            " triangles, got " + std::to_string(bytes.left()));
  }
  TriangleMesh mesh;
  mesh.vertices.reserve(static_cast<std::size_t>(counts.vertices));
  for (std::uint64_t vertex = 0; vertex < counts.vertices; ++vertex) {
    mesh.vertices.push_back(take_place(bytes, vertex));
  }
  mesh.triangles.resize(static_cast<std::size_t>(counts.triangles));
  for (auto& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      corner = bytes.take<std::uint32_t>();
      if (corner >= counts.vertices) {
        throw std::runtime_error("expected triangles of " + std::to_string(counts.vertices) +
                                 " vertices, got one that names vertex " + std::to_string(corner));
      }
    }
  }
  return mesh;
}

std::string content_hash(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text;
}

std::string content_hash(const TriangleMesh& mesh) {
  std::string bytes;
  append_number(bytes, static_cast<std::uint64_t>(mesh.vertices.size()));
  append_number(bytes, static_cast<std::uint64_t>(mesh.triangles.size()));
  append_mesh(bytes, mesh);
  return content_hash(bytes);
}

}  // namespace impetus::inline models
