// `impetus run`: one participant's session of a protocol, or many simulated ones.
// SPDX-License-Identifier: MIT
#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "build_info.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/laboratory.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/yoking.hpp"
#include "experiments/protocol/observer_checks.hpp"
#include "experiments/protocol/protocol_checks.hpp"
#include "experiments/protocol/protocol_scene_checks.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/session/gaze_latency.hpp"
#include "experiments/session/steady_clock.hpp"
#include "experiments/store/study_writer.hpp"

namespace impetus {
namespace {

/// Of 63 bits: what an SQLite integer holds without a sign, so a negative one is noticed.
constexpr std::uint64_t kLargestSeed = std::numeric_limits<std::int64_t>::max();

struct RunOptions {
  std::string protocol;
  std::string database{"study.sqlite"};
  std::string participant;
  std::string observer;
  std::int64_t participants{0};
  std::optional<std::uint64_t> seed;
  bool show{false};
  bool allow_rounding{false};
  bool override_sync_test{false};
  std::string screen_file;
  std::string window_size;
};

std::string machine_name() {
  utsname names{};
  uname(&names);
  return std::string(names.sysname) + " " + names.release + " " + names.machine;
}

ProtocolTexts texts_of(const Protocol& protocol) {
  return {protocol.name, protocol.hash, protocol.document.text, protocol.scene.text};
}

std::vector<StoredTrial> stored(const Plan& plan) {
  std::vector<StoredTrial> trials;
  for (const PlannedTrial& trial : plan) {
    trials.push_back({0, trial.slot, trial.phase, trial.repetition, to_json(trial.condition).dump(),
                      trial.seed});
    trials.back().yoked_trial_id = trial.yoked_trial_id;
  }
  return trials;
}

Plan planned(const std::vector<StoredTrial>& trials, const Design& design) {
  Plan plan;
  for (const StoredTrial& trial : trials) {
    const auto condition = nlohmann::json::parse(trial.condition);
    plan.push_back({trial.slot, trial.phase, trial.repetition,
                    condition_from_json(condition, design), trial.seed});
    plan.back().yoked_trial_id = trial.yoked_trial_id;
  }
  return plan;
}

/// The stored enrolment, to be resumed, if there is one.
std::optional<Enrolment> find_to_resume(StudyFile& study, const Protocol& protocol,
                                        const RunOptions& options) {
  const bool simulated = !options.observer.empty();
  auto found = find_enrolment(study, options.participant, simulated, texts_of(protocol));
  if (found && options.seed && *options.seed != found->seed) {
    throw InputError("--seed " + std::to_string(*options.seed) + ": expected " +
                     std::to_string(found->seed) + ", with which " + options.participant +
                     "'s trials were planned");
  }
  return found;
}

/// The plan of a new enrolment, yoked where regions follow another's gaze.
Plan new_plan(StudyFile& study, const Protocol& protocol, const RunOptions& options) {
  return yoked(plan_for(protocol, options.participant, options.seed.value_or(1)), study, protocol,
               options.participant, !options.observer.empty());
}

/// A new enrolment with its whole plan.
Enrolment enrol_anew(StudyFile& study, const Protocol& protocol, const RunOptions& options,
                     const Plan& plan) {
  const ProtocolTexts texts = texts_of(protocol);
  for (const std::string& hash : other_versions(study, texts)) {
    std::fprintf(stderr, "note: %s also holds another version of %s (%s)\n", study.name().c_str(),
                 protocol.name.c_str(), hash.c_str());
  }
  const std::uint64_t seed = options.seed.value_or(1);
  return enrol(study, options.participant, !options.observer.empty(), texts, seed, stored(plan));
}

SessionFacts facts_of(Laboratory& laboratory, const RunOptions& options,
                      const LaboratoryOptions& lab, const SyncTest& sync) {
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

void tell_lost_gaze(const SessionResult& result) {
  if (result.lost_gaze_trials + result.repeated_trials > 0) {
    std::fprintf(stderr,
                 "warning: too much of the gaze was lost in %lld trials, which are marked; %lld "
                 "were shown again for that\n",
                 static_cast<long long>(result.lost_gaze_trials),
                 static_cast<long long>(result.repeated_trials));
  }
}

/// Says how the session ended and returns the exit status.
int conclude(const SessionResult& result, StudyWriter& writer) {
  const auto done = static_cast<long long>(result.completed_trials);
  const auto total = static_cast<long long>(result.expected_trials);
  switch (result.ending) {
    case SessionEnding::kFinished:
      writer.end("finished");
      return kDone;
    case SessionEnding::kDeclined:
      writer.end("quit");
      std::printf("The participant did not consent; nothing was shown.\n");
      return kDone;
    case SessionEnding::kQuit:
      writer.end("quit");
      std::printf(
          "Stopped with %lld of %lld trials saved; the same command goes on with the next.\n", done,
          total);
      return kDone;
    default:
      writer.end("display closed");
      throw InputError("the window was closed with " + std::to_string(done) + " of " +
                       std::to_string(total) +
                       " trials saved; the same command goes on with the next");
  }
}

/// Builds what takes long before a window opens.
std::shared_ptr<ShapeLibrary> build_shapes(const Protocol& protocol, const LaboratoryOptions& lab) {
  auto shapes = std::make_shared<ShapeLibrary>();
  ProgressLine line("building the bodies");
  shapes->tell([&line](double share) { line.tell(share); });
  ProtocolScenes(protocol, 0.0, shapes).build_shapes(expected_screen(lab));
  shapes->tell({});
  return shapes;
}

int run_participant(const Protocol& protocol, const RunOptions& options, LaboratoryOptions lab,
                    StudyFile& study, const std::shared_ptr<ShapeLibrary>& shapes) {
  const std::optional<Enrolment> resumed = find_to_resume(study, protocol, options);
  lab.seed = resumed ? resumed->seed : options.seed.value_or(1);
  const Plan plan =
      resumed ? planned(resumed->trials, protocol.design) : new_plan(study, protocol, options);
  const GazePaths gaze_paths = gaze_paths_of(plan, study);
  const std::unique_ptr<Laboratory> laboratory = open_laboratory(lab);
  const SyncTest sync = laboratory->sync_test();
  const Enrolment enrolment = resumed ? *resumed : enrol_anew(study, protocol, options, plan);

  StudyWriter writer(study, enrolment, facts_of(*laboratory, options, lab, sync));
  if (!sync.passed && !options.override_sync_test) {
    writer.save(NoteRecord{"sync test failed", sync.verdict});
    writer.end("failed");
    throw InputError("the sync test failed in " + std::to_string(sync.tries) + " tries: " +
                     sync.verdict + "; --override-sync-test goes on and marks every trial");
  }
  const double rounding_hz = options.allow_rounding ? laboratory->display().refresh_hz() : 0.0;
  const ProtocolScenes scenes(protocol, rounding_hz, shapes);
  const SteadyClock work_clock;
  const Ports ports{laboratory->display(), laboratory->input(),  scenes,      writer,
                    laboratory->gaze(),    &laboratory->clock(), &work_clock, &gaze_paths};
  const SessionResult result = run_session(protocol.script, plan, enrolment.history, ports);
  tell_gaze_latency(result);
  tell_lost_gaze(result);
  return conclude(result, writer);
}

/// S01, S02, ...: as many digits as the last one needs, two at least.
std::string simulated_name(std::int64_t number, std::int64_t count) {
  const auto digits = std::max<std::size_t>(2, std::to_string(count).size());
  const std::string text = std::to_string(number);
  return "S" + std::string(digits - text.size(), '0') + text;
}

/// Runs those who have not finished: the same command goes on where it was stopped, and one with
/// more participants adds to the group.
int run_simulated_group(const Protocol& protocol, RunOptions options, LaboratoryOptions lab,
                        StudyFile& study, const std::shared_ptr<ShapeLibrary>& shapes) {
  const bool terminal = isatty(STDERR_FILENO) != 0;
  std::int64_t finished_before = 0;
  for (std::int64_t number = 1; number <= options.participants; ++number) {
    options.participant = lab.participant = simulated_name(number, options.participants);
    if (has_finished(study, options.participant, true, texts_of(protocol))) {
      ++finished_before;
    } else {
      run_participant(protocol, options, lab, study, shapes);
    }
    if (terminal || number == options.participants) {
      std::fprintf(stderr, "%ssimulated participant %lld of %lld", terminal ? "\r" : "",
                   static_cast<long long>(number), static_cast<long long>(options.participants));
    }
  }
  std::fprintf(stderr, "\n");
  if (finished_before > 0) {
    std::fprintf(stderr, "note: %lld of them had finished before\n",
                 static_cast<long long>(finished_before));
  }
  return kDone;
}

void require_sensible(const RunOptions& options) {
  if (options.observer.empty() && options.participants > 0) {
    throw InputError("--participants: expected --observer NAME with it; people come one by one");
  }
  if (options.observer.empty() && options.show) {
    throw InputError("--show: expected --observer NAME with it");
  }
  if (options.participants > 0 && !options.participant.empty()) {
    throw InputError("--participant: expected either one participant or --participants N");
  }
  if (options.participants == 0 && options.participant.empty()) {
    throw InputError("--participant: expected a code for the participant, such as P01");
  }
}

/// Everything that can be refused is refused before a window opens or a row is written.
int run(const RunOptions& options) {
  require_sensible(options);
  const Protocol protocol = load_protocol(options.protocol);
  LaboratoryOptions lab;
  if (!options.observer.empty()) {
    lab.observer = load_observer(options.observer, options.protocol);
    check_observer(protocol, *lab.observer);
  }
  lab.show = options.show;
  lab.participant = options.participant;
  lab.screen_file = options.screen_file;
  lab.window_size = options.window_size;
  check_frames(protocol, refresh_hz_of(lab), options.allow_rounding);
  plan_for(protocol, options.participant, options.seed.value_or(1));

  StudyFile study = StudyFile::open_for_writing(options.database, kBuild);
  const std::shared_ptr<ShapeLibrary> shapes = build_shapes(protocol, lab);
  try {
    if (options.participants > 0) {
      return run_simulated_group(protocol, options, lab, study, shapes);
    }
    const int status = run_participant(protocol, options, lab, study, shapes);
    std::printf("Saved in %s\n", options.database.c_str());
    return status;
  } catch (const SQLite::Exception& error) {
    throw StoreError(study.name() + ": could not be read (" + error.what() + ")");
  }
}

}  // namespace

void add_run(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Run a session of a protocol");
  command
      ->add_option("protocol", options->protocol, "Protocol file, such as protocols/causality.json")
      ->required();
  command->add_option("--db", options->database, "Study file; made when it does not exist")
      ->capture_default_str();
  command->add_option("--participant", options->participant,
                      "Code of the participant; the same code resumes");
  command->add_option("--seed", options->seed, "Seed of the order (default 1)")
      ->check(CLI::Range(std::uint64_t{0}, kLargestSeed));
  command->add_option("--observer", options->observer,
                      "A simulated participant: its name or file; headless unless --show");
  command
      ->add_option("--participants", options->participants,
                   "Run so many simulated participants, S01, S02, ...")
      ->check(CLI::Range(1, 100000));
  command->add_flag("--show", options->show, "Show the simulated participant's session");
  command->add_flag("--allow-rounding", options->allow_rounding,
                    "Round a delay to whole frames; what was realised is stored");
  command->add_flag("--override-sync-test", options->override_sync_test,
                    "Go on when the sync test fails; every trial is marked");
  command->add_option("--screen", options->screen_file,
                      "The lab's screen file (default: what `impetus screen` saved)");
  command->add_option("--window", options->window_size, "WIDTHxHEIGHT instead of fullscreen");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace impetus
