// A page: everything a participant reads or answers outside the stimulus, as plain data.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "experiments/languages/language.hpp"

namespace impetus::inline record {

/// How far the session has come; and in what language that and all else on the screen with it is
/// said, on what ground.
struct SessionProgress {
  std::int64_t done{0};
  std::int64_t total{0};
  std::string label;          ///< "Practice 2 of 6", "Trial 12 of 81"
  bool gaze_was_lost{false};  ///< in the trial before: a quiet mark for the experimenter
  Language language{};
  bool light_ground{false};  ///< of pages; else they have the pictures' grey
};

/// One way to leave a page. `key` is what is pressed: "1", "space", "enter", "escape", "y".
struct Choice {
  std::string label;
  std::string key;
};

/// One thing to fill in; always optional.
struct Field {
  /// What may be filled in: a number, one of several options, words, or a mark on a line, which has
  /// to be set: a whole number from end to end.
  enum class Kind { kNumber, kChoice, kText, kSlider };
  std::string id;
  std::string label;
  Kind kind{Kind::kText};
  std::vector<std::string> options;  ///< of a kChoice; of a kSlider, words spread along its line
  double minimum{-1e9};              ///< of a kNumber or a kSlider
  double maximum{1e9};
  std::string answer{};  ///< it begins with: of a page that is shown again what was filled in

  /// Whether a number has to lie within the two.
  [[nodiscard]] bool has_range() const {
    const Field any;
    return minimum < maximum && (minimum > any.minimum || maximum < any.maximum);
  }
};

/// A point that was looked at and where the gaze was, in screens: right of and above the centre.
struct LookedAtPoint {
  double x{0.0};
  double y{0.0};
  bool seen{false};  ///< whether there was a gaze
  double gaze_x{0.0};
  double gaze_y{0.0};
};

/// A small picture of the screen with points and gaze on it.
struct PointMap {
  double aspect{1.0};  ///< of the screen: width over height
  std::vector<LookedAtPoint> points;
};

/// One page, whole.
struct Page {
  /// kText: paragraphs, then choices as buttons. kForm: fields to fill in as well. kScale: the
  /// choices are the points of a rating scale, side by side, with anchors under the two ends.
  /// kChoices: a question whose answers are large, side by side.
  enum class Layout { kText, kForm, kScale, kChoices };
  Layout layout{Layout::kText};
  std::string title;
  std::vector<std::string> paragraphs;
  std::string statement{};  ///< under the paragraphs and set apart: what the choices agree to
  std::vector<Field> fields;
  std::vector<Choice> choices;
  std::string low_anchor;      ///< words under the first point of a scale
  std::string high_anchor;     ///< words under the last
  std::size_t best_choice{0};  ///< of a scale: the index of its good end
  SessionProgress progress;
  /// The response that is asked for, such as "rating" or "yes_no"; "": not one of a trial's.
  std::string response{};
  /// Of a yes_no: the index of yes; of a two_interval or a choice: of the right one, or past the
  /// last.
  std::size_t positive_choice{0};
  double timeout_ms{0.0};  ///< gone unanswered after so long; 0: never
  bool can_pause{true};    ///< Esc asks for a pause; false where Esc is one of the choices
  PointMap point_map{};    ///< under the paragraphs; none without points
  std::optional<std::size_t> choice_at_end{};  ///< made only once the page's end was on the screen
};

}  // namespace impetus::inline record
