// Writes a study's recorded trials as the lines in which a page hands over its own, each after its
// session and its plan: recording_lines STUDY OUT.
//
//   {"kind": "protocol", ...}  {"kind": "session", ...}  {"kind": "trial", ...}  {"kind":
//   "attempt", ...}
//
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "experiments/lines/record_lines.hpp"
#include "experiments/protocol/protocol_file.hpp"
#include "experiments/protocol/solved_values.hpp"
#include "experiments/store/step_rows.hpp"
#include "experiments/store/study_reader.hpp"

namespace impetus {
namespace {

using nlohmann::json;

SessionRecord session_of(const StoredAttempt& attempt) {
  SessionRecord session;
  session.participant = attempt.participant;
  session.screen = attempt.screen;
  session.refresh_hz = attempt.refresh_hz;
  session.rounding_allowed = attempt.rounding_allowed;
  return session;
}

PlannedTrial trial_of(const StoredAttempt& attempt, const Design& design) {
  PlannedTrial trial{attempt.trial_id, attempt.trial.phase, attempt.trial.repetition,
                     condition_from_json(json::parse(attempt.trial.condition), design),
                     attempt.trial.seed};
  trial.solved = solved_values_from(attempt.trial.solved);
  return trial;
}

/// A trial goes by its own number in the study, so that what is found is named by it.
AttemptRecord attempt_of(StudyFile& study, const StoredAttempt& attempt) {
  AttemptRecord record;
  record.slot = attempt.trial_id;
  record.number = attempt.number;
  for (std::int64_t interval = 1; interval <= 2; ++interval) {
    for (StepRecord& step : load_steps(study.database(), attempt.id, interval)) {
      record.steps.push_back(std::move(step));
    }
  }
  return record;
}

void write_lines(const char* file, std::ostream& out) {
  StudyFile study = StudyFile::open_for_reading(file);
  std::map<std::int64_t, Protocol> protocols;
  for (const StoredAttempt& attempt : load_attempts(study)) {
    const std::int64_t id = attempt.protocol_id;
    const ProtocolTexts texts = load_protocol_texts(study, id);
    if (!protocols.contains(id)) {
      protocols.emplace(id, trusted_protocol(parse_json(texts.name, texts.protocol_json),
                                             parse_json(texts.name, texts.scene_json)));
    }
    out << json{{"kind", "protocol"},
                {"id", id},
                {"recording_format", attempt.recording_format},
                {"protocol", texts.protocol_json},
                {"scene", texts.scene_json}}
               .dump()
        << "\n"
        << line_of(session_of(attempt)) << "\n"
        << line_of(trial_of(attempt, protocols.at(id).design)) << "\n"
        << line_of(attempt_of(study, attempt), Digests::kKept) << "\n";
  }
}

}  // namespace
}  // namespace impetus

int main(int count, char** words) {
  if (count != 3) {
    std::fputs("usage: recording_lines STUDY OUT\n", stderr);
    return 2;
  }
  std::ofstream out(words[2]);
  impetus::write_lines(words[1], out);
  return out.flush() ? 0 : 1;
}
