// SPDX-License-Identifier: MIT
#include "experiments/study/protocol_check.hpp"

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/checks/yoke_checks.hpp"
#include "experiments/store/enrolment.hpp"
#include "experiments/store/rows.hpp"
#include "experiments/store/study_reader.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline study {
namespace {

using nlohmann::json;

/// Who was planned for, and by which seed.
struct StoredEnrolment {
  std::int64_t id{0};
  std::int64_t protocol_id{0};
  std::string participant;
  std::uint64_t seed{0};
};

/// The condition as it was planned: an adaptive level came later.
std::string planned_condition(const StoredTrial& trial, const Design& design) {
  json condition = json::parse(trial.condition);
  if (trial.track && design.adaptive) {
    condition.erase(design.adaptive->factor);
  }
  return condition.dump();
}

std::string words(const StoredTrial& trial, const std::string& condition) {
  return std::string(name_of(trial.phase)) + " trial under " + condition + ", repetition " +
         std::to_string(trial.repetition) + ", block " + std::to_string(trial.block) +
         (trial.track ? ", track " + std::to_string(*trial.track) : "") +
         (trial.catch_trial ? ", catch" : "") + ", seed " + std::to_string(trial.seed);
}

/// Whether the trial follows a recorded gaze where it must, and only there.
std::optional<std::string> yoke_problem(const StoredTrial& trial, const PlannedTrial& planned,
                                        const Protocol& protocol) {
  const bool follows = followed_condition(protocol, planned.condition).has_value();
  if (follows == trial.yoked_trial_id.has_value()) {
    return std::nullopt;
  }
  return std::string(follows ? "follows nobody's gaze, though its condition asks for one"
                             : "follows another's gaze, though its condition asks for none");
}

std::optional<std::string> first_difference(const std::vector<StoredTrial>& kept, const Plan& plan,
                                            const Protocol& protocol) {
  const std::vector<StoredTrial> anew = stored(plan);
  for (std::size_t i = 0; i < std::min(kept.size(), anew.size()); ++i) {
    const std::string slot = "slot " + std::to_string(anew[i].slot);
    if (kept[i].slot != anew[i].slot) {
      return slot + " is missing from the plan";
    }
    const std::string was = words(kept[i], planned_condition(kept[i], protocol.design));
    const std::string is = words(anew[i], json::parse(anew[i].condition).dump());
    if (was != is) {
      return slot + ": the plan has a " + was + "; planned anew it is a " + is;
    }
    if (const auto problem = yoke_problem(kept[i], plan[i], protocol)) {
      return slot + ": " + *problem;
    }
  }
  if (kept.size() != anew.size()) {
    return "the plan has " + std::to_string(kept.size()) + " trials; planned anew it has " +
           std::to_string(anew.size());
  }
  return std::nullopt;
}

std::optional<std::string> plan_problem(SQLite::Database& database,
                                        const StoredEnrolment& enrolment,
                                        const Protocol& protocol) {
  try {
    const std::vector<StoredTrial> kept = load_trials(database, enrolment.id);
    const Condition group = stored_group(kept, protocol.design);
    return first_difference(kept, plan_for(protocol, enrolment.participant, enrolment.seed, group),
                            protocol);
  } catch (const SQLite::Exception&) {
    throw;
  } catch (const std::exception& error) {
    return std::string("cannot be planned anew: ") + error.what();
  }
}

}  // namespace

ProtocolShelf::ProtocolShelf(StudyFile& study) {
  for (const std::int64_t id :
       load_column<std::int64_t>(study.database(), "SELECT id FROM protocol ORDER BY id")) {
    const ProtocolTexts texts = load_protocol_texts(study, id);
    const std::string place = "protocol " + texts.name;
    try {
      Protocol protocol = make_protocol(parse_json(place, texts.protocol_json),
                                        parse_json(place + ", scene", texts.scene_json));
      if (protocol.name != texts.name) {
        failures_.push_back(place + ": calls itself " + protocol.name);
      }
      if (protocol.hash != texts.hash) {
        failures_.push_back(place + ": its hash is " + texts.hash + ", computed anew it is " +
                            protocol.hash);
      }
      protocols_.emplace(id, std::move(protocol));
    } catch (const std::exception& error) {
      failures_.emplace_back(error.what());
      ++unreadable_;
    }
  }
}

const Protocol* ProtocolShelf::find(std::int64_t id) const {
  const auto found = protocols_.find(id);
  return found == protocols_.end() ? nullptr : &found->second;
}

Failures changed_plans(StudyFile& study, const ProtocolShelf& shelf) {
  Failures failures;
  for (const StoredEnrolment& enrolment :
       load_as<StoredEnrolment, std::int64_t, std::int64_t, std::string, std::uint64_t>(
           study.database(),
           "SELECT enrolment.id, protocol_id, pseudonym, seed FROM enrolment "
           "JOIN participant ON participant.id = participant_id ORDER BY enrolment.id")) {
    const Protocol* protocol = shelf.find(enrolment.protocol_id);
    if (protocol == nullptr) {
      continue;
    }
    if (const auto problem = plan_problem(study.database(), enrolment, *protocol)) {
      failures.push_back(enrolment.participant + ", " + protocol->name + ": " + *problem);
    }
  }
  return failures;
}

}  // namespace impetus::inline study
