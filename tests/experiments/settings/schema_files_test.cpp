// The committed schemas are what the rows of settings say (settings/setting_rows.hpp). Whoever
// changes a row runs this with IMPETUS_WRITE_SCHEMAS=1, which writes the files anew.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "experiments/observers/observer_kinds.hpp"
#include "experiments/protocol/protocol_rows.hpp"
#include "experiments/protocol/series_file.hpp"
#include "experiments/scenes/scene.hpp"
#include "tests/places/places.hpp"

namespace impetus::schema_files_test {
namespace {

/// As JSON, ", " and ": " between the parts.
std::string one_line(const OrderedJson& value) {
  if (value.is_primitive()) {
    return value.dump();
  }
  std::string text;
  for (const auto& part : value.items()) {
    text += (text.empty() ? "" : ", ") +
            (value.is_object() ? OrderedJson(part.key()).dump() + ": " : "") +
            one_line(part.value());
  }
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

/// Whether a person reads it more easily on one line.
bool fits_one_line(const OrderedJson& value, std::size_t used) {
  constexpr std::size_t kColumns = 100;
  const bool is_list_of_words = value.is_array() && !value.empty() && value[0].is_primitive();
  return value.is_primitive() || is_list_of_words ||
         (!value.contains("description") && used + one_line(value).size() <= kColumns);
}

std::string in_lines(const OrderedJson& value, const std::string& indent, std::size_t used) {
  if (fits_one_line(value, used)) {
    return one_line(value);
  }
  const std::string inner = indent + "  ";
  std::string text;
  for (const auto& part : value.items()) {
    const std::string key =
        value.is_object() ? OrderedJson(part.key()).dump() + ": " : std::string();
    text += (text.empty() ? "\n" : ",\n") + inner + key +
            in_lines(part.value(), inner, inner.size() + key.size() + 1);
  }
  return (value.is_object() ? "{" : "[") + text + "\n" + indent + (value.is_object() ? "}" : "]");
}

void expect_committed(const OrderedJson& schema, const std::string& name) {
  const std::string path = source_folder() + "/" + name;
  if (std::getenv("IMPETUS_WRITE_SCHEMAS") != nullptr) {
    std::ofstream(path) << in_lines(schema, "", 0) << "\n";
  }
  std::ifstream file(path);
  EXPECT_EQ(nlohmann::json::diff(nlohmann::json::parse(file), nlohmann::json(schema)),
            nlohmann::json::array())
      << name << " differs from the rows; IMPETUS_WRITE_SCHEMAS=1 writes it anew";
}

/// The part of a schema that a reference leads to, or itself.
const OrderedJson& followed(const OrderedJson& root, const OrderedJson& schema) {
  const auto reference = schema.value("$ref", std::string());
  return reference.empty() ? schema : root.at(OrderedJson::json_pointer(reference.substr(1)));
}

/// "> 0 to 90"
std::string range_words(const OrderedJson& schema) {
  std::string words;
  if (schema.contains("exclusiveMinimum")) {
    words = "> " + schema["exclusiveMinimum"].dump();
  } else if (schema.contains("minimum")) {
    words = schema["minimum"].dump();
  }
  return schema.contains("maximum") ? words + " to " + schema["maximum"].dump() : words;
}

/// What a value may be, for a cell of the table.
std::string value_words(const OrderedJson& root, const OrderedJson& part) {
  const OrderedJson& schema = followed(root, part);
  std::string words;
  if (schema.contains("enum")) {
    for (const OrderedJson& option : schema["enum"]) {
      words += (words.empty() ? "" : ", ") + option.get<std::string>();
    }
    return words;
  }
  const auto type = schema.value("type", std::string());
  if (type != "array") {
    return (type == "integer" ? "whole " : "") + range_words(schema) +
           (type == "boolean"  ? "true, false"
            : type == "string" ? "text"
                               : "");
  }
  const int least = schema.value("minItems", 0);
  const std::string count = least > 0 && least == schema.value("maxItems", -1)
                                ? std::to_string(least) + " values"
                                : "list";
  return count + ": " + value_words(root, schema["items"]);
}

/// A row for each setting below `place`, and for what a list of objects has.
std::string table_rows(const OrderedJson& root, const OrderedJson& object, const std::string& place,
                       const std::map<std::string, std::string>& keys) {
  std::string rows;
  for (const auto& [key, part] : object["properties"].items()) {
    const OrderedJson& schema = followed(root, part);
    const bool is_list = schema.contains("items");
    const OrderedJson& below = is_list ? followed(root, schema["items"]) : schema;
    const std::string pointer = place + "/" + key;
    const auto with = keys.find(pointer);
    rows += "| `" + pointer + "` | " +
            (below.contains("properties") ? "" : value_words(root, schema)) + " | " +
            (with == keys.end() ? "" : "`" + with->second + "`") + " | " +
            part.value("description", schema.value("description", std::string())) + " |\n";
    if (below.contains("properties")) {
      rows += table_rows(root, below, pointer + (is_list ? "/*" : ""), keys);
    }
  }
  return rows;
}

/// The page that explains a scene's settings.
std::string settings_page() {
  std::map<std::string, std::string> keys;
  for (const WithKey& each : scene_with_keys()) {
    keys.emplace(each.pointer, each.key);
  }
  const OrderedJson schema = scene_file_schema();
  return "# What a scene may say\n\n" + schema["description"].get<std::string>() +
         "\n\nWritten from the rows of "
         "`experiments/scenes/{scene,appearance_settings,engine_settings}.cpp` by\n"
         "`schema_files_test`, as the schemas beside it are; `*` stands for a place in a list. "
         "The "
         "third column is the key of `impetus replay --with`.\n\n"
         "| setting | values | key | meaning |\n|---|---|---|---|\n" +
         table_rows(schema, schema, "", keys);
}

std::string file_text(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(SchemaFiles, AreWhatTheRowsSay) {
  expect_committed(scene_file_schema(), "stimuli/scene.schema.json");
  expect_committed(figure_file_schema(), "stimuli/figure.schema.json");
  expect_committed(protocol_file_schema(), "protocols/protocol.schema.json");
  expect_committed(observer_file_schema(), "experiments/observers/observer.schema.json");
  expect_committed(series_file_schema(), "protocols/series/series.schema.json");
}

TEST(SchemaFiles, TheTableOfSettingsIsWhatTheRowsSay) {
  const std::string path = source_folder() + "/stimuli/README.md";
  if (std::getenv("IMPETUS_WRITE_SCHEMAS") != nullptr) {
    std::ofstream(path) << settings_page();
  }
  EXPECT_EQ(file_text(path), settings_page()) << "IMPETUS_WRITE_SCHEMAS=1 writes it anew";
}

}  // namespace
}  // namespace impetus::schema_files_test
