// The shape of a body, as scenes and figures say it: its kind, and the measures of its kind.
//
// A scene's measures are degrees ("radius_deg"), a figure's are shares of its height
// ("radius_share"): the same rows, with another suffix and another range. In a scene with a plane,
// measures may be pixels of it ("radius_px").
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "engine/shapes/solids/prism_meshes.hpp"
#include "experiments/scenes/scene_problems.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline scenes {

/// The shapes that a body can have.
enum class ShapeKind {
  kSphere,
  kDisc,  ///< flat, across z; it collides as the sphere of its radius
  kBox,
  kPlate,   ///< a box that is thin along z
  kLBlock,  ///< two arms of a square section
  kTorus,
  kKnot,            ///< a tube along a trefoil
  kCreature,        ///< from snout to tail along x
  kLineSwept,       ///< a sphere swept along a line
  kRectangleSwept,  ///< a sphere swept over a rectangle
  kPrism,           ///< on an outline, along z
  kMesh,            ///< from a file
};

/// Of a prism's section: to the right and up.
using OutlineCorners = std::vector<std::array<double, 2>>;

/// Measures that the kind has not are left out.
struct ShapeSettings {
  ShapeKind kind{ShapeKind::kSphere};
  std::optional<std::string> file;
  std::optional<OutlineCorners> outline;  ///< of a prism
  std::optional<double> size;             ///< of a mesh, its longest side
  std::optional<double> radius;
  std::optional<double> width;
  std::optional<double> height;
  std::optional<double> depth;
  std::optional<double> arm;
  std::optional<double> thickness;
  std::optional<double> tube;
  std::optional<double> length;
  std::optional<int> resolution;
  std::optional<bool> sphere_first;  ///< "coarsest": level 0 is the sphere about what is swept
  std::optional<bool> deeper;
  bool has_px{false};   ///< some measures were said in pixels
  bool has_deg{false};  ///< some in degrees

  [[nodiscard]] bool is_swept() const {
    return kind == ShapeKind::kLineSwept || kind == ShapeKind::kRectangleSwept;
  }

 private:
  [[nodiscard]] auto members() const {
    return std::tie(kind, file, outline, size, radius, width, height, depth, arm, thickness, tube,
                    length, resolution, sphere_first, deeper);
  }

 public:
  friend bool operator==(const ShapeSettings&, const ShapeSettings&) = default;
  /// Any order, for containers.
  friend bool operator<(const ShapeSettings& a, const ShapeSettings& b) {
    return a.members() < b.members();
  }
};

/// A number of a shape that grows with it.
struct ShapeMeasure {
  const char* name;  ///< without "_deg" or "_share"
  std::optional<double> ShapeSettings::*place;
  const char* meaning;
};
const std::vector<ShapeMeasure>& shape_measures();

/// A prism's outline as the mesh is made of it. Precondition: it has one.
std::vector<OutlinePoint> outline_of(const ShapeSettings& shape);

/// "_px" or "_deg": what the measures of a scene's shape were said in.
std::string suffix_of(const ShapeSettings& shape);

/// Every measure times `factor`.
ShapeSettings scaled(ShapeSettings shape, double factor);

Kind<ShapeSettings> scene_shape_kind();
Kind<ShapeSettings> figure_shape_kind();

/// What a shape is called by its kind.
const std::string& name_of(ShapeKind kind);

/// The content of a mesh file, as a scene holds it.
struct MeshSettings {
  std::uint64_t vertices{0};
  std::uint64_t triangles{0};
  std::string hash;
  std::string base64;
};
using Meshes = std::map<std::string, MeshSettings>;  ///< by file

/// Adds what is wrong with the shape at `place` beyond the schema, at most one problem: each kind
/// needs its own measures and takes no other's; `resolution` is for kinds whose fineness is a
/// choice; a mesh is among `meshes`. `suffix` is that of the measures.
void add_shape_problems(const ShapeSettings& shape, const Meshes& meshes, const std::string& place,
                        const std::string& suffix, SceneProblems& problems);

}  // namespace impetus::inline scenes
