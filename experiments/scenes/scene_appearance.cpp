// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_appearance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "engine/numerics/elementary_functions.hpp"

namespace impetus::inline scenes {
namespace {

/// Shadows reach as far as this from the origin, whatever flies further, so that their edges stay
/// as fine as the screen's pixels.
constexpr double kMostShadowReach_m = 1.5;

Vector3 direction_of(const LightSettings& light) {
  const SineCosine round = sine_cosine_deg(light.azimuth_deg);
  const SineCosine raised = sine_cosine_deg(light.elevation_deg);
  return {raised.cosine * round.sine, raised.sine, raised.cosine * round.cosine};
}

/// The usual light shines from the viewer's upper left at the onset, and stays in the world.
std::vector<DistantLight> lights_of(const AppearanceSettings& settings, const Viewer& viewer) {
  std::vector<DistantLight> lights;
  if (!settings.lights) {
    const Vector3 seen = usual_light();
    const Vector3 backward = viewer.right.cross(viewer.up);
    lights.push_back({seen.x() * viewer.right + seen.y() * viewer.up + seen.z() * backward, 1.0});
    return lights;
  }
  for (const LightSettings& light : *settings.lights) {
    if (light.strength > 0.0) {
      lights.push_back({direction_of(light), light.strength});
    }
  }
  return lights;
}

double lowest_of(const DrawnBody& look, const Pose& pose) {
  if (!look.mesh) {
    return pose.position.y() - look.radius_m;
  }
  double lowest_m = std::numeric_limits<double>::infinity();
  for (const Vector3& vertex : look.mesh->vertices) {
    lowest_m = std::min(lowest_m, pose.transform(vertex).y());
  }
  return lowest_m;
}

double lowest_of(const StagedScene& staged) {
  double lowest_m = std::numeric_limits<double>::infinity();
  for (std::size_t body = 0; body < staged.looks.size(); ++body) {
    lowest_m = std::min(lowest_m, lowest_of(staged.looks[body], staged.world.states()[body].pose));
  }
  return lowest_m;
}

/// The height of what contact shadows fall on; none where there is neither ground nor cube.
std::optional<double> floor_of(const AppearanceSettings& settings, const StagedScene& staged,
                               double m_per_deg) {
  if (const ClosedCube* cube = closed_cube(staged.world.settings().enclosure)) {
    return -cube->half_edge_m;
  }
  if (settings.ground == GroundPattern::kNone) {
    return std::nullopt;
  }
  return settings.ground_deg ? *settings.ground_deg * m_per_deg : lowest_of(staged);
}

double mean_radius_m(const std::vector<DrawnBody>& looks) {
  double sum_m = 0.0;
  for (const DrawnBody& look : looks) {
    sum_m += look.radius_m;
  }
  return sum_m / static_cast<double>(looks.size());
}

/// What the screen shows at the origin's depth, all bodies at the onset, and the walls.
double shadow_reach_m(const StagedScene& staged) {
  const ScreenGeometry& screen = staged.viewer.screen;
  double reach_m = 0.5 * std::hypot(screen.width_m, screen.height_m);
  for (std::size_t body = 0; body < staged.looks.size(); ++body) {
    reach_m = std::max(
        reach_m, staged.world.states()[body].pose.position.norm() + staged.looks[body].radius_m);
  }
  if (const ClosedCube* cube = closed_cube(staged.world.settings().enclosure)) {
    reach_m = std::max(reach_m, std::sqrt(3.0) * cube->half_edge_m);
  }
  return std::min(reach_m, kMostShadowReach_m);
}

bool has_texture(const Scene& scene) {
  const auto named = scene.named_bodies();
  return scene.appearance.texture != SurfaceTexture::kNone ||
         std::any_of(named.begin(), named.end(), [](const BodySettings& body) {
           return body.texture.value_or(SurfaceTexture::kNone) != SurfaceTexture::kNone;
         });
}

/// Whether all is painted as in a scene that says nothing of it.
bool is_usual(const Scene& scene) {
  const AppearanceSettings& settings = scene.appearance;
  return settings.ground == GroundPattern::kNone && !settings.lights &&
         settings.cast_shadows == 0.0 && settings.contact_shadows == 0.0 && !has_texture(scene) &&
         settings.gloss == kUsualGloss && settings.smooth_below_deg == kUsualSmoothing_deg;
}

std::shared_ptr<const Appearance> appearance_of(const Scene& scene, double m_per_deg,
                                                const StagedScene& staged) {
  const AppearanceSettings& settings = scene.appearance;
  if (is_usual(scene)) {
    return nullptr;
  }
  constexpr double kReachInRadii = 0.7;
  auto appearance = std::make_shared<Appearance>();
  appearance->ground = settings.ground;
  appearance->ground_colour = settings.ground_colour;
  appearance->check_m = settings.check_deg * m_per_deg;
  appearance->floor_m = floor_of(settings, staged, m_per_deg);
  appearance->lights = lights_of(settings, staged.viewer);
  appearance->cast_shadows = settings.cast_shadows;
  appearance->contact_shadows = settings.contact_shadows;
  appearance->contact_reach_m = kReachInRadii * mean_radius_m(staged.looks);
  appearance->shadow_reach_m = shadow_reach_m(staged);
  appearance->texture = settings.texture;
  appearance->gloss = settings.gloss;
  appearance->smooth_below_deg = settings.smooth_below_deg;
  return appearance;
}

/// What gets one colour: a body, or a crowd's figure with all its parts.
struct ColouredThing {
  std::size_t first_body{0};
  std::size_t bodies{1};
  Vector3 place{Vector3::Zero()};
};

std::vector<ColouredThing> coloured_things(const Scene& scene, const StagedScene& staged) {
  std::vector<ColouredThing> things;
  const auto place = [&](std::size_t body) { return staged.world.states()[body].pose.position; };
  if (scene.figure_crowd) {
    for (const Figure& figure : staged.world.settings().figures) {
      const auto root = static_cast<std::size_t>(figure.first_part);
      things.push_back({root, static_cast<std::size_t>(figure.part_count), place(root)});
    }
    return things;
  }
  const std::size_t parts_begin =
      staged.world.settings().figures.empty() ? staged.looks.size() : scene.named_bodies().size();
  for (std::size_t body = 0; body < parts_begin; ++body) {
    things.push_back({body, 1, place(body)});
  }
  return things;
}

bool are_alike(const Colour& one, const Colour& other) {
  constexpr float kSame = 0.12F;  // in each channel
  return std::abs(one[0] - other[0]) < kSame && std::abs(one[1] - other[1]) < kSame &&
         std::abs(one[2] - other[2]) < kSame;
}

/// The colours of the things, no two alike, and where they are few the shipped scenes' own.
std::vector<Colour> palette_of(const std::vector<ColouredThing>& things,
                               const std::vector<DrawnBody>& looks) {
  constexpr std::size_t kFew = 6;
  constexpr std::array<Colour, kFew> kMore{{{0.85F, 0.51F, 0.23F},
                                            {0.23F, 0.50F, 0.77F},
                                            {0.35F, 0.64F, 0.41F},
                                            {0.71F, 0.37F, 0.65F},
                                            {0.83F, 0.71F, 0.24F},
                                            {0.29F, 0.66F, 0.66F}}};
  std::vector<Colour> palette;
  const auto add = [&](const Colour& colour) {
    if (std::none_of(palette.begin(), palette.end(),
                     [&](const Colour& known) { return are_alike(known, colour); })) {
      palette.push_back(colour);
    }
  };
  for (const ColouredThing& thing : things) {
    add(looks[thing.first_body].colour);
  }
  for (std::size_t more = 0; more < kFew && palette.size() < kFew; ++more) {
    add(kMore[more]);
  }
  return palette;
}

/// No two alike stand side by side: one thing after the other takes the colour whose nearest bearer
/// so far is farthest from it; of several that nobody bears yet, its own if it is among them, or
/// else the first.
void colour_apart(const Scene& scene, StagedScene& staged) {
  const std::vector<ColouredThing> things = coloured_things(scene, staged);
  const std::vector<Colour> palette = palette_of(things, staged.looks);
  std::vector<std::vector<Vector3>> bearers(palette.size());
  for (const ColouredThing& thing : things) {
    const auto nearest_bearer_m = [&](std::size_t colour) {
      double nearest_m = std::numeric_limits<double>::infinity();
      for (const Vector3& place : bearers[colour]) {
        nearest_m = std::min(nearest_m, (place - thing.place).norm());
      }
      return nearest_m;
    };
    std::size_t chosen = 0;
    while (!are_alike(palette[chosen], staged.looks[thing.first_body].colour)) {
      ++chosen;  // its own is in the palette, or one like it
    }
    for (std::size_t colour = 0; colour < palette.size(); ++colour) {
      if (nearest_bearer_m(colour) > nearest_bearer_m(chosen)) {
        chosen = colour;
      }
    }
    bearers[chosen].push_back(thing.place);
    for (std::size_t part = 0; part < thing.bodies; ++part) {
      staged.looks[thing.first_body + part].colour = palette[chosen];
    }
  }
}

}  // namespace

void apply_appearance(const Scene& scene, double metres_per_degree, StagedScene& staged) {
  if (scene.appearance.colours == ColourRule::kApart) {
    colour_apart(scene, staged);
  }
  staged.appearance = appearance_of(scene, metres_per_degree, staged);
}

void add_appearance_problems(const Scene& scene, SceneProblems& problems) {
  if (scene.enclosure && scene.appearance.ground != GroundPattern::kNone) {
    problems.add_got("/appearance/ground",
                     "expected \"none\" beside an enclosure, whose floor is the ground");
  }
}

}  // namespace impetus::inline scenes
