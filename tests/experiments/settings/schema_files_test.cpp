// The committed schemas are what the rows of settings say (settings/setting_rows.hpp). Whoever
// changes a row runs this with IMPETUS_WRITE_SCHEMAS=1, which writes the files anew.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "experiments/scenes/scene.hpp"
#include "tests/places/places.hpp"

namespace impetus::schema_files_test {
namespace {

/// As JSON on one line where it fits in a hundred columns, else a line for each part.
std::string in_lines(const OrderedJson& value, const std::string& indent, std::size_t used) {
  constexpr std::size_t kColumns = 100;
  const auto is_short = [](const OrderedJson& any) { return any.dump().size() < kColumns / 2; };
  std::string line = value.dump(-1, ' ', false);
  const bool is_text = value.is_primitive();
  if (is_text || (value.is_array() && line.size() + used < kColumns) ||
      (value.is_object() && !value.contains("description") && is_short(value) &&
       line.size() + used < kColumns)) {
    return line;
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

TEST(SchemaFiles, AreWhatTheRowsSay) {
  expect_committed(scene_file_schema(), "stimuli/scene.schema.json");
  expect_committed(figure_file_schema(), "stimuli/figure.schema.json");
}

}  // namespace
}  // namespace impetus::schema_files_test
