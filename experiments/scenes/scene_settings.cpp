// SPDX-License-Identifier: MIT
#include "experiments/scenes/scene_settings.hpp"

#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

namespace impetus::inline scenes {
namespace {

using nlohmann::json;
using Problems = std::vector<SceneProblem>;

constexpr const char* kNoMaterial = "";

/// The names that the scene's bodies, figures, crowd and enclosure give.
std::set<std::string> materials_of(const json& scene) {
  std::set<std::string> names;
  for (const char* list : {"bodies", "figures"}) {
    for (const json& body : scene.value(list, json::array())) {
      names.insert(body.value("material", kNoMaterial));
    }
  }
  for (const char* part : {"crowd", "figure_crowd", "enclosure"}) {
    names.insert(scene.value(part, json::object()).value("material", kNoMaterial));
  }
  names.erase(kNoMaterial);
  return names;
}

int number_of(const std::set<std::string>& materials, const std::string& name) {
  const auto found = materials.find(name);
  return found == materials.end() ? 0
                                  : 1 + static_cast<int>(std::distance(materials.begin(), found));
}

Tunnelling tunnelling_of(const json& engine) {
  const auto name = engine.value("tunnelling", std::string());
  return name == "ignored"         ? Tunnelling::kIgnored
         : name == "capped"        ? Tunnelling::kCapped
         : name == "stop-at-entry" ? Tunnelling::kStopAtEntry
                                   : WorldSettings{}.tunnelling;
}

ContactModel contacts_of(const json& engine) {
  const json entry = engine.value("contacts", json::object());
  ContactModel contacts;
  if (entry.contains("reduction")) {
    contacts.reduction = make_reduction(entry["reduction"].get<std::string>());
  }
  contacts.most_per_pair = entry.value("most_per_pair", contacts.most_per_pair);
  return contacts;
}

std::vector<PairRestitution> restitutions_of(const json& scene) {
  const std::set<std::string> materials = materials_of(scene);
  std::vector<PairRestitution> restitutions;
  for (const json& entry : scene["engine"].value("materials", json::array())) {
    restitutions.push_back({number_of(materials, entry["pair"][0].get<std::string>()),
                            number_of(materials, entry["pair"][1].get<std::string>()),
                            entry["restitution"].get<double>()});
  }
  return restitutions;
}

void add_material_problems(const json& scene, Problems& problems) {
  const std::set<std::string> materials = materials_of(scene);
  const json entries = scene["engine"].value("materials", json::array());
  std::set<std::pair<std::string, std::string>> stated;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string place = "/engine/materials/" + std::to_string(i) + "/pair";
    for (std::size_t side = 0; side < 2; ++side) {
      if (!materials.contains(entries[i]["pair"][side].get<std::string>())) {
        problems.push_back(
            {place + "/" + std::to_string(side),
             "expected a material that a body, the crowd or the enclosure has, got " +
                 entries[i]["pair"][side].dump()});
      }
    }
    auto first = entries[i]["pair"][0].get<std::string>();
    auto second = entries[i]["pair"][1].get<std::string>();
    if (second < first) {
      std::swap(first, second);
    }
    if (!stated.emplace(first, second).second) {
      problems.push_back(
          {place, "expected a pair of its own, got " + entries[i]["pair"].dump() + " again"});
    }
  }
}

void add_budget_problems(const json& engine, Problems& problems) {
  if (!engine.contains("budget")) {
    return;
  }
  const json& budget = engine["budget"];
  const bool by_tests = budget.contains("tests_per_step");
  if (by_tests == budget.contains("ms_per_step")) {
    problems.push_back(
        {"/engine/budget", std::string("expected one of the keys \"tests_per_step\" and "
                                       "\"ms_per_step\", got ") +
                               (by_tests ? "both" : "none")});
  }
}

}  // namespace

WorldSettings engine_settings_of(const json& scene) {
  const json& engine = scene["engine"];
  WorldSettings settings;
  settings.restitution = engine["restitution"].get<double>();
  if (engine.value("response", std::string()) == std::string("together")) {
    settings.response = ResponseMethod::kTogether;
  }
  if (engine.value("rotation", std::string()) == std::string("energy-kept")) {
    settings.rotation = Rotation::kEnergyKept;
  }
  settings.most_response_passes = engine.value("response_passes", settings.most_response_passes);
  if (engine.contains("gravity_m_s2")) {
    const auto gravity = engine["gravity_m_s2"].get<std::array<double, 3>>();
    settings.gravity_m_s2 = Vector3(gravity[0], gravity[1], gravity[2]);
  }
  settings.contacts = contacts_of(engine);
  settings.tunnelling = tunnelling_of(engine);
  settings.most_entry_tests = engine.value("most_entry_tests", settings.most_entry_tests);
  settings.materials = restitutions_of(scene);
  settings.wall_material = material_of(scene, scene.value("enclosure", json::object()));
  const json budget = engine.value("budget", json::object());
  if (budget.value("counts", std::string()) == std::string("all-phases")) {
    settings.costs = kAllPhases;
  }
  return settings;
}

int material_of(const json& scene, const json& holder) {
  return number_of(materials_of(scene), holder.value("material", kNoMaterial));
}

WorkBudget budget_of(const json& engine) {
  WorkBudget budget;
  const json entry = engine.value("budget", json::object());
  budget.tests_per_step = entry.value("tests_per_step", budget.tests_per_step);
  budget.ns_per_step = std::llround(entry.value("ms_per_step", 0.0) * 1e6);
  return budget;
}

std::vector<SceneProblem> engine_problems(const json& scene) {
  Problems problems;
  add_material_problems(scene, problems);
  add_budget_problems(scene["engine"], problems);
  return problems;
}

}  // namespace impetus::inline scenes
