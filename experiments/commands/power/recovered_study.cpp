// SPDX-License-Identifier: MIT
#include "experiments/commands/power/recovered_study.hpp"

#include <string>
#include <vector>

#include "experiments/commands/fitting/answered_study.hpp"
#include "experiments/commands/power/power_studies.hpp"
#include "experiments/fitting/fit.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline commands {

namespace fs = std::filesystem;

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

}  // namespace impetus::inline commands
