// SPDX-License-Identifier: MIT
#include "experiments/commands/power/recovered_study.hpp"

#include <SQLiteCpp/Database.h>

#include <string>
#include <vector>

#include "experiments/commands/fitting/answered_study.hpp"
#include "experiments/commands/power/power_studies.hpp"
#include "experiments/commands/running/participant_run.hpp"
#include "experiments/commands/running/simulated_group.hpp"
#include "experiments/fitting/fit.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

/// All participants one after the other; nothing is synchronised with the disk, for what is lost is
/// simulated again.
void simulate(const RecoveryWork& work, std::uint64_t seed, StudyFile& study) {
  study.database().exec("PRAGMA synchronous = OFF");
  RunOptions own = work.run;
  own.seed = seed;
  for (std::int64_t number = 1; number <= work.question.participants; ++number) {
    own.participant = simulated_name(number, number);
    ParticipantRun(work.part, own, study, nullptr).run({});
  }
}

/// The number of this name that was planted: where a fit of these people begins.
double planted_number(AnswerLikelihood& planted, const std::string& name) {
  for (const MovableParameter& one : planted.movable()) {
    if (one.name == name) {
      return *one.place;
    }
  }
  return 0.0;  // a fit names what can be moved, and nothing else
}

}  // namespace

RecoveredStudy recovered_study(const RecoveryWork& work, std::int64_t number,
                               const fs::path& scratch) {
  RecoveredStudy recovered{number, seed_of_study(work.question.seed, number), {}};
  const fs::path file = scratch / ("study-" + std::to_string(number) + ".sqlite");
  {
    StudyFile study = StudyFile::open_for_writing(file, build_name());
    simulate(work, recovered.seed, study);
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
      AnswerLikelihood planted(*observer.kind, *observer.parameters, people, wish.as_group);
      for (const FittedParameter& one : fit.parameters) {
        recovered.parameters.push_back({one.name, planted_number(planted, one.name), one.value,
                                        one.low, one.high, one.held_because});
      }
    }
  }
  for (const char* more : {"", "-wal", "-shm", "-journal"}) {
    fs::remove(fs::path(file.string() + more));
  }
  return recovered;
}

}  // namespace impetus::inline commands
