// SPDX-License-Identifier: MIT
#include "experiments/commands/participant_run.hpp"

#include <sys/utsname.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <optional>
#include <utility>

#include "build_info.hpp"
#include "experiments/protocol/protocol_checks.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/session/gaze_latency.hpp"
#include "experiments/session/steady_clock.hpp"
#include "experiments/store/study_writer.hpp"

namespace impetus {
namespace {

std::string machine_name() {
  utsname names{};
  uname(&names);
  return std::string(names.sysname) + " " + names.release + " " + names.machine;
}

std::vector<StoredTrial> stored(const Plan& plan) {
  std::vector<StoredTrial> trials;
  for (const PlannedTrial& trial : plan) {
    trials.push_back({0, trial.slot, trial.phase, trial.repetition, to_json(trial.condition).dump(),
                      trial.seed});
  }
  return trials;
}

Plan planned(const std::vector<StoredTrial>& trials, const Design& design) {
  Plan plan;
  for (const StoredTrial& trial : trials) {
    const auto condition = nlohmann::json::parse(trial.condition);
    plan.push_back({trial.slot, trial.phase, trial.repetition,
                    condition_from_json(condition, design), trial.seed});
  }
  return plan;
}

/// The stored enrolment, to be resumed, if there is one.
std::optional<Enrolment> find_to_resume(StudyFile& study, const Protocol& protocol,
                                        const RunOptions& options) {
  const bool simulated = !options.observers.empty();
  auto found = find_enrolment(study, options.participant, simulated, texts_of(protocol));
  if (found && options.seed && *options.seed != found->seed) {
    throw InputError("--seed " + std::to_string(*options.seed) + ": expected " +
                     std::to_string(found->seed) + ", with which " + options.participant +
                     "'s trials were planned");
  }
  return found;
}

/// A new enrolment with its whole plan.
Enrolment enrol_anew(StudyFile& study, const Protocol& protocol, const RunOptions& options) {
  const ProtocolTexts texts = texts_of(protocol);
  for (const std::string& hash : other_versions(study, texts)) {
    std::fprintf(stderr, "note: %s also holds another version of %s (%s)\n", study.name().c_str(),
                 protocol.name.c_str(), hash.c_str());
  }
  const std::uint64_t seed = options.seed.value_or(1);
  const Plan plan = plan_for(protocol, options.participant, seed);
  return enrol(study, options.participant, !options.observers.empty(), texts, seed, stored(plan));
}

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

SessionFacts facts_of(Laboratory& laboratory, const RunPart& part, const RunOptions& options,
                      const SyncTest& sync) {
  const LaboratoryOptions& lab = part.lab;
  SessionFacts facts;
  facts.build = kBuild;
  facts.machine = machine_name();
  facts.display = laboratory.description();
  facts.simulated = lab.observer.has_value();
  facts.observer = lab.observer ? lab.observer->document.value.dump() : "";
  facts.screen = laboratory.display().geometry();
  facts.screen_measured = laboratory.screen_measured();
  facts.refresh_hz = laboratory.display().refresh_hz();
  facts.rounding_allowed = options.allow_rounding;
  facts.sync = sync;
  facts.sync_overridden = !sync.passed && options.override_sync_test;
  facts.series = part.series;
  facts.series_place = part.series_place;
  return facts;
}

void tell_gaze_latency(const SessionResult& result) {
  if (result.slow_gaze_trials > 0) {
    std::fprintf(stderr,
                 "warning: from gaze sample to flip, %lld trials took more than %.0f ms (95th "
                 "percentile); %lld of them more than %.0f ms, and are marked\n",
                 static_cast<long long>(result.slow_gaze_trials), kWarnedGazeLatency_ms,
                 static_cast<long long>(result.late_gaze_trials), kMarkedGazeLatency_ms);
  }
}

/// Says how the session ended.
void conclude(const SessionResult& result, StudyWriter& writer) {
  const auto done = static_cast<long long>(result.completed_trials);
  const auto total = static_cast<long long>(result.expected_trials);
  switch (result.ending) {
    case SessionEnding::kFinished:
      writer.end("finished");
      return;
    case SessionEnding::kDeclined:
      writer.end("quit");
      std::printf("The participant did not consent; nothing was shown.\n");
      return;
    case SessionEnding::kQuit:
      writer.end("quit");
      std::printf(
          "Stopped with %lld of %lld trials saved; the same command goes on with the next.\n", done,
          total);
      return;
    default:
      writer.end("display closed");
      throw InputError("the window was closed with " + std::to_string(done) + " of " +
                       std::to_string(total) +
                       " trials saved; the same command goes on with the next");
  }
}

}  // namespace

ParticipantRun::ParticipantRun(const RunPart& part, const RunOptions& options, StudyFile& study,
                               std::shared_ptr<Laboratory> laboratory)
    : part_(part), options_(options), study_(study), laboratory_(std::move(laboratory)) {
  const std::lock_guard lock(study.transactions());
  std::optional<Enrolment> resumed = find_to_resume(study, part.protocol, options_);
  if (!laboratory_) {
    LaboratoryOptions lab = part.lab;
    lab.participant = options_.participant;
    lab.seed = resumed ? resumed->seed : options_.seed.value_or(1);
    laboratory_ = open_laboratory(lab);
  }
  sync_ = laboratory_->sync_test();
  enrolment_ = resumed ? std::move(*resumed) : enrol_anew(study, part.protocol, options_);
  if (!part.series.empty()) {
    skip_told_demographics(study, part, options_.participant, enrolment_.history);
  }
}

SessionEnding ParticipantRun::run(const std::function<void()>& saved) {
  const Protocol& protocol = part_.protocol;
  const Plan plan = planned(enrolment_.trials, protocol.design);
  StudyWriter writer(study_, enrolment_, facts_of(*laboratory_, part_, options_, sync_));
  writer.tell(saved);
  if (!sync_.passed && !options_.override_sync_test) {
    writer.save(NoteRecord{"sync test failed", sync_.verdict});
    writer.end("failed");
    throw InputError("the sync test failed in " + std::to_string(sync_.tries) + " tries: " +
                     sync_.verdict + "; --override-sync-test goes on and marks every trial");
  }
  const double rounding_hz = options_.allow_rounding ? laboratory_->display().refresh_hz() : 0.0;
  const ProtocolScenes scenes(protocol, rounding_hz, part_.shapes);
  const SteadyClock work_clock;
  const Ports ports{laboratory_->display(), laboratory_->input(),  scenes,     writer,
                    laboratory_->gaze(),    &laboratory_->clock(), &work_clock};
  const SessionResult result = run_session(protocol.script, plan, enrolment_.history, ports);
  tell_gaze_latency(result);
  conclude(result, writer);
  return result.ending;
}

ProtocolTexts texts_of(const Protocol& protocol) {
  return {protocol.name, protocol.hash, protocol.document.text, protocol.scene.text};
}

}  // namespace impetus
