// The kinds of response that a protocol can ask for. Each is one file in responses/: its parameters
// in the protocol, what it records, its page, and what an answer becomes.
//
//   script ─is_asked─> page ─Input::ask─> answer ─keep─> record ─feedback─> words after practice
//
// A new kind is such a file, its line in response_kinds.cpp, and its block in the protocol's schema
// and the script: a test holds declarations, schema and tables against each other.
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/record/ports.hpp"
#include "experiments/record/script.hpp"

namespace impetus::inline questions {

struct DeclaredValue {
  std::string name;
  std::string meaning;
  bool optional{false};  ///< of a parameter: it may be left out
};

/// The trial that a question is about; what it refers to must outlive it.
struct AskedTrial {
  const Script& script;
  const PlannedTrial& trial;
  const SessionProgress& progress;
  std::int64_t test_interval{1};  ///< which of two intervals showed the condition's own stimulus
};

struct ResponseKind {
  std::string name;
  std::string protocol_key;               ///< its block of parameters in a protocol
  std::string when;                       ///< in which part of a trial
  std::string table;                      ///< of the study file, that keeps it
  std::vector<DeclaredValue> parameters;  ///< of that block
  /// Recorded beside the attempt it belongs to: the table's columns; of the table `response`, the
  /// names in its column `detail`.
  std::vector<DeclaredValue> recorded;
  std::string simulated_by;  ///< Input's function that a simulated participant has

  bool (*is_asked)(const Script& script);
  /// Whether an answer can be right or wrong; null: never.
  bool (*has_right_answer)(const Script& script){nullptr};
  /// The question after the stimulus; null: nothing is asked then, and nothing kept.
  Page (*page)(const AskedTrial& asked){nullptr};
  /// Puts what was answered, or that the time was up, into the record.
  void (*keep)(const AskedTrial& asked, const Answer& answer, AttemptRecord& record){nullptr};
  /// What is said of the answer after a practice trial; null: nothing.
  Text (*feedback)(const Script& script, const AttemptRecord& record){nullptr};
};

/// All kinds, in the order in which they are asked.
const std::vector<ResponseKind>& response_kinds();

/// The names of those that a script asks for.
std::vector<std::string> responses_of(const Script& script);

/// Whether the script has a question that can be answered right or wrong.
bool has_right_answers(const Script& script);

/// Whether all questions that have a right answer were answered right; none without such a
/// question.
std::optional<bool> answered_right(const AttemptRecord& record);

/// The answer that counts for a threshold: the first that is positive or negative; none when it
/// timed out.
std::optional<bool> counted_answer(const AttemptRecord& attempt);

/// The answer to a question of this kind in a record; null when there is none.
const ResponseRecord* response_to(const std::string& kind, const AttemptRecord& record);

/// A record of the kind with what every kind records alike.
ResponseRecord response_record(const std::string& kind, const std::string& question,
                               const Answer& answer);

/// "The time was up", and how much there is: what is said after practice.
Text time_was_up(double timeout_ms);

}  // namespace impetus::inline questions
