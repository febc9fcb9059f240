// SPDX-License-Identifier: MIT
#include "experiments/scenes/figures/scene_figures.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/scenes/engine_setup.hpp"
#include "experiments/scenes/figures/figure_making.hpp"

namespace impetus::inline scenes {
namespace {

/// Makes figures of one file and height: a named one, or each of a crowd.
class FigureMaker {
 public:
  FigureMaker(const Scene& scene, const FigureMaking& making, const ShapeFrame& frame,
              ShapeLibrary& library)
      : scene_(&scene),
        making_(&making),
        settings_(&scene.figure_files.at(making.figure)),
        frame_(frame),
        library_(&library) {}

  /// `traits` are those of all parts but their names and colours.
  Figure& add(const BodyTraits& traits, const std::vector<Colour>& colours,
              SceneBodies& bodies) const {
    Figure figure;
    figure.name = traits.name;
    figure.first_part = static_cast<std::int32_t>(bodies.models.size());
    figure.part_count = static_cast<std::int32_t>(settings_->parts.size());
    for (std::size_t part = 0; part < settings_->parts.size(); ++part) {
      add_part(settings_->parts[part], traits, colours, bodies);
      if (part > 0) {
        figure.hinges.push_back(part_hinge(*settings_, part, figure.first_part, height_m()));
      }
    }
    figure.self_collision = making_->self_collision;
    bodies.figures.push_back(std::move(figure));
    return bodies.figures.back();
  }

  [[nodiscard]] JointMotion motion(const NamedFigure& entry) const {
    JointMotion motion = joint_motion(*settings_, settings_->motions->at(*entry.motion), height_m(),
                                      joint_angles(*settings_, entry.angles_deg));
    motion.root.start = {frame_.metres_per_degree * entry.position_deg, entry.orientation};
    motion.root.velocity_m_s =
        frame_.metres_per_degree * entry.path_deg_s.value_or(Vector3(Vector3::Zero()));
    return motion;
  }

 private:
  [[nodiscard]] double height_m() const { return making_->height_deg * frame_.metres_per_degree; }

  void add_part(const PartSettings& part, BodyTraits traits, const std::vector<Colour>& colours,
                SceneBodies& bodies) const {
    traits.name += "/" + part.name;
    traits.colour = colours[part.colour % colours.size()];
    const ShapeSettings shape = part_shape(part, making_->height_deg, making_->sphere_first);
    add_body(traits,
             library_->shape(shape, scene_->meshes,
                             {frame_.metres_per_degree, part_tree(part, frame_.tree)}),
             part.name, bodies);
  }

  const Scene* scene_;
  const FigureMaking* making_;
  const FigureSettings* settings_;
  ShapeFrame frame_;
  ShapeLibrary* library_;
};

}  // namespace

void add_figures(const Scene& scene, const ShapeFrame& frame, ShapeLibrary& library,
                 SceneBodies& bodies) {
  if (scene.figure_crowd) {
    const FigureCrowd& crowd = *scene.figure_crowd;
    const FigureMaker maker(scene, crowd.making, frame, library);
    BodyTraits traits{"", {}, crowd.density_kg_m3, material_number(scene, crowd.material)};
    for (std::size_t i = 0; i < crowd.count; ++i) {
      traits.name = std::to_string(i + 1);
      maker.add(traits, {crowd.colours[i % crowd.colours.size()]}, bodies);
    }
  }
  for (const NamedFigure& entry : scene.named_figures()) {
    const FigureMaker maker(scene, entry.making, frame, library);
    Figure& figure =
        maker.add({entry.name, {}, entry.density_kg_m3, material_number(scene, entry.material)},
                  entry.colours, bodies);
    if (entry.motion) {
      figure.driven = maker.motion(entry);
    }
  }
}

std::vector<BodyState> figure_states(const Scene& scene, const SceneBodies& bodies,
                                     double metres_per_degree, double step_s) {
  const Vector3 none = Vector3::Zero();
  std::vector<BodyState> states;
  const auto named = scene.named_figures();
  for (std::size_t i = 0; i < named.size(); ++i) {
    const NamedFigure& entry = named[i];
    const Figure& figure = bodies.figures[i];
    std::vector<BodyState> parts;
    if (figure.driven) {
      parts = driven_states(figure, bodies.models, 0.0, step_s);
    } else {
      const Pose root{metres_per_degree * entry.position_deg, entry.orientation};
      const std::vector<double> angles =
          joint_angles(scene.figure_files.at(entry.making.figure), entry.angles_deg);
      parts = states_of(figure, bodies.models, poses_of(figure, root, angles),
                        metres_per_degree * entry.velocity_deg_s.value_or(none),
                        kRadiansPerDegree * entry.spin_deg_s.value_or(none));
    }
    states.insert(states.end(), parts.begin(), parts.end());
  }
  return states;
}

bool are_neighbours(const Figure& figure, std::int32_t a, std::int32_t b) {
  return std::any_of(figure.hinges.begin(), figure.hinges.end(), [&](const Hinge& hinge) {
    return (hinge.child == a && hinge.parent == b) || (hinge.child == b && hinge.parent == a);
  });
}

bool leaves_out(const Figure& figure, std::int32_t a, std::int32_t b) {
  return figure.has_part(a) && figure.has_part(b) &&
         (!figure.self_collision.others || are_neighbours(figure, a, b));
}

const Hinge* folded_hinge(const Figure& figure, const std::vector<Pose>& poses) {
  if (!figure.self_collision.neighbours) {
    return nullptr;
  }
  const auto pose = [&](std::int32_t body) -> const Pose& {
    return poses[static_cast<std::size_t>(body - figure.first_part)];
  };
  const auto found = std::find_if(
      figure.hinges.begin(), figure.hinges.end(),
      [&](const Hinge& hinge) { return is_folded(hinge, pose(hinge.child), pose(hinge.parent)); });
  return found == figure.hinges.end() ? nullptr : &*found;
}

}  // namespace impetus::inline scenes
