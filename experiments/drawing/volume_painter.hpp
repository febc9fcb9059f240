// Draws volumes of every kind, solid or as a clear shell.
//
// A shell is drawn in two passes, the depths of all volumes first and then the nearest surface at
// every pixel: so nothing has to be sorted, and no volume shows through another.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "experiments/drawing/gl_parts.hpp"
#include "experiments/drawing/rounded_box_mesh.hpp"

namespace impetus::inline drawing {

/// A volume to be drawn.
struct ColouredVolume {
  RoundedBox shape;               ///< in world
  std::array<float, 3> colour{};  ///< sRGB, 0–1
};

/// Draws rounded boxes, each by a mesh as fine as its size asks for.
class VolumePainter {
 public:
  VolumePainter();

  /// Draws into the current target and viewport, which the viewer's screen fills exactly and is
  /// `height_px` high, where nothing is in front. `opacity` 1 is solid.
  void paint(const std::vector<ColouredVolume>& volumes, const Viewer& viewer, int height_px,
             float opacity);

 private:
  /// One mesh on the graphics card.
  struct Uploaded {
    GlName arrangement{GlName::Kind::kVertexArray};
    GlName vertices{GlName::Kind::kBuffer};
    GlName corners{GlName::Kind::kBuffer};
    int indices{0};
  };
  static constexpr std::array<int, 5> kParts{1, 2, 4, 8, 14};

  void upload(int parts, Uploaded& mesh) const;

  ShaderProgram program_;
  GlName instances_{GlName::Kind::kBuffer};
  std::array<Uploaded, kParts.size()> meshes_;  ///< from coarse to fine
};

}  // namespace impetus::inline drawing
