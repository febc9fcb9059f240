// One condition's scene, ready to step and to draw.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/world.hpp"

namespace impetus {

/// How a body looks: a mesh in the body's frame, or a sphere of this radius (metres) when there is
/// none; colour sRGB, 0–1.
struct DrawnBody {
  std::string name;
  double radius_m{0.0};  ///< of the sphere, or of a ball about the origin that holds the mesh
  std::array<float, 3> colour{0.8F, 0.8F, 0.8F};
  std::shared_ptr<const TriangleMesh> mesh{};
};

struct StagedScene {
  World world;
  Viewer viewer;
  std::vector<DrawnBody> looks;  ///< one per body of the world
  double step_hz{240.0};
  double duration_s{0.0};       ///< from onset to the end of the stimulus, an imposed hold included
  double contact_s{0.0};        ///< when the bodies are to meet, from onset
  double intended_hold_s{0.0};  ///< the freeze at contact that the condition asks for
  bool no_spin{false};          ///< imposed: nothing turns
  double realised_hold_s{0.0};  ///< differs only when rounding to whole frames was allowed
};

}  // namespace impetus
