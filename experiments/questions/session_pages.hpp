// The pages that every session shows, whatever the study: their words are those of the language
// that the progress on them has.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>

#include "experiments/design/plan.hpp"
#include "experiments/questions/rating.hpp"

namespace impetus::inline questions {

inline constexpr std::size_t kContinueChoice = 0;  ///< of the pause page
inline constexpr std::size_t kQuitChoice = 0;      ///< of the quit page
inline constexpr std::size_t kAgainChoice = 1;     ///< of the page after a demonstration
inline constexpr std::size_t kBackChoice = 1;  ///< of a page that leads back, and of the refusal

/// The choices of the page that asks for consent.
enum class ConsentChoice : std::size_t { kAgree, kDecline, kBack };

Text welcome_back(const Language& language, std::int64_t completed_trials);
Page text_page(const Text& text, const SessionProgress& progress);
/// A text page that leads on, or back to the one before it.
Page text_page_with_way_back(const Text& text, const SessionProgress& progress);

/// Has the statement that is agreed to on it. Who has not seen its end cannot agree yet.
Page consent_page(const Text& text, const std::string& statement, const SessionProgress& progress);
/// After a refusal: the first choice confirms it.
Page refusal_page(const SessionProgress& progress);
/// The last page of who refused.
Page declined_page(const SessionProgress& progress);
Page demographics_page(const std::vector<Field>& fields, const SessionProgress& progress);
/// Before the trials of a phase; `round` is of practice, 1 for the first. Where the script shows a
/// cross before each, it is told to look at it.
Page phase_intro(const Script& script, TrialPhase phase, std::int64_t round, std::int64_t count,
                 const SessionProgress& progress);
/// Before training.
Page training_intro(const TrainingRule& rule, const SessionProgress& progress);

/// After a demonstration: on, or the same again.
Page demonstration_over(const Text& text, const SessionProgress& progress);

/// After each practice trial: what was answered and what that meant, how often was clicked (where
/// clicks are asked for), and right or wrong where there is a right answer. Nothing where nothing
/// can be said, as of free words.
std::optional<Page> practice_feedback(const Script& script, const AttemptRecord& record,
                                      const SessionProgress& progress);

/// After a round of practice that was not understood, with another to come: what was missing.
Page practice_again(const std::vector<std::string>& missing, const SessionProgress& progress);

/// A page that the experimenter answers: kContinueChoice goes on.
Page experimenter_decides(const Text& text, const SessionProgress& progress);

/// After the last such round: the experimenter decides.
Page practice_not_understood(const SessionProgress& progress);

/// At a break: so many of the timed frames were late, and what was shown took a share longer than
/// it should; the experimenter decides.
Page frames_were_late(std::int64_t late, std::int64_t frames, double slower_share,
                      const SessionProgress& progress);

/// After practice: how often each point was used, and a reminder when only one was.
Page practice_summary(const RatingScale& scale, const std::map<std::int64_t, std::int64_t>& use,
                      const SessionProgress& progress);

/// After training: how many of the last answers were right.
Page training_over(std::int64_t right, std::int64_t of, const SessionProgress& progress);

Page break_page(const Text& text, std::int64_t done, std::int64_t total,
                const SessionProgress& progress);
Page question_page(const FreeQuestion& question, const SessionProgress& progress);
Page pause_page(const SessionProgress& progress);
Page quit_page(const SessionProgress& progress);

/// In place of the thanks, where another part of a series follows.
Text part_complete(const Language& language, std::size_t part, std::size_t parts);

/// The last page: leaving it closes the session, or goes on to the next part of a series.
Page thanks_page(const Text& text, bool part_follows, const SessionProgress& progress);

}  // namespace impetus::inline questions
