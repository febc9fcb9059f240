// SPDX-License-Identifier: MIT
#include "experiments/window/gui.hpp"

#include <backends/imgui_impl_opengl3.h>
#include <backends/imgui_impl_sdl.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "experiments/drawing/palette.hpp"
#include "experiments/record/shown_letters.hpp"
#include "experiments/window/window.hpp"

namespace impetus::inline window {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPlainFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr const char* kBoldFont = "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf";

/// Body text: readable at arm's length.
constexpr float kBodyShareOfHeight = 1.0F / 36.0F;
constexpr float kSmallestBodyPx = 22.0F;
constexpr std::array<float, kReadingSizes> kReadingScale{1.0F, 0.86F, 0.74F};
constexpr float kTitleScale = 1.4F;
constexpr float kSmallScale = 0.64F;

/// Of Arabic, the forms that letters have beside others.
constexpr std::array<LetterRange, 2> kJoinedForms{{{0xFB50, 0xFBFF}, {0xFE70, 0xFEFC}}};

/// First and last of each range, then 0, as ImGui reads them when it builds the fonts' texture:
/// what every screen shows, and what is read from right to left as well.
std::vector<ImWchar> glyph_ranges(bool right_to_left) {
  std::vector<ImWchar> ranges;
  const auto add = [&](const LetterRange& range) {
    ranges.insert(ranges.end(), {range.first, range.last});
  };
  std::for_each(kShownLetters.begin(), kShownLetters.end(), add);
  if (right_to_left) {
    std::for_each(kRightToLeftLetters.begin(), kRightToLeftLetters.end(), add);
    std::for_each(kJoinedForms.begin(), kJoinedForms.end(), add);
  }
  ranges.push_back(0);
  return ranges;
}

const ImWchar* glyphs(bool right_to_left) {
  static const std::vector<ImWchar> kUsual = glyph_ranges(false);
  static const std::vector<ImWchar> kBothWays = glyph_ranges(true);
  return (right_to_left ? kBothWays : kUsual).data();
}

// Fonts for Chinese, Japanese and Korean, beside the one that writes all else: looked for among
// what Debian's packages install, for the machine and for the user.
//
//   letters of a study ─> first_letter_without_font() ─none─> Gui ─> only these letters are loaded

/// A font by the place that its package gives it.
struct KnownFont {
  const char* plain;
  const char* bold;
  int face;
  float scale;
};

/// From fonts-noto-cjk (its face of simplified Chinese), fonts-wqy-microhei, fonts-droid-fallback.
constexpr std::array<KnownFont, 3> kKnownFonts{
    {{"opentype/noto/NotoSansCJK-Regular.ttc", "opentype/noto/NotoSansCJK-Bold.ttc", 2, 1.24F},
     {"truetype/wqy/wqy-microhei.ttc", "truetype/wqy/wqy-microhei.ttc", 0, 1.0F},
     {"truetype/droid/DroidSansFallbackFull.ttf", "truetype/droid/DroidSansFallbackFull.ttf", 0,
      1.12F}}};

/// Where the letters of one font are.
struct WideFont {
  std::string plain;  ///< a file
  std::string bold;   ///< a file; the same where there is no bold one
  int face{0};        ///< in a file of several
  float scale{1.0F};  ///< of a size, so that its letters are as large as those beside them
};

fs::path users_fonts() {
  const char* home = std::getenv("HOME");
  return home == nullptr ? fs::path() : fs::path(home) / ".local/share/fonts";
}

/// The first of the known fonts that is installed.
std::optional<WideFont> find_wide_font() {
  for (const fs::path& folder : {fs::path("/usr/share/fonts"), users_fonts()}) {
    for (const KnownFont& font : kKnownFonts) {
      std::error_code ignored;
      if (fs::is_regular_file(folder / font.plain, ignored)) {
        const bool has_bold = fs::is_regular_file(folder / font.bold, ignored);
        return WideFont{folder / font.plain, folder / (has_bold ? font.bold : font.plain),
                        font.face, font.scale};
      }
    }
  }
  return std::nullopt;
}

bool has_any_within(const std::set<std::uint16_t>& letters, int first, int last) {
  const auto from = letters.lower_bound(static_cast<std::uint16_t>(first));
  return from != letters.end() && *from <= last;
}

/// What somebody who reads these letters may type.
const ImWchar* common_letters(const std::set<std::uint16_t>& letters, ImFontAtlas& atlas) {
  return has_any_within(letters, 0xAC00, 0xD7A3)   ? atlas.GetGlyphRangesKorean()
         : has_any_within(letters, 0x3041, 0x30FF) ? atlas.GetGlyphRangesJapanese()
                                                   : atlas.GetGlyphRangesChineseSimplifiedCommon();
}

/// Ranges of code points, as ImGui reads them, of these letters; where participants type, also
/// those that are common in the same script.
ImVector<ImWchar> wide_ranges(const std::set<std::uint16_t>& letters, bool is_typed) {
  ImFontAtlas atlas;
  ImFontGlyphRangesBuilder builder;
  for (const std::uint16_t letter : letters) {
    builder.AddChar(letter);
  }
  if (is_typed) {
    builder.AddRanges(common_letters(letters, atlas));
  }
  ImVector<ImWchar> ranges;
  builder.BuildRanges(&ranges);
  return ranges;
}

/// Letters of another font beside those of the one that was loaded last.
struct MoreLetters {
  const std::string& file;
  int face{0};
  float scale{1.0F};
  const ImVector<ImWchar>& ranges;
};

ImFont* load_font(const char* path, float size_px, bool right_to_left) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const float whole_px = std::round(size_px);
  if (fs::exists(path)) {
    return atlas.AddFontFromFileTTF(path, whole_px, nullptr, glyphs(right_to_left));
  }
  ImFontConfig scaled;
  scaled.SizePixels = whole_px;
  return atlas.AddFontDefault(&scaled);
}

void add_letters(const MoreLetters& more, float size_px) {
  ImFontConfig config;
  config.MergeMode = true;
  config.FontNo = more.face;
  config.OversampleH = 1;  // there are thousands
  ImGui::GetIO().Fonts->AddFontFromFileTTF(more.file.c_str(), std::round(more.scale * size_px),
                                           &config, more.ranges.Data);
}

void apply_style(float body_px) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  style.WindowPadding = ImVec2(0, 0);
  style.WindowBorderSize = 0.0F;
  style.FramePadding = ImVec2(0.45F * body_px, 0.3F * body_px);
  style.FrameRounding = 0.2F * body_px;
  style.FrameBorderSize = 1.0F;
  style.ItemSpacing = ImVec2(0.5F * body_px, 0.4F * body_px);
  style.ScrollbarSize = 0.5F * body_px;
  style.AntiAliasedLinesUseTex = false;
  const auto colour = [&style](ImGuiCol what, ImU32 value) {
    style.Colors[what] = ImGui::ColorConvertU32ToFloat4(value);
  };
  colour(ImGuiCol_Text, palette::kText);
  colour(ImGuiCol_TextSelectedBg, IM_COL32(34, 82, 124, 90));
  colour(ImGuiCol_WindowBg, IM_COL32(0, 0, 0, 0));
  colour(ImGuiCol_ChildBg, palette::kSurface);
  colour(ImGuiCol_FrameBg, palette::kSurface);
  colour(ImGuiCol_FrameBgHovered, palette::kSurfaceHovered);
  colour(ImGuiCol_FrameBgActive, palette::kSurfaceHovered);
  colour(ImGuiCol_Border, palette::kLine);
  colour(ImGuiCol_ScrollbarBg, palette::kSurface);
  colour(ImGuiCol_ScrollbarGrab, palette::kLine);
  colour(ImGuiCol_NavHighlight, IM_COL32(0, 0, 0, 0));
}

bool is_of_keyboard(const SDL_Event& event) {
  return event.type == SDL_KEYDOWN || event.type == SDL_KEYUP;
}

bool is_ours(const SDL_Event& event) {
  if (!is_of_keyboard(event)) {
    return false;
  }
  const SDL_Keycode key = event.key.keysym.sym;
  return key == SDLK_TAB || key == SDLK_ESCAPE || key == SDLK_RETURN || key == SDLK_KP_ENTER;
}

bool is_editing_key(const SDL_Event& event) {
  if (!is_of_keyboard(event)) {
    return false;
  }
  const SDL_Keysym& key = event.key.keysym;
  const bool writes_text = key.sym >= SDLK_SPACE && key.sym < SDLK_DELETE;
  return !writes_text || (key.mod & KMOD_CTRL) != 0;
}

}  // namespace

std::optional<std::uint16_t> first_letter_without_font(const std::set<std::uint16_t>& shown) {
  std::set<std::uint16_t> letters;  // all others are in the font of every screen
  std::copy_if(shown.begin(), shown.end(), std::inserter(letters, letters.end()), is_wide_letter);
  const auto file = find_wide_font();
  if (letters.empty() || !file) {
    return letters.empty() ? std::nullopt : std::optional(*letters.begin());
  }
  constexpr float kSmall_px = 8.0F;
  ImFontAtlas atlas;  // needs no window
  ImFontConfig config;
  config.FontNo = file->face;
  const ImVector<ImWchar> ranges = wide_ranges(letters, /*is_typed=*/false);
  const ImFont* font =
      atlas.AddFontFromFileTTF(file->plain.c_str(), kSmall_px, &config, ranges.Data);
  atlas.Build();
  const auto missing = std::find_if(letters.begin(), letters.end(), [&](std::uint16_t letter) {
    return font->FindGlyphNoFallback(letter) == nullptr;
  });
  return missing == letters.end() ? std::nullopt : std::optional(*missing);
}

Gui::Gui(GlWindow& window, const std::set<std::uint16_t>& letters) : window_(window) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  load_fonts(letters);
  apply_style(body_size());
  ImGui_ImplSDL2_InitForOpenGL(window_.handle(), window_.context());
  ImGui_ImplOpenGL3_Init("#version 330 core");
  // The first frame builds the fonts' texture: here, not in front of a participant.
  begin();
  discard();
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplSDL2_Shutdown();
  ImGui::DestroyContext();
}

float Gui::body_size() const {
  return std::round(std::max(kSmallestBodyPx, height() * kBodyShareOfHeight));
}

void Gui::load_fonts(const std::set<std::uint16_t>& special) {
  const float body_px = body_size();
  const bool right_to_left = std::any_of(special.begin(), special.end(), is_right_to_left_letter);
  std::set<std::uint16_t> letters;
  std::copy_if(special.begin(), special.end(), std::inserter(letters, letters.end()),
               is_wide_letter);
  const auto wide = letters.empty() ? std::nullopt : find_wide_font();
  typed_ranges_ = wide_ranges(letters, /*is_typed=*/true);
  shown_ranges_ = wide_ranges(letters, /*is_typed=*/false);
  const auto load = [&](bool is_bold, float size_px, const ImVector<ImWchar>& ranges) {
    ImFont* font = load_font(is_bold ? kBoldFont : kPlainFont, size_px, right_to_left);
    if (wide) {
      add_letters({is_bold ? wide->bold : wide->plain, wide->face, wide->scale, ranges}, size_px);
    }
    return font;
  };
  for (std::size_t size = 0; size < kReadingSizes; ++size) {
    const float scale = kReadingScale[size];
    fonts_.body[size] = load(false, body_px * scale, typed_ranges_);  // of fields, too
    fonts_.title[size] = load(true, body_px * kTitleScale * scale, shown_ranges_);
  }
  fonts_.small = load(false, std::max(14.0F, body_px * kSmallScale), shown_ranges_);
}

void Gui::feed(const SDL_Event& event) {
  const bool repeats = is_of_keyboard(event) && event.key.repeat != 0;  // ImGui repeats by itself
  if (!is_ours(event) && !repeats) {
    waiting_.push_back(event);
  }
}

// ImGui sees only which keys are down in a frame: one that edits (Backspace, arrows, Ctrl-V) and
// was pressed and released since the last frame would be lost, so one such event passes in a frame.
// Letters come as text of their own.
void Gui::pass_events() {
  bool edited = false;
  while (!waiting_.empty()) {
    const SDL_Event& event = waiting_.front();
    if (is_editing_key(event) && edited) {
      break;
    }
    edited = edited || is_editing_key(event);
    pointer_used_ =
        pointer_used_ || event.type == SDL_MOUSEMOTION || event.type == SDL_MOUSEBUTTONDOWN;
    ImGui_ImplSDL2_ProcessEvent(&event);
    if (is_of_keyboard(event)) {
      // As they were with this key; ImGui's own code takes them as they are by now.
      ImGui::GetIO().KeyCtrl = (event.key.keysym.mod & KMOD_CTRL) != 0;
      ImGui::GetIO().KeyShift = (event.key.keysym.mod & KMOD_SHIFT) != 0;
    }
    waiting_.pop_front();
  }
}

void Gui::forget_input() {
  waiting_.clear();
  pointer_used_ = false;
  ImGuiIO& io = ImGui::GetIO();
  std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
  io.ClearInputCharacters();
  ImGui::ClearActiveID();
}

void Gui::begin() {
  pass_events();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplSDL2_NewFrame();
  if (!pointer_used_) {
    ImGui::GetIO().MousePos = ImVec2(-FLT_MAX, -FLT_MAX);  // nowhere
  }
  ImGui::NewFrame();
  ImGui::SetNextWindowPos(ImVec2(0, 0));
  ImGui::SetNextWindowSize(ImVec2(width(), height()));
  ImGui::Begin("screen", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PushFont(fonts_.body[0]);
}

void Gui::end() {
  ImGui::PopFont();
  ImGui::End();
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Gui::discard() {
  ImGui::PopFont();
  ImGui::End();
  ImGui::EndFrame();
}

}  // namespace impetus::inline window
