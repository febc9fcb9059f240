// SPDX-License-Identifier: MIT
#include "experiments/viewers/response_controls.hpp"

#include <array>
#include <string>

#include "experiments/viewers/panel_controls.hpp"

namespace impetus::inline viewers {
namespace {

/// All as scene files name them.
constexpr std::array<NamedValue<ResponseMethod>, 2> kResponses{
    {{ResponseMethod::kInTurn, "in-turn"}, {ResponseMethod::kTogether, "together"}}};
constexpr std::array<NamedValue<Tunnelling>, 3> kTunnelling{
    {{Tunnelling::kIgnored, "ignored"},
     {Tunnelling::kCapped, "capped"},
     {Tunnelling::kStopAtEntry, "stop-at-entry"}}};
constexpr std::array<NamedValue<Rotation>, 2> kRotations{
    {{Rotation::kMidpoint, "midpoint"}, {Rotation::kEnergyKept, "energy-kept"}}};
constexpr std::array<NamedValue<bool>, 2> kCounts{{{false, "tests"}, {true, "all-phases"}}};

bool draw_reduction(PreviewSettings& settings) {
  bool changed = false;
  panel_label("reduction");
  if (ImGui::BeginCombo("##reduction", settings.reduction.c_str())) {
    for (const std::string_view each : reduction_names()) {
      const std::string name(each);
      if (ImGui::Selectable(name.c_str(), name == settings.reduction)) {
        settings.reduction = name;
        changed = true;
      }
    }
    ImGui::EndCombo();
  }
  panel_tooltip(
      "How the contacts of overlapping nodes become few. none: all. first: the one entered first. "
      "average: their mean. groups: a mean for each pair of surface groups. density: the same, "
      "normals from density gradients. weighted: the same, by interpenetration and occupancy.");
  return changed;
}

bool budget_choice(PreviewSettings& settings, const char* name, BudgetUnit unit,
                   const char* tooltip) {
  const bool clicked = ImGui::RadioButton(name, settings.budget == unit);
  panel_tooltip(tooltip);
  if (clicked) {
    settings.budget = unit;
  }
  return clicked;
}

bool draw_limit(PreviewSettings& settings) {
  ImGui::SetNextItemWidth(-1.0F);
  if (settings.budget == BudgetUnit::kTests) {
    const bool changed = ImGui::SliderInt("##tests", &settings.tests_per_step, 1, 100'000,
                                          "%d units per step", ImGuiSliderFlags_Logarithmic);
    panel_tooltip("Units of work; the floor is done all the same. Ctrl-click to type.");
    return changed;
  }
  if (settings.budget == BudgetUnit::kMilliseconds) {
    auto ms = static_cast<float>(settings.ms_per_step);
    const bool changed = ImGui::SliderFloat("##ms", &ms, 0.01F, 10.0F, "%.2f ms per step",
                                            ImGuiSliderFlags_Logarithmic);
    settings.ms_per_step = changed ? ms : settings.ms_per_step;
    panel_tooltip("Milliseconds of this machine, motion included. Ctrl-click to type.");
    return changed;
  }
  return false;
}

}  // namespace

bool draw_contact_controls(PreviewSettings& settings) {
  constexpr int kMostContacts = 64;
  bool changed = draw_reduction(settings);
  panel_label("most per pair");
  changed |= ImGui::SliderInt("##most", &settings.most_per_pair, 1, kMostContacts, "%d",
                              ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  panel_tooltip("Of what the reduction leaves, those that span most torque.");
  changed |= chosen_of("response", settings.response, kResponses,
                       "in-turn: contact by contact. together: all of an island at once, after "
                       "which nothing approaches. Where there are figures: in turn alone.");
  changed |= chosen_of("fast bodies", settings.tunnelling, kTunnelling,
                       "Bodies that move further in a step than they are thick. ignored: they may "
                       "pass through. capped: only levels thicker than the way. stop-at-entry: "
                       "they stop where they first touch.");
  changed |= chosen_of("rotation", settings.rotation, kRotations,
                       "How rotation is stepped; both keep angular momentum. midpoint: the energy "
                       "swings a little. energy-kept: to rounding, for more work.");
  return changed;
}

bool draw_budget_controls(PreviewSettings& settings) {
  bool changed = budget_choice(settings, "unlimited", BudgetUnit::kUnlimited,
                               "Every pair to its list's greatest level.");
  ImGui::SameLine();
  changed |= budget_choice(settings, "work", BudgetUnit::kTests,
                           "A fixed number of units of work per step; replays anywhere.");
  ImGui::SameLine();
  changed |= budget_choice(settings, "milliseconds", BudgetUnit::kMilliseconds,
                           "Work is granted until so many milliseconds of the step are over.");
  changed |= draw_limit(settings);
  changed |= chosen_of("counts", settings.all_phases, kCounts,
                       "What is work. tests: node-pair tests. all-phases: modelling contacts and "
                       "responding to them too, in units of the test of two spheres.");
  return changed;
}

}  // namespace impetus::inline viewers
