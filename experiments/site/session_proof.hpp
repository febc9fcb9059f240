// What a page hands over, held line by line against the study that was published: the plan must
// follow from code and seed, and every trial, simulated again, must reach the same states.
//
// What is proved is that these trials were simulated from these inputs, in this order; never that a
// person sat there.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/lines/published_study.hpp"
#include "experiments/lines/record_lines.hpp"
#include "experiments/lines/replayed_attempt.hpp"
#include "experiments/lines/standing.hpp"
#include "experiments/store/enrolment.hpp"
#include "experiments/store/session_rows.hpp"

namespace impetus::inline site {

/// What a study file has of a participant who begins a session.
struct EarlierSessions {
  Enrolment enrolment;                      ///< whose history is what the session goes on from
  std::optional<ResumedSession> resumed{};  ///< none: enrolled, but there was no session yet
};

/// Looks for it when a session begins; none: the participant is new. May throw what keeps the
/// session from beginning.
using FindEarlier = std::function<std::optional<EarlierSessions>(const SessionRecord& session)>;

/// Proves one session.
class SessionProof {
 public:
  /// `study` and `protocol` must outlive this.
  SessionProof(std::string name, const PublishedStudy& study, const Protocol& protocol,
               FindEarlier find_earlier);

  /// Goes on with a session of which some is kept.
  SessionProof(std::string name, const PublishedStudy& study, const Protocol& protocol,
               const SessionRecord& session, EarlierSessions earlier);

  /// Reads the next line; returns the record that is to be kept, its digests filled in, or none
  /// where the line says of which session and plan the others are. Throws InputError, naming the
  /// session, the line, the trial and what differs; then nothing more may be taken.
  std::optional<AnyRecord> take(const std::string& line);

  /// Throws InputError unless session and plan were taken.
  void require_plan();

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const SessionRecord& session() const { return session_; }
  [[nodiscard]] int recording_format() const { return study_.recording_format; }
  [[nodiscard]] const Plan& plan() const { return plan_; }
  [[nodiscard]] const std::optional<EarlierSessions>& earlier() const { return earlier_; }
  [[nodiscard]] std::int64_t steps() const { return steps_; }  ///< simulated again

  /// Whether it ended where it would have begun, for its sync test failed.
  [[nodiscard]] bool stopped_by_sync_test() const { return stopped_by_sync_test_; }

 private:
  [[noreturn]] void refuse_line(const std::string& sentence) const;
  AnyRecord read(const std::string& line) const;
  void begin(const AnyRecord& record);
  void require_screen(const ScreenGeometry& screen) const;
  void require_same_plan(const Plan& stored) const;
  const PlannedTrial& trial_at(std::int64_t slot) const;
  void require_level(const ChosenLevel& chosen) const;
  void prove(AttemptRecord& attempt);
  void require_bodies(const AttemptRecord& attempt, const std::string& trial) const;

  std::string name_;
  const PublishedStudy& study_;
  const Protocol& protocol_;
  FindEarlier find_earlier_;
  SessionRecord session_;
  Plan plan_;  ///< as code and seed lead to it
  std::optional<EarlierSessions> earlier_;
  std::optional<AttemptReplay> replay_;  ///< once the session is known
  std::optional<Standing> standing_;     ///< once the plan is known
  bool stopped_by_sync_test_{false};
  std::int64_t steps_{0};
  std::int64_t line_{0};
};

/// What the session's row says of it.
SessionFacts facts_of(const SessionProof& proof, const std::string& key);

/// What a reader must know of the session's screen: that another was used before, or that its
/// pixels are not square.
std::vector<AnyRecord> screen_notes(const SessionProof& proof, StudyFile& study);

}  // namespace impetus::inline site
