// The answers of a study, each with what was shown: every trial simulated again, once.
//
//   attempt ─replay─> collisions as they were recorded ─the observers' percepts─> people's trials
//
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/fitting/answered_trials.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "experiments/study/replay_library.hpp"

namespace impetus::inline commands {

/// Whose answers, and to which of the study's protocols.
struct AnswerChoice {
  std::string protocol;  ///< its name; "": the study's only one
  std::string code;      ///< of a participant; "": everybody's
};

/// The answers of completed main trials that are not excluded.
struct AnsweredStudy {
  std::vector<StoredAttempt> attempts;  ///< of one protocol, in order
  std::int64_t protocol_id{0};
  bool all_simulated{false};          ///< nobody but simulated participants took part
  std::size_t simulated_left_out{0};  ///< beside people
};

/// Throws InputError where there is no such protocol or participant, and where it is left open
/// which of several protocols is meant.
AnsweredStudy choose_answers(StudyFile& study, const AnswerChoice& choice);

/// What everybody answered, with the percepts of each observer: a list of people for each, by their
/// codes, whoever finished first. `told` is told the share that is done. Throws InputError when a
/// trial does not replay as it was recorded.
std::vector<std::vector<AnsweringPerson>> answering_people(
    StudyFile& study, ReplayLibrary& library, const AnsweredStudy& answered,
    const std::vector<ObserverFile>& observers, const Progress& told);

}  // namespace impetus::inline commands
