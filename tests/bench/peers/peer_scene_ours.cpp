// SPDX-License-Identifier: MIT
#include <limits>

#include "engine/trees/builders/build_tree.hpp"
#include "tests/bench/peers/peer_scene.hpp"

namespace impetus {
namespace {

class OurScene final : public PeerScene {
 public:
  explicit OurScene(const ExtremeScene& scene)
      : world_(world_of(scene)), meter_(scene.work_per_step) {
    input_.dt_s = scene.step_s;
  }

  void step() override { world_.step(input_, meter_); }

  [[nodiscard]] std::vector<MotionSeen> motions() const override {
    std::vector<MotionSeen> motions;
    for (std::size_t body = 0; body < world_.models().size(); ++body) {
      motions.push_back(motion_of(world_.models()[body], world_.states()[body]));
    }
    return motions;
  }

  void spoil(std::size_t body) override {
    world_.mutable_states()[body].linear_momentum.x() = std::numeric_limits<double>::quiet_NaN();
  }

 private:
  World world_;
  StepInput input_;
  FixedWork meter_;
};

}  // namespace

std::unique_ptr<PeerScene> our_scene(const ExtremeScene& scene) {
  return std::make_unique<OurScene>(scene);
}

void empty_mesh_in_ours() { static_cast<void>(build_tree(TriangleMesh{}, {})); }

}  // namespace impetus
