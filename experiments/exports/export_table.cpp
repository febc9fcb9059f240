// SPDX-License-Identifier: MIT
#include "experiments/exports/export_table.hpp"

#include <nlohmann/json.hpp>

#include "experiments/exports/embedded_export_tables.hpp"
#include "experiments/exports/row_query.hpp"

namespace impetus::inline exports {
namespace {

constexpr std::string_view kFactors = "{factors} ";

/// What stands in a text between `before` and `after`, from `at` on; moves `at` there.
std::string part_between(const std::string& text, const std::string& before,
                         const std::string& after, std::size_t& at) {
  const std::size_t begin = text.find(before, at) + before.size();
  at = text.find(after, begin);
  return text.substr(begin, at - begin);
}

/// Reads "-- file: what a row is", and the query below it, of each table.
std::vector<ExportTable> read_tables(const std::string& sql) {
  std::vector<ExportTable> tables;
  for (std::size_t at = 0; (at = sql.find("\n\n-- ", at)) != std::string::npos;) {
    ExportTable& table = tables.emplace_back();
    table.file = part_between(sql, "\n-- ", ": ", at);
    table.rows = part_between(sql, ": ", "\n", at);
    table.query = part_between(sql, "\n", ";\n", at);
    std::size_t in_query = 0;
    table.base = part_between(table.query, "\nFROM ", "\n", in_query);
  }
  return tables;
}

using nlohmann::json;

/// What a text is at a pointer; null when it is no JSON or has nothing there. What a study holds
/// is never trusted to be a protocol.
json value_at(const std::string& text, const std::string& pointer) {
  const json value = json::parse(text, nullptr, false);
  const json::json_pointer place(pointer);
  return !value.is_discarded() && value.contains(place) ? value.at(place) : json();
}

void add_labels(const std::string& protocol, FactorLabels& labels) {
  const json factors = value_at(protocol, "/design/factors");
  for (const json& factor : factors.is_array() ? factors : json::array()) {
    const json::json_pointer name("/name");
    const json::json_pointer label("/label");
    if (factor.contains(name) && factor.at(name).is_string() && factor.contains(label) &&
        factor.at(label).is_string()) {
      const auto found = labels.find(factor.at(name).get<std::string>());
      if (found != labels.end() && found->second.empty()) {
        found->second = factor.at(label).get<std::string>();
      }
    }
  }
}

}  // namespace

const std::vector<ExportTable>& export_tables() {
  static const std::vector<ExportTable> kTables = read_tables(kExportTablesSql);
  return kTables;
}

const std::map<std::string, std::string>& computed_meanings() {
  static const std::map<std::string, std::string> kMeanings{
      {"outcome", "completed, not completed (it was shown), or not shown"},
      {"attempts", "how many times the trial was shown"},
      {"rating_time_ms", "from the flip that showed the question to the rating's arrival"},
      {"responses", "how many there are in responses.csv; the first of them follows"},
      {"response_time_ms", "from the flip that showed the question to the answer's arrival"},
      {"clicks", "how many; empty: not completed"},
      {"collisions", "how many; empty: not completed"},
      {"excluded", "1: left out of the analysis, by the last decision"},
      {"exclusion_reasons", "why it is left out; empty: it is not"},
      {"realised_lag_ms",
       "from the flip that showed the contact to the sound's onset; empty: one is not known"},
      {"sent_after_ms",
       "from the event to when the system had taken the marker; empty: not in time"},
      {"stimulus_time_s", "from the flip of the stimulus's first frame; empty: no frame recorded"}};
  return kMeanings;
}

std::string export_query(const ExportTable& table, const std::vector<std::string>& factors) {
  std::string levels;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    std::string name;
    for (const char letter : factors[i]) {
      name += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    levels +=
        "(SELECT CASE type WHEN 'true' THEN 'true' WHEN 'false' THEN 'false' ELSE value END "
        "FROM json_each(trial.condition) WHERE key = ?" +
        std::to_string(i + 1) + ") AS \"factor_" + name + "\", ";
  }
  std::string query = table.query;
  const std::size_t place = query.find(kFactors);
  return place == std::string::npos ? query : query.replace(place, kFactors.size(), levels);
}

FactorLabels factor_labels(SQLite::Database& database) {
  FactorLabels labels;
  RowQuery names(database,
                 "SELECT DISTINCT key FROM trial, json_each(trial.condition) WHERE key IS NOT NULL "
                 "AND json_type(trial.condition) = 'object'");
  while (names.step()) {
    labels[names.text(0)] = "";
  }
  RowQuery protocols(database, "SELECT protocol_json FROM protocol ORDER BY id");
  while (protocols.step()) {
    add_labels(protocols.text(0), labels);
  }
  return labels;
}

}  // namespace impetus::inline exports
