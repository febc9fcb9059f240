// SPDX-License-Identifier: MIT
#include "experiments/extremes/extreme_scene.hpp"

#include <array>
#include <map>
#include <memory>
#include <utility>

#include "engine/shapes/solids/block_meshes.hpp"
#include "engine/trees/builders/build_tree.hpp"

namespace impetus::inline extremes {
namespace {

using SharedTree = std::shared_ptr<const VolumeTree>;

SharedTree built(const SolidBlock& block, TreeKind kind) {
  using Key = std::pair<std::array<double, 3>, TreeKind>;
  static std::map<Key, SharedTree> kept;
  const Vector3& edges = block.edges_m;
  SharedTree& tree = kept[Key{{edges.x(), edges.y(), edges.z()}, kind}];
  if (tree == nullptr) {
    constexpr int kDepth = 2;
    constexpr int kBranching = 8;
    tree = std::make_shared<VolumeTree>(build_tree(box_mesh(edges), {kind, kDepth, kBranching}));
  }
  return tree;
}

SharedTree tree_of(const ExtremeBody& body) {
  if (const auto* ball = std::get_if<SolidBall>(&body.solid)) {
    return std::make_shared<VolumeTree>(single_node_tree(Sphere{Vector3::Zero(), ball->radius_m}));
  }
  const auto& block = std::get<SolidBlock>(body.solid);
  if (body.tree) {
    return built(block, *body.tree);
  }
  const Vector3 half_m = 0.5 * block.edges_m;
  return std::make_shared<VolumeTree>(
      single_node_tree(Box{Vector3::Zero(), half_m, Quaternion::Identity()}));
}

BodyModel model_of(const ExtremeBody& body, std::size_t index) {
  BodyModel model;
  model.name = "body " + std::to_string(index);
  model.tree = tree_of(body);
  if (body.mass_kg > 0.0) {
    model.inverse_mass = 1.0 / body.mass_kg;
    model.inverse_inertia = inertia_of(body).cwiseInverse().asDiagonal();
  }
  return model;
}

BodyState state_of(const BodyModel& model, const ExtremeBody& body) {
  BodyState state;
  state.pose = body.start.pose;
  state.linear_momentum = body.mass_kg * body.start.velocity_m_s;
  state.angular_momentum =
      angular_momentum_at(model, state.pose.orientation, body.start.spin_rad_s);
  return state;
}

}  // namespace

Vector3 inertia_of(const ExtremeBody& body) {
  if (const auto* ball = std::get_if<SolidBall>(&body.solid)) {
    return Vector3::Constant(0.4 * body.mass_kg * ball->radius_m * ball->radius_m);
  }
  const Vector3 squares = std::get<SolidBlock>(body.solid).edges_m.cwiseAbs2();
  return body.mass_kg / 12.0 * (Vector3::Constant(squares.sum()) - squares);
}

World world_of(const ExtremeScene& scene) {
  std::vector<BodyModel> models;
  std::vector<BodyState> states;
  for (const ExtremeBody& body : scene.bodies) {
    models.push_back(model_of(body, models.size()));
    states.push_back(state_of(models.back(), body));
  }
  return {std::move(models), std::move(states), scene.settings};
}

MotionSeen motion_of(const BodyModel& model, const BodyState& state) {
  return {state.pose, velocity(model, state), angular_velocity(model, state)};
}

}  // namespace impetus::inline extremes
