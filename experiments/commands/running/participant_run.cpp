// SPDX-License-Identifier: MIT
#include "experiments/commands/running/participant_run.hpp"

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <optional>
#include <utility>

#include "experiments/commands/running/enrolling.hpp"
#include "experiments/commands/running/session_warnings.hpp"
#include "experiments/markers/marker_writer.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/provenance/machine_name.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/record/ports.hpp"
#include "experiments/store/session_rows.hpp"
#include "experiments/store/study_writer.hpp"
#include "experiments/study/stored_plan.hpp"
#include "experiments/study/taking_up.hpp"

namespace impetus::inline commands {
namespace {

/// In a series nobody is asked the same about themselves twice.
void skip_told_demographics(StudyFile& study, const RunPart& part, const std::string& participant,
                            SessionHistory& history) {
  const auto told = told_demographics(study, participant);
  const std::vector<Field>& fields = part.protocol.script.demographics;
  const bool all = std::all_of(fields.begin(), fields.end(), [&](const Field& field) {
    const auto found = told.find(field.id);
    return found != told.end() && found->second == field.label;
  });
  for (const Field& field : fields) {
    if (all) {
      history.answered.insert(field.id);
    }
  }
}

SessionFacts facts_of(Laboratory& laboratory, const Gaze* gaze, const RunPart& part,
                      const RunOptions& options, const SyncTest& sync) {
  const LaboratoryOptions& lab = part.lab;
  SessionFacts facts;
  facts.build = build_name();
  facts.machine = machine_name();
  facts.display = laboratory.description();
  facts.simulated = lab.observer.has_value();
  facts.observer = lab.observer ? lab.observer->document.value.dump() : "";
  facts.screen = laboratory.display().geometry();
  facts.screen_measured = laboratory.screen_measured();
  facts.screen_light = laboratory.screen_light();
  facts.refresh_hz = laboratory.display().refresh_hz();
  facts.rounding_allowed = options.allow_rounding;
  facts.sync = sync;
  facts.sync_overridden = !sync.passed && options.override_sync_test;
  facts.photodiode_patch = lab.photodiode ? name_of(*lab.photodiode) : "";
  facts.gaze_source = part.protocol.script.gaze && gaze != nullptr ? gaze->source() : "";
  facts.series = part.series;
  facts.series_place = part.series_place;
  return facts;
}

/// Says of the screen what a reader of the study must know.
void save_screen_notes(const ScreenGeometry& screen, const std::string& change,
                       StudyWriter& writer) {
  if (!change.empty()) {
    std::fprintf(stderr, "warning: the screen changed: %s\n", change.c_str());
    writer.save(NoteRecord{kScreenChangedNote, change});
  }
  if (!has_square_pixels(screen)) {
    writer.save(NoteRecord{kPixelsNotSquareNote, pixel_words(screen)});
  }
}

/// Says how many markers did not reach the other recorder in time, where some did not.
void save_markers_note(const MarkerCounts& counts, StudyWriter& writer) {
  if (counts.lost == 0) {
    return;
  }
  const std::string words = std::to_string(counts.lost) + " of " + std::to_string(counts.marked) +
                            " markers were not sent in time";
  std::fprintf(stderr, "warning: %s\n", words.c_str());
  writer.save(NoteRecord{kMarkersLostNote, words});
}

/// How far its stamps can be trusted.
void save_tracker_note(const Tracker* tracker, StudyWriter& writer) {
  if (tracker != nullptr) {
    writer.save(NoteRecord{kGazeTrackerNote, tracker->clock_words() + "; it fell silent " +
                                                 std::to_string(tracker->silences()) + " times"});
  }
}

/// The participant may still sit there, so that it can be mended before more is recorded.
void tell_at_once(const std::string& sentence) {
  std::fprintf(stderr, "warning: %s\n", sentence.c_str());
}

void warn_of_clock(const std::optional<ResumedSession>& resumed, const std::string& participant) {
  if (resumed && *resumed->after_s < 0.0) {
    std::fprintf(stderr,
                 "warning: the last record of %s lies %s ahead of this machine's clock, which may "
                 "have been set back; the gap is stored as it is\n",
                 participant.c_str(), duration_words(-*resumed->after_s).c_str());
  }
}

/// Says how the session ended.
void conclude(const SessionResult& result, const RunOptions& options, StudyWriter& writer) {
  const auto done = static_cast<long long>(result.completed_trials);
  const auto total = static_cast<long long>(result.expected_trials);
  switch (result.ending) {
    case SessionEnding::kFinished:
      writer.end("finished");
      return;
    case SessionEnding::kDeclined:
      writer.end("declined");
      std::printf("The participant did not consent; nothing was shown.\n");
      return;
    case SessionEnding::kQuit:
      writer.end("quit");
      std::printf("Stopped with %lld of %lld trials saved; the same command goes on.\n", done,
                  total);
      return;
    default:
      writer.end("display closed");
      throw InputError("the window was closed with " + std::to_string(done) + " of " +
                       std::to_string(total) + " trials saved in " + options.database + " (" +
                       sitting_words(options.participant, {writer.session_id()}) +
                       "); the same command goes on");
  }
}

}  // namespace

std::string sitting_words(const std::string& participant,
                          const std::vector<std::int64_t>& sessions) {
  std::string words =
      "participant " + participant + (sessions.size() == 1 ? ", session" : ", sessions");
  for (const std::int64_t session : sessions) {
    words += (session == sessions.front() ? " " : ", ") + std::to_string(session);
  }
  return words;
}

ParticipantRun::ParticipantRun(const RunPart& part, const RunOptions& options, StudyFile& study,
                               std::shared_ptr<Laboratory> laboratory)
    : part_(part), options_(options), study_(study), laboratory_(std::move(laboratory)) {
  const std::lock_guard lock(study.transactions());
  std::optional<Enrolment> resumed = find_to_resume(study, part, options_);
  plan_ =
      resumed ? planned(resumed->trials, part.protocol.design) : new_plan(study, part, options_);
  if (resumed) {
    resumed_ = take_up(study, part.protocol, options_.participant, plan_, *resumed);
    warn_of_clock(resumed_, options_.participant);
  }
  gaze_paths_ = gaze_paths_of(plan_, study);
  if (!options_.markers.empty()) {
    markers_ = open_marker_line(options_.markers);
  }
  if (!laboratory_) {
    if (const auto expected = expected_screen(part.lab); expected && resumed) {
      change_of_screen(study, options_, *resumed, *expected);
    }
    LaboratoryOptions lab = part.lab;
    lab.participant = options_.participant;
    lab.seed = resumed ? resumed->seed : options_.seed.value_or(1);
    laboratory_ = open_laboratory(lab);
  }
  if (resumed) {
    screen_change_ = change_of_screen(study, options_, *resumed, laboratory_->display().geometry());
  }
  if (part.gaze) {
    eye_ = std::make_unique<RecordedEye>(part.gaze, main_slots(plan_),
                                         laboratory_->display().geometry(), laboratory_->clock());
  } else if (part.tracker) {
    eye_ = std::make_unique<TrackedEye>(part.tracker, laboratory_->display().geometry());
  }
  sync_ = laboratory_->sync_test();
  enrolment_ = resumed ? std::move(*resumed) : enrol_anew(study, part, options_, plan_);
  if (!part.series.empty()) {
    skip_told_demographics(study, part, options_.participant, enrolment_.history);
  }
}

SessionEnding ParticipantRun::run(const std::function<void()>& saved) {
  const Protocol& protocol = part_.protocol;
  SessionFacts facts = facts_of(*laboratory_, gaze(), part_, options_, sync_);
  facts.resumed = resumed_;
  StudyWriter writer(study_, enrolment_, facts);
  writer.tell(saved);
  if (!options_.keeps_steps) {
    writer.keep_no_steps();
  }
  save_screen_notes(facts.screen, screen_change_, writer);
  save_tracker_note(part_.tracker.get(), writer);
  if (!sync_.passed && !options_.override_sync_test) {
    writer.save(NoteRecord{kSyncTestFailedNote, sync_.verdict});
    writer.end("failed");
    throw InputError("the sync test failed in " + std::to_string(sync_.tries) + " tries: " +
                     sync_.verdict + "; --override-sync-test goes on and marks every trial");
  }
  const double rounding_hz = options_.allow_rounding ? laboratory_->display().refresh_hz() : 0.0;
  const ProtocolScenes scenes(protocol, rounding_hz);
  const SteadyClock work_clock;
  Ports ports{
      laboratory_->display(), laboratory_->input(), scenes,       writer,           gaze(),
      &laboratory_->clock(),  &work_clock,          &gaze_paths_, GazeCorrection{}, tell_at_once};
  if (is_heard(protocol) && laboratory_->sounds() != nullptr) {
    writer.save(NoteRecord{kSoundNote, laboratory_->sound_words()});
    ports.sounds = laboratory_->sounds();
  }
  std::optional<MarkerWriter> markers;
  if (markers_) {
    writer.save(NoteRecord{kMarkersNote, options_.markers});
    markers.emplace(std::move(markers_), *protocol.script.markers, laboratory_->clock());
    ports.markers = &*markers;
  }
  const SessionResult result =
      run_session(protocol.script, plan_, enrolment_.history, ports, protocol.design);
  save_tracker_note(part_.tracker.get(), writer);  // two clocks drift apart
  tell_warnings(result, writer);
  if (const std::string lost = laboratory_->sound_lost(); !lost.empty()) {
    std::fprintf(stderr, "warning: %s\n", lost.c_str());
    writer.save(NoteRecord{kSoundLostNote, lost});
  }
  if (markers) {
    save_markers_note(markers->counts(), writer);
  }
  conclude(result, options_, writer);
  session_id_ = writer.session_id();
  return result.ending;
}

}  // namespace impetus::inline commands
