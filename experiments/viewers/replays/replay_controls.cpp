// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_controls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>

#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

using Command = ReplayCommand;

/// In small-text sizes.
constexpr float kRowHeight = 1.65F;
constexpr float kRowGap = 0.35F;
constexpr float kInset = 0.45F;

/// The buttons of one frame.
class Toolbar {
 public:
  Toolbar(const Gui& gui, float width_px)
      : font_(gui.fonts().small),
        left_(ImGui::GetCursorScreenPos().x),
        right_(left_ + width_px),
        at_(ImGui::GetCursorScreenPos()) {
    ImGui::PushFont(font_);
  }
  ~Toolbar() {
    ImGui::PopFont();
    ImGui::SetCursorScreenPos(ImVec2(left_, at_.y + row_px()));
  }
  Toolbar(const Toolbar&) = delete;
  Toolbar& operator=(const Toolbar&) = delete;

  /// `widest`: of the labels that it can have, so that what follows stays where it is.
  void button(Command command, const std::string& label, const std::string& key,
              bool chosen = false, const std::string& widest = "") {
    const std::string hint = key.empty() ? "" : "  " + key;
    const float label_px = std::max(width_of(label), width_of(widest));
    const float width = std::ceil(label_px + width_of(hint) + 2.0F * inset_px());
    if (at_.x + width > right_) {
      next_row();
    }
    ImGui::SetCursorScreenPos(at_);
    const ButtonLook look{label, hint, ImVec2(width, button_px()), false, chosen};
    if (draw_button(static_cast<int>(command), look)) {
      clicked_ = command;
    }
    at_.x += width + std::round(0.25F * font_->FontSize);
  }

  void words(const std::string& text, float least_width_px = 0.0F) {
    const float y = std::round(at_.y + 0.5F * (button_px() - font_->FontSize));
    write_at(ImVec2(at_.x, y), text, font_, palette::kQuietText);
    at_.x += std::max(least_width_px, width_of(text)) + std::round(0.35F * font_->FontSize);
  }

  void gap() { at_.x += std::round(0.8F * font_->FontSize); }

  void next_row() { at_ = ImVec2(left_, at_.y + row_px()); }

  [[nodiscard]] float width_of(std::string_view text) const {
    return impetus::width_of(text, *font_);
  }
  [[nodiscard]] std::optional<Command> clicked() const { return clicked_; }

 private:
  [[nodiscard]] float button_px() const { return std::round(kRowHeight * font_->FontSize); }
  [[nodiscard]] float row_px() const {
    return std::round((kRowHeight + kRowGap) * font_->FontSize);
  }
  [[nodiscard]] float inset_px() const { return kInset * font_->FontSize; }

  ImFont* font_;
  float left_;
  float right_;
  ImVec2 at_;
  std::optional<Command> clicked_;
};

void draw_moves(Toolbar& bar, const ReplayPlayback& playback,
                const std::vector<TimelineMark>& marks) {
  bar.button(Command::kStart, "|◀", "");
  bar.button(Command::kStepBack, "step −1", ",");
  bar.button(Command::kPlay, playback.playing() ? "Pause" : "Play", "Space", false, "Pause");
  bar.button(Command::kStepOn, "step +1", ".");
  bar.button(Command::kEnd, "▶|", "");
  bar.gap();
  bar.button(Command::kSlower, "slower", "↓");
  bar.words(playback.speed_words(), bar.width_of("×1/16"));
  bar.button(Command::kFaster, "faster", "↑");
  const auto jumps = [&](JumpTarget target, Command back, Command on, const char* key_back = "",
                         const char* key_on = "") {
    if (has_target(marks, target)) {
      bar.gap();
      bar.button(back, "◀", key_back);
      bar.words(word_of(target));
      bar.button(on, "▶", key_on);
    }
  };
  jumps(JumpTarget::kCollision, Command::kPreviousCollision, Command::kNextCollision, "P", "N");
  jumps(JumpTarget::kClick, Command::kPreviousClick, Command::kNextClick);
  jumps(JumpTarget::kLateFrame, Command::kPreviousLateFrame, Command::kNextLateFrame);
  jumps(JumpTarget::kResponse, Command::kPreviousAnswer, Command::kNextAnswer);
}

const char* name_of(BodyColours colours) {
  return colours == BodyColours::kOwn        ? "Colours: own"
         : colours == BodyColours::kPriority ? "Colours: priority"
                                             : "Colours: level";
}

void draw_shows(Toolbar& bar, const ReplayLook& look) {
  bar.button(Command::kGaze, "Gaze", "G", look.gaze);
  bar.button(Command::kContacts, "Contacts", "C", look.contacts);
  bar.button(Command::kVolumes, "Volumes", "V", look.volumes);
  bar.button(Command::kColours, name_of(look.colours), "L", look.colours != BodyColours::kOwn,
             name_of(BodyColours::kPriority));
  bar.button(Command::kFinest, "Finest beside", "F", look.finest);
  bar.button(Command::kOwnView, "Own view", "R", look.camera.is_participants());
  bar.gap();
  bar.button(Command::kPicture, "Save PNG", "S");
  bar.gap();
  bar.button(Command::kPreviousTrial, "◀", "");
  bar.button(Command::kTrials, "Trials", "T");
  bar.button(Command::kNextTrial, "▶", "");
  bar.gap();
  bar.button(Command::kHelp, "Help", "F1");
}

/// How a kind of mark is drawn and called.
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

/// The timeline of one frame.
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
    const float width = width_of(mark.label, *font_);
    const float at = x(mark.begin_s);
    const float wanted = mark.kind == TimelineMark::Kind::kHold ? at + 4.0F : at - width - 4.0F;
    const float left = std::round(std::max(wanted, frame_.origin.x));
    const bool outside = left + width > frame_.origin.x + frame_.width_px + 2.0F;
    if (mark.label.empty() || left < labelled_until_ || outside) {
      return;
    }
    write_at(ImVec2(left, y(0.0F)), mark.label, font_, palette::kText);
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
      write_at(ImVec2(left, y(kKeyTop)), look.name, font_, palette::kQuietText);
      left += width_of(look.name, *font_) + 1.4F * font_->FontSize;
    }
  }

 private:
  ImFont* font_;
  const TimelineFrame& frame_;
  ImDrawList& draw_;
  float labelled_until_{-1.0F};
};

}  // namespace

std::optional<ReplayCommand> draw_toolbar(const Gui& gui, const ReplayPlayback& playback,
                                          const std::vector<TimelineMark>& marks,
                                          const ReplayLook& look, float width_px) {
  Toolbar bar(gui, width_px);
  draw_moves(bar, playback, marks);
  bar.next_row();
  draw_shows(bar, look);
  return bar.clicked();
}

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
