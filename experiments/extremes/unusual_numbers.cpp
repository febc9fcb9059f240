// States that are no finite numbers, put in or made by a step; numbers below the smallest normal
// one, and zeros with a sign.
// SPDX-License-Identifier: MIT
#include <limits>
#include <stdexcept>

#include "engine/dynamics/state_hash.hpp"
#include "engine/trees/builders/build_tree.hpp"
#include "experiments/extremes/building_blocks.hpp"
#include "experiments/extremes/extreme_cases.hpp"

namespace impetus::inline extremes {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kSpoilt = 7;
constexpr std::size_t kFields = 13;

double& number_of(BodyState& state, std::size_t field) {
  double* const numbers[kFields] = {
      &state.pose.position.x(),    &state.pose.position.y(),    &state.pose.position.z(),
      &state.pose.orientation.w(), &state.pose.orientation.x(), &state.pose.orientation.y(),
      &state.pose.orientation.z(), &state.linear_momentum.x(),  &state.linear_momentum.y(),
      &state.linear_momentum.z(),  &state.angular_momentum.x(), &state.angular_momentum.y(),
      &state.angular_momentum.z()};
  return *numbers[field];
}

bool same_bits(const BodyState& x, const BodyState& y) {
  return x.pose.position == y.pose.position &&
         x.pose.orientation.coeffs() == y.pose.orientation.coeffs() &&
         x.linear_momentum == y.linear_momentum && x.angular_momentum == y.angular_momentum;
}

bool finite(const World& world) {
  for (const BodyState& state : world.states()) {
    if (not_finite_field(state)) {
      return false;
    }
  }
  return true;
}

/// What must not happen when a body of a crowd is spoilt.
struct Failures {
  double unnamed{0.0};  ///< steps that did not name it at once, or named another
  double spread{0.0};   ///< others whose states then differ from those of a crowd without it
};

/// A crowd, one of whose bodies is spoilt in one field, beside the same crowd where that body is
/// far away.
void spoil(double value, std::size_t field, const World& crowd, Failures& failures) {
  World spoilt = crowd;
  World without = crowd;
  number_of(spoilt.mutable_states()[kSpoilt], field) = value;
  BodyState& gone = without.mutable_states()[kSpoilt];
  gone.pose.position = Vector3(1e6, 1e6, 1e6);
  gone.linear_momentum.setZero();
  gone.angular_momentum.setZero();
  StepInput input;
  input.dt_s = 1.0 / 240.0;
  FixedWork meter(kUnlimitedTests);
  for (int step = 0; step < 40; ++step) {
    const std::vector<NotFiniteBody> named = spoilt.step(input, meter).not_finite;
    without.step(input, meter);
    const bool right = step > 0 ? named.empty() : named.size() == 1 && named[0].body == kSpoilt;
    failures.unnamed += right && finite(spoilt) ? 0.0 : 1.0;
  }
  for (std::size_t body = 0; body < crowd.states().size(); ++body) {
    if (body != kSpoilt && !same_bits(spoilt.states()[body], without.states()[body])) {
      failures.spread += 1.0;
    }
  }
}

std::vector<double> spoilt_in_every_field(Length length, const Progress& progress) {
  ExtremeScene scene = crowd_scene(40, 3.0, 1.0, 0);
  scene.settings.enclosure.reset();
  World crowd = world_of(scene);
  StepInput input;
  input.dt_s = scene.step_s;
  FixedWork meter(kUnlimitedTests);
  for (int step = 0; step < 3; ++step) {
    crowd.step(input, meter);
  }
  Failures failures;
  const std::size_t stride = length == Length::kQuick ? 3 : 1;
  for (std::size_t field = 0; field < kFields; field += stride) {
    for (const double value : {kNan, kInfinite, -kInfinite, 1e308}) {
      spoil(value, field, crowd, failures);
    }
    if (progress) {
      progress(static_cast<double>(field) / static_cast<double>(kFields));
    }
  }
  return {failures.unnamed, failures.spread};
}

/// Steps in which a body that outgrows all numbers by its own motion, or by gravity, was not named
/// when it did, or was no finite number after it.
std::vector<double> made_by_steps(Length /*length*/, const Progress& /*progress*/) {
  double failures = 0.0;
  for (const double gravity_m_s2 : {0.0, 1e99}) {
    ExtremeScene scene;
    scene.bodies = {ball(0.1), ball(0.1, {1e99, 0.0, 0.0})};
    scene.bodies[0].mass_kg = 1.0;
    scene.bodies[1].mass_kg = 1.0;
    scene.settings.gravity_m_s2 = {0.0, -gravity_m_s2, 0.0};
    World world = world_of(scene);
    world.mutable_states()[1].linear_momentum.x() = 5e99;
    StepInput input;
    input.dt_s = 1.0;
    FixedWork meter(kUnlimitedTests);
    bool named = false;
    for (int step = 0; step < 20; ++step) {
      named |= !world.step(input, meter).not_finite.empty();
      failures += finite(world) ? 0.0 : 1.0;
    }
    failures += named ? 0.0 : 1.0;
  }
  return {failures};
}

template <typename Make>
double accepts(const Make& make) {
  try {
    make();
  } catch (const std::invalid_argument&) {
    return 0.0;
  }
  return 1.0;
}

/// What cannot be stepped, or is no body, and was taken.
std::vector<double> refusals(Length /*length*/, const Progress& /*progress*/) {
  const auto world_with = [](auto spoil_body) {
    return [spoil_body] {
      ExtremeScene scene;
      scene.bodies = {ball(0.1)};
      spoil_body(scene.bodies[0]);
      world_of(scene);
    };
  };
  double accepted = 0.0;
  for (const double bad : {kNan, kInfinite}) {
    accepted +=
        accepts(world_with([bad](ExtremeBody& body) { body.start.velocity_m_s.y() = bad; }));
    accepted +=
        accepts(world_with([bad](ExtremeBody& body) { body.start.pose.position.z() = bad; }));
    accepted += accepts(world_with([bad](ExtremeBody& body) { body.start.spin_rad_s.x() = bad; }));
    accepted += accepts(world_with([bad](ExtremeBody& body) { body.solid = SolidBall{bad}; }));
    accepted += accepts([bad] {
      World world({}, {}, {});
      StepInput input;
      input.dt_s = bad;
      FixedWork meter(1);
      world.step(input, meter);
    });
  }
  for (const TreeKind kind : all_tree_kinds()) {
    accepted += accepts([kind] { build_tree(TriangleMesh{}, {kind, 2, 8}); });
  }
  return {accepted};
}

constexpr double kDenormal = 3e-310;

/// Bodies that touch, with velocities, spins and offsets below the smallest normal number.
std::vector<ExtremeScene> denormals(Length /*length*/) {
  std::vector<ExtremeScene> scenes;
  for (const ResponseMethod method : {ResponseMethod::kInTurn, ResponseMethod::kTogether}) {
    ExtremeScene scene;
    scene.name = method == ResponseMethod::kInTurn ? "in turn" : "together";
    scene.bodies = {ball(0.5), block({1.0, 1.0, 1.0}, {1.0, kDenormal, 0.0}),
                    block({1.0, 1.0, 1.0}, {1.0, 1.0, -kDenormal})};
    for (ExtremeBody& body : scene.bodies) {
      const double towards = body.start.pose.position.x() > 0.0 ? -kDenormal : kDenormal;
      body.start.velocity_m_s = Vector3(towards, kDenormal, -kDenormal);
      body.start.spin_rad_s = Vector3(kDenormal, -kDenormal, 0.0);
    }
    scene.bodies[2].tree = TreeKind::kBox;
    scene.settings.response = method;
    scenes.push_back(scene);
  }
  return scenes;
}

void turn_signs_of_zeros(Vector3& v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (v[axis] == 0.0) {
      v[axis] = -v[axis];
    }
  }
}

/// Steps whose hashes differ between a scene full of zeros and the same with their signs turned.
std::vector<double> signed_zeros(Length /*length*/, const Progress& /*progress*/) {
  double differ = 0.0;
  for (const TreeKind kind : all_tree_kinds()) {
    ExtremeScene scene;
    scene.bodies = {block({1.0, 0.6, 0.4}, {-0.9, 0.0, 0.0}, {1.0, 0.0, 0.0}), ball(0.2),
                    block({0.8, 0.8, 0.3}, {0.0, 0.9, 0.0}, {0.0, -1.0, 0.0})};
    scene.bodies[0].tree = kind;
    scene.bodies[2].tree = kind;
    World plus = world_of(scene);
    World minus = plus;
    for (BodyState& state : minus.mutable_states()) {
      turn_signs_of_zeros(state.pose.position);
      turn_signs_of_zeros(state.linear_momentum);
      turn_signs_of_zeros(state.angular_momentum);
      state.pose.orientation = Quaternion(1.0, -0.0, -0.0, -0.0);
    }
    StepInput input;
    input.dt_s = scene.step_s;
    FixedWork meter(kUnlimitedTests);
    for (int step = 0; step < 480; ++step) {
      const std::uint64_t hash = plus.step(input, meter).state.hash;
      differ += hash == minus.step(input, meter).state.hash ? 0.0 : 1.0;
    }
  }
  return {differ};
}

}  // namespace

std::vector<ExtremeCase> not_finite_cases() {
  const std::string family = "not finite";
  return {
      {family,
       "not-finite-put-in",
       {{"Bodies of a crowd spoilt by NaN, infinity or 1e308 in any field, and not named at once",
         0.0},
        {"Others of the crowd that this changed in any bit", 0.0}},
       {},
       spoilt_in_every_field},
      {family,
       "not-finite-made",
       {{"Bodies that outgrow all numbers by their motion, and are not named or stay so", 0.0}},
       {},
       made_by_steps},
      {family,
       "not-finite-refused",
       {{"Worlds, steps and empty meshes that are no numbers, and were accepted", 0.0}},
       {},
       refusals},
  };
}

std::vector<ExtremeCase> small_number_cases() {
  const std::string family = "small numbers";
  return {
      single_promise(
          family, "denormals",
          "Touching bodies with velocities, spins and offsets of 3e-310 go, in a second, at most",
          1e-300, "m", distance_gone_m, denormals),
      {family,
       "signed-zeros",
       {{"Steps whose hashes change with the signs of zeros", 0.0}},
       {},
       signed_zeros},
  };
}

}  // namespace impetus::inline extremes
