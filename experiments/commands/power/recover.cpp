// `impetus recover`: whether a study of this design would give back the numbers of a simulated
// participant, by fits of whole simulated studies.
//
//   options ─> a question ─> chunks that are missing ─> studies, simulated and fitted, on threads
//                               └─ or one of them, on whatever machine ─> OUT/chunks/
//   all chunks ─> recovery.md, recovery.csv
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/fitting/answered_study.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/power/chunk_list.hpp"
#include "experiments/commands/power/given_words.hpp"
#include "experiments/commands/power/power_options.hpp"
#include "experiments/commands/power/power_studies.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/running/run_part.hpp"
#include "experiments/commands/scratch_folder.hpp"
#include "experiments/commands/sentences.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/fitting/fit.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/observers/side_by_side.hpp"
#include "experiments/power/recovery.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kUsualChunks = 20;  ///< what is lost by an interruption is one of them
constexpr const char* kProgress = "simulating and fitting studies";

/// What `impetus recover` was asked for.
struct RecoverOptions : ChunkOptions {
  std::string protocol;
  std::string observer;
  std::int64_t participants{20};
  std::int64_t studies{200};
  std::int64_t seed{1};
  std::int64_t jobs{0};
  bool allow_rounding{false};
  std::string out{"recovery"};

  [[nodiscard]] std::int64_t all_chunks() const {
    return chunks > 0 ? chunks : std::min(studies, kUsualChunks);
  }
};

/// Throws InputError unless the folder is new, empty, or one of chunks.
void require_recovery_folder(const fs::path& folder) {
  if (!fs::exists(folder) || fs::exists(chunk_folder(folder))) {
    return;
  }
  const std::string expected =
      folder.string() + ": expected a new folder, an empty one or an earlier recovery, got ";
  require(fs::is_directory(folder), expected + "a file");
  if (!fs::is_empty(folder)) {
    throw InputError(expected + "one that holds " +
                     fs::directory_iterator(folder)->path().filename().string());
  }
}

/// What a recovery simulates.
struct RecoveryWork {
  RunPart part;  ///< with the observer, whose numbers are planted
  RunOptions run;
  RecoveryQuestion question;
};

RecoveryWork work_of(const RecoverOptions& options) {
  RecoveryWork work;
  work.run = simulated_run(options.protocol, options.observer, options.allow_rounding);
  work.part = part_from(options.protocol, options.observer, work.run);
  const ObserverFile& observer = *work.part.lab.observer;
  require_fittable(observer);
  work.question = {work.part.protocol.name,
                   work.part.protocol.hash,
                   fs::path(observer.document.name).stem().string(),
                   observer.document.value.dump(),
                   screen_json(assumed_screen()),
                   options.participants,
                   options.studies,
                   options.seed};
  return work;
}

/// Study `number`, simulated in `scratch`, of which nothing is left. Its seed is that of the same
/// number in a power analysis. A study that cannot be fitted has a remark.
RecoveredStudy recovered_study(const RecoveryWork& work, std::int64_t number,
                               const fs::path& scratch) {
  RecoveredStudy recovered{number, seed_of_study(work.question.seed, number), {}};
  const fs::path folder = scratch / std::to_string(number);
  fs::create_directories(folder);
  {
    StudyFile study = StudyFile::open_for_writing(folder / "study.sqlite", build_name());
    RunOptions run = work.run;
    run.seed = recovered.seed;
    simulate_people(work.part, run, work.question.participants, study, [] { return false; });
    ReplayLibrary library(study);
    const ObserverFile& observer = *work.part.lab.observer;
    const std::vector<AnsweringPerson> people =
        answering_people(study, library, choose_answers(study, {}), {observer}, [](double) {
        }).front();
    if (const auto missing = missing_for_fit(*observer.kind, people)) {
      recovered.remark = "expected " + *missing;
    } else {
      FitWish wish;
      wish.as_group = people.size() > 1;
      const ObserverFit fit = fit_observer(*observer.kind, *observer.parameters, people, wish);
      for (const FittedParameter& one : fit.parameters) {  // the fit begins at what was planted
        recovered.parameters.push_back(
            {one.name, one.assumed, one.value, one.low, one.high, one.held_because});
      }
    }
  }
  fs::remove_all(folder);
  return recovered;
}

/// Builds what the studies of all chunks share.
void prepare(RecoveryWork& work) {
  solve_what_is_asked(work.part);
  build_shapes(work.part);
}

/// Simulates and fits the studies of a chunk, so many at a time as the options say, and tells the
/// share that is done.
RecoveryChunk computed_chunk(const RecoverOptions& options, const RecoveryWork& work,
                             const ChunkNumber& chunk, const std::function<void(double)>& told) {
  const auto begin = std::chrono::steady_clock::now();
  const ScratchFolder scratch(own_disk(), "impetus-recovering-");
  const std::vector<std::int64_t> numbers = numbers_of(chunk, work.question.studies);
  std::vector<RecoveredStudy> studies(numbers.size());
  std::mutex mutex;
  std::size_t done = 0;
  const auto recover_one = [&](std::size_t place) {
    studies[place] = recovered_study(work, numbers[place], scratch.path());
    const std::lock_guard lock(mutex);
    told(static_cast<double>(++done) / static_cast<double>(numbers.size()));
  };
  do_side_by_side(numbers.size(), recover_one, jobs_of(options.jobs));
  return {work.question, chunk, build_name(), seconds_since(begin), std::move(studies)};
}

/// The chunk that was asked for, unless it is there and can be used.
int compute_one(const RecoverOptions& options, RecoveryWork& work, const Sweep& sweep) {
  return compute_chunk(sweep, options.chunk, [&](ChunkMark& mark) {
    prepare(work);
    ProgressLine line(kProgress);
    const auto tell = [&](double share) {
      mark.tell(share);
      line.tell(share);
    };
    write_chunk(sweep.out, computed_chunk(options, work, {options.chunk, sweep.chunks}, tell));
  });
}

void compute_missing(const RecoverOptions& options, RecoveryWork& work, const Sweep& sweep) {
  const std::vector<std::int64_t> missing = sweep.missing();
  if (missing.empty()) {
    return;
  }
  make_out_folder(chunk_folder(sweep.out));
  prepare(work);
  ProgressLine line(kProgress);
  for (std::size_t i = 0; i < missing.size(); ++i) {
    attempt_chunk(sweep, missing[i], [&](ChunkMark& mark) {
      const auto tell = [&](double share) {
        mark.tell(share);
        line.tell((static_cast<double>(i) + share) / static_cast<double>(missing.size()));
      };
      write_chunk(sweep.out, computed_chunk(options, work, {missing[i], sweep.chunks}, tell));
    });
  }
}

int write_page(const Sweep& sweep, const RecoveryQuestion& question) {
  const std::vector<RecoveredStudy> studies = read_studies(sweep);
  const fs::path page = sweep.out / "recovery.md";
  const std::string text = recovery_page(question, studies);
  write_whole_file(sweep.out / "recovery.csv", recovery_csv(studies));
  write_whole_file(page, text);
  std::printf("%s%s: the page; recovery.csv beside it has every study\n", text.c_str(),
              page.c_str());
  return kDone;
}

int recover(const RecoverOptions& options) {
  const BuildingLine told;
  require_chunks(options, options.all_chunks(), options.studies);
  require_recovery_folder(options.out);
  RecoveryWork work = work_of(options);
  const Sweep sweep = recovery_sweep(options.out, work.question, options.all_chunks());
  if (options.list) {
    return list_chunks(sweep, options.repeated);
  }
  sweep.require_build(build_name());
  if (options.chunk > 0) {
    return compute_one(options, work, sweep);
  }
  compute_missing(options, work, sweep);
  return write_page(sweep, work.question);
}

}  // namespace

void add_recover(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<RecoverOptions>();
  CLI::App* command = app.add_subcommand(
      "recover", "Whether a study would give back a simulated participant's numbers: many, fitted");
  command->add_option("protocol", options->protocol, "Protocol file, such as protocols/gap.json")
      ->required()
      ->transform([](const std::string& name) { return shipped_file(name); });
  command
      ->add_option("--observer", options->observer,
                   "The simulated participant whose numbers are planted: its name or file")
      ->required();
  command->add_option("--n", options->participants, "Participants of each study")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--studies", options->studies, "Studies that are simulated and fitted")
      ->check(CLI::Range(1, 999999))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Of all studies")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  command
      ->add_option("--jobs", options->jobs,
                   "So many studies at a time (default: as many as there are cores)")
      ->check(CLI::Range(1, 1000));
  command->add_flag("--allow-rounding", options->allow_rounding, "Round a delay to whole frames");
  command
      ->add_option("--out", options->out,
                   "The folder of the chunks and the results; the same one goes on")
      ->capture_default_str();
  add_chunk_options(*command, *options,
                    "In so many pieces, each a command of its own on any machine that sees the "
                    "folder; alone, computes those that are missing (default: 20)");
  command->callback([options, command, &chosen] {
    options->repeated = given_words(*command, {"--chunk", "--list"});
    chosen = [options] { return recover(*options); };
  });
}

}  // namespace impetus::inline commands
