// SPDX-License-Identifier: MIT
#include "experiments/commands/running/enrolling.hpp"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "experiments/design/between_participants.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/yoke_checks.hpp"
#include "experiments/record/lab_screen.hpp"
#include "experiments/store/session_rows.hpp"
#include "experiments/store/study_reader.hpp"
#include "experiments/store/yoke_rows.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline commands {
namespace {

using nlohmann::json;

constexpr const char* kPlace = "/gaze/yoked_to";

/// What must be alike where one follows the other's gaze: all but where the region is and how late.
json comparable(json scene) {
  for (const char* key : {"$schema", "title", "source"}) {
    scene.erase(key);
  }
  scene["engine"].erase("region");
  if (scene.contains("imposed")) {
    scene["imposed"].erase("gaze_latency_ms");
  }
  if (scene.contains("imposed") && scene["imposed"].empty()) {
    scene.erase("imposed");
  }
  return scene;
}

std::string value_at(const json& scene, const std::string& pointer) {
  const json::json_pointer place(pointer);
  return scene.contains(place) ? scene[place].dump() : "missing";
}

/// Finds for one participant whom to follow, and in which trial.
class Yoking {
 public:
  /// `followed`: a condition that the partner has trials under.
  Yoking(StudyFile& study, const Protocol& protocol, const std::string& participant, bool simulated,
         const Condition& followed)
      : study_(study),
        protocol_(protocol),
        rule_(*protocol.script.gaze->yoked_to),
        source_name_(rule_.protocol.empty() ? protocol.name : rule_.protocol),
        participant_(participant),
        simulated_(simulated),
        partner_(find_partner(to_json(followed).dump())),
        sources_(yoke_sources(study, partner_)),
        source_protocol_(load_source()) {}

  /// The trial that a trial under `followed` follows.
  std::int64_t source_of(const PlannedTrial& trial, const Condition& followed) {
    const json wanted = to_json(followed);
    const auto found =
        std::find_if(sources_.begin(), sources_.end(), [&](const YokeSource& source) {
          return source.phase == trial.phase && source.repetition == trial.repetition &&
                 source.catch_trial == trial.catch_trial && json::parse(source.condition) == wanted;
        });
    if (found == sources_.end() || !found->completed) {
      refuse(protocol_.document, kPlace,
             "expected a completed trial of " + partner_.pseudonym + " in " + source_name_ +
                 " to follow, under " + wanted.dump() + " in " +
                 (trial.phase == TrialPhase::kPractice ? "practice round " : "repetition ") +
                 std::to_string(trial.repetition) + ", but there is none");
    }
    require_same_scene(*found, followed);
    require_gaze(*found);
    return found->trial_id;
  }

 private:
  YokePartner find_partner(const std::string& followed) {
    const std::string place = std::string(kPlace) + "/participant";
    if (rule_.participant == YokeRule::kPrevious || rule_.participant == YokeRule::kLeastFollowed) {
      const auto find =
          rule_.participant == YokeRule::kPrevious ? last_partner : least_followed_partner;
      const bool from_here = rule_.protocol.empty();
      auto found = find(study_, source_name_, participant_, simulated_, followed);
      if (!found && !from_here) {
        found = find(study_, source_name_, participant_, simulated_, "");  // source_of() tells why
      }
      if (found) {
        return *found;
      }
      refuse(protocol_.document, place,
             "expected another " + std::string(simulated_ ? "simulated participant" : "person") +
                 " who has finished " + source_name_ + " in " + study_.name() +
                 (from_here ? " under " + followed : "") + ", but there is none yet; " +
                 (from_here ? "somebody whose regions are tracked has to be first, which --seed "
                              "decides"
                            : "run " + source_name_ + " first"));
    }
    if (!has_participant(study_, rule_.participant)) {
      refuse(
          protocol_.document, place,
          "expected a participant of " + study_.name() + ", got " + json(rule_.participant).dump());
    }
    const auto found = finished_partner(study_, rule_.participant, source_name_);
    if (rule_.participant == participant_ || !found) {
      refuse(protocol_.document, place,
             "expected another participant who has finished " + source_name_ + " in " +
                 study_.name() + ", got " + json(rule_.participant).dump());
    }
    return *found;
  }

  Protocol load_source() {
    const ProtocolTexts texts = load_protocol_texts(study_, partner_.protocol_id);
    return make_protocol(parse_json(texts.name, texts.protocol_json),
                         parse_json(texts.name + "'s scene", texts.scene_json));
  }

  void require_same_scene(const YokeSource& source, const Condition& followed) {
    const Condition then =
        condition_from_json(json::parse(source.condition), source_protocol_.design);
    const json theirs = comparable(scene_under(source_protocol_, then));
    const json ours = comparable(scene_under(protocol_, followed));
    const json differences = json::diff(theirs, ours);
    if (!differences.empty()) {
      const auto pointer = differences[0]["path"].get<std::string>();
      refuse(protocol_.document, kPlace,
             "expected the same scene in what is followed, but " + pointer + " is " +
                 value_at(theirs, pointer) + " in " + partner_.pseudonym + "'s trial " +
                 std::to_string(source.slot) + " of " + source_name_ + ", not " +
                 value_at(ours, pointer));
    }
  }

  void require_gaze(const YokeSource& source) {
    const GazePath path = load_gaze_path(study_, source.trial_id);
    if (std::none_of(path.fixations.begin(), path.fixations.end(),
                     [](const Fixation& fixation) { return fixation.has_value(); })) {
      refuse(protocol_.document, kPlace,
             "expected a recorded gaze to follow, but " + partner_.pseudonym + "'s trial " +
                 std::to_string(source.slot) + " of " + source_name_ + " has no valid sample");
    }
  }

  StudyFile& study_;
  const Protocol& protocol_;
  YokeRule rule_;
  std::string source_name_;
  std::string participant_;
  bool simulated_;
  YokePartner partner_;
  std::vector<YokeSource> sources_;
  Protocol source_protocol_;
};

}  // namespace

Plan yoked(Plan plan, StudyFile& study, const Protocol& protocol, const std::string& participant,
           bool simulated) {
  std::optional<Yoking> yoking;
  for (PlannedTrial& trial : plan) {
    if (const auto followed = followed_condition(protocol, trial.condition)) {
      if (!yoking) {
        yoking.emplace(study, protocol, participant, simulated, *followed);
      }
      trial.yoked_trial_id = yoking->source_of(trial, *followed);
    }
  }
  return plan;
}

GazePaths gaze_paths_of(const Plan& plan, StudyFile& study) {
  GazePaths paths;
  for (const PlannedTrial& trial : plan) {
    if (trial.yoked_trial_id) {
      paths[*trial.yoked_trial_id] = load_gaze_path(study, *trial.yoked_trial_id);
    }
  }
  return paths;
}

std::string change_of_screen(StudyFile& study, const RunOptions& options,
                             const Enrolment& enrolment, const ScreenGeometry& screen) {
  const auto last = last_screen(study.database(), enrolment.id);
  if (!last || is_same_screen(*last, screen)) {
    return "";
  }
  const std::string now = screen_words(screen);
  if (!options.changed_screen) {
    throw InputError(study.name() + ": participant " + options.participant +
                     " goes on: expected the screen of the session before (" + screen_words(*last) +
                     "), got " + now +
                     "; --changed-screen goes on with this one, and keeps a note");
  }
  return now + "; in the session before " + screen_words(*last);
}

std::optional<Enrolment> find_to_resume(StudyFile& study, const RunPart& part,
                                        const RunOptions& options) {
  auto found =
      find_enrolment(study, options.participant, options.simulated(), texts_of(part.protocol));
  if (found && options.seed && *options.seed != found->seed) {
    throw InputError("--seed " + std::to_string(*options.seed) + ": expected " +
                     std::to_string(found->seed) + ", with which " + options.participant +
                     "'s trials were planned");
  }
  return found;
}

namespace {

/// The groups of those who have a plan of the protocol, people or simulated participants. Who
/// declined or was left out of the analysis leaves a place.
std::vector<Condition> earlier_groups(StudyFile& study, const Protocol& protocol, bool simulated) {
  std::vector<Condition> earlier;
  for (const std::string& condition : first_conditions(study, protocol.name, simulated)) {
    earlier.push_back(
        group_of(protocol.design, condition_from_json(json::parse(condition), protocol.design)));
  }
  return earlier;
}

}  // namespace

Plan new_plan(StudyFile& study, const RunPart& part, const RunOptions& options) {
  const std::uint64_t seed = options.seed.value_or(1);
  const Condition group =
      draw_group(part.protocol.design, {part.protocol.name, options.participant, seed},
                 earlier_groups(study, part.protocol, options.simulated()));
  Plan plan = plan_for(part.protocol, options.participant, seed, group);
  put_solved(part.solved, plan);
  return yoked(std::move(plan), study, part.protocol, options.participant, options.simulated());
}

Enrolment enrol_anew(StudyFile& study, const RunPart& part, const RunOptions& options,
                     const Plan& plan) {
  const ProtocolTexts texts = texts_of(part.protocol);
  for (const std::string& hash : other_versions(study, texts)) {
    std::fprintf(stderr, "note: %s also holds another version of %s (%s)\n", study.name().c_str(),
                 texts.name.c_str(), hash.c_str());
  }
  return enrol(study, options.participant, options.simulated(), texts, options.seed.value_or(1),
               stored(plan));
}

}  // namespace impetus::inline commands
