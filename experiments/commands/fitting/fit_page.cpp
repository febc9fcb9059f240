// SPDX-License-Identifier: MIT
#include "experiments/commands/fitting/fit_page.hpp"

#include <algorithm>

#include "experiments/tables/number_text.hpp"
#include "experiments/tables/text_table.hpp"

namespace impetus::inline commands {
namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr int kDigits = 4;

std::string number(double value) { return rounded_number(value, kDigits); }

std::string interval(double low, double high) { return number(low) + " to " + number(high); }

std::string markdown(const Rows& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += "|";
    for (const std::string& cell : rows[i]) {
      text += " " + cell + " |";
    }
    text += "\n";
    if (i == 0) {
      text += "|";
      for (std::size_t column = 0; column < rows[i].size(); ++column) {
        text += "---|";
      }
      text += "\n";
    }
  }
  return text + "\n";
}

const GroupMean* mean_of(const FitStory& story, const std::string& name) {
  const auto found = std::find_if(story.means.begin(), story.means.end(),
                                  [&](const GroupMean& one) { return one.name == name; });
  return found == story.means.end() ? nullptr : &*found;
}

std::string people_words(std::size_t people) {
  return std::to_string(people) + (people == 1 ? " person" : " people");
}

Rows person_rows(const FitStory& story) {
  Rows rows{{"person", "trials"}};
  for (const GroupMean& mean : story.means) {
    rows[0].push_back(mean.name);
  }
  for (const PersonFit& person : story.by_person) {
    std::vector<std::string>& row = rows.emplace_back();
    row = {printable(person.code), std::to_string(person.trials)};
    for (const GroupMean& mean : story.means) {
      const FittedParameter* own = person.fit.find(mean.name);
      row.push_back(own->is_fitted()
                        ? number(own->value) + " (" + interval(own->low, own->high) + ")"
                        : "not identified");
    }
  }
  return rows;
}

std::string residual_pages(const FitStory& story) {
  std::string text;
  for (const QuestionResiduals& question : story.residuals) {
    Rows rows{{"expected", "trials", "mean expected", "mean answered", "difference / its error"}};
    for (const ResidualGroup& group : question.groups) {
      rows.push_back({interval(group.expected_from, group.expected_to),
                      std::to_string(group.trials), number(group.expected), number(group.answered),
                      rounded_number(group.z, 2)});
    }
    text += "Of the " + question.question + ":\n\n" + markdown(rows);
  }
  return text;
}

std::string posterior_page(const Posterior& posterior) {
  Rows rows{{"parameter", "median", "95 %", "95 % of the prior", "told by the answers, %", "R-hat",
             "independent draws"}};
  for (const PosteriorParameter& one : posterior.parameters) {
    rows.push_back({one.name, number(one.median), interval(one.low, one.high),
                    interval(one.prior_low, one.prior_high), rounded_number(100.0 * one.told, 3),
                    rounded_number(one.rhat, kDigits), rounded_number(one.enough, 3)});
  }
  return "## Posterior\n\n" +
         std::string(posterior.agrees() ? ""
                                        : "**Not to be used: the chains do not agree, or are too "
                                          "short** (R-hat above 1.01, or worth fewer than 400 "
                                          "independent draws; Vehtari et al. 2021).\n\n") +
         markdown(rows) + "Four chains of Metropolis' random walk, " +
         std::to_string(posterior.draws.size()) +
         " draws after a warm-up, by the R package mcmc; every draw is in the table beside this "
         "page. Priors are normal, about what the file assumed: of what is positive the logarithm, "
         "standard deviation 1; of a probability the logit, 1.5; of logits 3; of other numbers "
         "three quarters of what was assumed. Told by the answers is the share of the prior's "
         "variance that they took away: where it is small, the posterior is what was assumed.\n\n";
}

std::string comparison_page(const ObserverComparison& comparison) {
  Rows rows{{"observer", "log-likelihood per trial", "gain over none", "chance may make"}};
  for (const Foretelling& one : comparison.observers) {
    const bool is_none = &one == &comparison.observers.back();
    rows.push_back({one.name, number(one.per_trial), is_none ? "" : number(one.gain),
                    is_none ? "" : number(one.gain_by_chance)});
  }
  return "## Observers compared\n\nEach was fitted to all folds but one, " +
         std::to_string(comparison.folds) +
         " times, and foretold that one. A gain, in units of the logarithm, counts beyond what "
         "chance "
         "may make: 1, or t (97.5 %) standard errors over people, over trials where there is one "
         "person.\n\n" +
         markdown(rows) + choice_sentence(comparison) + "\n\n";
}

}  // namespace

std::string choice_sentence(const ObserverComparison& comparison) {
  if (!comparison.chosen) {
    return "None of them foretells answers better than one who goes by nothing that was shown.";
  }
  std::string sentence = comparison.observers[*comparison.chosen].name + " foretells answers best";
  std::vector<std::string> names;
  for (const std::size_t other : comparison.not_told_apart) {
    names.push_back(comparison.observers[other].name);
  }
  return sentence + (names.empty() ? "." : ", not told apart from " + listed(names) + ".");
}

std::string fitted_words(const FitStory& story) {
  return "fitted to " + story.study + " (" + story.study_hash + "), " + people_words(story.people);
}

std::vector<std::vector<std::string>> parameter_rows(const FitStory& story) {
  Rows rows{{"parameter", "value", "95 % interval", ""}};
  for (const FittedParameter& one : story.fit.parameters) {
    const GroupMean* mean = mean_of(story, one.name);
    if (mean != nullptr) {
      rows.push_back(
          {one.name, number(mean->mean), interval(mean->low, mean->high),
           "mean of " + people_words(mean->people) + ", spread " + number(mean->spread)});
    } else if (one.is_fitted() && story.means.empty()) {
      rows.push_back({one.name, number(one.value), interval(one.low, one.high), ""});
    } else {
      rows.push_back(
          {one.name, "", "",
           "held as assumed: " + (one.is_fitted() ? "no one person shows it" : one.held_because)});
    }
  }
  return rows;
}

nlohmann::ordered_json fitted_document(const JsonDocument& assumed, const FitStory& story) {
  constexpr int kFileDigits = 6;
  const auto rounded = [](double value) { return std::stod(rounded_number(value, kFileDigits)); };
  auto document = nlohmann::ordered_json::parse(assumed.text);
  document["note"] =
      "Parameters whose source says so were fitted by impetus fit; the others are "
      "as in " +
      story.observer + ", and what was fitted is given these.";
  for (auto& [name, parameter] : document["parameters"].items()) {
    const FittedParameter* one = story.fit.find(name);
    if (one == nullptr) {
      continue;
    }
    const GroupMean* mean = mean_of(story, name);
    if (mean != nullptr || (one->is_fitted() && story.means.empty())) {
      const double value = mean != nullptr ? mean->mean : one->value;
      // Cuts rise; around a rating that nobody gave two would meet when they are rounded.
      parameter["value"] = name.starts_with("cut_") ? value : rounded(value);
      parameter["source"] = fitted_words(story);
      parameter["note"] =
          "95 % interval " + (mean != nullptr
                                  ? interval(mean->low, mean->high) + ", of the mean over people"
                                  : interval(one->low, one->high) + ", by profile likelihood");
    } else {
      parameter["note"] = "Held in the fit to " + story.study + ": " +
                          (one->is_fitted() ? "no one person shows it" : one->held_because) + ".";
    }
  }
  return document;
}

std::string fit_page(const FitStory& story) {
  std::string text = "# " + story.kind + ", " + fitted_words(story) + "\n\n";
  text += "Observer `" + story.observer + "`, answers to the protocol `" +
          printable(story.protocol) + "`: " + people_words(story.people) + ", " +
          std::to_string(story.trials) + " completed main trials" +
          (story.all_simulated ? ". No person took part: all are simulated" : "") +
          (story.simulated_left_out > 0 ? ". " + std::to_string(story.simulated_left_out) +
                                              " simulated are left out, since people took part"
                                        : "") +
          ".\n\n";
  text += "## Fit\n\n";
  Rows rows = parameter_rows(story);
  rows[0][3] = "remark";
  text += markdown(rows);
  text += story.by_person.empty()
              ? "Maximum likelihood" +
                    std::string(story.people > 1 ? ", over people whose traits are drawn from "
                                                   "normal distributions (their spreads are "
                                                   "parameters)"
                                                 : "") +
                    ". Intervals are by profile likelihood: all other parameters follow. An end at "
                    "0 or 1 means that the answers do not exclude it. Log-likelihood " +
                    rounded_number(story.fit.logarithm, 8) + ".\n\n"
              : "Each person by maximum likelihood, with intervals by profile likelihood; the "
                "group is the mean over people, with an interval by Student's t. A spread over "
                "people includes the error of each person's fit.\n\n";
  if (!story.by_person.empty()) {
    text += "## Person by person\n\n" + markdown(person_rows(story));
  }
  if (story.posterior) {
    text += posterior_page(*story.posterior);
  }
  if (story.comparison) {
    text += comparison_page(*story.comparison);
  }
  text +=
      "## Residuals\n\nTrials in groups of equal size by what the fitted observer expects" +
      std::string(story.people > 1 ? ", of people with the traits that explain each best" : "") +
      ".\n\n" + residual_pages(story);
  return text;
}

}  // namespace impetus::inline commands
