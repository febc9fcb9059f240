// The kinds of response that a protocol can ask for. Each is one source file in this folder: the
// rows of its block in the protocol and their checks, its page, what becomes of an answer, how a
// simulated participant gives one, and what exports and pages of explanation call it.
//
//   protocol ─read─> question ─page─> Input::ask ─> answer ─keep─> record ─feedback─> after
//   practice
//
// A new kind is such a file and its line in response_kinds.cpp: CONTRIBUTING.md shows one.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/questions/script.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline questions {

/// Something that a kind records.
struct DeclaredValue {
  std::string name;
  std::string meaning;
};

/// The trial that a question is about; what it refers to must outlive it.
struct AskedTrial {
  const PlannedTrial& trial;
  const SessionProgress& progress;
  std::int64_t test_interval{1};  ///< which of two intervals showed the condition's own stimulus
  /// Whether two bodies of the condition's own stimulus touch until its scene's end, seen or not;
  /// none where there is no scene.
  std::function<bool(const std::array<std::string, 2>& names)> touch{};
};

/// A simulated participant, as a question meets it after the stimulus.
class Judge {
 public:
  virtual ~Judge() = default;

  /// How clearly something wrong was seen in each interval of the trial, from 0 to 1.
  [[nodiscard]] virtual const std::vector<double>& seen_in_intervals() const = 0;
  /// The same in the clearest of them.
  [[nodiscard]] double clearest() const;

  /// Probability of each point of a rating scale, from its good end on, for what was seen.
  [[nodiscard]] virtual std::vector<double> probabilities(double seen) const = 0;
  /// Probability of yes for what was seen.
  [[nodiscard]] virtual double yes_probability(double seen) const = 0;
  /// Probability that the first of two intervals is chosen, for what was seen in each.
  [[nodiscard]] virtual double first_probability(double seen_first, double seen_second) const = 0;

  /// Where a line from nothing to everything is marked, 0 to 1; and one from the contrary, −1 to 1.
  virtual double mark() { return clearest(); }
  virtual double two_sided_mark() { return 2.0 * mark() - 1.0; }

  /// A draw from 0 to below 1.
  virtual double uniform() = 0;
};

/// What all questions of a kind have in common.
struct ResponseKind {
  std::string name;
  std::string protocol_key;                     ///< its block of parameters in a protocol
  std::string when;                             ///< in which part of a trial
  std::string table;                            ///< of the study file, that keeps it
  Kind<std::shared_ptr<const Question>> block;  ///< what the block may say, and what it asks
  /// Recorded beside the attempt it belongs to: the table's columns; of the table `response`, the
  /// names in its column `detail`.
  std::vector<DeclaredValue> recorded;
  std::string event;  ///< what an export says of such an event

  /// What `impetus power` tests of it, "rating", "answer" or "clicks"; "": nothing.
  std::string tested_as{};
  bool during_stimulus{false};  ///< there is no page for it
  bool is_typed{false};         ///< an anonymised study lacks what was typed
  bool asks_for_a_fact{false};  ///< some answer is true, whether the protocol knows it or not
  bool is_two_sided{false};     ///< answers are positive or negative: adaptive levels follow them
  double guessed_share{0.0};    ///< of right answers, where whoever sees nothing has to choose
  std::string guessing{};       ///< "between two intervals": among what

  /// Answers a page as a simulated participant does; null: the first choice, and no words.
  void (*simulate)(const Page& page, Judge& judge, Answer& answer){nullptr};
};

/// A body that a question is about.
struct NamedBody {
  std::string place;  ///< JSON Pointer into the protocol
  std::string name;
};

/// What a script asks by one kind of response, with the parameters that its protocol gives.
class Question {
 public:
  virtual ~Question() = default;
  [[nodiscard]] virtual const ResponseKind& kind() const = 0;

  /// Whether the protocol's block fits itself, and whether it fits the design, whose factors are
  /// known to be sound. Both throw InputError.
  virtual void check_block(const JsonDocument& /*protocol*/) const {}
  virtual void check_in_design(const JsonDocument& /*protocol*/, const Design& /*design*/) const {}
  /// Whether all of the block has an effect: of files alone (see check_sense). Throws InputError.
  virtual void check_sense(const JsonDocument& /*protocol*/, const Design& /*design*/) const {}
  /// Whether an answer can be right or wrong.
  [[nodiscard]] virtual bool has_right_answer() const { return false; }
  /// How many answers have a key that a protocol may choose; 0: none.
  [[nodiscard]] virtual std::size_t keyed_answers() const { return 0; }
  /// The keys that the protocol's block chooses for them; none: the page has its own.
  [[nodiscard]] virtual std::vector<std::string> keys() const { return {}; }
  /// How long there is to answer; 0: as long as one likes.
  [[nodiscard]] virtual double timeout_ms() const { return 0.0; }
  /// Factors by whose levels it is chosen what is asked: they need change nothing of the scene.
  [[nodiscard]] virtual std::vector<std::string> asked_by() const { return {}; }
  /// Bodies that every scene of the protocol must have, each with its place in the protocol.
  [[nodiscard]] virtual std::vector<NamedBody> named_bodies() const { return {}; }
  /// The page after the stimulus; none: nothing is asked then, and nothing kept.
  [[nodiscard]] virtual std::optional<Page> page(const AskedTrial& /*asked*/) const { return {}; }
  /// Puts what was answered, or that the time was up, into the record.
  virtual void keep(const AskedTrial& /*asked*/, const Answer& /*answer*/,
                    AttemptRecord& /*record*/) const {}
  /// What is said of the answer after a practice trial; empty: nothing.
  [[nodiscard]] virtual Text feedback(const AttemptRecord& /*record*/,
                                      const Language& /*language*/) const {
    return {};
  }

  /// What a page of explanation says of it, where `words` makes any text fit to stand there: what
  /// is asked, or what is recorded during the stimulus.
  using Words = std::function<std::string(const std::string&)>;
  [[nodiscard]] virtual std::string explanation(const Words& words) const = 0;
};

/// All kinds, in the order in which they are asked.
const std::vector<std::reference_wrapper<const ResponseKind>>& response_kinds();

/// The same in the order in which words list them: what is asked after the stimulus comes first.
const std::vector<std::reference_wrapper<const ResponseKind>>& listed_kinds();

/// `"rating", "yes_no" or "clicks"`: the keys of the kinds of which `is_meant` is true.
std::string list_keys(const std::function<bool(const ResponseKind&)>& is_meant);

/// The kind of this name; null when there is none.
const ResponseKind* find_kind(const std::string& name);

/// The blocks of all kinds in a protocol, read in the order in which they are asked.
RowList<Script> question_rows();

/// A kind's block, which becomes a question of the class that is its struct.
template <typename Asked>
Kind<std::shared_ptr<const Question>> block(const std::string& sentence,
                                            const RowList<Asked>& rows) {
  return {rows.form(sentence), [rows](const nlohmann::json& value) {
            auto question = std::make_shared<Asked>();
            rows.read(value, question.get());
            return question;
          }};
}

/// After how long without an answer a question is over, ms.
Kind<double> timeout_kind();

/// A script's question of a class that is known; null when it asks none.
template <typename Asked>
const Asked* find_question(const Script& script) {
  for (const auto& question : script.asked) {
    if (const auto* asked = dynamic_cast<const Asked*>(question.get())) {
      return asked;
    }
  }
  return nullptr;
}

/// Whether clicks during the stimulus are asked for.
bool takes_clicks(const Script& script);
/// Whether the first of them ends it.
bool ends_with_click(const Script& script);

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
/// The page of such a question, still without what is chosen or filled in. `timeout_ms`: 0: none.
Page page_of(const ResponseKind& kind, Page::Layout layout, const std::string& question,
             const AskedTrial& asked, double timeout_ms = 0.0);

ResponseRecord response_record(const std::string& kind, const std::string& question,
                               const Answer& answer);

/// "The time was up", and how much there is: what is said after practice.
Text time_was_up(double timeout_ms, const Language& language);

/// "That was right.", or that it was not and what the right answer was.
std::string right_or_wrong(bool right, const std::string& right_answer, const Language& language);

}  // namespace impetus::inline questions
