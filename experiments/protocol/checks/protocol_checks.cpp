// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/protocol_checks.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <utility>

#include "experiments/design/adaptive_levels.hpp"
#include "experiments/design/between_participants.hpp"
#include "experiments/design/blocks.hpp"
#include "experiments/protocol/checks/adaptive_checks.hpp"
#include "experiments/protocol/checks/factor_checks.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/factor_values.hpp"
#include "experiments/questions/answer_keys.hpp"
#include "experiments/questions/level_value.hpp"
#include "experiments/questions/question_order.hpp"
#include "experiments/questions/response_kinds.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline protocol {
namespace {

constexpr double kMostTrials = 10'000;

std::string count_text(double count) { return printed("%.15g", count); }

/// Refuses a design that nobody could sit through before its cells fill the memory.
void check_size(const Protocol& protocol) {
  auto trials = static_cast<double>(protocol.design.repetitions);
  double conditions = 1.0;
  for (const Factor& factor : protocol.design.factors) {
    conditions *= static_cast<double>(factor.levels.size());
    trials *= factor.between ? 1.0 : static_cast<double>(factor.levels.size());
  }
  if (conditions > kMostTrials) {
    refuse(protocol.document, "/design",
           "expected at most 10000 conditions, got " + count_text(conditions) +
               " (levels of all factors)");
  }
  if (trials > kMostTrials) {
    refuse(protocol.document, "/design",
           "expected at most 10000 trials, got " + count_text(trials) +
               " (levels of all factors within participants × repetitions)");
  }
}

/// The same of the trials that are planned, blocks and tracks, catch trials and at most all of
/// adaptation counted.
void check_planned_size(const Protocol& protocol) {
  const Design design = design_of_group(protocol.design, groups(protocol.design).front());
  double trials =
      static_cast<double>(design.repetitions) * static_cast<double>(cells(design).size());
  if (design.adaptive) {
    trials = static_cast<double>(design.adaptive->trials_per_track) *
             static_cast<double>(adaptive_tracks(design).size());
  }
  const auto blocks = static_cast<double>(block_order(design, {"", "P01", 0}).size());
  for (const CatchTrials& kind : design.catch_trials) {
    trials += static_cast<double>(kind.count) * blocks;
  }
  const double followed = trials;
  for (const Adaptation& stream : design.adaptation) {
    trials += static_cast<double>(stream.first) * blocks +
              static_cast<double>(stream.before_each) * followed;
  }
  if (trials > kMostTrials) {
    refuse(protocol.document, "/design",
           "expected at most 10000 trials, got " + count_text(trials) +
               " (all tracks, catch trials and adaptation counted)");
  }
}

void check_runs(const Protocol& protocol) {
  for (std::size_t i = 0; i < protocol.design.longest_runs.size(); ++i) {
    const std::string place = item("/design/longest_runs", i) + "/factor";
    factor_within(protocol.document, place, protocol.design,
                  protocol.design.longest_runs[i].factor);
  }
}

/// Ids that are taken.
using Ids = std::set<std::string>;

void check_id(const Protocol& protocol, const std::string& place, const std::string& id, Ids& ids) {
  if (!ids.insert(id).second) {
    refuse(protocol.document, place + "/id",
           "expected an id of its own, got " + json_text(id) + " again");
  }
}

void check_field(const Protocol& protocol, const std::string& place, const Field& field) {
  if (field.kind == Field::Kind::kChoice && field.options.empty()) {
    refuse(protocol.document, place, "expected the key \"options\" for a choice, which is missing");
  }
  if (field.minimum >= field.maximum) {
    refuse(protocol.document, place + "/maximum",
           "expected more than the minimum " + json_text(field.minimum) + ", got " +
               json_text(field.maximum));
  }
}

void check_questions(const Protocol& protocol) {
  Ids ids{"consent"};
  for (std::size_t i = 0; i < protocol.script.demographics.size(); ++i) {
    const std::string place = item("/session/demographics", i);
    check_id(protocol, place, protocol.script.demographics[i].id, ids);
    check_field(protocol, place, protocol.script.demographics[i]);
  }
  for (std::size_t i = 0; i < protocol.script.questions.size(); ++i) {
    check_id(protocol, item("/session/questions", i), protocol.script.questions[i].id, ids);
  }
}

/// Blocks alike have every cell equally often; others have factors and an order.
void check_kind_of_blocks(const Protocol& protocol) {
  const nlohmann::json& blocks = protocol.document.value["design"]["blocks"];
  const bool alike = blocks.contains("count");
  if (alike == blocks.contains("factors")) {
    refuse(protocol.document, "/design/blocks",
           std::string("expected either \"factors\" or \"count\", got ") +
               (alike ? "both" : "neither"));
  }
  if (alike == blocks.contains("order")) {
    refuse(protocol.document, "/design/blocks",
           alike ? "expected no \"order\" of blocks that are alike (count)"
                 : "expected the key \"order\", which is missing");
  }
  const Design& design = protocol.design;
  const std::int64_t all = design.adaptive ? design.adaptive->trials_per_track : design.repetitions;
  if (alike && all % design.blocks->count != 0) {
    refuse(protocol.document, "/design/blocks/count",
           "expected a number that divides the " + std::to_string(all) +
               (design.adaptive ? " trials of a track" : " repetitions") +
               ", so that each block has every cell equally often, got " +
               std::to_string(design.blocks->count));
  }
}

/// Blocks are made of factors of the design, or alike.
void check_blocks(const Protocol& protocol) {
  const Design& design = protocol.design;
  if (design.blocks) {
    check_kind_of_blocks(protocol);
  }
  for (std::size_t i = 0; design.blocks && i < design.blocks->factors.size(); ++i) {
    const std::string& name = design.blocks->factors[i];
    const std::string place = item("/design/blocks/factors", i);
    factor_within(protocol.document, place, design, name);
    if (design.adaptive && design.adaptive->factor == name) {
      refuse(protocol.document, place,
             "expected a factor whose levels are known beforehand, got " + json_text(name) +
                 ", which is adaptive");
    }
  }
}

/// Breaks come after so many trials, or after blocks.
void check_breaks(const Protocol& protocol) {
  if (breaks_after_blocks(protocol.script) && !protocol.design.blocks) {
    refuse(protocol.document, "/session/breaks",
           "expected the key \"every\", which is missing, where /design has no blocks");
  }
}

/// A session stops at breaks.
void check_lateness(const Protocol& protocol) {
  const Script& script = protocol.script;
  if (script.lateness.then == LatenessRule::Then::kStop && script.break_text.title.empty()) {
    refuse(protocol.document, "/session/late_frames/then",
           "expected \"tell\" or \"nothing\" where the session has no breaks to stop at, got "
           "\"stop\"");
  }
}

/// Only a design that has blocks, and whose levels do not follow from answers that would be set
/// aside, is resumed at a block's start.
void check_resume(const Protocol& protocol) {
  if (protocol.script.resume.at != ResumeRule::At::kBlock) {
    return;
  }
  if (!protocol.design.blocks) {
    refuse(protocol.document, "/session/resume/at",
           "expected \"trial\" where /design has no blocks, got \"block\"");
  }
  if (protocol.design.adaptive) {
    refuse(protocol.document, "/session/resume/at",
           "expected \"trial\" where levels are adaptive (they followed from the answers that "
           "would be set aside), got \"block\"");
  }
}

/// As many right answers fit into the trials that are looked at as train_until asks for, and these
/// into the most that there are.
void check_training_criterion(const Protocol& protocol) {
  if (!protocol.script.training_rule) {
    return;
  }
  const TrainingRule& rule = *protocol.script.training_rule;
  const std::string of = std::to_string(rule.of);
  if (rule.right > rule.of) {
    refuse(protocol.document, "/design/train_until/right",
           "expected at most the " + of + " trials that are looked at, got " +
               std::to_string(rule.right));
  }
  if (rule.of > rule.most_trials) {
    refuse(protocol.document, "/design/train_until/of",
           "expected at most the " + std::to_string(rule.most_trials) +
               " trials that there are (most_trials), got " + of);
  }
}

/// Its words for the type of a level, which are those of its index in the variant.
const char* type_words(const LevelValue& level) {
  constexpr std::array<const char*, 3> kWords{"a number", "a text", "a boolean"};
  return kWords.at(level.index());
}

/// Every factor within participants has a level in the condition, which `check` finds no fault
/// with, and nothing else has one.
void check_condition(
    const Protocol& protocol, const std::string& place, const Condition& condition,
    const std::function<void(const Factor& factor, const FactorLevel& level)>& check) {
  for (const FactorLevel& level : condition) {
    if (find_factor(protocol.design, level.factor) == nullptr) {
      refuse(protocol.document, place,
             "expected only factors of the design, got " + json_text(level.factor));
    }
  }
  for (const Factor& factor : protocol.design.factors) {
    const auto level = std::find_if(condition.begin(), condition.end(),
                                    [&](const auto& one) { return one.factor == factor.name; });
    if (factor.between && level != condition.end()) {
      refuse(protocol.document, place + "/" + factor.name,
             "expected no level of a factor between participants, whose own holds here too, got " +
                 json_text(level->value));
    }
    if (factor.between) {
      continue;
    }
    if (level == condition.end()) {
      refuse(protocol.document, place,
             "expected a level for every factor, but \"" + factor.name + "\" has none");
    }
    check(factor, *level);
  }
}

/// What is shown beside the cells has a level for every factor, of the same type as the factor's
/// own.
void check_conditions_beside(const Protocol& protocol) {
  for (const ConditionBeside& beside : conditions_beside(protocol.design)) {
    const std::string& place = beside.place;
    check_condition(
        protocol, place, beside.condition, [&](const Factor& factor, const auto& level) {
          if (!factor.sets.empty() && !has_set(factor, level.value)) {
            refuse(protocol.document, place + "/" + factor.name,
                   "expected a word that \"sets\" has, got " + json_text(level.value));
          }
          if (factor.levels.front().index() != level.value.index()) {
            refuse(protocol.document, place + "/" + factor.name,
                   std::string("expected ") + type_words(factor.levels.front()) +
                       ", as the factor's own levels are, got " + json_text(level.value));
          }
        });
  }
}

/// No two kinds of catch trials are alike.
void check_catch_trials(const Protocol& protocol) {
  const std::vector<CatchTrials>& kinds = protocol.design.catch_trials;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    for (std::size_t before = 0; before < i; ++before) {
      if (kinds[before].condition == kinds[i].condition) {
        refuse(protocol.document, item("/design/catch_trials", i) + "/condition",
               "expected a condition of its own, got " + to_json(kinds[i].condition).dump() +
                   " again");
      }
    }
  }
}

/// Streams are where trials of the design's own levels are, and somebody sees them.
void check_adaptation(const Protocol& protocol) {
  const std::vector<Adaptation>& streams = protocol.design.adaptation;
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const std::string place = item("/design/adaptation", i);
    for (const FactorLevel& level : streams[i].when) {
      const Factor* factor = find_factor(protocol.design, level.factor);
      if (factor == nullptr) {
        refuse(protocol.document, place + "/when",
               "expected a factor of the design, got " + json_text(level.factor));
      }
      if (protocol.design.adaptive && protocol.design.adaptive->factor == level.factor) {
        refuse(protocol.document, place + "/when/" + factor->name,
               "expected a factor whose levels are known beforehand, got " +
                   json_text(level.factor) + ", which is adaptive");
      }
      if (!has_level(*factor, level.value)) {
        refuse(protocol.document, place + "/when/" + factor->name,
               "expected one of the factor's levels " + list_text(factor->levels) + ", got " +
                   json_text(level.value));
      }
    }
    if (streams[i].first + streams[i].before_each == 0) {
      refuse(protocol.document, place, "expected some trials, first or before each, got none");
    }
    if (!protocol.has_participants) {
      refuse(protocol.document, place, "expected none where nobody takes part");
    }
  }
}

}  // namespace

void check_design(const Protocol& protocol) {
  check_size(protocol);
  check_factors(protocol);
  check_runs(protocol);
  check_blocks(protocol);
  check_conditions_beside(protocol);
  check_catch_trials(protocol);
  check_adaptation(protocol);
  check_adaptive(protocol);
  check_planned_size(protocol);
  check_training_criterion(protocol);
  check_resume(protocol);
  check_breaks(protocol);
  check_lateness(protocol);
  check_fixation(protocol.document, protocol.script.timing.fixation);
  for (const auto& question : protocol.script.asked) {
    question->check_block(protocol.document);
    if (!question->keys().empty()) {
      check_keys(protocol.document, "/" + question->kind().protocol_key + "/keys", question->keys(),
                 question->keyed_answers());
    }
  }
  check_question_order(protocol.document, protocol.script);
  check_questions(protocol);
}

void check_practice(const Protocol& protocol) {
  for (std::size_t i = 0; i < protocol.design.practice.size(); ++i) {
    const std::string place = item("/design/practice", i);
    check_condition(protocol, place, protocol.design.practice[i],
                    [&](const Factor& factor, const FactorLevel& level) {
                      if (!has_level(factor, level.value) && !has_set(factor, level.value)) {
                        refuse(protocol.document, place + "/" + factor.name,
                               "expected one of the factor's levels " + list_text(factor.levels) +
                                   ", got " + json_text(level.value));
                      }
                    });
    const std::string problem =
        complaint(scene_under(protocol, protocol.design.practice[i]), *protocol.shapes);
    if (!problem.empty()) {
      refuse(protocol.document, place, problem);
    }
  }
}

void check_practice_rule(const Protocol& protocol) {
  if (!protocol.script.practice_rule) {
    return;
  }
  const PracticeRule& rule = *protocol.script.practice_rule;
  named_factor(protocol.document, "/design/practice_until/factor", protocol.design, rule.factor);
  if (rule.best == rule.worst) {
    refuse(protocol.document, "/design/practice_until/worst",
           "expected another level than the best, got " + json_text(rule.worst));
  }
  for (const auto& [end, level] : {std::pair("best", rule.best), std::pair("worst", rule.worst)}) {
    const FactorLevel wanted{rule.factor, level};
    const std::vector<Condition>& practice = protocol.design.practice;
    if (std::none_of(practice.begin(), practice.end(), [&](const Condition& condition) {
          return std::find(condition.begin(), condition.end(), wanted) != condition.end();
        })) {
      refuse(protocol.document, std::string("/design/practice_until/") + end,
             "expected a level of " + rule.factor + " that is practised, got " + json_text(level));
    }
  }
}

Plan plan_for(const Protocol& protocol, const std::string& participant, std::uint64_t seed,
              const std::optional<Condition>& group) {
  try {
    return make_plan(protocol.design, {protocol.name, participant, seed, group});
  } catch (const InputError&) {
    throw;  // of the participant's code
  } catch (const std::runtime_error&) {
    refuse(protocol.document, "/design/longest_runs",
           "expected rules that some order of the trials keeps to, but none was found");
  }
}

}  // namespace impetus::inline protocol
