// Every text that participants can see and no protocol wrote: a row for each, by key. The words
// stand in the language files beside this one. A new text is its row, its line in each of them, and
// its use.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace impetus::inline languages {

/// What a text is for: words, which a protocol may switch off; a label, without which a button or
/// a sentence means nothing; the letter of a key to press.
enum class TextUse { kWords, kLabel, kKey };

/// The row of a text: "pause" is one of words, "yes"_label one of a label, "yes_key"_key of a key.
struct TextRow {
  constexpr TextRow(const char* name, TextUse what_for = TextUse::kWords)
      : key(name), use(what_for) {}

  std::string_view key;
  TextUse use;
};
constexpr TextRow operator""_label(const char* name, std::size_t /*size*/) {
  return {name, TextUse::kLabel};
}
constexpr TextRow operator""_key(const char* name, std::size_t /*size*/) {
  return {name, TextUse::kKey};
}

/// A key that ends in _one is the text for a count of one, of the key without that ending. No comma
/// follows the last row: with one, clang-format would give each row its own line.
inline constexpr std::array kTextRows = std::to_array<TextRow>(
    {// keys to press: of the consent and of quitting, of yes and no in trials, of the other pages
     "agree_key"_key, "decline_key"_key, "yes_key"_key, "no_key"_key, "again_key"_key,
     "quit_key"_key, "go_on_key"_key, "stop_key"_key, "back_key"_key,
     // the names of keys, as they are printed on buttons
     "space_bar"_label, "enter"_label, "escape"_label,
     // buttons
     "continue"_label, "close"_label, "back"_label, "agree"_label, "decline"_label,
     "see_again"_label, "try_again"_label, "quit"_label, "quit_yes"_label, "quit_no"_label,
     "refuse_yes"_label, "go_on"_label, "stop"_label, "yes"_label, "no"_label, "first"_label,
     "second"_label,
     // how words and numbers are written
     "quoted"_label, "sentence"_label, "decimal_mark"_label, "percent"_label,
     // the beginning and the end
     "welcome_back", "trials_saved_one", "trials_saved", "instructions_again", "refuse_question",
     "declined_title", "declined_saved", "about_you", "about_you_advice", "one_question",
     "part_complete", "part_saved",
     // where a session is
     "trial_label", "practice_label", "training_label", "gaze_lost_mark",
     // practice
     "practice", "practice_first_one", "practice_first", "practice_another_one", "practice_another",
     "training", "training_rule", "demonstration_over", "you_answered", "you_chose",
     "scale_meaning", "scale_between"_label, "was_right", "was_wrong", "clicked_never",
     "clicked_one", "clicked", "time_was_up", "time_to_answer", "answer_by_looks",
     "no_right_answers", "once_more", "practise_again", "did_not_click", "did_not_rate_better",
     "call_experimenter", "practice_unclear", "experimenter_decides", "frames_late",
     "practice_over", "scale_use", "used_never"_label, "used_one"_label, "used"_label,
     "practice_advice", "practice_advice_one_point", "training_result",
     // trials
     "ready", "ready_trials_one", "ready_trials", "ready_advice", "ready_advice_no_cross",
     "break_progress", "pause", "pause_saved", "pause_in_trial", "quit_question", "quit_saved",
     // the gaze
     "pointing_title", "pointing", "pointing_points", "looking_title", "looking", "looking_points",
     "gaze_went_well", "gaze_once_more", "gaze_not_known", "gaze_accuracy", "gaze_worst",
     "gaze_nowhere", "gaze_unseen_one", "gaze_unseen", "gaze_precision", "gaze_samples",
     "gaze_samples_rate", "mouse"_label, "unknown"_label, "gaze_call_experimenter",
     "gaze_again_title", "gaze_drifted", "gaze_not_in_middle", "gaze_off_middle", "shown_again",
     "gaze_was_lost", "keep_pointer", "keep_looking", "look_at_middle", "point_at_middle",
     "map_caption",
     // hints
     "press_or_click", "scroll_hint", "read_to_end", "number_within", "mark_needed",
     "number_needed",
     // of a session in a web page alone
     "page_cannot_go_on"_label, "page_not_sent", "page_no_connection"_label,
     "page_server_answered"_label, "page_not_taken", "page_not_remembered", "page_done_already",
     "page_needs_keyboard", "page_too_small", "page_coarse_clock", "page_unsteady", "page_no_webgl",
     "page_too_old", "page_full_screen", "page_full_screen_why", "page_fill_screen"_label,
     "page_card", "page_card_how", "page_card_width"_label, "page_card_fits"_label,
     "page_skip"_label, "page_distance", "page_distance_how", "page_distance_times",
     "page_distance_gone"});

/// The place of a key, with an ending or without one, in the table; its size: it is not there.
constexpr std::size_t find_text(std::string_view key, std::string_view ending = "") {
  std::size_t at = 0;
  while (at < kTextRows.size() &&
         !(kTextRows[at].key.size() == key.size() + ending.size() &&
           kTextRows[at].key.starts_with(key) && kTextRows[at].key.ends_with(ending))) {
    ++at;
  }
  return at;
}

}  // namespace impetus::inline languages
