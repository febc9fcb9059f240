// SPDX-License-Identifier: MIT
#include "experiments/stage/preview_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "experiments/stage/palette.hpp"
#include "experiments/stage/panel_style.hpp"

namespace impetus {
namespace {

struct Speed {
  double factor;
  const char* name;
};
constexpr std::array<Speed, 4> kSpeeds{{{1.0, "1"}, {0.5, "½"}, {0.25, "¼"}, {0.1, "1/10"}}};

struct RegionChoice {
  RegionKind kind;
  const char* name;
};
/// As scene files name them.
constexpr std::array<RegionChoice, 4> kRegions{{{RegionKind::kTracked, "tracked"},
                                                {RegionKind::kRandom, "random"},
                                                {RegionKind::kAllGood, "all-good"},
                                                {RegionKind::kAllBad, "all-bad"}}};

const char* name_of(RegionKind kind) {
  const auto* const found = std::find_if(
      kRegions.begin(), kRegions.end(), [kind](const auto& choice) { return choice.kind == kind; });
  return found == kRegions.end() ? "" : found->name;
}

constexpr const char* kDragHint = " Drag to change, double-click to type.";

class Panel {
 public:
  Panel(PreviewRun& run, PreviewOverlays& overlays, const PanelFrame& frame)
      : run_(run), overlays_(overlays), frame_(frame), settings_(run.settings()) {}

  void draw() {
    draw_time();
    draw_numbers();
    panel_heading("Scheduler");
    draw_scheduler();
    draw_lists();
    draw_problem();
    panel_heading("Budget of a step");
    draw_budget();
    panel_heading("Overlays");
    draw_overlay_boxes();
    panel_heading("Keys");
    ImGui::TextWrapped(
        "Space pause, play  ·  S one step  ·  R restart  ·  O overlays  ·  H this panel  ·  "
        "Esc leave");
    if (frame_.picture_share < 0.995) {
      ImGui::TextWrapped("The picture has %.0f %% of life size; without the panel, all of it.",
                         100.0 * frame_.picture_share);
    }
    if (changed_) {
      run_.change(settings_);
    }
  }

 private:
  void draw_time() {
    const float width = (ImGui::GetContentRegionAvail().x - 2.0F * spacing()) / 3.0F;
    if (ImGui::Button(run_.playing() ? "Pause###play" : "Play###play", ImVec2(width, 0))) {
      run_.toggle();
    }
    panel_tooltip("Lets time run or stand still. Key: Space");
    ImGui::SameLine();
    if (ImGui::Button("Step", ImVec2(width, 0))) {
      run_.step();
    }
    panel_tooltip("Stands still, one step further. Key: S");
    ImGui::SameLine();
    if (ImGui::Button("Restart", ImVec2(width, 0))) {
      run_.restart();
    }
    panel_tooltip("The scene from its onset, with the settings as they are. Key: R");
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Speed");
    for (const Speed& speed : kSpeeds) {
      ImGui::SameLine();
      if (ImGui::RadioButton(speed.name, run_.speed() == speed.factor)) {
        run_.set_speed(speed.factor);
      }
      panel_tooltip(std::string(speed.name) + " of real time");
    }
  }

  void draw_numbers() {
    const double time_s = static_cast<double>(run_.step_number()) / run_.scene().step_hz;
    if (ImGui::BeginTable("numbers", 4)) {
      number("step", "%.0f", static_cast<double>(run_.step_number()));
      number("time", "%.2f s", time_s);
      number("bodies", "%.0f", static_cast<double>(run_.scene().looks.size()));
      number("pairs", "%.0f", static_cast<double>(run_.pairs().size()));
      number("collisions", "%.0f", static_cast<double>(run_.collision_count()));
      number("energy", "%.1f %%", 100.0 * run_.energy_share());
      panel_tooltip("Kinetic energy, as a share of that at the onset");
      number("a step takes", "%.3f ms", run_.step_ms());
      number("pace", "%.0f %%", 100.0 * run_.pace());
      panel_tooltip(
          "Scene time gone by, as a share of what the speed asks for. Below 100 %, this "
          "machine is too slow for the scene: the run falls behind, and no step is "
          "skipped.");
      ImGui::EndTable();
    }
  }

  static void number(const char* name, const char* format, double value) {
    char text[40];
    std::snprintf(text, sizeof text, format, value);
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text);
  }

  void draw_scheduler() {
    labelled("orders pairs by");
    if (ImGui::BeginCombo("##scheduler", settings_.scheduler.c_str())) {
      for (const std::string& name : scheduler_names()) {
        if (ImGui::Selectable(name.c_str(), name == settings_.scheduler)) {
          choose_scheduler(settings_, name);
          changed_ = true;
        }
      }
      ImGui::EndCombo();
    }
    panel_tooltip(
        "What decides a pair's list and its order there. region: pairs within a circle, such as "
        "one about the mouse, come first.");
    const bool by_region = settings_.scheduler == "region";
    ImGui::BeginDisabled(by_region);
    labelled("lists");
    int count = settings_.list_count;
    if (ImGui::SliderInt("##lists", &count, 1, kMostPreviewLists)) {
      choose_list_count(settings_, count);
      changed_ = true;
    }
    ImGui::EndDisabled();
    panel_tooltip(by_region ? "A region has two: within, and elsewhere."
                            : "Number of priority lists, 1 to 4.");
    ImGui::BeginDisabled(!by_region);
    draw_region_rule();
    ImGui::EndDisabled();
  }

  void draw_region_rule() {
    RegionRule& region = settings_.region;
    labelled("region");
    if (ImGui::BeginCombo("##region", name_of(region.kind))) {
      for (const RegionChoice& choice : kRegions) {
        if (ImGui::Selectable(choice.name, choice.kind == region.kind)) {
          region.kind = choice.kind;
          changed_ = true;
        }
      }
      ImGui::EndCombo();
    }
    panel_tooltip(
        "For the scheduler \"region\". tracked: about the mouse. random: about places that are "
        "drawn anew all the time. all-good: everywhere. all-bad: nowhere.");
    const bool has_radius =
        region.kind == RegionKind::kTracked || region.kind == RegionKind::kRandom;
    ImGui::BeginDisabled(!has_radius);
    labelled("its radius");
    auto radius_deg = static_cast<float>(region.radius_deg);
    if (ImGui::SliderFloat("##radius", &radius_deg, 0.5F, 20.0F, "%.1f °")) {
      region.radius_deg = radius_deg;
      changed_ = true;
    }
    ImGui::EndDisabled();
    panel_tooltip("Degrees of visual angle; for a region that is tracked or random.");
  }

  void draw_lists() {
    const bool thresholds = settings_.scheduler != "region" && settings_.list_count > 1;
    const ThresholdRange range = threshold_range(settings_.scheduler);
    if (!ImGui::BeginTable("lists", 5, ImGuiTableFlags_SizingStretchSame)) {
      return;
    }
    const std::string threshold = thresholds ? "until, " + range.unit : "";
    for (const char* name : {"list", "share", "least", "greatest", threshold.c_str()}) {
      ImGui::TableNextColumn();
      ImGui::TextDisabled("%s", name);
    }
    for (int i = 0; i < settings_.list_count; ++i) {
      ImGui::PushID(i);
      draw_list(i, thresholds && i + 1 < settings_.list_count ? &range : nullptr);
      ImGui::PopID();
    }
    ImGui::EndTable();
  }

  void draw_list(int index, const ThresholdRange* range) {
    PreviewList& list = settings_.lists[static_cast<std::size_t>(index)];
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    const std::array<float, 3> colour = colour_of_list(index);
    ImGui::TextColored(ImVec4(colour[0], colour[1], colour[2], 1.0F), "%s %d",
                       index == 0 ? "high" : "lower", index);
    panel_tooltip(index == 0 ? "High priority: its pairs are drawn red." : "Drawn blue.");
    cell("##share", list.share, 0.02F, 0.0, 100.0, "%.2f",
         "Share of the work beyond the floor, relative to the other lists'.");
    cell("##least", list.least_level, "Least level: done whatever the budget.");
    cell("##greatest", list.greatest_level,
         "Greatest level: never exceeded; the finest level, " +
             std::to_string(settings_.finest_level) + ", is no limit.");
    if (range == nullptr) {
      ImGui::TableNextColumn();
      return;
    }
    const double most = std::max(range->urgent, range->relaxed);
    cell("##threshold", list.threshold, static_cast<float>(most / 300.0), 0.0, 10.0 * most, "%.2f",
         "Pairs up to this " + settings_.scheduler + " (" + range->unit +
             ") fall into this list, the others into a later one.");
  }

  void cell(const char* id, double& value, float speed, double least, double most,
            const char* format, const std::string& tooltip) {
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0F);
    changed_ |= ImGui::DragScalar(id, ImGuiDataType_Double, &value, speed, &least, &most, format,
                                  ImGuiSliderFlags_AlwaysClamp);
    panel_tooltip(tooltip + kDragHint);
  }

  void cell(const char* id, int& value, const std::string& tooltip) {
    ImGui::TableNextColumn();
    ImGui::SetNextItemWidth(-1.0F);
    changed_ |= ImGui::DragInt(id, &value, 0.05F, 0, settings_.finest_level, "%d",
                               ImGuiSliderFlags_AlwaysClamp);
    panel_tooltip(tooltip + kDragHint);
  }

  void draw_problem() {
    if (run_.problem().empty()) {
      return;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
    ImGui::TextWrapped("%s", run_.problem().c_str());
    ImGui::TextWrapped("The last good schedule goes on.");
    ImGui::PopStyleColor();
  }

  void draw_budget() {
    budget_choice("unlimited", BudgetUnit::kUnlimited, "Every pair to its list's greatest level.");
    ImGui::SameLine();
    budget_choice("tests", BudgetUnit::kTests,
                  "A fixed number of node-pair tests per step; replays anywhere.");
    ImGui::SameLine();
    budget_choice("milliseconds", BudgetUnit::kMilliseconds,
                  "Work is granted until so many milliseconds of the step are over.");
    ImGui::SetNextItemWidth(-1.0F);
    if (settings_.budget == BudgetUnit::kTests) {
      changed_ |= ImGui::SliderInt("##tests", &settings_.tests_per_step, 1, 100'000,
                                   "%d tests per step", ImGuiSliderFlags_Logarithmic);
      panel_tooltip("Node-pair tests; the floor is done all the same. Ctrl-click to type.");
    } else if (settings_.budget == BudgetUnit::kMilliseconds) {
      auto ms = static_cast<float>(settings_.ms_per_step);
      if (ImGui::SliderFloat("##ms", &ms, 0.01F, 10.0F, "%.2f ms per step",
                             ImGuiSliderFlags_Logarithmic)) {
        settings_.ms_per_step = ms;
        changed_ = true;
      }
      panel_tooltip("Milliseconds of this machine, motion included. Ctrl-click to type.");
    }
  }

  void budget_choice(const char* name, BudgetUnit unit, const char* tooltip) {
    if (ImGui::RadioButton(name, settings_.budget == unit)) {
      settings_.budget = unit;
      changed_ = true;
    }
    panel_tooltip(tooltip);
  }

  void draw_overlay_boxes() {
    box("shown", overlays_.shown, "All of them, or none. Key: O");
    ImGui::BeginDisabled(!overlays_.shown);
    const float column = 0.5F * ImGui::GetContentRegionAvail().x;
    box("pairs", overlays_.pairs,
        "Lines between bodies that may touch: red for list 0, blue else.");
    ImGui::SameLine(column);
    box("tint bodies", overlays_.tint,
        "Bodies in the colour of their most urgent pair; paler without one.");
    box("contacts", overlays_.contacts,
        "Contact points with their normals, kept in view for a quarter of a second.");
    ImGui::SameLine(column);
    box("gaze, region", overlays_.gaze, "Where the mouse says you look, and the region.");
    box("volumes", overlays_.volumes, "The volumes that stand for the bodies.");
    ImGui::SameLine(column);
    draw_volume_level();
    ImGui::EndDisabled();
  }

  void draw_volume_level() {
    const auto name = [](int level) {
      return level < 0 ? std::string("in use") : "level " + std::to_string(level);
    };
    ImGui::BeginDisabled(!overlays_.volumes);
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::BeginCombo("##level", name(overlays_.volume_level).c_str())) {
      for (int level = -1; level <= settings_.finest_level; ++level) {
        if (ImGui::Selectable(name(level).c_str(), level == overlays_.volume_level)) {
          overlays_.volume_level = level;
        }
      }
      ImGui::EndCombo();
    }
    ImGui::EndDisabled();
    panel_tooltip("The level that the body's collisions reached lately, or one for all bodies.");
  }

  static void box(const char* name, bool& value, const char* tooltip) {
    ImGui::Checkbox(name, &value);
    panel_tooltip(tooltip);
  }

  /// A name in the left third, the control in the rest.
  static void labelled(const char* name) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name);
    ImGui::SameLine(8.5F * ImGui::GetFontSize());
    ImGui::SetNextItemWidth(-1.0F);
  }

  static float spacing() { return ImGui::GetStyle().ItemSpacing.x; }

  PreviewRun& run_;
  PreviewOverlays& overlays_;
  const PanelFrame& frame_;
  PreviewSettings settings_;
  bool changed_{false};
};

}  // namespace

float panel_width(const Gui& gui) { return std::round(23.0F * gui.fonts().small->FontSize); }

void draw_preview_panel(const Gui& gui, PreviewRun& run, PreviewOverlays& overlays,
                        const PanelFrame& frame) {
  const PanelStyle style(gui.fonts().small);
  ImGui::SetCursorScreenPos(ImVec2(frame.left_px, 0));
  ImGui::BeginChild("panel", ImVec2(gui.width() - frame.left_px, gui.height()), false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding);
  Panel(run, overlays, frame).draw();
  ImGui::EndChild();
}

}  // namespace impetus
