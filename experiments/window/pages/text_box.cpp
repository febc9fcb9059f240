// SPDX-License-Identifier: MIT
#include "experiments/window/pages/text_box.hpp"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include "experiments/tables/number_text.hpp"
#include "experiments/window/pages/widgets.hpp"
#include "experiments/window/right_to_left.hpp"

namespace impetus::inline window {
namespace {

constexpr const char* kName = "##text";

// ImGui does not wrap what is edited. Enter leaves a form, so every line break in the text is ours:
// turning a space into a break and back keeps the length, and the cursor where it is.
int wrap_lines(ImGuiInputTextCallbackData* data) {
  const float width_px = *static_cast<const float*>(data->UserData);
  std::replace(data->Buf, data->Buf + data->BufTextLen, '\n', ' ');
  const char* line = data->Buf;
  char* last_space = nullptr;
  for (char* at = data->Buf; at < data->Buf + data->BufTextLen; ++at) {
    const bool too_long = ImGui::CalcTextSize(line, at + 1).x > width_px;
    if (*at != ' ' && too_long && last_space != nullptr) {
      *last_space = '\n';
      line = last_space + 1;
      last_space = nullptr;
    }
    last_space = *at == ' ' ? at : last_space;
  }
  data->BufDirty = true;
  return 0;
}

/// While it lives ImGui edits a text that is read from the right as if it stood there: without
/// drawing it, with the arrows the other way round and the mouse in the mirror.
class MirroredEditing {
 public:
  explicit MirroredEditing(ImVec2 size_px) : io_(ImGui::GetIO()), mouse_(io_.MousePos) {
    const float left = ImGui::GetCursorScreenPos().x;
    io_.MousePos.x = 2.0F * left + size_px.x - ImGui::GetStyle().ScrollbarSize - mouse_.x;
    swap_arrows();
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_BLACK_TRANS);
    ImGui::PushStyleColor(ImGuiCol_TextSelectedBg, IM_COL32_BLACK_TRANS);
  }
  ~MirroredEditing() {
    ImGui::PopStyleColor(2);
    swap_arrows();
    io_.MousePos = mouse_;
  }
  MirroredEditing(const MirroredEditing&) = delete;
  MirroredEditing& operator=(const MirroredEditing&) = delete;

 private:
  void swap_arrows() { std::swap(io_.KeyMap[ImGuiKey_LeftArrow], io_.KeyMap[ImGuiKey_RightArrow]); }

  ImGuiIO& io_;
  ImVec2 mouse_;
};

/// What is edited, in bytes of the text.
struct Editing {
  bool active{false};
  std::ptrdiff_t caret{0};
  std::ptrdiff_t from{0};  ///< what is selected; empty: nothing is
  std::ptrdiff_t to{0};
};

Editing editing_of(ImGuiID entry) {
  ImGuiInputTextState* const state = ImGui::GetInputTextState(entry);
  if (state == nullptr || ImGui::GetActiveID() != entry) {
    return {};
  }
  const auto byte_of = [&](int letter) {
    const ImWchar* const text = state->TextW.Data;
    return std::ptrdiff_t{ImTextCountUtf8BytesFromStr(text, text + letter)};
  };
  const auto [from, to] = std::minmax({state->GetSelectionStart(), state->GetSelectionEnd()});
  return {true, byte_of(state->GetCursorPos()), byte_of(from), byte_of(to)};
}

/// Draws the lines of a text that is read from the right, each from the same right on.
class LinesFromRight {
 public:
  LinesFromRight(ImDrawList& list, ImVec2 top_right, const Editing& editing)
      : list_(list), at_(top_right), editing_(editing) {}

  /// `begin`: of the line in the text, in bytes.
  void draw(std::string_view line, std::ptrdiff_t begin) {
    const auto place = [&](std::ptrdiff_t byte) {
      const std::ptrdiff_t within = byte - begin;
      const auto length = static_cast<std::ptrdiff_t>(line.size());
      return at_.x - shown_width(line.substr(0, static_cast<std::size_t>(std::clamp(
                                                    within, std::ptrdiff_t{0}, length))));
    };
    const float bottom = at_.y + ImGui::GetFontSize();
    list_.AddRectFilled(ImVec2(place(editing_.to), at_.y), ImVec2(place(editing_.from), bottom),
                        ImGui::GetColorU32(ImGuiCol_TextSelectedBg));
    const std::string shown = visual_line(line, true);
    list_.AddText(ImVec2(std::round(at_.x - shown_width(line)), at_.y),
                  ImGui::GetColorU32(ImGuiCol_Text), shown.data(), shown.data() + shown.size());
    const std::ptrdiff_t end = begin + static_cast<std::ptrdiff_t>(line.size());
    if (editing_.active && editing_.caret >= begin && editing_.caret <= end) {
      const float caret = std::round(place(editing_.caret));
      list_.AddLine(ImVec2(caret, at_.y), ImVec2(caret, bottom), ImGui::GetColorU32(ImGuiCol_Text));
    }
    at_.y = bottom;
  }

 private:
  static float shown_width(std::string_view line) {
    return width_of(visual_line(line, true), *ImGui::GetFont());
  }

  ImDrawList& list_;
  ImVec2 at_;
  Editing editing_;
};

/// Over what ImGui has just edited in the box of the window, and scrolled.
void draw_from_right(const std::string& text, float inside_px) {
  const ImGuiID entry = ImGui::GetID(kName);
  const ImGuiWindow* const box = ImGui::FindWindowByName(
      printed("%s/%s_%08X", ImGui::GetCurrentWindow()->Name, kName, entry).c_str());
  if (box == nullptr) {
    return;
  }
  const ImVec2 corner = box->DC.CursorStartPos + ImGui::GetStyle().FramePadding;
  box->DrawList->PushClipRect(box->InnerClipRect.Min, box->InnerClipRect.Max);
  LinesFromRight lines(*box->DrawList, ImVec2(corner.x + inside_px, corner.y), editing_of(entry));
  std::string_view rest = text;
  while (true) {
    const std::size_t end = rest.find('\n');
    lines.draw(rest.substr(0, end), rest.data() - text.data());
    if (end == std::string_view::npos) {
      break;
    }
    rest.remove_prefix(end + 1);
  }
  box->DrawList->PopClipRect();
}

}  // namespace

void draw_text_box(std::string& text, ImVec2 size_px, bool from_right) {
  const ImGuiStyle& style = ImGui::GetStyle();
  float inside_px = size_px.x - 2.0F * style.FramePadding.x - style.ScrollbarSize - 2.0F;
  const auto edit = [&] {
    ImGui::InputTextMultiline(kName, &text, size_px, ImGuiInputTextFlags_CallbackEdit, wrap_lines,
                              &inside_px);
  };
  if (!is_right_to_left(text, from_right)) {
    edit();
    return;
  }
  {
    const MirroredEditing mirrored(size_px);
    edit();
  }
  draw_from_right(text, inside_px);
}

}  // namespace impetus::inline window
