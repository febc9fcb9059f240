// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/observers/headless_lab.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/python/module.hpp"
#include "experiments/record/wall_names.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/session/session.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline python {
namespace {

namespace py = pybind11;

/// The scenes of a protocol, in which a metric of Python's orders collisions.
class PilotScenes final : public Scenes {
 public:
  PilotScenes(const Protocol& protocol, std::shared_ptr<const PriorityMetric> metric)
      : scenes_(protocol, kUnroundedHold), metric_(std::move(metric)) {}

  [[nodiscard]] StagedScene stage(const PlannedTrial& trial,
                                  const ScreenGeometry& screen) const override {
    return with_metric(scenes_.stage(trial, screen));
  }
  [[nodiscard]] StagedScene stage_demonstration(const std::string& id,
                                                const ScreenGeometry& screen) const override {
    return with_metric(scenes_.stage_demonstration(id, screen));
  }

 private:
  [[nodiscard]] StagedScene with_metric(StagedScene scene) const {
    if (metric_) {
      put_metric(scene.world, metric_);
    }
    return scene;
  }

  ProtocolScenes scenes_;
  std::shared_ptr<const PriorityMetric> metric_;
};

/// Nothing of a pilot is kept but what Python is given: the completed attempts.
class PilotRecord final : public Recorder {
 public:
  void save(AttemptRecord attempt) override {
    if (attempt.outcome == AttemptOutcome::kCompleted) {
      completed_[attempt.slot] = std::move(attempt);
    }
  }
  void save(QuestionRecord /*answer*/) override {}
  void save(NoteRecord /*note*/) override {}
  void save(ChosenLevel chosen) override { levels_[chosen.slot] = std::move(chosen.condition); }
  void save(CalibrationRecord /*calibration*/) override {}
  void mark_finished() override {}
  void await_saved() override {}

  [[nodiscard]] const std::map<std::int64_t, AttemptRecord>& completed() const {
    return completed_;
  }
  /// The condition that the trial was shown under.
  [[nodiscard]] Condition condition_of(const PlannedTrial& trial) const {
    const auto chosen = levels_.find(trial.slot);
    return chosen == levels_.end() ? trial.condition : chosen->second;
  }

 private:
  std::map<std::int64_t, AttemptRecord> completed_;
  std::map<std::int64_t, Condition> levels_;
};

py::list collisions_of(const AttemptRecord& record) {
  py::list all;
  for (const CollisionRecord& each : record.collisions) {
    const BodyPair& bodies = each.report.bodies;
    py::dict one;
    one["step"] = each.step;
    one["time_s"] = each.time_s;
    one["body_a"] = body_or_wall_name(bodies.a, record.body_names, record.wall_naming);
    one["body_b"] = body_or_wall_name(bodies.b, record.body_names, record.wall_naming);
    one["level"] = each.report.level;
    one["eccentricity_deg"] = each.eccentricity_deg;
    one["impulse_Ns"] = each.report.impulse_Ns;
    one["priority"] = each.priority;
    all.append(std::move(one));
  }
  return all;
}

py::dict shown_of(const AttemptRecord& record, const StagedScene& scene) {
  py::dict shown;
  shown["condition"] = as_python(to_json(scene.condition));
  shown["intended_hold_s"] = record.intended_hold_s;
  shown["realised_hold_s"] = record.realised_hold_s;
  shown["duration_s"] = scene.duration_s;
  shown["collisions"] = collisions_of(record);
  return shown;
}

/// A participant who answers by a function of Python's: answer(question, shown).
class PilotObserver final : public Input {
 public:
  PilotObserver(py::function answer, VirtualClock& clock)
      : answer_(std::move(answer)), clock_(&clock) {}

  Answer ask(const Page& page) override {
    Answer answer;
    answer.device = "simulated";
    answer.shown_ns = clock_->now_ns();
    answer.fields.assign(page.fields.size(), "");
    clock_->advance_by(kReaction_ns);
    answer.arrived_ns = clock_->now_ns();
    if (!page.response.empty()) {
      fill(page, answer_(question_of(page), shown_), answer);
    }
    return answer;
  }
  Interruption interruption() override { return Interruption::kNone; }
  void witnessed(const AttemptRecord& shown, const StagedScene& scene) override {
    const bool is_second = !shown.frames.empty() && shown.frames.back().interval == 2;
    if (!is_second) {
      shown_ = py::list();
    }
    shown_.append(shown_of(shown, scene));
  }

 private:
  static constexpr std::int64_t kReaction_ns = 500'000'000;

  static py::dict question_of(const Page& page) {
    py::dict question;
    question["kind"] = page.response;
    question["words"] = page.paragraphs;
    std::vector<std::string> labels;
    for (const Choice& choice : page.choices) {
      labels.push_back(choice.label);
    }
    question["choices"] = labels;
    question["best_choice"] = page.best_choice;
    question["positive_choice"] = page.positive_choice;
    return question;
  }

  /// On a slider's line, where the page has one.
  static void require_mark(const Page& page, const py::object& given) {
    const Field& field = page.fields.front();
    if (field.kind != Field::Kind::kSlider) {
      return;
    }
    std::optional<double> mark;
    try {
      mark = given.cast<double>();
    } catch (const py::cast_error&) {  // no number: refused below
    }
    if (!mark || !(*mark >= field.minimum && *mark <= field.maximum)) {
      throw py::value_error(
          printed("an observer's answer to %s: expected a number from %g to %g, "
                  "got %s",
                  page.response.c_str(), field.minimum, field.maximum,
                  py::repr(given).cast<std::string>().c_str()));
    }
  }

  static void fill(const Page& page, const py::object& given, Answer& answer) {
    if (!page.fields.empty() && page.choices.size() <= 1) {
      answer.fields.front() = py::str(given).cast<std::string>();
      require_mark(page, given);
      return;
    }
    const auto expected = [&](const std::string& got) {
      return py::value_error("an observer's answer to " + page.response +
                             ": expected an index from 0 to " +
                             std::to_string(page.choices.size() - 1) + ", got " + got);
    };
    std::int64_t choice = -1;
    try {
      choice = given.cast<std::int64_t>();
    } catch (const py::cast_error&) {
      throw expected(py::repr(given).cast<std::string>());
    }
    if (choice < 0 || static_cast<std::size_t>(choice) >= page.choices.size()) {
      throw expected(std::to_string(choice));
    }
    answer.choice = static_cast<std::size_t>(choice);
  }

  py::function answer_;
  VirtualClock* clock_;
  py::list shown_;  ///< in each interval of the trial
};

py::dict row_of(const PlannedTrial& trial, const Condition& condition,
                const AttemptRecord& record) {
  py::dict row;
  row["slot"] = trial.slot;
  row["phase"] = std::string(name_of(trial.phase));
  row["repetition"] = trial.repetition;
  row["catch"] = trial.catch_trial;
  row["condition"] = as_python(to_json(condition));
  row["rating"] =
      record.ratings.empty() ? py::object(py::none()) : py::int_(record.ratings.front().rating);
  py::dict answers;
  for (const ResponseRecord& response : record.responses) {
    answers[py::str(response.question.empty() ? response.kind : response.question)] =
        response.answer;
  }
  row["answers"] = std::move(answers);
  row["collisions"] = collisions_of(record);
  row["hash"] = bits_of(record.steps.empty() ? 0 : record.steps.back().state.hash);
  return row;
}

py::list pilot(const Protocol& protocol, const std::string& participant, std::uint64_t seed,
               const py::function& observer, const std::shared_ptr<const PriorityMetric>& metric) {
  if (!protocol.has_participants) {
    throw InputError(protocol.document.name +
                     ": expected a protocol in which somebody takes part, for a pilot");
  }
  if (protocol.script.gaze) {
    throw InputError(protocol.document.name +
                     ": expected a protocol that does not follow the gaze, which an observer "
                     "written in Python does not have");
  }
  const Plan plan = plan_for(protocol, participant, seed);
  VirtualClock clock;
  HeadlessDisplay display(clock, kHeadlessHz, assumed_screen());
  PilotObserver input(observer, clock);
  const PilotScenes scenes(protocol, metric);
  PilotRecord record;
  const SteadyClock work_clock;
  const Ports ports{display, input, scenes, record, nullptr, &clock, &work_clock};
  run_session(protocol.script, plan, {}, ports, protocol.design);
  py::list rows;
  for (const PlannedTrial& trial : plan) {
    const auto found = record.completed().find(trial.slot);
    if (found != record.completed().end()) {
      rows.append(row_of(trial, record.condition_of(trial), found->second));
    }
  }
  return rows;
}

}  // namespace

void add_pilots(py::module_& module) {
  module.def("pilot", [](const Protocol& protocol, const std::string& participant,
                         std::uint64_t seed, const py::function& observer) {
    return pilot(protocol, participant, seed, observer, nullptr);
  });
  module.def("pilot",
             [](const Protocol& protocol, const std::string& participant, std::uint64_t seed,
                const py::function& observer, py::function metric, const std::string& urgent) {
               return pilot(protocol, participant, seed, observer,
                            metric_of_function(std::move(metric), urgent));
             });
}

}  // namespace impetus::inline python
