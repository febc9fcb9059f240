// The same surface in more triangles.
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "engine/shapes/triangle_mesh.hpp"

namespace impetus {

/// Every triangle split in four, in its plane.
inline TriangleMesh split_flat(const TriangleMesh& mesh) {
  TriangleMesh finer{mesh.vertices, {}};
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto next = static_cast<std::uint32_t>(finer.vertices.size());
    const auto [at, made] = middles.try_emplace(std::minmax(a, b), next);
    if (made) {
      finer.vertices.emplace_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
    }
    return at->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b);
    const std::uint32_t bc = middle(b, c);
    const std::uint32_t ca = middle(c, a);
    for (const auto& triangle : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
      finer.triangles.push_back(triangle);
    }
  }
  return finer;
}

}  // namespace impetus
