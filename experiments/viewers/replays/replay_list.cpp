// SPDX-License-Identifier: MIT
#include "experiments/viewers/replays/replay_list.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline viewers {
namespace {

constexpr std::size_t kLongestNumber = 9;
constexpr int kPage = 10;

/// A digit of either part of the keyboard.
std::optional<char> digit_of(SDL_Keycode key) {
  if (key >= SDLK_0 && key <= SDLK_9) {
    return static_cast<char>('0' + (key - SDLK_0));
  }
  const bool on_keypad = key >= SDLK_KP_1 && key <= SDLK_KP_0;  // which runs 1 2 … 9 0
  return on_keypad ? std::optional(static_cast<char>('0' + (key - SDLK_KP_1 + 1) % 10))
                   : std::nullopt;
}

}  // namespace

ReplayList::ReplayList(ViewedStimuli& stimuli, std::size_t current)
    : current_(current), marked_(current) {
  for (std::size_t index = 0; index < stimuli.count(); ++index) {
    lines_.push_back(stimuli.line(index));
  }
}

void ReplayList::open() {
  open_ = scrolls_ = known_ = true;
  marked_ = current_;
  number_.clear();
}

void ReplayList::move(int lines) {
  const auto last = static_cast<int>(lines_.size()) - 1;
  marked_ = static_cast<std::size_t>(std::clamp(static_cast<int>(marked_) + lines, 0, last));
  number_.clear();
  known_ = scrolls_ = true;
}

void ReplayList::seek() {
  const auto found = std::find_if(lines_.begin(), lines_.end(), [this](const StimulusLine& line) {
    return std::to_string(line.trial) == number_;
  });
  known_ = number_.empty() || found != lines_.end();
  if (found != lines_.end()) {
    marked_ = static_cast<std::size_t>(found - lines_.begin());
    scrolls_ = true;
  }
}

bool ReplayList::press(const SDL_Keysym& key) {
  const auto digit = digit_of(key.sym);
  if (!open_ && !digit) {
    return false;
  }
  if (!open_) {
    open();
  }
  if (digit && number_.size() < kLongestNumber) {
    number_ += *digit;
    seek();
    return true;
  }
  switch (key.sym) {
    case SDLK_BACKSPACE:
      number_ = number_.substr(0, number_.empty() ? 0 : number_.size() - 1);
      seek();
      break;
    case SDLK_UP:
    case SDLK_DOWN:
      move(key.sym == SDLK_DOWN ? 1 : -1);
      break;
    case SDLK_PAGEUP:
    case SDLK_PAGEDOWN:
      move(key.sym == SDLK_PAGEDOWN ? kPage : -kPage);
      break;
    case SDLK_RETURN:
    case SDLK_KP_ENTER:
      chosen_ = known_ ? std::optional(marked_) : std::nullopt;
      break;
    case SDLK_ESCAPE:
    case SDLK_t:
      close();
      break;
    default:
      break;
  }
  return true;
}

std::optional<std::size_t> ReplayList::draw(const Gui& gui) {
  ImFont* font = gui.fonts().small;
  const float inset = font->FontSize;
  const ImVec2 size(std::round(0.8F * gui.width()), std::round(0.75F * gui.height()));
  const ImVec2 from = draw_card(gui, size);
  const std::string head =
      number_.empty() ? "Go to trial: type its number, or ↑ ↓, then Enter; or click.  Esc: back"
                      : "Go to trial " + number_ + (known_ ? "  (Enter)" : ": there is none here");
  write_at(from + ImVec2(inset, 0.7F * inset), head, font,
           known_ ? palette::kText : palette::kWarning);
  ImGui::SetCursorScreenPos(from + ImVec2(inset, 2.3F * inset));
  ImGui::PushFont(font);
  ImGui::PushStyleColor(ImGuiCol_Header, palette::kAccent);
  ImGui::PushStyleColor(ImGuiCol_HeaderHovered, palette::kSurfaceHovered);
  ImGui::PushStyleColor(ImGuiCol_HeaderActive, palette::kSurfaceHovered);
  ImGui::BeginChild("trials", ImVec2(size.x - 2.0F * inset, size.y - 3.0F * inset));
  std::int64_t greatest = 0;
  for (const StimulusLine& line : lines_) {
    greatest = std::max(greatest, line.trial);
  }
  const float number_px = ImGui::CalcTextSize(std::to_string(greatest).c_str()).x + inset;
  for (std::size_t index = 0; index < lines_.size(); ++index) {
    const bool marked = index == marked_;
    ImGui::PushID(static_cast<int>(index));
    ImGui::PushStyleColor(ImGuiCol_Text, marked              ? palette::kOnAccent
                                         : index == current_ ? palette::kAccent
                                                             : palette::kText);
    if (ImGui::Selectable(std::to_string(lines_[index].trial).c_str(), marked)) {
      chosen_ = index;
    }
    ImGui::SameLine(number_px);
    ImGui::TextUnformatted(lines_[index].words.c_str());
    if (marked && scrolls_) {
      ImGui::SetScrollHereY();
      scrolls_ = false;
    }
    ImGui::PopStyleColor();
    ImGui::PopID();
  }
  ImGui::EndChild();
  ImGui::PopStyleColor(3);
  ImGui::PopFont();
  if (chosen_) {
    close();
  }
  return std::exchange(chosen_, std::nullopt);
}

}  // namespace impetus::inline viewers
