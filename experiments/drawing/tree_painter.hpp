// Paints a volume tree and the mesh it bounds, turned as one likes: its level, what colours mean,
// and the numbers beside it.
//
// The object is shown at a size of its own, whatever its metres: its bounding sphere fills the
// picture at a zoom of 1.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/trees/level_quality.hpp"
#include "experiments/drawing/gl_parts.hpp"
#include "experiments/drawing/mesh_painter.hpp"
#include "experiments/drawing/volume_painter.hpp"

namespace impetus::inline drawing {

/// A tree and the mesh it bounds, in one frame, in metres.
struct ShownTree {
  std::string title;  ///< "dragon.obj · medial, depth 4, branching 8"
  TriangleMesh mesh;
  VolumeTree tree;
  std::vector<LevelQuality> quality;  ///< one per level; empty: not known
};

/// What the colour of a node tells: its level, the share of it that is solid, or the piece of
/// surface that it lies on.
enum class TreeColour { kLevel, kOccupancy, kGroup };

/// What is shown of a tree.
struct TreeLook {
  int level{0};
  TreeColour colour{TreeColour::kLevel};
  bool volumes{true};
  bool mesh{true};  ///< seen through the volumes, which are clear then

  friend bool operator==(const TreeLook&, const TreeLook&) = default;
};

/// One number of a level, and what it is.
struct LegendLine {
  std::string name;
  std::string value;
};

/// A level in numbers: those that are known.
std::vector<LegendLine> legend_of(const ShownTree& shown, int level);

/// How the object is held before the eye.
struct Orbit {
  Quaternion turn{initial_turn()};
  double zoom{1.0};

  static Quaternion initial_turn();

  /// Turns as if the object were dragged by so many pictures' heights, right and up.
  void drag(double right, double up);
  /// Closer by notches of the wheel, or away.
  void notch(double notches);

  friend bool operator==(const Orbit& one, const Orbit& other) {
    return one.turn.coeffs() == other.turn.coeffs() && one.zoom == other.zoom;
  }
};

/// Paints one tree, and only what has changed.
class TreePainter {
 public:
  /// `shown` must outlive it.
  explicit TreePainter(const ShownTree& shown);

  /// Paints the area of the window on a ground of a grey (sRGB, 0–1); what is as it was the last
  /// time costs next to nothing.
  void paint(const TreeLook& look, const Orbit& orbit, const PixelArea& area, float ground);

  /// Paints the current target, `width` × `height` pixels at 0, 0.
  void paint_here(const TreeLook& look, const Orbit& orbit, int width, int height, float ground);

 private:
  /// What the target holds.
  struct Painted {
    TreeLook look;
    Orbit orbit;
    int width{0};
    int height{0};
    float ground{0.0F};

    friend bool operator==(const Painted&, const Painted&) = default;
  };

  void choose(const TreeLook& look);

  const ShownTree& shown_;
  double scale_;  ///< of the object as shown
  Vector3 centre_;
  std::shared_ptr<const TriangleMesh> mesh_;  ///< as shown
  TreeLook chosen_;
  std::vector<ColouredVolume> volumes_;  ///< as shown, for `chosen_`
  VolumePainter volume_painter_;
  MeshPainter mesh_painter_;
  MultisampledTarget target_;
  Painted painted_;
};

}  // namespace impetus::inline drawing
