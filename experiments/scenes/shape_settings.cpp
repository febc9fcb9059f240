// SPDX-License-Identifier: MIT
#include "experiments/scenes/shape_settings.hpp"

#include <algorithm>
#include <exception>

#include "engine/shapes/solids/ring_meshes.hpp"
#include "experiments/scenes/scene_meshes.hpp"

namespace impetus::inline scenes {
namespace {

using S = ShapeSettings;
using Measures = std::vector<const char*>;

const std::string kOutline = "outline";  ///< with the suffix of the unit

/// What a kind is called, the measures that it needs, and the choices that it has.
struct KindOfShape {
  const char* name;
  Measures measures;
  bool has_resolution{false};
};

/// In the order of the enum. A mesh has a file, too.
const std::vector<KindOfShape>& kinds_of_shapes() {
  static const std::vector<KindOfShape> kinds{
      {"sphere", {"radius"}},
      {"disc", {"radius"}},
      {"box", {"width", "height", "depth"}},
      {"plate", {"width", "height", "thickness"}},
      {"l-block", {"arm", "thickness"}},
      {"torus", {"radius", "tube"}, true},
      {"knot", {"radius", "tube"}, true},
      {"creature", {"length"}, true},
      {"line-swept", {"length", "radius"}, true},
      {"rectangle-swept", {"width", "height", "radius"}, true},
      {"prism", {"thickness"}},
      {"mesh", {"size"}}};
  return kinds;
}

const KindOfShape& entry_of(ShapeKind kind) {
  return kinds_of_shapes()[static_cast<std::size_t>(kind)];
}

const ShapeMeasure& measure_named(const std::string& name) {
  const auto& all = shape_measures();
  return *std::find_if(all.begin(), all.end(),
                       [&](const ShapeMeasure& each) { return name == each.name; });
}

Kind<ShapeKind> kind_of_kind() {
  Names<ShapeKind> names;
  for (std::size_t i = 0; i < kinds_of_shapes().size(); ++i) {
    names.emplace_back(kinds_of_shapes()[i].name, static_cast<ShapeKind>(i));
  }
  return choice(names);
}

Kind<OutlineCorners> corners_kind(double most) {
  return list(several<2>(number({-most, most})), {3, 200});
}

/// A prism's outline said in one unit.
Row<S> outline_row(const std::string& suffix, double most, bool S::*has_unit) {
  return {kOutline + suffix, corners_kind(most),
          "Of a prism: the corners of its section, to the right and up, one after the other. The "
          "body's place is that of its centre of mass.",
          [has_unit, read = corners_kind(most).read](const nlohmann::json& value, S& shape) {
            shape.outline = read(value);
            shape.*has_unit = true;
          }};
}

/// A measure said in one unit, which is remembered in `has_unit`.
Row<S> measure_row(const ShapeMeasure& measure, const std::string& suffix, const Kind<double>& kind,
                   bool S::*has_unit) {
  const bool in_px = suffix == "_px";
  return {
      measure.name + suffix, kind,
      in_px ? "The same in pixels of the scene's plane." : measure.meaning,
      [place = measure.place, has_unit, read = kind.read](const nlohmann::json& value, S& shape) {
        shape.*place = read(value);
        shape.*has_unit = true;
      }};
}

/// Where a shape is said, and what is said of it.
class ShapeRules {
 public:
  ShapeRules(const S& shape, const std::string& place, const std::string& suffix,
             SceneProblems& problems)
      : shape_(&shape), place_(place), suffix_(suffix), problems_(&problems) {}

  /// Measures of the kind alone, and its choices. False when a problem was added, as below.
  bool keep_to_kind() {
    const KindOfShape& kind = entry_of(shape_->kind);
    std::vector<std::string> own;
    if (shape_->kind == ShapeKind::kMesh) {
      own.emplace_back("file");
    }
    if (shape_->kind == ShapeKind::kPrism) {
      own.push_back(kOutline + suffix_);
    }
    for (const char* measure : kind.measures) {
      own.push_back(measure + suffix_);
    }
    std::string names;
    for (const std::string& key : own) {
      if (!has(key)) {
        problems_->add_missing(place_, key, "for kind " + std::string(kind.name));
        return false;
      }
      names += ", " + key;
    }
    if (const std::size_t count = measures_said(); count != own.size()) {
      problems_->add(place_, "expected the measures of kind " + std::string(kind.name) + " alone" +
                                 names + ", got " + std::to_string(count));
      return false;
    }
    return keep_to_choices(kind);
  }

  /// Measures that, each allowed by itself, make a solid together.
  bool fit_together() {
    switch (shape_->kind) {
      case ShapeKind::kLBlock:
        return is_less("thickness", "arm");
      case ShapeKind::kPlate:
        return is_less("thickness", "width") && is_less("thickness", "height");
      case ShapeKind::kTorus:
        return is_less("tube", "radius");
      case ShapeKind::kKnot:
        if (*shape_->tube > kThickestKnot * *shape_->radius) {
          add_got("tube", "expected at most a quarter of radius" + suffix_ +
                              ", or the knot would touch itself");
          return false;
        }
        return true;
      case ShapeKind::kPrism:
        return has_an_outline();
      default:
        return true;
    }
  }

  /// A mesh is known by its content: a file may change after a scene was recorded.
  void have_content(const Meshes& meshes) {
    const std::string& file = *shape_->file;
    if (!meshes.contains(file)) {
      problems_->add_got(place_ + "/file", "expected a mesh whose content the scene holds");
      return;
    }
    try {
      mesh_content(meshes, file);
    } catch (const std::exception& error) {
      problems_->add(place_ + "/file",
                     std::string(error.what()) + " for " + nlohmann::json(file).dump());
    }
  }

 private:
  [[nodiscard]] bool has(const std::string& key) const {
    return key == "file" ? shape_->file.has_value()
           : key == kOutline + suffix_
               ? shape_->outline.has_value()
               : (shape_->*measure_named(key.substr(0, key.size() - suffix_.size())).place)
                     .has_value();
  }

  /// File and outline counted.
  [[nodiscard]] std::size_t measures_said() const {
    const auto& all = shape_measures();
    const auto said = std::count_if(all.begin(), all.end(), [&](const ShapeMeasure& each) {
      return (shape_->*each.place).has_value();
    });
    return static_cast<std::size_t>(said) + (shape_->file ? 1 : 0) + (shape_->outline ? 1 : 0);
  }

  bool keep_to_choices(const KindOfShape& kind) {
    const bool swept = shape_->is_swept();
    return has_only("resolution", shape_->resolution.has_value(), kind.has_resolution) &&
           has_only("coarsest", shape_->sphere_first.has_value(), swept) &&
           has_only("deeper", shape_->deeper.has_value(), swept);
  }

  bool has_only(const std::string& key, bool is_said, bool may_be_said) {
    if (is_said && !may_be_said) {
      problems_->add_got(place_ + "/" + key, "expected none for kind " + name_of(shape_->kind));
    }
    return !is_said || may_be_said;
  }

  bool has_an_outline() {
    const std::string problem = problem_of(outline_of(*shape_));
    if (!problem.empty()) {
      problems_->add(place_ + "/" + kOutline + suffix_, problem);
    }
    return problem.empty();
  }

  bool is_less(const std::string& measure, const std::string& limit) {
    const bool less =
        *(shape_->*measure_named(measure).place) < *(shape_->*measure_named(limit).place);
    if (!less) {
      add_got(measure, "expected less than " + limit + suffix_);
    }
    return less;
  }

  void add_got(const std::string& measure, const std::string& message) {
    problems_->add_got(place_ + "/" + measure + suffix_, message);
  }

  const S* shape_;
  std::string place_;
  std::string suffix_;
  SceneProblems* problems_;
};

}  // namespace

const std::vector<ShapeMeasure>& shape_measures() {
  static const std::vector<ShapeMeasure> measures{
      {"size", &S::size, "Of a mesh: its longest side along x, y or z."},
      {"radius", &S::radius,
       "Of a sphere, a disc, or of a sphere that sweeps; of the circle along a torus; from a "
       "knot's "
       "axis to its "
       "curve at most."},
      {"width", &S::width,
       "Of a box, a plate or the rectangle along which a sphere is swept, along x."},
      {"height", &S::height,
       "Of a box, a plate or the rectangle along which a sphere is swept, along y."},
      {"depth", &S::depth, "Of a box, along z."},
      {"arm", &S::arm, "Of an L-block: the length of both arms."},
      {"thickness", &S::thickness,
       "Of an L-block: the side of its square section. Of a plate or a prism, along z."},
      {"tube", &S::tube,
       "The radius of a torus' section, less than radius_deg; of a knot's, at most a quarter of "
       "it."},
      {"length", &S::length,
       "Of a creature, from snout to tail along x; of the line along which a sphere is swept, "
       "along y."}};
  return measures;
}

std::vector<OutlinePoint> outline_of(const ShapeSettings& shape) {
  std::vector<OutlinePoint> outline;
  for (const auto& [x, y] : *shape.outline) {
    outline.emplace_back(x, y);
  }
  return outline;
}

std::string suffix_of(const ShapeSettings& shape) { return shape.has_px ? "_px" : "_deg"; }

ShapeSettings scaled(ShapeSettings shape, double factor) {
  for (const ShapeMeasure& each : shape_measures()) {
    if (auto& measure = shape.*each.place) {
      *measure = factor * *measure;
    }
  }
  if (shape.outline) {
    for (auto& corner : *shape.outline) {
      corner = {factor * corner[0], factor * corner[1]};
    }
  }
  return shape;
}

Kind<ShapeSettings> scene_shape_kind() {
  RowList<S> rows{
      required("kind", &S::kind, kind_of_kind()),
      row("file", &S::file, text(),
          "Of a mesh: an OBJ, PLY, STL, OFF or glTF file of a closed surface, seen from the "
          "scene's folder and within it.")};
  for (const ShapeMeasure& each : shape_measures()) {
    rows.append(measure_row(each, "_deg", number(above(0, 45)), &S::has_deg));
  }
  for (const ShapeMeasure& each : shape_measures()) {
    rows.append(measure_row(each, "_px", number(above(0, 1e5)), &S::has_px));
  }
  rows.append(outline_row("_deg", 45.0, &S::has_deg));
  rows.append(outline_row("_px", 1e5, &S::has_px));
  rows.append(
      row("resolution", &S::resolution, whole<int>({4, 12}),
          "Sides of a torus' (10) or a knot's (8) tube; a quarter of the grid's cells along a "
          "creature (4); of a swept sphere, that of 20 or so sides (4) to 84 (12). Triangles grow "
          "with its square."));
  rows.append(row("coarsest", &S::sphere_first, choice<bool>({{"volume", false}, {"sphere", true}}),
                  "What a swept sphere is at level 0 of its tree. volume, when left out: "
                  "exactly what is swept. sphere: the sphere about it; the volume is level 1."));
  rows.append(row("deeper", &S::deeper, flag(),
                  "Of a swept sphere: below the volume its tree has the levels of the engine's "
                  "kind of tree, too, to tree_depth; false when left out."));
  return defined("shape", object<S>("", rows));
}

Kind<ShapeSettings> figure_shape_kind() {
  const Kind<double> measure = defined("measure", number(above(0, 10)));
  RowList<S> rows{
      required("kind", &S::kind, kind_of_kind()),
      row("file", &S::file, text(), "Of a mesh, seen from the scene's folder and within it.")};
  for (const ShapeMeasure& each : shape_measures()) {
    rows.append(row(each.name + std::string("_share"), each.place, measure));
  }
  rows.append(row(kOutline + "_share", &S::outline, corners_kind(10.0)));
  rows.append(row("resolution", &S::resolution, whole<int>({4, 12})));
  rows.append(
      row("coarsest", &S::sphere_first, choice<bool>({{"volume", false}, {"sphere", true}})));
  rows.append(row("deeper", &S::deeper, flag()));
  return defined("shape", object<S>("", rows),
                 "As in scenes, its measures shares of the figure's height.");
}

const std::string& name_of(ShapeKind kind) {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const KindOfShape& each : kinds_of_shapes()) {
      all.emplace_back(each.name);
    }
    return all;
  }();
  return names[static_cast<std::size_t>(kind)];
}

void add_shape_problems(const ShapeSettings& shape, const Meshes& meshes, const std::string& place,
                        const std::string& suffix, SceneProblems& problems) {
  if (shape.has_px && shape.has_deg) {
    problems.add(place, "expected all measures in degrees, or all in pixels, got both");
    return;
  }
  ShapeRules rules(shape, place, suffix, problems);
  if (rules.keep_to_kind() && rules.fit_together() && shape.kind == ShapeKind::kMesh) {
    rules.have_content(meshes);
  }
}

}  // namespace impetus::inline scenes
