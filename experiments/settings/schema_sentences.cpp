// SPDX-License-Identifier: MIT
#include "experiments/settings/schema_sentences.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>
#include <vector>

namespace impetus::inline settings {
namespace {

using nlohmann::json;

/// One step down from `schema` to what governs `token`, references followed; null when nothing
/// does.
const json* follow(const json& root, const json* schema) {
  while (schema != nullptr && schema->contains("$ref")) {
    const std::string target = (*schema)["$ref"].get<std::string>();
    schema = &root.at(json::json_pointer(target.substr(1)));
  }
  return schema;
}

const json* governing(const json& root, const json& schema, const std::string& token,
                      bool in_array) {
  if (in_array) {
    return schema.contains("items") ? follow(root, &schema["items"]) : nullptr;
  }
  if (schema.contains("properties") && schema["properties"].contains(token)) {
    return follow(root, &schema["properties"][token]);
  }
  if (schema.contains("additionalProperties") && schema["additionalProperties"].is_object()) {
    return follow(root, &schema["additionalProperties"]);
  }
  return nullptr;
}

std::string shortened(const json& value) {
  constexpr std::size_t kLongest = 60;
  const std::string text = value.dump();
  std::size_t end = kLongest;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) {
    --end;  // Never half a character.
  }
  return text.size() <= kLongest ? text : text.substr(0, end) + "…";
}

/// 1000000 for 1e6, where JSON would say 1000000.0.
std::string number_text(const json& number) {
  const auto value = number.get<double>();
  const bool whole = std::floor(value) == value && std::abs(value) < 1e15;
  return whole ? std::to_string(static_cast<std::int64_t>(value)) : number.dump();
}

/// What a regular expression of the schemas asks for, for people who read none.
std::string pattern_words(const std::string& pattern) {
  static const std::map<std::string, std::string> words{
      {"^[a-z][a-z0-9-]*$", " of lower-case letters, digits and hyphens that begins with a letter"},
      {"^[a-z][a-z0-9_]*$",
       " of lower-case letters, digits and underscores that begins with a letter"},
      {"^/", " that begins with /"},
      {"^#[0-9a-fA-F]{6}$", " such as \"#d9813b\""}};
  const auto known = words.find(pattern);
  return known != words.end() ? known->second : " that matches " + json(pattern).dump();
}

/// " ≥ 0 and ≤ 1", " of 2 values", "...": what a schema asks for beyond the type.
std::string range_words(const json& schema) {
  const bool from = schema.contains("minimum") || schema.contains("exclusiveMinimum");
  std::string words;
  if (schema.contains("minimum")) {
    words += " ≥ " + number_text(schema["minimum"]);
  }
  if (schema.contains("exclusiveMinimum")) {
    words += " > " + number_text(schema["exclusiveMinimum"]);
  }
  if (schema.contains("maximum")) {
    words += (from ? " and ≤ " : " ≤ ") + number_text(schema["maximum"]);
  }
  return words;
}

std::string size_words(const json& schema) {
  const std::int64_t least = schema.value("minItems", std::int64_t{0});
  const std::int64_t most = schema.value("maxItems", std::int64_t{-1});
  const auto values = [](std::int64_t count) {
    return std::to_string(count) + (count == 1 ? " value" : " values");
  };
  if (least == most) {
    return " of " + values(least);
  }
  if (least > 0 && most > least) {
    return " of " + std::to_string(least) + " to " + values(most);
  }
  return (least > 0 ? " of at least " + values(least) : "") +
         (most >= 0 ? " of at most " + values(most) : "");
}

std::string joined(const std::vector<std::string>& items, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += i == 0 ? "" : i + 1 == items.size() ? last : ", ";
    text += items[i];
  }
  return text;
}

std::string type_words(const json& schema) {
  if (!schema.contains("type")) {
    return "a value";
  }
  std::vector<std::string> words;
  const json types = schema["type"].is_array() ? schema["type"] : json::array({schema["type"]});
  for (const json& type : types) {
    const auto name = type.get<std::string>();
    if (name == "array") {
      words.emplace_back("a list");
    } else if (name == "integer") {
      words.emplace_back("a whole number");
    } else if (name == "string") {
      words.emplace_back("a text");
    } else {
      words.push_back((name == "object" ? "an " : "a ") + name);
    }
  }
  return joined(words, " or ");
}

std::string expectation(const json& schema) {
  if (schema.contains("const")) {
    return schema["const"].dump();
  }
  if (schema.contains("enum")) {
    std::vector<std::string> options;
    for (const json& option : schema["enum"]) {
      options.push_back(option.dump());
    }
    return (options.size() > 1 ? "one of " : "") + joined(options, ", ");
  }
  std::string words = type_words(schema) + size_words(schema) + range_words(schema);
  if (schema.value("minLength", 0) > 0) {
    words += " that is not empty";
  }
  if (schema.contains("pattern")) {
    words += pattern_words(schema["pattern"].get<std::string>());
  }
  if (schema.value("uniqueItems", false)) {
    words += " without repeats";
  }
  return words;
}

/// "" unless the object has a key too many or too few.
std::string key_problem(const json& schema, const json& value) {
  if (!value.is_object() || !schema.contains("properties")) {
    return "";
  }
  for (const json& key : schema.value("required", json::array())) {
    if (!value.contains(key.get<std::string>())) {
      return "expected the key " + key.dump() + ", which is missing";
    }
  }
  if (schema.value("additionalProperties", json(true)) != json(false)) {
    return "";
  }
  std::vector<std::string> known;
  for (const auto& [key, unused] : schema["properties"].items()) {
    known.push_back("\"" + key + "\"");
  }
  for (const auto& [key, unused] : value.items()) {
    if (!schema["properties"].contains(key)) {
      return "expected only the keys " + joined(known, ", ") + ", got \"" + key + "\"";
    }
  }
  return "";
}

SchemaProblem explain(const json& root, const json& value, const std::vector<std::string>& path) {
  SchemaProblem problem;
  json::json_pointer place;
  const json* schema = &root;
  const json* here = &value;
  for (const std::string& token : path) {
    const json* next = governing(root, *schema, token, here->is_array());
    if (next == nullptr) {
      break;
    }
    place.push_back(token);
    here = here->is_array() ? &(*here)[std::stoul(token)] : &(*here)[token];
    schema = next;
  }
  problem.pointer = place.to_string();
  const std::string about_keys = key_problem(*schema, *here);
  problem.message = about_keys.empty()
                        ? "expected " + expectation(*schema) + ", got " + shortened(*here)
                        : about_keys;
  return problem;
}

/// valijson compares each value of a list with each other, which takes hours of a long one: it gets
/// the schema without this rule, which find_repeat() judges.
constexpr const char* kNoRepeats = "uniqueItems";

json without_repeat_rules(json schema) {
  if (schema.is_object()) {
    schema.erase(kNoRepeats);
  }
  if (schema.is_structured()) {
    for (json& part : schema) {
      part = without_repeat_rules(std::move(part));
    }
  }
  return schema;
}

bool has_repeat(const json& list) {
  const auto is_less = [](const json* one, const json* other) { return *one < *other; };
  std::set<const json*, decltype(is_less)> seen(is_less);
  return std::any_of(list.begin(), list.end(),
                     [&](const json& value) { return !seen.insert(&value).second; });
}

/// Extends `path` to the first list that has a repeat where the schema allows none.
bool find_repeat(const json& root, const json* schema, const json& value,
                 std::vector<std::string>& path) {
  if (schema == nullptr || !value.is_structured()) {
    return false;
  }
  if (value.is_array() && schema->value(kNoRepeats, false) && has_repeat(value)) {
    return true;
  }
  for (const auto& part : value.items()) {
    if (part.value().is_structured()) {
      path.push_back(part.key());
      if (find_repeat(root, governing(root, *schema, part.key(), value.is_array()), part.value(),
                      path)) {
        return true;
      }
      path.pop_back();
    }
  }
  return false;
}

/// valijson names places "<root>", "[key]", "[key]", ...
std::vector<std::string> path_of(const std::vector<std::string>& context) {
  std::vector<std::string> path;
  for (const std::string& part : context) {
    if (part.size() > 2 && part.front() == '[') {
      path.push_back(part.substr(1, part.size() - 2));
    }
  }
  return path;
}

}  // namespace

std::optional<SchemaProblem> find_schema_problem(const json& schema, const json& value) {
  const json rules = without_repeat_rules(schema);
  valijson::Schema parsed;
  valijson::SchemaParser().populateSchema(valijson::adapters::NlohmannJsonAdapter(rules), parsed);
  valijson::ValidationResults results;
  const valijson::adapters::NlohmannJsonAdapter target(value);
  std::vector<std::string> repeat;
  const bool repeats = find_repeat(schema, &schema, value, repeat);
  if (valijson::Validator().validate(parsed, target, &results) && !repeats) {
    return std::nullopt;
  }
  // Errors are listed from the innermost out: the deepest place is the cause.
  std::vector<std::string> deepest;
  valijson::ValidationResults::Error error;
  while (results.popError(error)) {
    std::vector<std::string> path = path_of(error.context);
    if (path.size() > deepest.size()) {
      deepest = std::move(path);
    }
  }
  if (repeat.size() > deepest.size()) {
    deepest = std::move(repeat);
  }
  return explain(schema, value, deepest);
}

void require_schema(const JsonDocument& document, const json& schema) {
  if (const auto problem = find_schema_problem(schema, document.value)) {
    refuse(document, problem->pointer, problem->message);
  }
}

}  // namespace impetus::inline settings
