// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_file.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include <xxhash.h>

#include "experiments/protocol/embedded_schema.hpp"
#include "experiments/protocol/protocol_checks.hpp"
#include "experiments/protocol/protocol_scene_checks.hpp"
#include "experiments/protocol/scene_loading.hpp"
#include "experiments/protocol/validation.hpp"

namespace impetus {
namespace {

using nlohmann::json;

const json& protocol_schema() {
  static const json schema = json::parse(kProtocolSchemaText);
  return schema;
}

LevelValue level_value(const json& value) {
  if (value.is_string()) {
    return value.get<std::string>();
  }
  if (value.is_boolean()) {
    return value.get<bool>();
  }
  return value.get<double>();
}

/// A whole number stays one, so that 100 is stored as 100 and not as 100.0.
json to_json(const LevelValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    const bool whole = std::floor(*number) == *number && std::abs(*number) < 1e15;
    return whole ? json(static_cast<std::int64_t>(*number)) : json(*number);
  }
  return std::visit([](const auto& any) { return json(any); }, value);
}

Text text_from(const json& object) {
  return {object["title"].get<std::string>(), object["paragraphs"].get<std::vector<std::string>>()};
}

Field field_from(const json& object) {
  const auto kind = object["kind"].get<std::string>();
  Field field;
  field.id = object["id"].get<std::string>();
  field.label = object["label"].get<std::string>();
  field.kind = kind == "number"   ? Field::Kind::kNumber
               : kind == "choice" ? Field::Kind::kChoice
                                  : Field::Kind::kText;
  field.options = object.value("options", std::vector<std::string>{});
  field.minimum = object.value("minimum", -1e9);
  field.maximum = object.value("maximum", 1e9);
  return field;
}

Design design_from(const json& object) {
  Design design;
  for (const json& entry : object["factors"]) {
    Factor factor{entry["name"].get<std::string>(), {}};
    for (const json& level : entry["levels"]) {
      factor.levels.push_back(level_value(level));
    }
    design.factors.push_back(std::move(factor));
  }
  design.repetitions = object["repetitions"].get<std::int64_t>();
  if (object.contains("practice_until")) {
    design.practice_rounds = object["practice_until"]["rounds"].get<std::int64_t>();
  }
  for (const json& rule : object.value("longest_runs", json::array())) {
    design.longest_runs.push_back(
        {rule["factor"].get<std::string>(), rule["longest"].get<std::int64_t>()});
  }
  return design;
}

RatingScale scale_from(const json& object) {
  return {object["question"].get<std::string>(),   object["minimum"].get<std::int64_t>(),
          object["maximum"].get<std::int64_t>(),   object["best"].get<std::int64_t>(),
          object["low_anchor"].get<std::string>(), object["high_anchor"].get<std::string>()};
}

std::optional<PracticeRule> practice_rule_from(const json& design) {
  if (!design.contains("practice_until")) {
    return std::nullopt;
  }
  const json& rule = design["practice_until"];
  return PracticeRule{rule["factor"].get<std::string>(), level_value(rule["best"]),
                      level_value(rule["worst"])};
}

Script script_from(const json& document) {
  const json& session = document["session"];
  Script script;
  script.title = document["title"].get<std::string>();
  script.welcome = text_from(session["welcome"]);
  script.consent = text_from(session["consent"]);
  script.consent_statement = session["consent"]["statement"].get<std::string>();
  for (const json& field : session.value("demographics", json::array())) {
    script.demographics.push_back(field_from(field));
  }
  for (const json& page : session["instructions"]) {
    script.instructions.push_back(text_from(page));
  }
  if (session.contains("breaks")) {
    script.break_text = text_from(session["breaks"]);
    script.break_every = session["breaks"]["every"].get<std::int64_t>();
  }
  for (const json& question : session.value("questions", json::array())) {
    script.questions.push_back(
        {question["id"].get<std::string>(), question["text"].get<std::string>()});
  }
  script.thanks = text_from(session["thanks"]);
  for (const json& entry : session.value("demonstrations", json::array())) {
    script.demonstrations.push_back({entry["id"].get<std::string>(), text_from(entry)});
  }
  script.scale = scale_from(document["rating"]);
  script.timing = {document["timing"]["fixation_ms"].get<double>(),
                   document["timing"]["interval_ms"].get<double>()};
  if (document.contains("clicks")) {
    script.clicks = ClickTask{document["clicks"]["merge_within_ms"].get<double>()};
  }
  if (document.contains("gaze")) {
    script.gaze = GazeTask{document["gaze"]["extra_latency_ms"].get<double>()};
  }
  script.practice_rule = practice_rule_from(document["design"]);
  return script;
}

void require_schema(const JsonDocument& document, const json& schema) {
  if (const auto problem = find_schema_problem(schema, document.value)) {
    refuse(document, problem->pointer, problem->message);
  }
}

/// The mesh files that factors and demonstrations put into the scene.
std::vector<std::string> mesh_files_of_design(const json& protocol) {
  std::vector<std::string> files;
  const auto add = [&](const std::string& pointer, const json& value) {
    if (pointer.ends_with("/shape/file") && value.is_string()) {
      files.push_back(value.get<std::string>());
    }
  };
  for (const json& factor : protocol["design"]["factors"]) {
    for (const json& level : factor["levels"]) {
      add(factor["pointer"].get<std::string>(), level);
    }
  }
  const json entries = protocol["session"].value("demonstrations", json::array());
  for (const json& entry : entries) {
    for (auto value = entry["set"].begin(); value != entry["set"].end(); ++value) {
      add(value.key(), value.value());
    }
  }
  return files;
}

std::string hash_of(const json& protocol, const json& scene) {
  const std::string canonical = protocol.dump() + "\n" + scene.dump();
  const XXH128_hash_t hash = XXH3_128bits(canonical.data(), canonical.size());
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text;
}

}  // namespace

json to_json(const Condition& condition) {
  json object = json::object();
  for (const FactorLevel& level : condition) {
    object[level.factor] = to_json(level.value);
  }
  return object;
}

Condition condition_from_json(const json& object, const Design& design) {
  Condition condition;
  for (const Factor& factor : design.factors) {
    condition.push_back({factor.name, level_value(object.at(factor.name))});
  }
  return condition;
}

json scene_under(const Protocol& protocol, const Condition& condition) {
  json scene = protocol.scene.value;
  for (const FactorLevel& level : condition) {
    scene[json::json_pointer(protocol.pointers.at(level.factor))] = to_json(level.value);
  }
  return scene;
}

json demonstration_scene(const Protocol& protocol, const std::string& id) {
  json scene = protocol.scene.value;
  for (const json& entry : protocol.document.value["session"]["demonstrations"]) {
    if (entry["id"].get<std::string>() == id) {
      const json& values = entry["set"];
      for (auto value = values.begin(); value != values.end(); ++value) {
        scene[json::json_pointer(value.key())] = value.value();
      }
    }
  }
  return scene;
}

Protocol make_protocol(JsonDocument document, JsonDocument scene) {
  require_schema(document, protocol_schema());
  require_scene(scene);
  Protocol protocol;
  protocol.name = document.value["name"].get<std::string>();
  protocol.title = document.value["title"].get<std::string>();
  protocol.hash = hash_of(document.value, scene.value);
  protocol.document = std::move(document);
  protocol.scene = std::move(scene);

  const json& design = protocol.document.value["design"];
  check_design(protocol.document, protocol.scene);
  protocol.design = design_from(design);
  for (const json& factor : design["factors"]) {
    const auto name = factor["name"].get<std::string>();
    protocol.pointers[name] = factor["pointer"].get<std::string>();
    protocol.labels[name] = factor.value("label", name);
  }
  check_levels(protocol);
  check_practice(protocol.document);
  check_practice_rule(protocol.document);
  check_demonstrations(protocol);
  check_gaze(protocol);
  for (const json& condition : design.value("practice", json::array())) {
    protocol.design.practice.push_back(condition_from_json(condition, protocol.design));
  }
  protocol.script = script_from(protocol.document.value);
  return protocol;
}

Protocol load_protocol(const std::filesystem::path& path) {
  JsonDocument document = read_json(path);
  require_schema(document, protocol_schema());
  const auto beside = path.parent_path() / document.value["scene"].get<std::string>();
  const std::filesystem::path scene = beside.lexically_normal();
  if (!std::filesystem::exists(scene)) {
    refuse(document, "/scene",
           "expected a file, seen from this one, got " + document.value["scene"].dump() +
               ", but there is no " + scene.string());
  }
  const std::vector<std::string> files = mesh_files_of_design(document.value);
  return make_protocol(std::move(document), read_scene(scene, files));
}

}  // namespace impetus
