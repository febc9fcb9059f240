// SPDX-License-Identifier: MIT
#include "experiments/window/pages/page_view.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/window/pages/widgets.hpp"

namespace impetus::inline window {
namespace {

constexpr float kMarginShare = 0.05F;    // of the window's height, above and below
constexpr float kOpticalCentre = 0.44F;  // a block looks centred a little above the middle
constexpr float kScrollStep = 0.8F;      // of what is visible

/// The bar of the time that is left, and what is free above it.
float time_bar_height() { return std::max(3.0F, std::round(0.12F * ImGui::GetFontSize())); }
float time_bar_gap() { return std::round(1.5F * part_gap()); }

}  // namespace

PageView::PageView(const Page& page, Gui& gui) : page_(page), gui_(gui) {
  for (const Field& field : page.fields) {
    fields_.emplace_back(field, page.progress.language);
  }
  gui_.forget_input();
  while (measure() > visible_height() && reading_size_ + 1 < kReadingSizes) {
    ++reading_size_;
  }
  if (!fields_.empty()) {
    focus_ = 0;
    focus_moved_ = true;
  }
}

std::optional<std::size_t> PageView::draw() {
  const float margin = std::round(kMarginShare * gui_.height());
  const float spare = std::max(0.0F, visible_height() - content_px_);
  const float top = std::round(margin + kOpticalCentre * spare - scroll_px_);
  const Column column = reading_column(gui_);
  ImGui::PushFont(gui_.fonts().body[reading_size_]);
  ImGui::SetCursorScreenPos(ImVec2(column.left, top));
  draw_words(gui_, page_, reading_size_);
  draw_point_map(gui_, page_.point_map, page_.progress.language);
  draw_fields(column);
  const float choices_top = ImGui::GetCursorScreenPos().y;
  const float time_px = page_.timeout_ms > 0.0 ? time_bar_gap() + time_bar_height() : 0.0F;
  const float bottom = top + visible_height() - time_px;
  const auto clicked = draw_choices(gui_, page_, {focused_choice(), chosen_}, bottom);
  const bool is_to_be_read = page_.choice_at_end && !end_was_seen_;
  if (seeks_focus_ && focused_choice() && !is_to_be_read) {
    scroll_to(choices_top, ImGui::GetCursorScreenPos().y);
  }
  draw_time_left(column);
  content_px_ = ImGui::GetCursorScreenPos().y - top;
  ImGui::PopFont();
  draw_reading_hint();
  draw_progress(gui_, page_.progress, BarPlace::kPage);
  return clicked;
}

std::optional<std::size_t> PageView::press(const SDL_Keysym& key) {
  if (is_key(key, "enter") && (key.mod & KMOD_CTRL) == 0) {
    if (focused_choice()) {
      return focused_choice();
    }
    if (focus_ && *focus_ + 1 < fields_.size()) {
      leave_field();
      return std::nullopt;
    }
  }
  if (focused_field() != nullptr && focused_field()->press(key.sym)) {
    return std::nullopt;
  }
  if (const auto choice = choice_with_key(key)) {
    return choice;
  }
  if (key.sym == SDLK_TAB) {
    move_focus((key.mod & KMOD_SHIFT) != 0);
  } else if (key.sym == SDLK_PAGEDOWN || key.sym == SDLK_PAGEUP) {
    scroll(key.sym == SDLK_PAGEDOWN ? 1.0F : -1.0F);
  } else if (key.sym == SDLK_SPACE && focused_choice()) {
    return focused_choice();
  } else if (!text_is_entered() && (key.sym == SDLK_LEFT || key.sym == SDLK_RIGHT)) {
    move_focus(key.sym == SDLK_LEFT);
  }
  return std::nullopt;
}

void PageView::scroll(float pages) {
  const float wanted = scroll_px_ + pages * kScrollStep * visible_height();
  scroll_px_ = std::round(std::clamp(wanted, 0.0F, longest_scroll()));
}

bool PageView::may_leave_by(std::size_t choice) {
  if (page_.choice_at_end == choice && !end_was_seen_) {
    was_hasty_ = true;
    return false;
  }
  static_cast<void>(take_input());
  if (page_.choices[choice].key == "escape") {
    return true;
  }
  std::optional<std::size_t> first_refused;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (!fields_[i].check() && !first_refused) {
      first_refused = i;
    }
  }
  if (first_refused) {
    focus_on(first_refused);
  }
  return !first_refused;
}

std::vector<std::string> PageView::answers() const {
  std::vector<std::string> answers;
  for (const FormField& field : fields_) {
    answers.push_back(field.answer());
  }
  return answers;
}

float PageView::measure() {
  gui_.begin();
  draw();
  gui_.discard();
  return content_px_;
}

std::optional<std::size_t> PageView::take_input() {
  constexpr int kOfAClick = 2;  // a button that went down and up again is seen down, then up
  std::optional<std::size_t> clicked;
  for (int drawn = 0; drawn < kOfAClick || gui_.input_waits(); ++drawn) {
    gui_.begin();
    const auto now = draw();
    gui_.discard();
    clicked = clicked ? clicked : now;
  }
  return clicked;
}

void PageView::leave_field() {
  static_cast<void>(take_input());
  focus_on(*focus_ + (fields_[*focus_].check() ? 1 : 0));
}

void PageView::draw_fields(const Column& column) {
  if (focus_moved_) {
    ImGui::ClearActiveID();
  }
  const auto focus = focus_;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(ImVec2(column.left, at.y + std::round(0.5F * part_gap())));
    const bool focused = focus == i;
    const int id = static_cast<int>(page_.choices.size() + i);
    const FocusChange change =
        fields_[i].draw(id, gui_, reading_size_, column.width, focused, focused && focus_moved_);
    if (focused && seeks_focus_) {
      scroll_to(at.y, ImGui::GetCursorScreenPos().y);
    }
    if (change == FocusChange::kGained) {
      focus_ = i;
    } else if (change == FocusChange::kLost && focus_ == i) {
      focus_.reset();
    }
  }
  focus_moved_ = false;
}

void PageView::scroll_to(float top, float bottom) {
  const float margin = std::round(kMarginShare * gui_.height());
  const float below = bottom - (margin + visible_height());
  const float above = margin - top;
  const float wanted = scroll_px_ + (below > 0.0F ? below : 0.0F) - (above > 0.0F ? above : 0.0F);
  scroll_px_ = std::round(std::clamp(wanted, 0.0F, longest_scroll()));
  seeks_focus_ = false;
}

void PageView::draw_time_left(const Column& column) const {
  if (page_.timeout_ms <= 0.0) {
    return;
  }
  const float height = time_bar_height();
  const float top = ImGui::GetCursorScreenPos().y + time_bar_gap();
  const float left_px = column.width * static_cast<float>(std::clamp(time_left_, 0.0, 1.0));
  const float middle = column.left + 0.5F * column.width;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(ImVec2(column.left, top), ImVec2(column.left + column.width, top + height),
                     palette::kSurface);
  draw.AddRectFilled(ImVec2(middle - 0.5F * left_px, top),
                     ImVec2(middle + 0.5F * left_px, top + height), palette::kLine);
  ImGui::SetCursorScreenPos(ImVec2(column.left, top + height));
}

void PageView::draw_reading_hint() const {
  if (longest_scroll() <= 0.0F) {
    return;
  }
  const float bottom = gui_.height() - progress_height(gui_);
  const float height = 2.0F * gui_.fonts().small->FontSize;
  ImGui::GetWindowDrawList()->AddRectFilled(
      ImVec2(0, bottom - height), ImVec2(gui_.width(), gui_.height()),
      page_.progress.light_ground ? palette::kLight : palette::kPicture);
  ImGui::SetCursorScreenPos(ImVec2(0, bottom - 0.7F * height));
  const Language& language = page_.progress.language;
  const bool waits = page_.choice_at_end && !end_was_seen_;
  draw_text(waits ? language.text("read_to_end") : language.text("scroll_hint"), gui_.fonts().small,
            waits && was_hasty_ ? palette::kWarning : palette::kQuietText, gui_.width(),
            Align::kCentre);
}

float PageView::visible_height() const {
  return gui_.height() - 2.0F * std::round(kMarginShare * gui_.height()) - progress_height(gui_);
}

float PageView::longest_scroll() const { return std::max(0.0F, content_px_ - visible_height()); }

std::optional<std::size_t> PageView::choice_with_key(const SDL_Keysym& key) {
  for (std::size_t choice = 0; choice < page_.choices.size(); ++choice) {
    const std::string& name = page_.choices[choice].key;
    const bool typed = name.size() == 1 || name == "space";
    if (is_key(key, name) && !(typed && text_is_entered())) {
      return choice;
    }
  }
  return std::nullopt;
}

FormField* PageView::focused_field() {
  return focus_ && *focus_ < fields_.size() ? &fields_[*focus_] : nullptr;
}

bool PageView::text_is_entered() {
  return focused_field() != nullptr && focused_field()->takes_text();
}

std::optional<std::size_t> PageView::focused_choice() const {
  return focus_ && *focus_ >= fields_.size() ? std::optional(*focus_ - fields_.size())
                                             : std::nullopt;
}

void PageView::move_focus(bool back) {
  if (focused_field() != nullptr) {
    static_cast<void>(take_input());
    focused_field()->check_again();
  }
  const std::size_t stops = fields_.size() + page_.choices.size();
  if (stops > 0) {
    const std::size_t from = focus_.value_or(back ? 0 : stops - 1);
    focus_on((from + (back ? stops - 1 : 1)) % stops);
  }
}

void PageView::focus_on(std::optional<std::size_t> stop) {
  focus_ = stop;
  focus_moved_ = true;
  seeks_focus_ = true;
}

}  // namespace impetus::inline window
