// SPDX-License-Identifier: MIT
#include "experiments/scenes/crowd.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "engine/volumes/volume.hpp"
#include "experiments/scenes/figures/scene_figures.hpp"
#include "experiments/scenes/random_places.hpp"

namespace impetus::inline scenes {
namespace {

/// A place where a ball is within the walls and apart from the bodies that have theirs.
std::optional<Vector3> free_place(const std::vector<BodyState>& placed, const Room& room,
                                  double radius_m, RandomStream& stream) {
  for (int draw = 0; draw < kMostDraws; ++draw) {
    const Vector3 place = draw_place(room, stream);
    if (room.walls != nullptr && reaches_wall(*room.walls, Sphere{place, radius_m})) {
      continue;
    }
    const bool apart = std::all_of(placed.begin(), placed.end(), [&](const BodyState& other) {
      return (other.pose.position - place).squaredNorm() > 4.0 * radius_m * radius_m;
    });
    if (apart) {
      return place;
    }
  }
  return std::nullopt;
}

/// A figure in a posture: its parts, their bounds, and a ball about the root that holds them.
struct Posture {
  std::vector<Pose> poses;
  std::vector<Volume> bounds;
  Vector3 middle{Vector3::Zero()};  ///< the root's centre of mass
  double radius_m{0.0};
};

double random_angle(const Hinge& hinge, RandomStream& stream) {
  const double least = std::max(hinge.least_rad, -std::numbers::pi);
  const double most = std::min(hinge.most_rad, std::numbers::pi);
  return least + (most - least) * stream.uniform();
}

Posture posture_of(const Figure& figure, const std::vector<BodyModel>& models,
                   std::vector<Pose> poses) {
  Posture posture;
  posture.middle = poses.front().position;
  for (std::size_t part = 0; part < poses.size(); ++part) {
    const BodyModel& model = models[static_cast<std::size_t>(figure.first_part) + part];
    posture.bounds.push_back(placed(model.tree->volume(0), poses[part]));
    const Sphere ball = bounding_sphere(posture.bounds.back());
    posture.radius_m =
        std::max(posture.radius_m, (ball.centre - posture.middle).norm() + ball.radius_m);
  }
  posture.poses = std::move(poses);
  return posture;
}

bool is_apart_from_itself(const Figure& figure, const Posture& posture) {
  if (folded_hinge(figure, posture.poses) != nullptr) {
    return false;
  }
  for (std::int32_t a = 0; a < figure.part_count; ++a) {
    for (std::int32_t b = a + 1; b < figure.part_count; ++b) {
      if (!leaves_out(figure, figure.first_part + a, figure.first_part + b) &&
          overlap(posture.bounds[static_cast<std::size_t>(a)],
                  posture.bounds[static_cast<std::size_t>(b)])) {
        return false;
      }
    }
  }
  return true;
}

bool overlap_anywhere(const Posture& a, const Posture& b) {
  const double reach_m = a.radius_m + b.radius_m;
  if ((a.middle - b.middle).squaredNorm() > reach_m * reach_m) {
    return false;
  }
  return std::any_of(a.bounds.begin(), a.bounds.end(), [&](const Volume& of_a) {
    return std::any_of(b.bounds.begin(), b.bounds.end(),
                       [&](const Volume& of_b) { return overlap(of_a, of_b); });
  });
}

/// Apart from itself, about the origin.
std::optional<Posture> random_posture(const Figure& figure, const std::vector<BodyModel>& models,
                                      RandomStream& stream) {
  for (int draw = 0; draw < kMostDraws; ++draw) {
    std::vector<double> angles;
    for (const Hinge& hinge : figure.hinges) {
      angles.push_back(random_angle(hinge, stream));
    }
    const Pose root{Vector3::Zero(), draw_orientation(stream)};
    Posture posture = posture_of(figure, models, poses_of(figure, root, angles));
    if (is_apart_from_itself(figure, posture)) {
      return posture;
    }
  }
  return std::nullopt;
}

Posture moved(const Figure& figure, const std::vector<BodyModel>& models, const Posture& posture,
              const Vector3& by) {
  std::vector<Pose> poses = posture.poses;
  for (Pose& pose : poses) {
    pose.position += by;
  }
  return posture_of(figure, models, std::move(poses));
}

/// Draws figures' postures and finds places for them in which nothing overlaps.
class Placer {
 public:
  Placer(const std::vector<BodyModel>& models, const Enclosure& enclosure)
      : models_(&models), enclosure_(&enclosure), room_(room_within(enclosure, 0.0)) {}

  /// Draws a posture, then places for it.
  std::optional<Posture> place(const Figure& figure, RandomStream& stream) {
    const auto posture = random_posture(figure, *models_, stream);
    for (int draw = 0; posture && draw < kMostDraws; ++draw) {
      Posture there = moved(figure, *models_, *posture, draw_place(room_, stream));
      if (is_free(there)) {
        placed_.push_back(there);
        return there;
      }
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool is_free(const Posture& posture) const {
    return std::none_of(posture.bounds.begin(), posture.bounds.end(),
                        [&](const Volume& part) { return reaches_wall(*enclosure_, part); }) &&
           std::none_of(placed_.begin(), placed_.end(),
                        [&](const Posture& other) { return overlap_anywhere(posture, other); });
  }

  const std::vector<BodyModel>* models_;
  const Enclosure* enclosure_;
  Room room_;
  std::vector<Posture> placed_;
};

}  // namespace

std::optional<std::vector<BodyState>> crowd_states(const std::vector<BodyModel>& models,
                                                   const Enclosure& enclosure,
                                                   const CrowdStart& start) {
  RandomStream stream(start.seed, start.name);
  const Room room = room_within(enclosure, start.radius_m);
  if (room.half_extents_m.minCoeff() < 0.0) {
    return std::nullopt;
  }
  std::vector<BodyState> states;
  for (const BodyModel& model : models) {
    const auto place = free_place(states, room, start.radius_m, stream);
    if (!place) {
      return std::nullopt;
    }
    BodyState state;
    state.pose.position = *place;
    state.pose.orientation = draw_orientation(stream);
    state.linear_momentum = start.speed_m_s / model.inverse_mass * draw_direction(stream);
    const Vector3 spin = start.spin_rad_s * draw_direction(stream);
    state.angular_momentum = angular_momentum_at(model, state.pose.orientation, spin);
    states.push_back(state);
  }
  return states;
}

bool has_posture(const Figure& figure, const std::vector<BodyModel>& models,
                 const CrowdStart& start) {
  RandomStream stream(start.seed, start.name);
  return random_posture(figure, models, stream).has_value();
}

std::optional<std::vector<BodyState>> figure_crowd_states(const std::vector<Figure>& figures,
                                                          const std::vector<BodyModel>& models,
                                                          const Enclosure& enclosure,
                                                          const CrowdStart& start) {
  RandomStream stream(start.seed, start.name);
  Placer placer(models, enclosure);
  std::vector<BodyState> states;
  for (const Figure& figure : figures) {
    const auto posture = placer.place(figure, stream);
    if (!posture) {
      return std::nullopt;
    }
    const Vector3 velocity_m_s = start.speed_m_s * draw_direction(stream);
    const Vector3 spin_rad_s = start.spin_rad_s * draw_direction(stream);
    const std::vector<BodyState> parts =
        states_of(figure, models, posture->poses, velocity_m_s, spin_rad_s);
    states.insert(states.end(), parts.begin(), parts.end());
  }
  return states;
}

}  // namespace impetus::inline scenes
