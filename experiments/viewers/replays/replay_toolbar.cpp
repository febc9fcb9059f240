// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_toolbar.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/drawing/palette.hpp"
#include "experiments/viewing/timeline_jumps.hpp"
#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

using Command = ReplayCommand;

/// In small-text sizes.
constexpr float kRowHeight = 1.65F;
constexpr float kRowGap = 0.35F;
constexpr float kInset = 0.45F;

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
    ImGui::GetWindowDrawList()->AddText(font_, font_->FontSize, ImVec2(at_.x, y),
                                        palette::kQuietText, text.c_str());
    at_.x += std::max(least_width_px, width_of(text)) + std::round(0.35F * font_->FontSize);
  }

  void gap() { at_.x += std::round(0.8F * font_->FontSize); }

  void next_row() { at_ = ImVec2(left_, at_.y + row_px()); }

  [[nodiscard]] float width_of(const std::string& text) const {
    return font_->CalcTextSizeA(font_->FontSize, 1e6F, 0.0F, text.c_str()).x;
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
  const auto jumps = [&](JumpTarget target, const char* name, Command back, Command on,
                         const char* key_back, const char* key_on) {
    if (has_target(marks, target)) {
      bar.gap();
      bar.button(back, "◀", key_back);
      bar.words(name);
      bar.button(on, "▶", key_on);
    }
  };
  jumps(JumpTarget::kCollision, "collision", Command::kPreviousCollision, Command::kNextCollision,
        "P", "N");
  jumps(JumpTarget::kClick, "click", Command::kPreviousClick, Command::kNextClick, "", "");
  jumps(JumpTarget::kLateFrame, "late frame", Command::kPreviousLateFrame, Command::kNextLateFrame,
        "", "");
  jumps(JumpTarget::kResponse, "answer", Command::kPreviousAnswer, Command::kNextAnswer, "", "");
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

}  // namespace

float toolbar_height(const Gui& gui) {
  return std::round(2.0F * (kRowHeight + kRowGap) * gui.fonts().small->FontSize);
}

std::optional<ReplayCommand> draw_toolbar(const Gui& gui, const ReplayPlayback& playback,
                                          const std::vector<TimelineMark>& marks,
                                          const ReplayLook& look, float width_px) {
  Toolbar bar(gui, width_px);
  draw_moves(bar, playback, marks);
  bar.next_row();
  draw_shows(bar, look);
  return bar.clicked();
}

}  // namespace impetus::inline viewers
