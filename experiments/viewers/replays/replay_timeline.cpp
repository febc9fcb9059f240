// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_timeline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "experiments/drawing/palette.hpp"

namespace impetus::inline viewers {
namespace {

struct MarkLook {
  TimelineMark::Kind kind;
  ImU32 colour;
  const char* name;
};
constexpr std::array<MarkLook, 9> kLooks{
    {{TimelineMark::Kind::kContact, palette::kContact, "contact"},
     {TimelineMark::Kind::kHold, palette::kHold, "hold"},
     {TimelineMark::Kind::kFineCollision, palette::kFineCollision, "collision, finest level"},
     {TimelineMark::Kind::kCoarseCollision, palette::kCoarseCollision, "collision, coarser"},
     {TimelineMark::Kind::kClick, palette::kClick, "click"},
     {TimelineMark::Kind::kResponse, palette::kResponse, "response"},
     {TimelineMark::Kind::kLateFrame, palette::kLateFrame, "late frame"},
     {TimelineMark::Kind::kGazeLost, palette::kGazeLost, "gaze lost"},
     {TimelineMark::Kind::kParting, palette::kParting, "parts from the finest"}}};

/// Vertical places, from the bar's top, in small-text sizes.
constexpr float kTrackTop = 1.5F;
constexpr float kTrackBottom = 2.9F;
constexpr float kClickTop = 1.15F;
constexpr float kClickBottom = 2.0F;
constexpr float kLostBottom = 1.75F;
constexpr float kCollisionTop = 2.2F;
constexpr float kKeyTop = 3.9F;
constexpr float kWholeHeight = 5.2F;

const MarkLook& look_of(TimelineMark::Kind kind) { return kLooks[static_cast<std::size_t>(kind)]; }

class TimelineDrawing {
 public:
  TimelineDrawing(ImFont* font, const TimelineFrame& frame)
      : font_(font), frame_(frame), draw_(*ImGui::GetWindowDrawList()) {}

  [[nodiscard]] float x(double time_s) const {
    return std::round(frame_.origin.x +
                      frame_.width_px * static_cast<float>(time_s / frame_.span_s));
  }
  [[nodiscard]] float y(float place) const {
    return std::round(frame_.origin.y + place * font_->FontSize);
  }

  void track() const {
    const ImVec2 from(frame_.origin.x, y(kTrackTop));
    const ImVec2 to(frame_.origin.x + frame_.width_px, y(kTrackBottom));
    draw_.AddRectFilled(from, to, palette::kSurface, 3.0F);
    draw_.AddRect(from, to, palette::kLine, 3.0F);
  }

  void mark(const TimelineMark& mark) const {
    const ImU32 colour = look_of(mark.kind).colour;
    const float left = x(mark.begin_s);
    ImVec2 from(left - 1.5F, y(kTrackTop) - 3.0F);
    ImVec2 to(left + 1.5F, y(kTrackBottom) + 3.0F);
    switch (mark.kind) {
      case TimelineMark::Kind::kHold:
        from = ImVec2(left, y(kTrackTop) + 1.0F);
        to = ImVec2(std::max(left + 2.0F, x(mark.end_s)), y(kTrackBottom) - 1.0F);
        break;
      case TimelineMark::Kind::kFineCollision:
      case TimelineMark::Kind::kCoarseCollision:
        from = ImVec2(left - 1.0F, y(kCollisionTop));
        to = ImVec2(left + 1.0F, y(kTrackBottom) - 1.0F);
        break;
      case TimelineMark::Kind::kClick:
        from.y = y(kClickTop);
        to.y = y(kClickBottom);
        break;
      case TimelineMark::Kind::kGazeLost:
        from = ImVec2(left, y(kTrackTop) + 1.0F);
        to = ImVec2(std::max(left + 1.0F, x(mark.end_s)), y(kLostBottom));
        break;
      case TimelineMark::Kind::kParting:
        from = ImVec2(left - 1.5F, y(kClickTop));
        to.y = y(kTrackBottom + 0.6F);
        break;
      case TimelineMark::Kind::kLateFrame:
        from = ImVec2(left - 1.0F, y(kTrackBottom) + 2.0F);
        to = ImVec2(left + 1.0F, y(kTrackBottom + 0.6F));
        break;
      default:
        break;
    }
    draw_.AddRectFilled(from, to, colour);
  }

  /// A hold's label begins at its mark, the others end there; called from left to right, one that
  /// would run into the label before it is left out.
  void label(const TimelineMark& mark) {
    const float width = width_of(mark.label.c_str());
    const float at = x(mark.begin_s);
    const float wanted = mark.kind == TimelineMark::Kind::kHold ? at + 4.0F : at - width - 4.0F;
    const float left = std::round(std::max(wanted, frame_.origin.x));
    const bool outside = left + width > frame_.origin.x + frame_.width_px + 2.0F;
    if (mark.label.empty() || left < labelled_until_ || outside) {
      return;
    }
    draw_.AddText(font_, font_->FontSize, ImVec2(left, y(0.0F)), palette::kText,
                  mark.label.c_str());
    labelled_until_ = left + width + 2.0F;
  }

  void cursor() const {
    const float at = x(frame_.time_s);
    const float half = 0.35F * font_->FontSize;
    draw_.AddRectFilled(ImVec2(at - 1, y(kTrackTop)), ImVec2(at + 1, y(kTrackBottom)),
                        palette::kText);
    draw_.AddTriangleFilled(ImVec2(at, y(kTrackBottom)),
                            ImVec2(at + half, y(kTrackBottom) + 1.6F * half),
                            ImVec2(at - half, y(kTrackBottom) + 1.6F * half), palette::kText);
  }

  /// Only the kinds that occur.
  void key(const std::vector<TimelineMark>& marks) const {
    float left = frame_.origin.x;
    for (const MarkLook& look : kLooks) {
      const bool occurs = std::any_of(marks.begin(), marks.end(),
                                      [&look](const auto& mark) { return mark.kind == look.kind; });
      if (!occurs) {
        continue;
      }
      const float side = std::round(0.7F * font_->FontSize);
      const float top = y(kKeyTop) + 0.2F * font_->FontSize;
      draw_.AddRectFilled(ImVec2(left, top), ImVec2(left + side, top + side), look.colour, 2.0F);
      left += 1.5F * side;
      draw_.AddText(font_, font_->FontSize, ImVec2(left, y(kKeyTop)), palette::kQuietText,
                    look.name);
      left += width_of(look.name) + 1.4F * font_->FontSize;
    }
  }

 private:
  [[nodiscard]] float width_of(const char* text) const {
    return font_->CalcTextSizeA(font_->FontSize, 1e6F, 0.0F, text).x;
  }

  ImFont* font_;
  const TimelineFrame& frame_;
  ImDrawList& draw_;
  float labelled_until_{-1.0F};
};

}  // namespace

float timeline_height(const Gui& gui) { return kWholeHeight * gui.fonts().small->FontSize; }

std::optional<double> draw_timeline(const Gui& gui, const std::vector<TimelineMark>& marks,
                                    const TimelineFrame& frame) {
  TimelineDrawing drawing(gui.fonts().small, frame);
  std::vector<TimelineMark> ordered = marks;
  std::stable_sort(ordered.begin(), ordered.end(), [](const auto& one, const auto& other) {
    return std::tie(one.begin_s, one.kind) < std::tie(other.begin_s, other.kind);
  });
  drawing.track();
  const auto is_band = [](const TimelineMark& mark) {
    return mark.kind == TimelineMark::Kind::kHold || mark.kind == TimelineMark::Kind::kGazeLost;
  };
  for (const bool bands : {true, false}) {  // first, so that a line on a band stays visible
    for (const TimelineMark& mark : ordered) {
      if (is_band(mark) == bands) {
        drawing.mark(mark);
      }
    }
  }
  for (const TimelineMark& mark : ordered) {
    drawing.label(mark);
  }
  drawing.cursor();
  drawing.key(marks);

  ImGui::SetCursorScreenPos(ImVec2(frame.origin.x, drawing.y(kTrackTop)));
  ImGui::InvisibleButton("track",
                         ImVec2(frame.width_px, drawing.y(kTrackBottom) - drawing.y(kTrackTop)));
  if (!ImGui::IsItemActive()) {
    return std::nullopt;
  }
  const float share = (ImGui::GetIO().MousePos.x - frame.origin.x) / frame.width_px;
  return std::clamp(static_cast<double>(share), 0.0, 1.0) * frame.span_s;
}

}  // namespace impetus::inline viewers
