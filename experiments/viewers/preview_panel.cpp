// SPDX-License-Identifier: MIT
#include "experiments/viewers/preview_panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "experiments/drawing/palette.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/viewers/panel.hpp"
#include "experiments/viewers/preview_controls.hpp"

namespace impetus::inline viewers {
namespace {

constexpr std::array<NamedValue<double>, 4> kSpeeds{
    {{1.0, "1"}, {0.5, "½"}, {0.25, "¼"}, {0.1, "1/10"}}};

constexpr std::array<NamedValue<BodyColours>, 3> kBodyColours{{{BodyColours::kOwn, "their own"},
                                                               {BodyColours::kPriority, "priority"},
                                                               {BodyColours::kLevel, "level"}}};

/// The panel of one frame.
class PreviewPanel {
 public:
  PreviewPanel(PreviewRun& run, PreviewOverlays& overlays, const PanelFrame& frame)
      : run_(run), overlays_(overlays), frame_(frame), settings_(run.settings()) {}

  void draw() {
    draw_time();
    draw_numbers();
    draw_sections();
    if (changed_) {
      run_.change(settings_);
    }
  }

 private:
  void draw_sections() {
    if (panel_section("Scheduler", true)) {
      changed_ |= draw_scheduler_controls(settings_, run_.scene().step_hz);
    }
    draw_problem();
    if (panel_section("Budget of a step", true)) {
      changed_ |= draw_budget_controls(settings_);
    }
    const bool tells_lacks = panel_section("What fell short", false);
    panel_tooltip(
        "In how many steps the budget, or a setting, left something undone: fewer parts of a "
        "figure's motion, pairs not looked at, contacts not made or not answered to the end.");
    if (tells_lacks) {
      draw_degradations();
    }
    if (panel_section("Contacts and response", true)) {
      changed_ |= draw_contact_controls(settings_);
    }
    if (panel_section("Overlays", true)) {
      draw_overlay_boxes();
    }
    if (panel_section("Keys", false)) {
      draw_keys();
    }
  }

  void draw_keys() const {
    ImGui::TextWrapped(
        "Space pause, play  ·  S one step  ·  R restart  ·  O overlays  ·  C colours  ·  "
        "H this panel  ·  Esc leave");
    if (frame_.picture_share < 0.995) {
      ImGui::TextWrapped("The picture has %.0f %% of life size; without the panel, all of it.",
                         100.0 * frame_.picture_share);
    }
  }

  void draw_time() {
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float width = (ImGui::GetContentRegionAvail().x - 2.0F * spacing) / 3.0F;
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
    for (const NamedValue<double>& speed : kSpeeds) {
      ImGui::SameLine();
      if (ImGui::RadioButton(speed.name, run_.speed() == speed.value)) {
        run_.set_speed(speed.value);
      }
      panel_tooltip(std::string(speed.name) + " of real time");
    }
  }

  void draw_numbers() {
    if (!ImGui::BeginTable("numbers", 4)) {
      return;
    }
    const auto number = [](const char* name, const char* format, double value) {
      const std::string text = printed(format, value);
      panel_row(name, text);
    };
    const auto count = [&](const char* name, auto value) {
      number(name, "%.0f", static_cast<double>(value));
    };
    count("step", run_.step_number());
    number("time", "%.2f s", static_cast<double>(run_.step_number()) / run_.scene().step_hz);
    count("bodies", run_.scene().looks.size());
    count("pairs", run_.pairs().size());
    count("collisions", run_.collision_count());
    number("energy", "%.1f %%", 100.0 * run_.energy_share());
    panel_tooltip("Kinetic energy, as a share of that at the onset");
    number("step takes", "%.3f ms", run_.step_ms());
    count("pops", run_.pop_count());
    panel_tooltip("Pairs that fell to a coarser level while they touched");
    count("stopped", run_.stopped_count());
    panel_tooltip("Pairs stopped at entry, for they would have passed through each other");
    number("pace", "%.0f %%", 100.0 * run_.pace());
    panel_tooltip(
        "Scene time gone by, as a share of what the speed asks for. Below 100 %, this machine is "
        "too slow for the scene: the run falls behind, and no step is skipped.");
    number("frames", "%.1f /s", frame_.frames_per_s);
    panel_tooltip("Pictures shown in a second, over the last half second or so.");
    ImGui::EndTable();
  }

  /// In how many steps each thing that a step can lack was lacking, of those that ever were.
  void draw_degradations() const {
    const auto& counts = run_.degraded_counts();
    if (std::all_of(counts.begin(), counts.end(), [](auto count) { return count == 0; })) {
      ImGui::TextDisabled("nothing so far");
      return;
    }
    if (!ImGui::BeginTable("degradations", 2)) {
      return;
    }
    for (std::size_t bit = 0; bit < counts.size(); ++bit) {
      if (counts[bit] > 0) {
        panel_row(std::string(kDegradationNames[bit]), std::to_string(counts[bit]) + " steps");
      }
    }
    ImGui::EndTable();
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

  void draw_overlay_boxes() {
    panel_box("shown", overlays_.shown, "All marks, or none. Key: O");
    ImGui::BeginDisabled(!overlays_.shown);
    const float column = 0.5F * ImGui::GetContentRegionAvail().x;
    panel_box("pairs", overlays_.pairs,
              "Lines between bodies that may touch: red for list 0, blue else.");
    ImGui::SameLine(column);
    panel_box("contacts", overlays_.contacts,
              "Contacts in view for a quarter of a second: red, of all overlapping nodes; yellow, "
              "with their normals, what the reduction leaves.");
    panel_box("gaze, region", overlays_.gaze, "Where the mouse says you look, and the region.");
    panel_box("volumes", overlays_.volumes, "The volumes that stand for the bodies.");
    ImGui::SameLine(column);
    draw_volume_level();
    ImGui::EndDisabled();
    chosen_value("colours", overlays_.colours, kBodyColours,
                 "Of bodies, whatever marks are shown; paler where they are apart from others. "
                 "Priority: that of their most urgent pair. Level: what their collisions reached "
                 "lately. Key: C");
  }

  void draw_volume_level() {
    std::vector<std::string> names{"in use"};
    for (int level = 0; level <= settings_.finest_level; ++level) {
      names.push_back("level " + std::to_string(level));
    }
    ImGui::BeginDisabled(!overlays_.volumes);
    ImGui::SetNextItemWidth(-1.0F);
    const auto shown = static_cast<std::size_t>(overlays_.volume_level + 1);
    if (const auto clicked = clicked_name("##level", names[shown], names)) {
      overlays_.volume_level = static_cast<int>(*clicked) - 1;
    }
    ImGui::EndDisabled();
    panel_tooltip("The level that the body's collisions reached lately, or one for all bodies.");
  }

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
  const Panel panel(gui, frame.left_px);
  PreviewPanel(run, overlays, frame).draw();
}

}  // namespace impetus::inline viewers
