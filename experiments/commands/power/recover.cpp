// `impetus recover`: whether a study of this design would give back the numbers of a simulated
// participant, by fits of whole simulated studies.
//
//   options ─> a question ─> chunks that are missing ─> studies, simulated and fitted, on threads
//                               └─ or one of them, on whatever machine ─> OUT/chunks/
//   all chunks ─> recovery.md, recovery.csv
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/fitting/answered_study.hpp"
#include "experiments/commands/fitting/fittable.hpp"
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
#include "experiments/power/chunk_mark.hpp"
#include "experiments/power/recovery.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kUsualChunks = 20;  ///< what is lost by an interruption is one of them

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

/// Studies of one chunk, shared among threads.
class ChunkStudies {
 public:
  ChunkStudies(const RecoveryWork& work, const std::vector<std::int64_t>& numbers,
               const fs::path& scratch, std::function<void(double)> told)
      : work_(work),
        numbers_(numbers),
        scratch_(scratch),
        told_(std::move(told)),
        studies_(numbers.size()) {}

  std::vector<RecoveredStudy> run(std::int64_t jobs) {
    std::vector<std::thread> threads;
    for (std::int64_t job = 1; job < std::min(jobs, std::ssize(numbers_)); ++job) {
      threads.emplace_back([this] { work_until_done(); });
    }
    work_until_done();
    for (std::thread& thread : threads) {
      thread.join();
    }
    if (failure_) {
      std::rethrow_exception(failure_);
    }
    return std::move(studies_);
  }

 private:
  void work_until_done() {
    try {
      for (std::size_t place = next_++; place < numbers_.size() && !fails_; place = next_++) {
        studies_[place] = recovered_study(work_, numbers_[place], scratch_);
        const std::lock_guard lock(mutex_);
        told_(static_cast<double>(++done_) / static_cast<double>(numbers_.size()));
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      fails_ = true;
      failure_ = failure_ ? failure_ : std::current_exception();
    }
  }

  const RecoveryWork& work_;
  const std::vector<std::int64_t>& numbers_;
  const fs::path& scratch_;
  std::function<void(double)> told_;
  std::vector<RecoveredStudy> studies_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> fails_{false};
  std::size_t done_{0};
  std::exception_ptr failure_;
  std::mutex mutex_;
};

/// Computes it and writes its file. Throws what keeps it from it; then there is no file.
void do_chunk(const RecoverOptions& options, const RecoveryWork& work, const ChunkNumber& chunk,
              const std::function<void(double)>& told) {
  ChunkMark mark(options.out, chunk.number);
  try {
    require_writable(chunk_file(options.out, chunk.number));
    const auto begin = std::chrono::steady_clock::now();
    const ScratchFolder scratch(own_disk(), "impetus-recovering-");
    const std::vector<std::int64_t> numbers = numbers_of(chunk, work.question.studies);
    ChunkStudies studies(work, numbers, scratch.path(), [&](double share) {
      mark.tell(share);
      told(share);
    });
    RecoveryChunk done{work.question, chunk, build_name(), 0.0, studies.run(jobs_of(options.jobs))};
    done.took_s = seconds_since(begin);
    write_chunk(options.out, done);
  } catch (const std::exception& error) {
    mark.fail(error.what());
    throw;
  }
}

std::vector<std::int64_t> missing_chunks(const RecoverOptions& options) {
  std::vector<std::int64_t> missing;
  for (std::int64_t number = 1; number <= options.all_chunks(); ++number) {
    if (!fs::exists(chunk_file(options.out, number))) {
      missing.push_back(number);
    }
  }
  return missing;
}

void compute(const RecoverOptions& options, RecoveryWork& work,
             const std::vector<std::int64_t>& chunks) {
  solve_what_is_asked(work.part);
  build_shapes(work.part);
  ProgressLine line("simulating and fitting studies");
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    do_chunk(options, work, {chunks[i], options.all_chunks()}, [&](double share) {
      line.tell((static_cast<double>(i) + share) / static_cast<double>(chunks.size()));
    });
  }
}

/// The chunk that was asked for, unless it is there and can be used.
int compute_one(const RecoverOptions& options, RecoveryWork& work) {
  const fs::path file = chunk_file(options.out, options.chunk);
  if (fs::exists(file)) {
    read_chunk(options.out, work.question, {options.chunk, options.all_chunks()});
    std::printf("%s: is there already\n", file.c_str());
    return kDone;
  }
  compute(options, work, {options.chunk});
  std::printf("%s: done\n", file.c_str());
  return kDone;
}

int write_page(const RecoverOptions& options, const RecoveryQuestion& question) {
  const std::vector<RecoveredStudy> studies =
      read_all_chunks(options.out, question, options.all_chunks());
  const fs::path page = fs::path(options.out) / "recovery.md";
  const std::string text = recovery_page(question, studies);
  write_whole_file(fs::path(options.out) / "recovery.csv", recovery_csv(studies));
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
  if (options.list) {
    return list_chunks(
        {options.out, options.all_chunks(), options.repeated, [&](std::int64_t number) {
           return read_chunk(options.out, work.question, {number, options.all_chunks()}).took_s;
         }});
  }
  make_out_folder(chunk_folder(options.out));
  require_build(options.out, work.question, options.all_chunks(), build_name());
  if (options.chunk > 0) {
    return compute_one(options, work);
  }
  if (const std::vector<std::int64_t> missing = missing_chunks(options); !missing.empty()) {
    compute(options, work, missing);
  }
  return write_page(options, work.question);
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
