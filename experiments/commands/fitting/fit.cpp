// `impetus fit`: the parameters of a simulated participant from people's answers.
//
//   study ─replay─> percepts and answers ─maximum likelihood─> a participant file, and a page
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/fitting/answered_study.hpp"
#include "experiments/commands/fitting/fit_page.hpp"
#include "experiments/commands/named_observer.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/store/merging/merge_part.hpp"
#include "experiments/tables/student_t.hpp"
#include "experiments/tables/text_table.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

/// What `impetus fit` was asked for.
struct FitOptions {
  std::string study;
  std::string observer;
  std::string out;
  std::string protocol;
  std::string code;
  bool by_person{false};
  bool posterior{false};
  std::vector<std::string> compared;
  std::int64_t folds{10};
};

/// Those that are fitted or compared; the first is the one to fit.
std::vector<ObserverFile> observers_of(const FitOptions& options, const Protocol& protocol) {
  std::vector<ObserverFile> observers;
  std::vector<std::string> names{options.observer};
  names.insert(names.end(), options.compared.begin(), options.compared.end());
  for (const std::string& name : names) {
    if (&name != &names.front() && name == options.observer) {
      continue;
    }
    // As for a protocol in a folder beside this one's experiments/observers.
    observers.push_back(observer_for(protocol, "protocols/study.json", name));
    require_fittable(observers.back());
  }
  return observers;
}

void require_enough(const FitOptions& options, const ObserverFile& observer,
                    const std::vector<AnsweringPerson>& people) {
  if (const auto missing = missing_for_fit(*observer.kind, people)) {
    throw InputError(options.study + ": expected " + *missing);
  }
}

/// A fit that found nothing of what the observer sees is none.
void require_any_found(const FitOptions& options, const ObserverFile& observer,
                       const ObserverFit& fit) {
  const std::vector<std::string>& own = observer.kind->answers.fitted;
  const bool any = std::any_of(own.begin(), own.end(), [&](const std::string& name) {
    const FittedParameter* found = fit.find(name);
    return found != nullptr && found->is_fitted() && name != "guess_rate" && name != "miss_rate" &&
           name != "lapse_rate";
  });
  if (!any) {
    throw InputError(options.study +
                     ": expected answers that depend on what the observer looks "
                     "at (" +
                     attention_of(observer).words + "), got none of which " + own.front() +
                     " would have an interval");
  }
}

/// The means of what at least three people's answers identify.
std::vector<GroupMean> group_means(const std::vector<PersonFit>& fits) {
  constexpr std::size_t kFewest = 3;
  std::vector<GroupMean> means;
  for (const FittedParameter& one : fits.front().fit.parameters) {
    std::vector<double> values;
    for (const PersonFit& person : fits) {
      const FittedParameter* own = person.fit.find(one.name);
      if (own->is_fitted()) {
        values.push_back(own->value);
      }
    }
    if (values.size() < kFewest) {
      continue;
    }
    const auto count = static_cast<double>(values.size());
    GroupMean mean{one.name, values.size()};
    for (const double value : values) {
      mean.mean += value / count;
    }
    for (const double value : values) {
      mean.spread += (value - mean.mean) * (value - mean.mean) / (count - 1.0);
    }
    mean.spread = std::sqrt(mean.spread);
    const double half = student_t(count - 1.0) * mean.spread / std::sqrt(count);
    mean.low = mean.mean - half;
    mean.high = mean.mean + half;
    means.push_back(mean);
  }
  return means;
}

void fit_one_by_one(const FitOptions& options, const ObserverFile& observer,
                    const std::vector<AnsweringPerson>& people, FitStory& story) {
  ProgressLine line("fitting person by person");
  for (const AnsweringPerson& person : people) {
    line.tell(static_cast<double>(story.by_person.size()) / static_cast<double>(people.size()));
    story.by_person.push_back(
        {person.code, person.trials.size(),
         fit_observer(*observer.kind, *observer.parameters, {person}, {.as_group = false})});
  }
  story.means = group_means(story.by_person);
  if (story.means.empty()) {
    throw InputError(options.study +
                     ": expected at least three people whose own answers identify "
                     "a parameter, got " +
                     std::to_string(people.size()) + " people");
  }
}

ObserverFit fit_as_group(const ObserverFile& observer, const std::vector<AnsweringPerson>& people) {
  ProgressLine line("fitting");
  FitWish wish;
  wish.as_group = people.size() > 1;
  wish.progress = [&](double share) { line.tell(share); };
  return fit_observer(*observer.kind, *observer.parameters, people, wish);
}

Posterior posterior_of(const ObserverFile& observer, const std::vector<AnsweringPerson>& people,
                       const ObserverFit& fit) {
  ProgressLine line("drawing from the posterior");
  PosteriorDensity density(*observer.kind, *observer.parameters, people, fit);
  return sample_posterior(density, [&](double share) { line.tell(share); });
}

/// The observers' names as they were given, with the answers as each perceives the trials.
ObserverComparison compare(const FitOptions& options, const std::vector<ObserverFile>& observers,
                           const std::vector<std::vector<AnsweringPerson>>& people) {
  std::vector<ComparedObserver> compared;
  for (std::size_t i = 0; i < observers.size(); ++i) {
    if (trials_of(people[i]) != trials_of(people[0])) {
      throw InputError("--compare: expected observers that answer the same trials, got " +
                       std::to_string(trials_of(people[0])) + " of " + options.observer + " and " +
                       std::to_string(trials_of(people[i])) + " of " + observers[i].document.name);
    }
    const std::string name = fs::path(observers[i].document.name).stem().string();
    compared.push_back({name, observers[i].kind, observers[i].parameters, people[i]});
  }
  ProgressLine line("comparing observers");
  return compare_observers(compared, static_cast<std::size_t>(options.folds),
                           [&](double share) { line.tell(share); });
}

FitStory told_fit(const FitOptions& options, const AnsweredStudy& answered,
                  const Protocol& protocol, const std::vector<ObserverFile>& observers,
                  const std::vector<std::vector<AnsweringPerson>>& people) {
  const ObserverFile& observer = observers.front();
  require_enough(options, observer, people.front());
  FitStory story;
  story.study = fs::path(options.study).filename().string();
  story.study_hash = hash_of_file(options.study);
  story.protocol = protocol.name;
  story.all_simulated = answered.all_simulated;
  story.simulated_left_out = answered.simulated_left_out;
  story.observer = fs::path(observer.document.name).filename().string();
  story.kind = observer.kind->name;
  story.people = people.front().size();
  story.trials = trials_of(people.front());
  std::fprintf(stderr, "fitting %s to %zu trials of %zu people\n", story.kind.c_str(), story.trials,
               story.people);
  story.fit = fit_as_group(observer, people.front());
  require_any_found(options, observer, story.fit);
  if (options.by_person) {
    fit_one_by_one(options, observer, people.front(), story);
  }
  if (options.posterior) {
    story.posterior = posterior_of(observer, people.front(), story.fit);
  }
  AnswerLikelihood fitted(*observer.kind, *story.fit.best, people.front(), story.people > 1);
  story.residuals = residuals(fitted, people.front());
  if (!options.compared.empty()) {
    story.comparison = compare(options, observers, people);
  }
  return story;
}

std::vector<std::vector<AnsweringPerson>> people_of(StudyFile& study, ReplayLibrary& library,
                                                    const AnsweredStudy& answered,
                                                    const std::vector<ObserverFile>& observers) {
  ProgressLine line("simulating trials again");
  return answering_people(study, library, answered, observers,
                          [&line](double share) { line.tell(share); });
}

int fit(const FitOptions& options) {
  const fs::path page = fs::path(options.out).replace_extension(".md");
  const fs::path draws = fs::path(options.out).replace_extension(".draws.csv");
  require_new_files({{"--out", options.out},
                     {"the page beside it", page},
                     {"--posterior", options.posterior ? draws : fs::path()}});
  if (options.posterior) {
    require_sampler();
  }
  StudyFile study = StudyFile::open_for_reading(options.study);
  const AnsweredStudy answered = choose_answers(study, {options.protocol, options.code});
  ReplayLibrary library(study);
  const Protocol& protocol = library.protocol(answered.protocol_id);
  const std::vector<ObserverFile> observers = observers_of(options, protocol);
  const auto people = people_of(study, library, answered, observers);
  const FitStory story = told_fit(options, answered, protocol, observers, people);
  const std::string text = fitted_document(observers.front().document, story).dump(2) + "\n";
  static_cast<void>(observers.front().kind->read(parse_json(options.out, text)));
  write_whole_file(options.out, text);
  write_whole_file(page, fit_page(story));
  if (story.posterior) {
    write_whole_file(draws, draws_table(*story.posterior));
  }
  std::printf("%s", text_table(parameter_rows(story)).c_str());
  if (story.comparison) {
    std::printf("%s\n", choice_sentence(*story.comparison).c_str());
  }
  if (story.posterior) {
    std::printf("%s: draws from the posterior%s\n", draws.c_str(),
                story.posterior->agrees() ? "" : ", whose chains do not agree: not to be used");
  }
  std::printf("%s: a participant for run and power; %s: the page\n", options.out.c_str(),
              page.c_str());
  return kDone;
}

}  // namespace

void add_fit(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<FitOptions>(
      app, chosen, fit, "fit", "The parameters of a simulated participant from people's answers");
  command->add_option("study", options->study, "Study file")->required();
  command
      ->add_option("--observer", options->observer,
                   "The simulated participant to fit, its name or file: where the search begins, "
                   "and what is held that the answers do not tell")
      ->required();
  command
      ->add_option("--out", options->out,
                   "The participant file to write, such as fitted.json; the page fitted.md is "
                   "written beside it")
      ->required();
  command->add_option("--protocol", options->protocol,
                      "Answers to this protocol (default: the study's only one)");
  CLI::Option* code =
      command->add_option("--code", options->code, "Only this participant's answers");
  CLI::Option* by_person = command
                               ->add_flag("--by-person", options->by_person,
                                          "Fit everybody alone; the file has the means over people")
                               ->excludes(code);
  command
      ->add_flag(
          "--posterior", options->posterior,
          "Also draw from the posterior under weak priors, for the page and a table of draws "
          "(needs R, mcmc and coda)")
      ->excludes(by_person);
  command
      ->add_option("--compare", options->compared,
                   "Other simulated participants: which foretells best what it was not fitted to")
      ->delimiter(',');
  command->add_option("--folds", options->folds, "Of --compare: parts that are foretold in turn")
      ->check(CLI::Range(2, 100))
      ->capture_default_str();
}

}  // namespace impetus::inline commands
