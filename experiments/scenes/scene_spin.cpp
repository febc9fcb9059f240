// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_spin.hpp"

#include <string>

#include "engine/numerics/random_stream.hpp"

namespace impetus::inline scenes {
namespace {

using nlohmann::json;

const json* rule_of(const json& scene) {
  if (!scene.contains("imposed") || !scene["imposed"].contains("random_spin")) {
    return nullptr;
  }
  return &scene["imposed"]["random_spin"];
}

Vector3 drawn(const json& limits, RandomStream& stream) {
  Vector3 spin;
  for (int i = 0; i < 3; ++i) {
    const auto component = static_cast<std::size_t>(i);
    const auto least = limits["least_rad_s"][component].get<double>();
    const auto most = limits["most_rad_s"][component].get<double>();
    spin[i] = least + (most - least) * stream.uniform();
  }
  return spin;
}

void add_limit_problems(const json& limits, const std::string& place,
                        std::vector<SceneProblem>& problems) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (limits["most_rad_s"][i] < limits["least_rad_s"][i]) {
      problems.push_back({place + "/most_rad_s/" + std::to_string(i),
                          "expected at least least_rad_s, which is " +
                              limits["least_rad_s"][i].dump() + ", got " +
                              limits["most_rad_s"][i].dump()});
    }
  }
}

}  // namespace

std::optional<ImposedSpinRule> imposed_spin_of(const json& scene, std::uint64_t seed) {
  const json* rule = rule_of(scene);
  if (rule == nullptr || !(*rule)["on"].get<bool>()) {
    return std::nullopt;
  }
  RandomStream stream(seed, "random spin");
  const Vector3 a = drawn((*rule)["a"], stream);
  const Vector3 b = drawn((*rule)["b"], stream);
  return ImposedSpinRule{(*rule)["at_level"].get<int>(), {a, b}};
}

std::vector<SceneProblem> spin_problems(const json& scene) {
  std::vector<SceneProblem> problems;
  const json* rule = rule_of(scene);
  if (rule == nullptr) {
    return problems;
  }
  if (!scene.contains("meeting")) {
    return {{"/imposed/random_spin", "expected none where no two bodies meet"}};
  }
  add_limit_problems((*rule)["a"], "/imposed/random_spin/a", problems);
  add_limit_problems((*rule)["b"], "/imposed/random_spin/b", problems);
  if ((*rule)["on"].get<bool>() && scene["imposed"].value("no_spin", false)) {
    problems.push_back(
        {"/imposed/random_spin/on", "expected false where no_spin keeps bodies from turning"});
  }
  return problems;
}

}  // namespace impetus::inline scenes
