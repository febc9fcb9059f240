// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene.hpp"

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/scenes/meeting_rows.hpp"
#include "experiments/scenes/plane/plane_rows.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

Kind<std::vector<Colour>> colours_kind() { return list(colour_kind(), {1, -1}); }

/// A turn about one of the world's axes.
struct Turn {
  int axis{0};
  double angle_deg{0.0};
};

Quaternion turned(const std::vector<Turn>& turns) {
  Quaternion orientation = Quaternion::Identity();
  for (const Turn& turn : turns) {
    orientation = turn_about(turn.axis, turn.angle_deg) * orientation;
  }
  return orientation;
}

/// One after the other.
Kind<Quaternion> turns_kind() {
  const Kind<std::vector<Turn>> turns = list(
      object<Turn>("", {required("axis", &Turn::axis, choice<int>({{"x", 0}, {"y", 1}, {"z", 2}})),
                        required("angle_deg", &Turn::angle_deg, number({-360, 360}))}),
      {});
  return {turns, [read = turns.read](const json& value) { return turned(read(value)); }};
}

Kind<double> density_kind() { return defined("density", number(above(0, 1e6))); }

Kind<MeshSettings> mesh_kind() {
  using M = MeshSettings;
  const Kind<std::string> hash{{{{"type", "string"}, {"minLength", 32}, {"maxLength", 32}}},
                               any_text().read};
  return object<M>("", {required("vertices", &M::vertices, whole<std::uint64_t>({1, 1e8})),
                        required("triangles", &M::triangles, whole<std::uint64_t>({1, 1e8})),
                        required("hash", &M::hash, hash),
                        required("base64", &M::base64, any_text(),
                                 "Coordinates (metres of the file, 64-bit floating point), then "
                                 "three vertices a triangle (32 bits), little-endian.")});
}

Kind<ViewerSettings> viewer_kind() {
  using V = ViewerSettings;
  return object<V>(
      "", {required("azimuth_deg", &V::azimuth_deg, number({-90, 90}),
                    "Angle between the line of approach (the x axis) and the image plane."),
           row("elevation_deg", &V::elevation_deg, number({0, 80}),
               "How far the eye is raised, to look down at the scene: a ground needs it, which is "
               "seen from its edge at 0; 0 when left out."),
           row("turn_deg_s", &V::turn_deg_s, number({-360, 360}),
               "The eye goes round the vertical at this rate, from azimuth_deg, anticlockwise seen "
               "from above; 0 when left out.")});
}

Kind<BodySettings> body_kind() {
  using B = BodySettings;
  return object<B>(
      "",
      {required("name", &B::name, text()), required("shape", &B::shape, scene_shape_kind()),
       row("orientation", &B::orientation, turns_kind(),
           "Turns about the world's axes, one after the other."),
       row("position_deg", &B::position_deg, vector_kind(),
           "Of the centre of mass at the start; left out where the bodies meet."),
       row("velocity_deg_s", &B::velocity_deg_s, vector_kind()),
       row("spin_deg_s", &B::spin_deg_s, vector_kind(), "Angular velocity about the world's axes."),
       row("position_px", &B::position_px, several<2>(number({-1e5, 1e5})),
           "In the scene's plane, in place of position_deg."),
       row("velocity_px_s", &B::velocity_px_s, several<2>(number({-1e5, 1e5})),
           "In the scene's plane, in place of velocity_deg_s."),
       required("density_kg_m3", &B::density_kg_m3, density_kind()),
       row("fixed", &B::fixed, flag(),
           "Nothing moves or turns it; bodies that are fixed may overlap each other and the "
           "enclosure."),
       row("passes_through", &B::passes_through, flag(),
           "It touches nothing, as a curtain that hides what is behind it; false when left out."),
       row("material", &B::material, material_kind()),
       required("colour", &B::colour, colour_kind()),
       row("texture", &B::texture, texture_kind(), "In place of the appearance's.")});
}

/// How fast a crowd moves, and where it starts.
RowList<CrowdSettings> rows_of_start() {
  using C = CrowdSettings;
  return {required("speed_deg_s", &C::speed_deg_s, number({0, 1000})),
          required("spin_deg_s", &C::spin_deg_s, number({0, 10000})),
          row("start", &C::start, whole<std::uint64_t>({0, 1e6}),
              "Another number, another random start; 1 when left out.")};
}

Kind<BodyCrowd> crowd_kind() {
  using C = BodyCrowd;
  RowList<C> rows{required("count", &C::count, whole<std::size_t>({1, 1000})),
                  required("shape", &C::shape, scene_shape_kind()),
                  required("density_kg_m3", &C::density_kg_m3, density_kind()),
                  row("material", &C::material, material_kind()),
                  required("colours", &C::colours, colours_kind(), "Taken in turn.")};
  rows.append_base(rows_of_start());
  return object<C>(
      "Bodies alike but for their colour, at random places within the enclosure, with "
      "random directions and orientations; the same for every participant.",
      rows);
}

Kind<std::string> figure_file_kind() {
  return defined("figure_file", text(),
                 "A file with figure.schema.json, seen from the scene's folder and within it.");
}

Kind<double> figure_height_kind() {
  return defined("figure_height", number(above(0, 45)), "What the figure's lengths are shares of.");
}

Kind<bool> figure_coarsest_kind() {
  return defined("figure_coarsest", choice<bool>({{"volume", false}, {"sphere", true}}),
                 "What its swept parts are at level 0 of their trees, where the figure does not "
                 "say: volume, when left out, or sphere.");
}

Kind<SelfCollision> self_collision_kind() {
  using C = SelfCollision;
  return defined(
      "self_collision",
      object<C>("Which parts of one figure may collide with each other; both true when left out.",
                {row("others", &C::others, flag(), "Parts that no hinge joins."),
                 row("neighbours", &C::neighbours, flag(),
                     "Parts that a hinge joins, where it is folded past its threshold.")}));
}

Kind<NamedFigure> named_figure_kind() {
  using F = NamedFigure;
  using M = FigureMaking;
  return object<F>(
      "", {required("name", &F::name, text()),
           required("figure", &F::making, &M::figure, figure_file_kind()),
           required("height_deg", &F::making, &M::height_deg, figure_height_kind()),
           required("density_kg_m3", &F::density_kg_m3, density_kind()),
           row("material", &F::material, material_kind()),
           required("colours", &F::colours, colours_kind(),
                    "Of its parts, by their numbers in the figure."),
           row("coarsest", &F::making, &M::sphere_first, figure_coarsest_kind()),
           required("position_deg", &F::position_deg, vector_kind(),
                    "Of the root's centre of mass at the start."),
           row("orientation", &F::orientation, defined("turns", turns_kind()),
               "Of the root: turns about the world's axes, one after the other."),
           row("velocity_deg_s", &F::velocity_deg_s, vector_kind(),
               "Of a figure that moves freely, at its root."),
           row("spin_deg_s", &F::spin_deg_s, vector_kind(),
               "Of a figure that moves freely, as one rigid body at the start, about the world's "
               "axes."),
           row("angles_deg", &F::angles_deg, by_name(number({-180, 180})),
               "By joint, where it does not start at its rest angle."),
           row("motion", &F::motion, text(),
               "One of the figure's motions, which nothing disturbs; left out: it moves freely, as "
               "collisions and its hinges make it."),
           row("path_deg_s", &F::path_deg_s, vector_kind(),
               "Beside motion: the steady velocity of its root."),
           row("self_collision", &F::making, &M::self_collision, self_collision_kind())});
}

Kind<FigureCrowd> figure_crowd_kind() {
  using C = FigureCrowd;
  using M = FigureMaking;
  RowList<C> rows{required("figure", &C::making, &M::figure, figure_file_kind()),
                  required("count", &C::count, whole<std::size_t>({1, 100})),
                  required("height_deg", &C::making, &M::height_deg, figure_height_kind()),
                  required("density_kg_m3", &C::density_kg_m3, density_kind()),
                  row("material", &C::material, material_kind()),
                  required("colours", &C::colours, colours_kind(),
                           "Taken in turn, one for all parts of a figure."),
                  row("coarsest", &C::making, &M::sphere_first, figure_coarsest_kind())};
  rows.append_base(rows_of_start());
  rows.append(row("self_collision", &C::making, &M::self_collision, self_collision_kind()));
  return object<C>(
      "Figures alike but for their colour, that move freely: at random places within the "
      "enclosure, with random directions, orientations and joint angles; the same for every "
      "participant. They are called 1, 2, ...",
      rows);
}

const Names<EnclosureKind>& enclosure_names() {
  static const Names<EnclosureKind> names{{"closed-cube", EnclosureKind::kClosedCube},
                                          {"view-frustum", EnclosureKind::kViewFrustum}};
  return names;
}

Kind<EnclosureSettings> enclosure_kind() {
  using E = EnclosureSettings;
  return object<E>(
      "Walls that keep the bodies inside: a closed cube about the origin, or what the viewer sees "
      "through the screen.",
      {row("kind", &E::kind, choice(enclosure_names()),
           "closed-cube, when left out, needs edge_deg; view-frustum front_deg and back_deg."),
       row("material", &E::material, material_kind()),
       row("front_deg", &E::front_deg, number({0, 50}),
           "Of a view frustum: how far it reaches from the screen towards the eye, which is at "
           "57."),
       row("back_deg", &E::back_deg, number(above(0, 90)),
           "Of a view frustum: how far it reaches behind the screen."),
       row("edge_deg", &E::edge_deg, number(above(0, 90)), "Of a closed cube."),
       row("edge_at_count", &E::edge_at_count, whole<double>({1, 1000}),
           "The edge is for a crowd of so many and grows with the cube root of the count: density "
           "stays.")});
}

/// What was said in pixels of the plane, in degrees as well.
Scene in_degrees(Scene scene) {
  if (!scene.plane) {
    return scene;
  }
  const PlaneSettings& plane = *scene.plane;
  if (scene.crowd && scene.crowd->shape.has_px) {
    scene.crowd->shape = scaled(scene.crowd->shape, 1.0 / plane.px_per_deg);
  }
  if (!scene.bodies) {
    return scene;
  }
  for (BodySettings& body : *scene.bodies) {
    if (body.position_px) {
      body.position_deg = plane.place_deg(*body.position_px);
    }
    if (scene.launch && body.name == scene.launch->first && !body.position_deg) {
      body.position_deg = Vector3::Zero();  // until launch_of() knows its own
    }
    if (body.velocity_px_s) {
      const auto& [x, y] = *body.velocity_px_s;
      body.velocity_deg_s = Vector3(x, y, 0.0) / plane.px_per_deg;
    }
    if (body.shape.has_px) {
      body.shape = scaled(body.shape, 1.0 / plane.px_per_deg);
    }
  }
  return scene;
}

/// A figure's content is judged by a schema of its own.
Kind<FigureSettings> figure_content_kind() {
  return {{OrderedJson{{"type", "object"}}}, figure_kind().read};
}

const Kind<Scene>& scene_kind() {
  using S = Scene;
  static const Kind<S> kind = object<S>(
      "", rows_of_file<S>(RowList<S>{
              required("engine", &S::engine, engine_kind()),
              row("meshes", &S::meshes, by_name(mesh_kind()),
                  "The content of mesh files, by file: put in when a scene is read, so that a "
                  "recording holds all that it needs. A file that is here is not read."),
              required("viewer", &S::viewer, viewer_kind()), row("plane", &S::plane, plane_kind()),
              row("appearance", &S::appearance, appearance_kind()),
              row("bodies", &S::bodies, list(body_kind(), {1, 1000}),
                  "Named one by one: two that meet, or any number with positions of their own."),
              row("crowd", &S::crowd, crowd_kind()),
              row("figures", &S::figures, list(named_figure_kind(), {1, 100}),
                  "Articulated figures, beside bodies or alone: each part is a body, called "
                  "FIGURE/PART."),
              row("figure_crowd", &S::figure_crowd, figure_crowd_kind()),
              row("figure_files", &S::figure_files, by_name(figure_content_kind()),
                  "The content of figure files, by file: put in when a scene is read, so that a "
                  "recording holds all that it needs. A file that is here is not read."),
              row("enclosure", &S::enclosure, enclosure_kind()),
              row("duration_s", &S::duration_s, number(above(0, 3600)),
                  "Of the scene from where it begins to move, where nothing meets."),
              row("goal", &S::goal, goal_kind()), row("meeting", &S::meeting, meeting_kind()),
              row("launch", &S::launch, launch_kind()),
              row("distractors", &S::distractors, distractors_kind()),
              row("imposed", &S::imposed, imposed_kind()), row("sound", &S::sound, sound_kind()),
              row("sound_files", &S::sound_files, by_name(sound_content_kind()),
                  "The content of sound files, by file: put in when a scene is read, so that a "
                  "recording holds all that it needs. A file that is here is not read.")}
                              .append_within(&S::showing, showing_rows())));
  return kind;
}

}  // namespace

Scene::Scene(const json& valid) : Scene(in_degrees(scene_kind().read(valid))) {}

OrderedJson scene_file_schema() {
  return file_schema("Impetus scene",
                     "What is on show, in degrees of visual angle at the screen's centre. A "
                     "protocol's factors override any value by JSON Pointer.",
                     scene_kind());
}

const json& scene_schema() {
  static const json schema = scene_file_schema();
  return schema;
}

const std::vector<WithKey>& scene_with_keys() { return scene_kind().with; }

std::vector<FigureFile> named_figure_files(const Scene& scene) {
  std::vector<FigureFile> files;
  if (scene.figure_crowd) {
    files.push_back({"/figure_crowd/figure", scene.figure_crowd->making.figure});
  }
  const auto figures = scene.named_figures();
  for (std::size_t i = 0; i < figures.size(); ++i) {
    files.push_back({"/figures/" + std::to_string(i) + "/figure", figures[i].making.figure});
  }
  return files;
}

Quaternion turn_about(int axis, double angle_deg) {
  const SineCosine half = sine_cosine_deg(0.5 * angle_deg);
  Vector3 sines = Vector3::Zero();
  sines[axis] = half.sine;
  return {half.cosine, sines.x(), sines.y(), sines.z()};
}

const std::string& name_of(EnclosureKind kind) { return word_for(kind, enclosure_names()); }

}  // namespace impetus::inline scenes
