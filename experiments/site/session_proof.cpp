// SPDX-License-Identifier: MIT
#include "experiments/site/session_proof.hpp"

#include <algorithm>
#include <utility>

#include "experiments/protocol/participant_code.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline site {

using nlohmann::json;

SessionProof::SessionProof(std::string name, const PublishedStudy& study, const Protocol& protocol,
                           FindEarlier find_earlier)
    : name_(std::move(name)),
      study_(study),
      protocol_(protocol),
      find_earlier_(std::move(find_earlier)) {}

SessionProof::SessionProof(std::string name, const PublishedStudy& study, const Protocol& protocol,
                           const SessionRecord& session, EarlierSessions earlier)
    : name_(std::move(name)),
      study_(study),
      protocol_(protocol),
      session_(session),
      earlier_(std::move(earlier)),
      replay_(std::in_place, protocol, session, study.recording_format) {
  plan_ = planned(earlier_->enrolment.trials, protocol.design);
  standing_.emplace(Standing{plan_, earlier_->enrolment.history});
}

std::optional<AnyRecord> SessionProof::take(const std::string& line) {
  ++line_;
  AnyRecord record = read(line);
  if (!replay_) {
    begin(record);
    return std::nullopt;
  }
  if (auto* trial = std::get_if<PlannedTrial>(&record); trial != nullptr && !standing_) {
    plan_.push_back(std::move(*trial));
    return std::nullopt;
  }
  require_plan();
  if (auto* attempt = std::get_if<AttemptRecord>(&record)) {
    prove(*attempt);
  } else if (const auto* chosen = std::get_if<ChosenLevel>(&record)) {
    require_level(*chosen);
  } else if (const auto* note = std::get_if<NoteRecord>(&record)) {
    stopped_by_sync_test_ = stopped_by_sync_test_ || note->kind == kSyncTestFailedNote;
  } else if (std::holds_alternative<SessionRecord>(record) ||
             std::holds_alternative<PlannedTrial>(record)) {
    refuse_line("expected one session and its plan once, got another");
  }
  add(record, *standing_);
  return record;
}

void SessionProof::refuse_line(const std::string& sentence) const {
  throw InputError(name_ + ": line " + std::to_string(line_) + ": " + sentence);
}

AnyRecord SessionProof::read(const std::string& line) const {
  try {
    return record_from(json::parse(line));
  } catch (const std::exception& error) {
    refuse_line(error.what());
  }
}

void SessionProof::begin(const AnyRecord& record) {
  const auto* session = std::get_if<SessionRecord>(&record);
  if (session == nullptr) {
    refuse_line("expected the session first");
  }
  if (session->protocol_hash != protocol_.hash) {
    refuse_line("expected a session of " + protocol_.name + " (" + protocol_.hash +
                "), got one of " + session->protocol_hash);
  }
  if (!is_participant_code(session->participant)) {
    refuse_line("expected a participant's code, got " + json(session->participant).dump());
  }
  require_screen(session->screen);
  session_ = *session;
  earlier_ = find_earlier_(session_);
  replay_.emplace(protocol_, session_, study_.recording_format);
}

void SessionProof::require_screen(const ScreenGeometry& screen) const {
  constexpr double kMost_m = 1000.0;
  for (const double length_m : {screen.width_m, screen.height_m, screen.viewing_distance_m}) {
    if (!(length_m > 0.0 && length_m <= kMost_m)) {
      refuse_line("expected a screen with sides and a viewing distance above 0 m");
    }
  }
}

/// The plan follows from code and seed: the page's is the program's own.
void SessionProof::require_plan() {
  if (standing_) {
    return;
  }
  if (!replay_) {
    refuse_line("expected a session, got no line");
  }
  if (plan_of(study_, protocol_, session_.participant, session_.seed) != plan_) {
    refuse_line("expected the trials that code and seed lead to, got others");
  }
  if (earlier_) {
    standing_.emplace(Standing{planned(earlier_->enrolment.trials, protocol_.design),
                               earlier_->enrolment.history});
    require_same_plan(standing_->plan);
  } else {
    standing_.emplace(Standing{plan_, SessionHistory{}});
  }
}

/// But for levels, which are chosen on the way.
void SessionProof::require_same_plan(const Plan& stored) const {
  const bool same = std::equal(plan_.begin(), plan_.end(), stored.begin(), stored.end(),
                               [](const PlannedTrial& ours, const PlannedTrial& theirs) {
                                 return ours.slot == theirs.slot && ours.seed == theirs.seed &&
                                        (ours.track || ours.condition == theirs.condition);
                               });
  if (!same) {
    refuse_line("expected the trials with which " + session_.participant +
                " began in this study, got others");
  }
}

const PlannedTrial& SessionProof::trial_at(std::int64_t slot) const {
  const Plan& plan = standing_->plan;
  const auto found = std::find_if(plan.begin(), plan.end(),
                                  [&](const PlannedTrial& trial) { return trial.slot == slot; });
  if (found == plan.end()) {
    refuse_line("expected a trial of the plan, got " + std::to_string(slot));
  }
  return *found;
}

void SessionProof::require_level(const ChosenLevel& chosen) const {
  trial_at(chosen.slot);
  const std::vector<Condition> shown = cells(protocol_.design);
  if (std::find(shown.begin(), shown.end(), chosen.condition) == shown.end()) {
    refuse_line("trial " + std::to_string(chosen.slot) + ": expected a level of the design, got " +
                to_json(chosen.condition).dump());
  }
}

void SessionProof::prove(AttemptRecord& attempt) {
  const std::string trial = "trial " + std::to_string(attempt.slot);
  const PlannedTrial& planned = trial_at(attempt.slot);
  require_bodies(attempt, trial);
  ReplayedAttempt found;
  try {
    found = replay_->replay(planned, attempt);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    refuse_line(trial + ": " + error.what());
  }
  if (found.divergence) {
    refuse_line("expected the states that these inputs lead to, got others from " +
                divergence_words(attempt.slot, *found.divergence) + " on");
  }
  const SessionHistory& history = standing_->history;
  const auto made = history.attempts.find(attempt.slot);
  const std::int64_t before = made == history.attempts.end() ? 0 : made->second;
  if (attempt.number <= before || history.completed_slots.contains(attempt.slot)) {
    refuse_line(trial + ": expected each attempt once, got " + std::to_string(attempt.number) +
                " after " + std::to_string(before));
  }
  steps_ += found.steps;
}

/// What names a body names one.
void SessionProof::require_bodies(const AttemptRecord& attempt, const std::string& trial) const {
  const auto bodies = static_cast<std::int32_t>(attempt.body_names.size());
  for (const CollisionRecord& collision : attempt.collisions) {
    const BodyPair& pair = collision.report.bodies;
    if (pair.a < 0 || pair.a >= bodies || pair.b >= bodies || pair.b < wall_index(kWallCount - 1)) {
      refuse_line(trial + ": expected collisions of its bodies, got one of others");
    }
  }
  for (const StepRecord& step : attempt.steps) {
    for (const NotFiniteBody& found : step.not_finite) {
      if (found.body < 0 || found.body >= bodies) {
        refuse_line(trial + ": expected states of its bodies, got one of another");
      }
    }
  }
}

SessionFacts facts_of(const SessionProof& proof, const std::string& key) {
  const SessionRecord& session = proof.session();
  SessionFacts facts;
  facts.recording_format = proof.recording_format();
  facts.build = session.build;
  facts.machine = session.machine;
  facts.display = session.display;
  facts.screen = session.screen;
  facts.screen_measured = session.screen_measured;
  facts.refresh_hz = session.refresh_hz;
  facts.rounding_allowed = session.rounding_allowed;
  facts.sync = session.sync;
  facts.sync_overridden = !session.sync.passed && !proof.stopped_by_sync_test();
  facts.gaze_source = session.gaze_source;
  facts.resumed = proof.earlier() ? proof.earlier()->resumed : std::nullopt;
  facts.page = SessionPage{proof.name(), key};
  return facts;
}

std::vector<AnyRecord> screen_notes(const SessionProof& proof, StudyFile& study) {
  const ScreenGeometry& screen = proof.session().screen;
  std::vector<AnyRecord> notes;
  const auto before =
      proof.earlier() ? last_screen(study.database(), proof.earlier()->enrolment.id) : std::nullopt;
  if (before && !is_same_screen(*before, screen)) {
    notes.emplace_back(
        NoteRecord{kScreenChangedNote,
                   screen_words(screen) + "; in the session before " + screen_words(*before)});
  }
  if (!has_square_pixels(screen)) {
    notes.emplace_back(NoteRecord{kPixelsNotSquareNote, pixel_words(screen)});
  }
  return notes;
}

}  // namespace impetus::inline site
