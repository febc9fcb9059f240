// `impetus run`: one participant's session of a protocol or a series, or many simulated ones.
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/running/chosen_screen.hpp"
#include "experiments/commands/running/enrolling.hpp"
#include "experiments/commands/running/participant_run.hpp"
#include "experiments/commands/running/run_part.hpp"
#include "experiments/commands/running/session_warnings.hpp"
#include "experiments/commands/running/simulated_group.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/participant_code.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/series_file.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/provenance/machine_name.hpp"
#include "experiments/questions/session_pages.hpp"
#include "experiments/session/unattended.hpp"
#include "experiments/store/study_file.hpp"
#include "experiments/store/study_writer.hpp"
#include "experiments/study/stored_plan.hpp"
#include "experiments/study/taking_up.hpp"
#include "experiments/trackers/tracker_kinds.hpp"

namespace impetus::inline commands {
namespace {

// `impetus run` of a protocol in which nobody takes part: its trials are simulated and stored.

/// Of a sitting without display and participant.
SessionFacts facts_without_laboratory(const std::string& screen_file) {
  constexpr double kNominalHz = 60.0;  // of frames that there are none of
  SessionFacts facts;
  facts.build = build_name();
  facts.machine = machine_name();
  facts.display = "none: simulated, and shown to nobody";
  facts.simulated = true;
  facts.screen = screen_without_window(screen_file);
  facts.screen_measured = !screen_file.empty();
  facts.refresh_hz = kNominalHz;
  facts.sync.passed = true;
  return facts;
}

/// The options with nobody, a simulated participant, as who takes part. Throws InputError when they
/// name somebody.
RunOptions as_nobody(RunOptions options) {
  const std::pair<const char*, bool> given[] = {{"--participant", !options.participant.empty()},
                                                {"--participants", options.participants > 0},
                                                {"--observer", options.simulated()},
                                                {"--show", options.show}};
  for (const auto& [name, is_given] : given) {
    if (is_given) {
      throw InputError(std::string(name) + ": expected none, for nobody takes part in " +
                       options.protocol);
    }
  }
  options.participant = "nobody";
  options.observers = {"nobody"};
  return options;
}

/// Runs the trials that are left, with a line of progress. `options` are
/// as_nobody()'s. Returns the session that was saved. Throws what the recorder throws.
std::int64_t run_unattended_part(const RunPart& part, const RunOptions& options, StudyFile& study) {
  std::optional<Enrolment> known = find_to_resume(study, part, options);
  SessionFacts facts = facts_without_laboratory(options.screen_file);
  if (known) {
    facts.resumed = take_up(study, part.protocol, options.participant,
                            planned(known->trials, part.protocol.design), *known);
  }
  const Enrolment enrolment =
      known ? std::move(*known) : enrol_anew(study, part, options, new_plan(study, part, options));
  StudyWriter writer(study, enrolment, facts);
  const ProtocolScenes scenes(part.protocol, 0.0);
  ProgressLine line("simulating");
  run_unattended(planned(enrolment.trials, part.protocol.design), enrolment.history, scenes,
                 facts.screen, writer, SteadyClock(), [&line](double share) { line.tell(share); });
  writer.end("finished");
  tell_not_finite(writer);
  return writer.session_id();
}

/// In quotes and on one line, whatever it holds; its beginning when it is long.
std::string shown(const std::string& code) {
  const std::string beginning = code.substr(0, kLongestParticipantCode);
  return nlohmann::json(beginning).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace) +
         (beginning == code ? "" : " ...");
}

void require_sensible(const RunOptions& options) {
  const bool simulated = options.simulated();
  if (!simulated && options.participants > 0) {
    throw InputError("--participants: expected --observer NAME with it; people come one by one");
  }
  if (!simulated && options.show) {
    throw InputError("--show: expected --observer NAME with it");
  }
  if (options.participants > 0 && options.show) {
    throw InputError("--show: expected one participant, not --participants");
  }
  if (simulated && !options.show && !options.window_size.empty()) {
    throw InputError("--window: expected --show beside --observer, for nobody sees a window else");
  }
  if (options.participants > 0 && !options.participant.empty()) {
    throw InputError("--participant: expected either one participant or --participants N");
  }
  if (options.participants == 0 && options.participant.empty()) {
    throw InputError("--participant: expected a code for the participant, such as P01");
  }
  if (!options.participant.empty() && !is_participant_code(options.participant)) {
    throw InputError("--participant: expected a code of at most " +
                     std::to_string(kLongestParticipantCode) +
                     " bytes of text without control characters, unseen ones, / and \\, and "
                     "without a space at its ends, got " +
                     shown(options.participant));
  }
  if (is_tracker_url(options.gaze)) {
    parse_tracker(options.gaze);
    if (simulated) {
      throw InputError("--gaze " + options.gaze +
                       ": expected a file of recorded gaze with --observer, for a simulated "
                       "participant sits before no tracker");
    }
  }
  if (!simulated && looks_like_name(options.participant)) {
    std::fprintf(stderr,
                 "warning: %s looks like a person's name; a code that says nothing of the person, "
                 "such as P01, keeps who took part out of the data\n",
                 shown(options.participant).c_str());
  }
}

/// The observer of a part; "" for a person.
std::string observer_of(const RunOptions& options, std::size_t part, std::size_t parts) {
  const std::vector<std::string>& names = options.observers;
  if (names.empty()) {
    return "";
  }
  if (names.size() != 1 && names.size() != parts) {
    throw InputError("--observer: expected one, or one for each of the " + std::to_string(parts) +
                     " protocols, got " + std::to_string(names.size()));
  }
  return names[names.size() == 1 ? 0 : part];
}

std::vector<RunPart> parts_from(const Series& series, const RunOptions& options) {
  const std::size_t count = series.protocols.size();
  std::vector<RunPart> parts;
  SeriesNames names(options.protocol);
  for (std::size_t i = 0; i < count; ++i) {
    parts.push_back(part_from(series.protocols[i], observer_of(options, i, count), options));
    RunPart& part = parts.back();
    part.series = series.name;
    part.series_place = static_cast<std::int64_t>(i) + 1;
    if (i + 1 < count) {
      part.protocol.script.thanks = part_complete(part.protocol.script.language, i + 1, count);
      part.protocol.script.part_follows = true;
    }
    names.take(part.protocol.name);
  }
  for (RunPart& part : parts) {  // which share one laboratory
    for (const RunPart& other : parts) {
      part.lab.letters.insert(other.lab.letters.begin(), other.lab.letters.end());
      part.lab.sounds = part.lab.sounds || other.lab.sounds;
    }
  }
  return parts;
}

/// Whether it sends anything within a second, be it that nobody sits before it.
bool is_sending(Tracker& tracker) {
  for (int tries = 0; tries < 50; ++tries) {
    if (!tracker.take_readings().empty()) {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

/// Connects all parts to the tracker that was asked for. Throws InputError.
void share_tracker(std::vector<RunPart>& parts, const RunOptions& options) {
  if (!is_tracker_url(options.gaze)) {
    return;
  }
  const std::shared_ptr<Tracker> tracker = open_tracker(options.gaze);
  std::fprintf(stderr, "note: %s\n", tracker->clock_words().c_str());
  if (!is_sending(*tracker)) {
    std::fprintf(stderr,
                 "warning: nothing has come from %s in 1 s; if it is a surface's gaze, is the "
                 "surface defined, named so, and in sight?\n",
                 options.gaze.c_str());
  }
  if (!options.window_size.empty()) {
    std::fprintf(stderr,
                 "warning: --window: the tracker's places are taken as shares of the window, which "
                 "must be what it was calibrated on\n");
  }
  for (RunPart& part : parts) {
    part.tracker = tracker;
  }
}

/// One participant goes through the parts that are not finished, before one window. Returns the
/// sessions that were saved.
std::vector<std::int64_t> run_participant(const std::vector<RunPart>& parts,
                                          const RunOptions& options, StudyFile& study) {
  std::shared_ptr<Laboratory> window;
  std::vector<std::int64_t> sessions;
  for (const RunPart& part : parts) {
    const bool last = &part == &parts.back();
    if (!last &&
        has_finished(study, options.participant, options.simulated(), texts_of(part.protocol))) {
      std::fprintf(stderr, "note: %s has finished %s already\n", options.participant.c_str(),
                   part.protocol.name.c_str());
      continue;
    }
    ParticipantRun participant(part, options, study, window);
    const SessionEnding ending = participant.run({});
    sessions.push_back(participant.session_id());
    if (ending != SessionEnding::kFinished) {
      break;
    }
    window = options.simulated() ? nullptr : participant.laboratory();
  }
  return sessions;
}

/// The last line of every run: where all that was recorded is.
void tell_saved(const RunOptions& options, const std::string& whose) {
  std::printf("Saved in %s: %s\n", options.database.c_str(), whose.c_str());
}

bool nobody_takes_part(const Series& series) {
  return series.protocols.size() == 1 && !load_protocol(series.protocols.front()).has_participants;
}

int run_without_participants(const std::filesystem::path& file, const RunOptions& options) {
  RunPart part{load_protocol(file), {}};
  const RunOptions nobody = as_nobody(options);
  plan_for(part.protocol, nobody.participant, nobody.seed.value_or(1));
  solve_what_is_asked(part);
  StudyFile study = StudyFile::open_for_writing(options.database, build_name());
  const std::int64_t session = run_unattended_part(part, nobody, study);
  tell_saved(nobody, sitting_words(nobody.participant, {session}));
  return kDone;
}

/// Everything that can be refused is refused before a window opens or a row is written.
int run(const RunOptions& options) {
  const BuildingLine told;
  const Series series = load_series(options.protocol);
  if (nobody_takes_part(series)) {
    return run_without_participants(series.protocols.front(), options);
  }
  require_sensible(options);
  std::vector<RunPart> parts = parts_from(series, options);
  for (RunPart& part : parts) {
    solve_what_is_asked(part);
  }
  share_tracker(parts, options);
  StudyFile study = StudyFile::open_for_writing(options.database, build_name());
  for (const RunPart& part : parts) {
    build_shapes(part);
  }
  return while_reading(study, [&] {
    if (options.participants > 0) {
      run_simulated_group(parts, options, study);
      tell_saved(options, group_words(options.participants));
    } else {
      tell_saved(options,
                 sitting_words(options.participant, run_participant(parts, options, study)));
    }
    return kDone;
  });
}

}  // namespace

void add_run(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<RunOptions>(
      app, chosen, run, "run", "Run a session of a protocol, or of a series");
  command
      ->add_option("protocol", options->protocol,
                   "Protocol file, such as protocols/causality.json, or a series of them")
      ->required()
      ->transform([](const std::string& name) { return shipped_file(name); });
  command->add_option("--db", options->database, "Study file; made when it does not exist")
      ->capture_default_str();
  command->add_option("--participant", options->participant,
                      "Code of the participant, such as P01; the same code resumes");
  command->add_option("--seed", options->seed, "Seed of the order (default 1)")
      ->check(CLI::Range(std::uint64_t{0}, kLargestSeed));
  command->add_option("--observer", options->observers,
                      "A simulated participant: its name or file, one for each protocol of a "
                      "series; headless unless --show");
  command
      ->add_option("--participants", options->participants,
                   "Run so many simulated participants, S01, S02, ...")
      ->check(CLI::Range(1, 100000));
  command
      ->add_option("--jobs", options->jobs,
                   "So many of them at a time (default: as many as there are cores)")
      ->check(CLI::Range(1, 1000));
  command->add_flag("--show", options->show, "Show the simulated participant's session");
  command->add_flag("--allow-rounding", options->allow_rounding,
                    "Round a delay to whole frames; what was realised is stored");
  command->add_flag("--override-sync-test", options->override_sync_test,
                    "Go on when the sync test fails; every trial is marked");
  command->add_flag("--changed-screen", options->changed_screen,
                    "Resume on another screen than the session before; a note is kept");
  command
      ->add_option("--gaze", options->gaze,
                   "An eye tracker: pupil://HOST[:PORT][?surface=NAME], gazepoint://HOST[:PORT] or "
                   "lsl://STREAM; "
                   "or a file of recorded gaze that is followed in place of the participant's: CSV "
                   "or TSV with times and places, one trial for all or one for each")
      ->check([](const std::string& given) {
        return is_tracker_url(given) ? std::string() : CLI::ExistingFile(given);
      });
  command->add_option(
      "--screen", options->screen_file,
      "The lab's screen file (default: what `impetus screen` saved; without a window, an "
      "assumed screen)");
  command->add_option("--window", options->window_size,
                      "WIDTHxHEIGHT instead of fullscreen; the screen's measures are then taken as "
                      "the window's");
  command->add_option(
      "--photodiode", options->photodiode,
      "A corner, such as \"bottom left\", for a square whose light tells each frame");
  command->add_option("--markers", options->markers,
                      "Where the codes of a protocol's \"markers\" go, right after each flip: "
                      "serial:///dev/ttyUSB0?baud=115200, tcp://HOST:PORT or lsl://NAME");
}

}  // namespace impetus::inline commands
