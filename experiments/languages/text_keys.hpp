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

/// The row of a text.
struct TextRow {
  std::string_view key;
  TextUse use{TextUse::kWords};
};

/// A key that ends in _one is the text for a count of one, of the key without that ending.
inline constexpr std::array kTextRows = std::to_array<TextRow>({
    // keys to press: of the consent and of quitting, of yes and no in trials, of the other pages
    {"agree_key", TextUse::kKey},
    {"decline_key", TextUse::kKey},
    {"yes_key", TextUse::kKey},
    {"no_key", TextUse::kKey},
    {"again_key", TextUse::kKey},
    {"quit_key", TextUse::kKey},
    {"go_on_key", TextUse::kKey},
    {"stop_key", TextUse::kKey},
    {"back_key", TextUse::kKey},
    // the names of keys, as they are printed on buttons
    {"space_bar", TextUse::kLabel},
    {"enter", TextUse::kLabel},
    {"escape", TextUse::kLabel},
    // buttons
    {"continue", TextUse::kLabel},
    {"close", TextUse::kLabel},
    {"back", TextUse::kLabel},
    {"agree", TextUse::kLabel},
    {"decline", TextUse::kLabel},
    {"see_again", TextUse::kLabel},
    {"try_again", TextUse::kLabel},
    {"quit", TextUse::kLabel},
    {"quit_yes", TextUse::kLabel},
    {"quit_no", TextUse::kLabel},
    {"refuse_yes", TextUse::kLabel},
    {"go_on", TextUse::kLabel},
    {"stop", TextUse::kLabel},
    {"yes", TextUse::kLabel},
    {"no", TextUse::kLabel},
    {"first", TextUse::kLabel},
    {"second", TextUse::kLabel},
    // how words and numbers are written
    {"quoted", TextUse::kLabel},
    {"sentence", TextUse::kLabel},
    {"decimal_mark", TextUse::kLabel},
    {"percent", TextUse::kLabel},
    // the beginning and the end
    {"welcome_back"},
    {"trials_saved_one"},
    {"trials_saved"},
    {"instructions_again"},
    {"refuse_question"},
    {"declined_title"},
    {"declined_saved"},
    {"about_you"},
    {"about_you_advice"},
    {"one_question"},
    {"part_complete"},
    {"part_saved"},
    // where a session is
    {"trial_label"},
    {"practice_label"},
    {"training_label"},
    {"gaze_lost_mark"},
    // practice
    {"practice"},
    {"practice_first_one"},
    {"practice_first"},
    {"practice_another_one"},
    {"practice_another"},
    {"training"},
    {"training_rule"},
    {"demonstration_over"},
    {"you_answered"},
    {"you_chose"},
    {"scale_meaning"},
    {"scale_between", TextUse::kLabel},
    {"was_right"},
    {"was_wrong"},
    {"clicked_never"},
    {"clicked_one"},
    {"clicked"},
    {"time_was_up"},
    {"time_to_answer"},
    {"answer_by_looks"},
    {"no_right_answers"},
    {"once_more"},
    {"practise_again"},
    {"did_not_click"},
    {"did_not_rate_better"},
    {"call_experimenter"},
    {"practice_unclear"},
    {"experimenter_decides"},
    {"frames_late"},
    {"practice_over"},
    {"scale_use"},
    {"used_never", TextUse::kLabel},
    {"used_one", TextUse::kLabel},
    {"used", TextUse::kLabel},
    {"practice_advice"},
    {"practice_advice_one_point"},
    {"training_result"},
    // trials
    {"ready"},
    {"ready_trials_one"},
    {"ready_trials"},
    {"ready_advice"},
    {"break_progress"},
    {"pause"},
    {"pause_saved"},
    {"pause_in_trial"},
    {"quit_question"},
    {"quit_saved"},
    // the gaze
    {"pointing_title"},
    {"pointing"},
    {"pointing_points"},
    {"looking_title"},
    {"looking"},
    {"looking_points"},
    {"gaze_went_well"},
    {"gaze_once_more"},
    {"gaze_not_known"},
    {"gaze_accuracy"},
    {"gaze_worst"},
    {"gaze_nowhere"},
    {"gaze_unseen_one"},
    {"gaze_unseen"},
    {"gaze_precision"},
    {"gaze_samples"},
    {"gaze_samples_rate"},
    {"mouse", TextUse::kLabel},
    {"unknown", TextUse::kLabel},
    {"gaze_call_experimenter"},
    {"gaze_again_title"},
    {"gaze_drifted"},
    {"gaze_not_in_middle"},
    {"gaze_off_middle"},
    {"shown_again"},
    {"gaze_was_lost"},
    {"keep_pointer"},
    {"keep_looking"},
    {"look_at_middle"},
    {"point_at_middle"},
    {"map_caption"},
    // hints
    {"press_or_click"},
    {"scroll_hint"},
    {"read_to_end"},
    {"number_within"},
    {"mark_needed"},
    {"number_needed"},
    // of a session in a web page alone
    {"page_cannot_go_on", TextUse::kLabel},
    {"page_not_sent"},
    {"page_no_connection", TextUse::kLabel},
    {"page_server_answered", TextUse::kLabel},
    {"page_not_taken"},
    {"page_not_remembered"},
    {"page_done_already"},
    {"page_needs_keyboard"},
    {"page_too_small"},
    {"page_coarse_clock"},
    {"page_unsteady"},
    {"page_no_webgl"},
    {"page_too_old"},
    {"page_full_screen"},
    {"page_full_screen_why"},
    {"page_fill_screen", TextUse::kLabel},
    {"page_card"},
    {"page_card_how"},
    {"page_card_width", TextUse::kLabel},
    {"page_card_fits", TextUse::kLabel},
    {"page_skip", TextUse::kLabel},
    {"page_distance"},
    {"page_distance_how"},
    {"page_distance_times"},
    {"page_distance_gone"},
});

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
