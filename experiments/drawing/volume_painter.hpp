// Draws volumes of every kind, solid or as a clear shell.
//
// A shell is drawn in two passes, the depths of all volumes first and then the nearest surface at
// every pixel: so nothing has to be sorted, and no volume shows through another.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "engine/scheduling/viewer.hpp"
#include "experiments/drawing/rounded_box_mesh.hpp"

namespace impetus::inline drawing {

struct ColouredVolume {
  RoundedBox shape;               ///< in world
  std::array<float, 3> colour{};  ///< sRGB, 0–1
};

class VolumePainter {
 public:
  /// Needs a current OpenGL 3.3 context, now and for every call.
  VolumePainter();
  ~VolumePainter();
  VolumePainter(const VolumePainter&) = delete;
  VolumePainter& operator=(const VolumePainter&) = delete;

  /// Draws into the current target and viewport, which the viewer's screen fills exactly and is
  /// `height_px` high, where nothing is in front. `opacity` 1 is solid.
  void paint(const std::vector<ColouredVolume>& volumes, const Viewer& viewer, int height_px,
             float opacity);

 private:
  /// One mesh on the graphics card, from coarse to fine.
  struct Uploaded {
    unsigned arrangement{0};
    std::array<unsigned, 2> buffers{};
    int indices{0};
  };
  static constexpr std::array<int, 5> kParts{1, 2, 4, 8, 14};

  static Uploaded upload(int parts, unsigned instances);

  unsigned program_{0};
  unsigned instances_{0};
  std::array<Uploaded, kParts.size()> meshes_;
};

}  // namespace impetus::inline drawing
