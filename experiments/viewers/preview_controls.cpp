// SPDX-License-Identifier: MIT
#include "experiments/viewers/preview_controls.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scheduling/metrics.hpp"
#include "experiments/drawing/body_colours.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/viewers/panel.hpp"

namespace impetus::inline viewers {
namespace {

/// All as scene files name them.
constexpr std::array<NamedValue<RegionKind>, 5> kRegions{{{RegionKind::kTracked, "tracked"},
                                                          {RegionKind::kRandom, "random"},
                                                          {RegionKind::kFixed, "fixed"},
                                                          {RegionKind::kAllGood, "all-good"},
                                                          {RegionKind::kAllBad, "all-bad"}}};

std::vector<NamedValue<std::string>> named_limits() {
  std::vector<NamedValue<std::string>> named;
  for (const std::string& rule : limited_list_rule_names()) {
    named.push_back({rule, make_list_rule(rule)->limits()->in_panel.data()});  // of a literal
  }
  return named;
}

using SharedTraversal = std::shared_ptr<const Traversal>;

std::vector<NamedValue<SharedTraversal>> named_traversals() {
  std::vector<NamedValue<SharedTraversal>> named;
  for (const std::string_view name : traversal_names()) {
    named.push_back({make_traversal(name), name.data()});  // of a literal
  }
  return named;
}

/// The part of the panel about the schedule.
class SchedulerControls {
 public:
  SchedulerControls(PreviewSettings& settings, double step_hz)
      : settings_(settings), step_hz_(step_hz), by_region_(settings.scheduler == "region") {}

  bool draw() {
    draw_scheduler();
    if (settings_.scheduler == "weighted") {
      draw_terms();
    }
    by_region_ ? draw_region() : draw_list_count();
    draw_lists();
    draw_order();
    return changed_;
  }

 private:
  void draw_scheduler() {
    std::string chosen = settings_.scheduler;
    if (chosen_name("orders pairs by", chosen, scheduler_names(),
                    "What decides a pair's list and its order there. region: pairs within a "
                    "circle, such as one about the mouse, come first. weighted: a sum of the "
                    "scene's terms.")) {
      choose_scheduler(settings_, chosen);
      by_region_ = settings_.scheduler == "region";
      changed_ = true;
    }
  }

  /// The scene's own, or two usual ones; here only their weights change.
  void draw_terms() {
    std::vector<WeightedTerm>& terms = settings_.metric_options.terms;
    for (std::size_t i = 0; i < terms.size(); ++i) {
      WeightedTerm& term = terms[i];
      ImGui::PushID(static_cast<int>(i));
      panel_label(term.metric.c_str());
      const std::string range =
          printed("weight %%.2f  (1 at %.4g, 0 at %.4g)", term.urgent, term.relaxed);
      changed_ |= dragged_number("##weight", term.weight, 0.02F, 0.01, 100.0, range.c_str(),
                                 "What this metric counts in the sum.");
      ImGui::PopID();
    }
  }

  void draw_list_count() {
    panel_label("lists");
    int count = settings_.list_count;
    if (ImGui::SliderInt("##lists", &count, 1, kMostPreviewLists)) {
      choose_list_count(settings_, count);
      changed_ = true;
    }
    panel_tooltip("Number of priority lists, 1 to 4.");
    if (settings_.list_count > 1) {
      changed_ |=
          chosen_value("parted by", settings_.rule, named_limits(),
                       "Whether a pair's list follows from its metric, or from its rank among "
                       "the step's pairs.");
    }
  }

  void draw_region() {
    RegionRule& region = settings_.region;
    changed_ |= chosen_value(
        "region", region.kind, kRegions,
        "tracked: about the mouse. random: about places that are drawn anew all the time. fixed: "
        "about the scene's point, or the centre. all-good: everywhere. all-bad: nowhere.");
    const bool has_radius =
        region.kind != RegionKind::kAllGood && region.kind != RegionKind::kAllBad;
    ImGui::BeginDisabled(!has_radius);
    panel_label("its radius");
    auto radius_deg = static_cast<float>(region.radius_deg);
    if (ImGui::SliderFloat("##radius", &radius_deg, 0.5F, 20.0F, "%.1f °",
                           ImGuiSliderFlags_AlwaysClamp)) {
      region.radius_deg = radius_deg;
      changed_ = true;
    }
    ImGui::EndDisabled();
    panel_tooltip("Degrees of visual angle; for a region that has an edge.");
  }

  [[nodiscard]] const ListLimits& limits() const {
    return *make_list_rule(settings_.rule)->limits();
  }
  [[nodiscard]] bool has_limits() const { return !by_region_ && settings_.list_count > 1; }

  void draw_lists() {
    const MeasureRange range = measure_range(settings_.scheduler);
    if (!ImGui::BeginTable("lists", 5, ImGuiTableFlags_SizingStretchSame)) {
      return;
    }
    const std::string limit = !has_limits()            ? ""
                              : !limits().is_of_metric ? std::string(limits().unit_words)
                              : range.unit.empty()     ? "until"
                                                       : "until, " + std::string(range.unit);
    for (const char* name : {"list", "share", "least", "greatest", limit.c_str()}) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", name);
    }
    for (int i = 0; i < settings_.list_count; ++i) {
      ImGui::PushID(i);
      draw_list(i, range);
      ImGui::PopID();
    }
    ImGui::EndTable();
  }

  void draw_list(int index, const MeasureRange& range) {
    PreviewList& list = settings_.lists[static_cast<std::size_t>(index)];
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    const std::array<float, 3> colour = colour_of_list(index);
    ImGui::TextColored(ImVec4(colour[0], colour[1], colour[2], 1.0F), "%s %d",
                       index == 0 ? "high" : "lower", index);
    panel_tooltip(index == 0 ? "High priority: its pairs are drawn red." : "Drawn blue.");
    ImGui::TableNextColumn();
    changed_ |= dragged_number("##share", list.share, 0.02F, 0.0, 100.0, "%.2f",
                               "Share of the work beyond the floor, relative to the other lists'.");
    ImGui::TableNextColumn();
    changed_ |= dragged_number("##least", list.least_level, 0.05F, 0, settings_.finest_level, "%d",
                               "Least level: done whatever the budget.");
    ImGui::TableNextColumn();
    changed_ |=
        dragged_number("##greatest", list.greatest_level, 0.05F, 0, settings_.finest_level, "%d",
                       "Greatest level: never exceeded; the finest level, " +
                           std::to_string(settings_.finest_level) + ", is no limit.");
    ImGui::TableNextColumn();
    if (has_limits() && index + 1 < settings_.list_count) {
      draw_limit(list, range);
    }
  }

  void draw_limit(PreviewList& list, const MeasureRange& range) {
    double least = limits().least;
    double most = limits().most;
    double speed = (most - least) / 200.0;
    if (limits().is_of_metric) {
      const double relaxed = std::max(range.urgent, range.relaxed);
      least = 0.0;
      most = 10.0 * relaxed;
      speed = relaxed / 300.0;
    }
    changed_ |= dragged_number("##limit", list.limits[settings_.rule], static_cast<float>(speed),
                               least, most, "%.2f", std::string(limits().of_one));
  }

  void draw_order() {
    static const std::string traversals = traversals_in_words();
    changed_ |=
        chosen_value("within a list", settings_.traversal, named_traversals(), traversals.c_str());
    panel_label("persistence");
    const int second = std::max(1, static_cast<int>(step_hz_));
    const std::string format =
        "%d steps (" + std::to_string(1000 * settings_.persistence_steps / second) + " ms)";
    changed_ |= ImGui::SliderInt("##persistence", &settings_.persistence_steps, 0, second,
                                 format.c_str(), ImGuiSliderFlags_AlwaysClamp);
    panel_tooltip("A pair that touches keeps the highest priority it had for so long.");
  }

  PreviewSettings& settings_;
  double step_hz_;
  bool by_region_;
  bool changed_{false};
};

constexpr std::array<NamedValue<ResponseMethod>, 2> kResponses{
    {{ResponseMethod::kInTurn, "in-turn"}, {ResponseMethod::kTogether, "together"}}};
constexpr std::array<NamedValue<Tunnelling>, 3> kTunnelling{
    {{Tunnelling::kIgnored, "ignored"},
     {Tunnelling::kCapped, "capped"},
     {Tunnelling::kStopAtEntry, "stop-at-entry"}}};
constexpr std::array<NamedValue<Rotation>, 2> kRotations{
    {{Rotation::kMidpoint, "midpoint"}, {Rotation::kEnergyKept, "energy-kept"}}};
constexpr std::array<NamedValue<bool>, 2> kCounts{{{false, "tests"}, {true, "all-phases"}}};

constexpr ImGuiSliderFlags kLimitFlags =
    ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp;

bool draw_limit(PreviewSettings& settings) {
  ImGui::SetNextItemWidth(-1.0F);
  if (settings.budget == BudgetUnit::kTests) {
    const bool changed = ImGui::SliderInt("##tests", &settings.tests_per_step, 1, 1'000'000,
                                          "%d units per step", kLimitFlags);
    panel_tooltip("Units of work; the floor is done all the same. Ctrl-click to type.");
    return changed;
  }
  if (settings.budget == BudgetUnit::kMilliseconds) {
    auto ms = static_cast<float>(settings.ms_per_step);
    const bool changed =
        ImGui::SliderFloat("##ms", &ms, 0.01F, 100.0F, "%.2f ms per step", kLimitFlags);
    settings.ms_per_step = changed ? ms : settings.ms_per_step;
    panel_tooltip("Milliseconds of this machine, motion included. Ctrl-click to type.");
    return changed;
  }
  return false;
}

}  // namespace

bool draw_scheduler_controls(PreviewSettings& settings, double step_hz) {
  return SchedulerControls(settings, step_hz).draw();
}

bool draw_contact_controls(PreviewSettings& settings) {
  constexpr int kMostContacts = 64;
  const std::vector<std::string_view> reductions = reduction_names();
  bool changed = chosen_name(
      "reduction", settings.reduction, {reductions.begin(), reductions.end()},
      "How the contacts of overlapping nodes become few. none: all. first: the one entered first. "
      "average: their mean. groups: a mean for each pair of surface groups. density: the same, "
      "normals from density gradients. weighted: the same, by interpenetration and occupancy.");
  panel_label("most per pair");
  changed |= ImGui::SliderInt("##most", &settings.most_per_pair, 1, kMostContacts, "%d",
                              ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  panel_tooltip("Of what the reduction leaves, those that span most torque.");
  changed |= chosen_value("response", settings.response, kResponses,
                          "in-turn: contact by contact. together: all of an island at once, after "
                          "which nothing approaches. Where there are figures: in turn alone.");
  changed |=
      chosen_value("fast bodies", settings.tunnelling, kTunnelling,
                   "Bodies that move further in a step than they are thick. ignored: they may "
                   "pass through. capped: only levels thicker than the way. stop-at-entry: "
                   "they stop where they first touch.");
  changed |=
      chosen_value("rotation", settings.rotation, kRotations,
                   "How rotation is stepped; both keep angular momentum. midpoint: the energy "
                   "swings a little. energy-kept: to rounding, for more work.");
  return changed;
}

bool draw_budget_controls(PreviewSettings& settings) {
  bool changed = false;
  const auto choice = [&](const char* name, BudgetUnit unit, const char* tooltip) {
    if (ImGui::RadioButton(name, settings.budget == unit)) {
      settings.budget = unit;
      changed = true;
    }
    panel_tooltip(tooltip);
  };
  choice("unlimited", BudgetUnit::kUnlimited, "Every pair to its list's greatest level.");
  ImGui::SameLine();
  choice("work", BudgetUnit::kTests, "A fixed number of units of work per step; replays anywhere.");
  ImGui::SameLine();
  choice("milliseconds", BudgetUnit::kMilliseconds,
         "Work is granted until so many milliseconds of the step are over.");
  changed |= draw_limit(settings);
  changed |=
      chosen_value("counts", settings.all_phases, kCounts,
                   "What is work. tests: node-pair tests. all-phases: modelling contacts and "
                   "responding to them too, in units of the test of two spheres.");
  return changed;
}

}  // namespace impetus::inline viewers
