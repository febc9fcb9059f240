// Simulated participants of studies without a world: each is shown what is planted and answers as
// in a session, through the same questions.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "engine/numerics/elementary_functions.hpp"
#include "experiments/fitting/answered_trials.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "tests/experiments/fakes.hpp"

namespace impetus {

inline ObserverFile shipped_observer(const std::string& name) {
  return load_observer(source_file("experiments/observers/" + name + ".json").string(), "x");
}

/// The same with some of its numbers changed, or added.
inline ObserverFile observer_with(const std::string& name,
                                  const std::map<std::string, double>& numbers) {
  ObserverFile file = shipped_observer(name);
  for (const auto& [number, value] : numbers) {
    auto& entry = file.document.value["parameters"][number];
    entry.update({{"value", value}, {"unit", "x"}, {"source", "x"}});
  }
  file.parameters = file.kind->read(file.document);
  return file;
}

/// What a trial shows: one stimulus, or two.
struct PlantedStimulus {
  AttemptRecord shown;
  double eccentricity_deg{0.0};
};

/// Two balls of 1 cm before an eye at the usual distance.
inline StagedScene two_balls() {
  StagedScene scene{World({}, {}, {}), viewer_at(assumed_screen(), 0.0), {}};
  scene.looks = {{"a", 0.01}, {"b", 0.01}};
  return scene;
}

/// A freeze at contact.
inline AttemptRecord freeze(double delay_ms) {
  AttemptRecord shown;
  shown.collisions.resize(1);
  shown.collisions[0].report.imposed_hold_s = delay_ms / 1e3;
  shown.collisions[0].report.bodies = {0, 1};
  return shown;
}

/// A collision at a gap (minutes of arc, at the screen's distance) and an eccentricity.
inline AttemptRecord gap_between_balls(double gap_arcmin, double eccentricity_deg,
                                       double approach_deg_s = 0.0) {
  const double eye_m = assumed_screen().viewing_distance_m;
  const double m_per_deg = metres_per_degree(eye_m);
  // The two closest points, symmetric about the line of sight, are seen under the gap's angle.
  const double half_m = eye_m * std::tan(0.5 * gap_arcmin / 60.0 * 3.14159265358979 / 180.0);
  AttemptRecord shown;
  shown.collisions.resize(1);
  CollisionRecord& collision = shown.collisions[0];
  collision.report.bodies = {0, 1};
  collision.report.approach_m_s = approach_deg_s * m_per_deg;
  collision.pose_a.position = Vector3(-0.01 - half_m, 0.0, 0.0);
  collision.pose_b.position = Vector3(0.01 + half_m, 0.0, 0.0);
  collision.eccentricity_deg = eccentricity_deg;
  return shown;
}

inline Page question_page(const std::string& kind, std::size_t choices) {
  Page page;
  page.layout = Page::Layout::kChoices;
  page.response = kind;
  page.choices.resize(choices);
  return page;
}

/// What everybody is shown, and asked: "yes_no", "rating" (1 is good), "two_interval" or "slider".
struct PlantedStudy {
  std::vector<std::vector<AttemptRecord>> trials;  ///< of one or two stimuli each
  std::string question{"yes_no"};
  std::size_t points{2};
  StagedScene scene{two_balls()};
};

/// As a slider from 0 to 100 keeps it.
inline Mark rounded_mark(double value) { return {std::round(100.0 * value) / 100.0}; }

/// A participant's trials with the answers of a simulated one.
inline AnsweringPerson answering_person(const ObserverFile& file, const PlantedStudy& study,
                                        std::uint64_t seed, const std::string& code) {
  VirtualClock clock;
  const auto observer = make_observer(file, {seed, code, clock, clock});
  const Page page = question_page(study.question, study.points);
  AnsweringPerson person{code, {}};
  for (const std::vector<AttemptRecord>& stimuli : study.trials) {
    AnsweredTrial& trial = person.trials.emplace_back();
    std::int64_t interval = 0;
    for (AttemptRecord shown : stimuli) {
      shown.frames.resize(1);
      shown.frames[0].interval = ++interval;
      observer->witnessed(shown, study.scene);
      trial.percepts.push_back(file.kind->answers.percept(*file.parameters, shown, study.scene));
    }
    if (study.question == "slider") {
      trial.mark = rounded_mark(observer->mark());
      continue;
    }
    const std::size_t choice = observer->ask(page).choice;
    if (study.question == "rating") {
      trial.rating_steps = choice;
      trial.rating_points = study.points;
    } else if (study.question == "yes_no") {
      trial.yes = choice == page.positive_choice;
    } else {
      trial.first = choice == 0;
    }
  }
  return person;
}

/// A group of `people`, S1 and on.
inline std::vector<AnsweringPerson> answering_group(const ObserverFile& file,
                                                    const PlantedStudy& study, int people,
                                                    std::uint64_t seed) {
  std::vector<AnsweringPerson> group;
  for (int i = 1; i <= people; ++i) {
    group.push_back(answering_person(file, study, seed, "S" + std::to_string(i)));
  }
  return group;
}

/// Seven delays (ms), each so often, answered yes or no.
inline PlantedStudy delays_study(int repetitions,
                                 const std::vector<double>& delays_ms = {0.0, 33.3, 66.7, 100.0,
                                                                         150.0, 200.0, 300.0}) {
  PlantedStudy study;
  for (int i = 0; i < repetitions; ++i) {
    for (const double delay_ms : delays_ms) {
      study.trials.push_back({freeze(delay_ms)});
    }
  }
  return study;
}

/// Gaps (minutes of arc) at two eccentricities.
inline PlantedStudy gaps_study(int repetitions) {
  PlantedStudy study;
  for (int i = 0; i < repetitions; ++i) {
    for (const double eccentricity_deg : {0.0, 4.0}) {
      for (const double gap_arcmin : {2.0, 5.0, 8.0, 12.0, 18.0, 27.0, 40.0, 80.0}) {
        study.trials.push_back({gap_between_balls(gap_arcmin, eccentricity_deg)});
      }
    }
  }
  return study;
}

}  // namespace impetus
