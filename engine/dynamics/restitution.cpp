// SPDX-License-Identifier: MIT
#include "engine/dynamics/restitution.hpp"

#include <algorithm>

namespace impetus::inline dynamics {
namespace {

bool is_of(const PairRestitution& pair, int material, int other) {
  return (pair.material == material && pair.other == other) ||
         (pair.material == other && pair.other == material);
}

std::string named(const PairRestitution& pair) {
  return "materials " + std::to_string(pair.material) + " and " + std::to_string(pair.other);
}

}  // namespace

double Restitutions::of(int material, int other) const {
  const auto found = std::find_if(stated.begin(), stated.end(), [&](const PairRestitution& pair) {
    return is_of(pair, material, other);
  });
  return found != stated.end() ? found->restitution : otherwise;
}

void Restitutions::find(const std::vector<Contact>& contacts, const std::vector<BodyModel>& models,
                        std::vector<double>& restitutions) const {
  const auto material_of = [&](std::int32_t body) {
    return is_wall(body) ? wall_material : models[static_cast<std::size_t>(body)].material;
  };
  restitutions.clear();
  for (const Contact& contact : contacts) {
    restitutions.push_back(of(material_of(contact.bodies.a), material_of(contact.bodies.b)));
  }
}

std::string problem_of(const std::vector<PairRestitution>& stated) {
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const PairRestitution& pair = stated[i];
    if (!(pair.restitution >= 0.0 && pair.restitution <= 1.0)) {
      return "the restitution of " + named(pair) + " must lie in [0, 1], got " +
             std::to_string(pair.restitution);
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (is_of(stated[j], pair.material, pair.other)) {
        return "expected one restitution for " + named(pair) + ", got two";
      }
    }
  }
  return "";
}

}  // namespace impetus::inline dynamics
