// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/scene_figures.hpp"

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/scenes/figures/figure_files.hpp"
#include "experiments/scenes/figures/figure_motion.hpp"
#include "experiments/scenes/figures/figure_parts.hpp"
#include "experiments/scenes/scene_settings.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

/// What is made of one entry: a named figure, or each of a crowd.
struct FigureTraits {
  std::string name;
  std::vector<std::string> colours;
  int material{0};
};

/// A figure of which all scenes' keys are known: "figure", "height_deg", "density_kg_m3", ...
class FigureMaker {
 public:
  FigureMaker(const json& scene, const json& entry, const ShapeFrame& frame, ShapeLibrary& library)
      : entry_(&entry),
        figure_(&figure_content(scene, entry["figure"].get<std::string>())),
        meshes_(scene.value("meshes", json::object())),
        frame_(frame),
        library_(&library) {}

  void add(const FigureTraits& traits, SceneBodies& bodies) const {
    Figure figure;
    figure.name = traits.name;
    figure.first_part = static_cast<std::int32_t>(bodies.models.size());
    figure.part_count = static_cast<std::int32_t>((*figure_)["parts"].size());
    for (std::size_t part = 0; part < (*figure_)["parts"].size(); ++part) {
      add_part(part, traits, bodies);
      if (part > 0) {
        figure.hinges.push_back(part_hinge(*figure_, part, figure.first_part, height_m()));
      }
    }
    const json self = entry_->value("self_collision", json::object());
    figure.self_collision.others = self.value("others", figure.self_collision.others);
    figure.self_collision.neighbours = self.value("neighbours", figure.self_collision.neighbours);
    if (entry_->contains("motion")) {
      figure.driven = motion();
    }
    bodies.figures.push_back(std::move(figure));
  }

 private:
  [[nodiscard]] double height_m() const {
    return (*entry_)["height_deg"].get<double>() * frame_.metres_per_degree;
  }

  void add_part(std::size_t index, const FigureTraits& traits, SceneBodies& bodies) const {
    const json& part = (*figure_)["parts"][index];
    const json shape = part_shape(part, (*entry_)["height_deg"].get<double>(),
                                  entry_->value("coarsest", std::string()));
    const auto name = part["name"].get<std::string>();
    const std::size_t colour = part.value("colour", std::size_t{0}) % traits.colours.size();
    add_body(
        {traits.name + "/" + name, traits.colours[colour], (*entry_)["density_kg_m3"].get<double>(),
         traits.material},
        library_->shape(shape, meshes_, {frame_.metres_per_degree, part_tree(part, frame_.tree)}),
        name, bodies);
  }

  [[nodiscard]] JointMotion motion() const {
    const std::vector<double> angles =
        joint_angles(*figure_, entry_->value("angles_deg", json::object()));
    JointMotion motion =
        figure_motion(*figure_, (*entry_)["motion"].get<std::string>(), height_m(), angles);
    motion.root.start = {vector_of(*entry_, "position_deg", frame_.metres_per_degree),
                         orientation_of(*entry_)};
    motion.root.velocity_m_s = vector_of(*entry_, "path_deg_s", frame_.metres_per_degree);
    return motion;
  }

  const json* entry_;
  const json* figure_;
  json meshes_;
  ShapeFrame frame_;
  ShapeLibrary* library_;
};

}  // namespace

void add_figures(const json& scene, const ShapeFrame& frame, ShapeLibrary& library,
                 SceneBodies& bodies) {
  if (scene.contains("figure_crowd")) {
    const json& crowd = scene["figure_crowd"];
    const FigureMaker maker(scene, crowd, frame, library);
    const json& colours = crowd["colours"];
    for (std::size_t i = 0; i < crowd["count"].get<std::size_t>(); ++i) {
      maker.add({std::to_string(i + 1),
                 {colours[i % colours.size()].get<std::string>()},
                 material_of(scene, crowd)},
                bodies);
    }
  }
  const std::size_t named = scene.contains("figures") ? scene["figures"].size() : 0;
  for (std::size_t i = 0; i < named; ++i) {
    const json& entry = scene["figures"][i];
    FigureMaker(scene, entry, frame, library)
        .add({entry["name"].get<std::string>(), entry["colours"].get<std::vector<std::string>>(),
              material_of(scene, entry)},
             bodies);
  }
}

std::vector<BodyState> figure_states(const json& scene, const SceneBodies& bodies,
                                     double metres_per_degree, double step_s) {
  std::vector<BodyState> states;
  const std::size_t named = scene.contains("figures") ? scene["figures"].size() : 0;
  for (std::size_t i = 0; i < named; ++i) {
    const json& entry = scene["figures"][i];
    const Figure& figure = bodies.figures[i];
    std::vector<BodyState> parts;
    if (figure.driven) {
      parts = driven_states(figure, bodies.models, 0.0, step_s);
    } else {
      const Pose root{vector_of(entry, "position_deg", metres_per_degree), orientation_of(entry)};
      const json& content = figure_content(scene, entry["figure"].get<std::string>());
      const std::vector<double> angles =
          joint_angles(content, entry.value("angles_deg", json::object()));
      parts = states_of(figure, bodies.models, poses_of(figure, root, angles),
                        vector_of(entry, "velocity_deg_s", metres_per_degree),
                        vector_of(entry, "spin_deg_s", kRadiansPerDegree));
    }
    states.insert(states.end(), parts.begin(), parts.end());
  }
  return states;
}

}  // namespace impetus::inline scenes
