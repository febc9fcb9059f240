// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/figure_settings.hpp"

#include "experiments/scenes/engine_settings.hpp"

namespace impetus::inline scenes {
namespace {

Kind<Vector3> point_kind() {
  return defined("point", vector({-10, 10}),
                 "From the part's centre of mass, in the part's frame: right, up, forwards, as "
                 "shares of the figure's height.");
}

Kind<Vector3> direction_kind() {
  return defined("direction", vector({-1000, 1000}), "Of any length but 0, in the part's frame.");
}

Kind<double> angle_kind() { return defined("angle", number({-180, 180})); }

Kind<PartTree> part_tree_kind() {
  using T = PartTree;
  return object<T>(
      "A kind of volume tree of its own, in place of the engine's; never deeper than "
      "the engine's tree_depth. Of a swept sphere, below its volume.",
      {required("kind", &T::kind, kind_of_trees()), row("depth", &T::depth, whole<int>({0, 6})),
       row("branching", &T::branching, whole<int>({kLeastBranching, kGreatestBranching}))});
}

Kind<HingeSettings> hinge_kind() {
  using H = HingeSettings;
  return object<H>(
      "By which the part hangs from another; the root has none.",
      {required("name", &H::name, text(), "What scenes and motions call it."),
       required("parent", &H::parent, any_text(), "The name of an earlier part."),
       required("on_parent", &H::on_parent, point_kind()),
       required("on_part", &H::on_part, point_kind()), required("axis", &H::axis, direction_kind()),
       row("rest_deg", &H::rest_deg, angle_kind(),
           "Of the part's turn about the axis, from where its frame is its parent's; 0 when left "
           "out."),
       row("least_deg", &H::least_deg, angle_kind(),
           "Beside most_deg; both left out: it turns freely."),
       row("most_deg", &H::most_deg, angle_kind()),
       row("fold_deg", &H::fold_deg, number(above(0, 180)),
           "The two parts collide where the angle between their cores is smaller than at rest by "
           "more than this; left out: never."),
       row("core_of_parent", &H::core_of_parent, direction_kind(),
           "The direction of the parent's core, away from the hinge; from the hinge to the "
           "parent's centre when left out."),
       row("core_of_part", &H::core_of_part, direction_kind(), "Likewise of the part.")});
}

Kind<PartSettings> part_kind() {
  using P = PartSettings;
  return object<P>(
      "", {required("name", &P::name, text()), required("shape", &P::shape, figure_shape_kind()),
           row("colour", &P::colour, whole<std::size_t>({0, 1000}),
               "Which of the figure's colours in a scene, counted from 0 and round again; "
               "0 when left out."),
           row("tree", &P::tree, part_tree_kind()), row("hinge", &P::hinge, hinge_kind())});
}

Kind<WaveSettings> wave_kind() {
  using W = WaveSettings;
  return object<W>(
      "", {required("middle_deg", &W::middle_deg, angle_kind()),
           required("amplitude_deg", &W::amplitude_deg, number({0, 180})),
           row("phase", &W::phase, number({-1, 1}), "A share of a turn; 0 when left out."),
           row("cycles", &W::cycles, whole<int>({1, 100}), "In a period; 1 when left out.")});
}

Kind<MotionSettings> motion_kind() {
  using M = MotionSettings;
  const Kind<KeySettings> key = object<KeySettings>(
      "", {required("time_s", &KeySettings::time_s, number({0, 3600})),
           required("angles_deg", &KeySettings::angles_deg, by_name(angle_kind()))});
  return object<M>(
      "", {row("period_s", &M::period_s, number({0.01, 1000}), "Of waves; 1 when left out."),
           row("bob_share", &M::bob_share, point_kind(),
               "The root swings by this twice a period, as hips do in a walk; shares of the "
               "height."),
           row("root_spin_deg_s", &M::root_spin_deg_s, vector({-10000, 10000}),
               "The root turns steadily, about the world's axes."),
           row("waves", &M::waves, by_name(wave_kind()),
               "By joint: middle + amplitude sin(2π (cycles t / period + phase))."),
           row("keys", &M::keys, list(key, {2, 10000}),
               "In place of waves: recorded angles at rising times, from 0 on, and smoothly "
               "between them."),
           row("repeats", &M::repeats, flag(),
               "Of keys: after the last it goes on from the first, which equals it; false when "
               "left out.")});
}

}  // namespace

std::size_t FigureSettings::part_named(const std::string& name) const {
  std::size_t part = 0;
  while (part < parts.size() && parts[part].name != name) {
    ++part;
  }
  return part;
}

std::size_t FigureSettings::joint_named(const std::string& name) const {
  std::size_t joint = 0;
  while (joint + 1 < parts.size() && parts[joint + 1].hinge->name != name) {
    ++joint;
  }
  return joint;
}

const Kind<FigureSettings>& figure_kind() {
  using F = FigureSettings;
  static const Kind<F> kind = object<F>(
      "", rows_of_file<F>({required("parts", &F::parts, list(part_kind(), {1, 64}),
                                    "The root first, each other part after the one that it hangs "
                                    "from."),
                           row("motions", &F::motions, by_name(motion_kind()),
                               "By name, for scenes: sine waves of the joints' angles, or recorded "
                               "keys. A joint that is not named stays where the scene has it.")}));
  return kind;
}

OrderedJson figure_file_schema() {
  return file_schema("Impetus figure",
                     "Rigid parts joined by hinges into a tree, and how they may be moved. Lengths "
                     "are shares of the figure's height, which a scene states; frames of all parts "
                     "are alike where every hinge is at 0 degrees.",
                     figure_kind());
}

const nlohmann::json& figure_schema() {
  static const nlohmann::json schema = figure_file_schema();
  return schema;
}

std::string figure_place(const std::string& file) {
  return (nlohmann::json::json_pointer("/figure_files") / file).to_string();
}

std::string part_place(const std::string& file, std::size_t part) {
  return figure_place(file) + "/parts/" + std::to_string(part);
}

}  // namespace impetus::inline scenes
