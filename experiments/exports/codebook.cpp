// SPDX-License-Identifier: MIT
#include "experiments/exports/codebook.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/exports/export_table.hpp"
#include "experiments/store/schema_words.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline exports {
namespace {

/// How a column's name ends, and the unit that this says.
struct Suffix {
  std::string_view ending;
  const char* unit;
};

/// The longer ones before those that they end with.
constexpr std::array<Suffix, 14> kSuffixes{{{"_rad_s", "rad/s"},
                                            {"_deg_s", "deg/s"},
                                            {"_m_s", "m/s"},
                                            {"_arcmin", "arcmin"},
                                            {"_deg", "deg"},
                                            {"_Ns", "N s"},
                                            {"_ms", "ms"},
                                            {"_ns", "ns"},
                                            {"_hz", "Hz"},
                                            {"_px", "px"},
                                            {"_s", "s"},
                                            {"_m", "m"},
                                            {"_utc", "ISO 8601, UTC"},
                                            {"_share", "share, 0 to 1"}}};

using nlohmann::ordered_json;

constexpr std::string_view kFactor = "factor_";

/// The file of an export whose rows are those of a table.
std::string file_of(const std::string& table) {
  for (const ExportTable& each : export_tables()) {
    if (each.base == table) {
      return each.file + ".csv";
    }
  }
  return table;
}

std::string meaning_of(const std::string& column, const ColumnWords& words) {
  if (!words.meaning.empty()) {
    return words.meaning;
  }
  if (!words.refers_to.empty()) {
    return "`id` of the row in " + file_of(words.refers_to);
  }
  return column == "id" ? "number of the row, by which other files refer to it" : "";
}

/// Of a column of the study that holds 64 bits, read as a number by nothing.
bool holds_bits(const std::string& column, const std::string& type) {
  return type == "INTEGER" && (column == "seed" || column == "hash");
}

std::string type_of(const std::string& column, const std::string& type) {
  if (holds_bits(column, type)) {
    return "bits";
  }
  static const std::map<std::string, std::string> kTypes{
      {"INTEGER", "integer"}, {"REAL", "number"}, {"TEXT", "text"}, {"BLOB", "bytes"}};
  const auto known = kTypes.find(type);
  return known == kTypes.end() ? "" : known->second;
}

/// The words of the study's column that a column of the query is; null when it is computed.
const ColumnWords* words_of(const ColumnOrigin& origin) {
  const auto found = schema_words().find(origin.table);
  if (found == schema_words().end()) {
    return nullptr;
  }
  const auto words = found->second.find(origin.column);
  return words == found->second.end() ? nullptr : &words->second;
}

CodebookColumn describe(const RowQuery& query, int index,
                        const std::map<std::string, std::string>& factors) {
  CodebookColumn column;
  column.name = query.name(index);
  column.unit = unit_of(column.name);
  const ColumnOrigin origin = query.origin(index);
  const ColumnWords* words = words_of(origin);
  if (words != nullptr) {
    column.type = type_of(origin.column, words->type);
    column.meaning = meaning_of(origin.column, *words);
    return column;
  }
  const auto computed = computed_meanings().find(column.name);
  if (computed != computed_meanings().end()) {
    column.meaning = computed->second;
    column.type = column.unit.empty() ? "" : "number";
  } else if (column.name.starts_with(kFactor)) {
    const auto label = factors.find(column.name.substr(kFactor.size()));
    column.meaning = "level of this factor of the condition" +
                     (label == factors.end() ? "" : ": " + label->second);
  }
  return column;
}

std::string about(const CodebookHead& head) {
  return "Exported by " + head.build + " from a study made by " + head.study_build + ".";
}

std::string anonymised_words() {
  return "Anonymised: codes of participants are new, demographic answers, free text and names of "
         "machines are left out, dates are days since the first.";
}

}  // namespace

std::string unit_of(std::string_view column) {
  for (const Suffix& suffix : kSuffixes) {
    if (column.ends_with(suffix.ending)) {
      return suffix.unit;
    }
  }
  return "";
}

std::vector<CodebookColumn> describe_columns(const RowQuery& query,
                                             const std::map<std::string, std::string>& factors) {
  std::vector<CodebookColumn> columns;
  columns.reserve(static_cast<std::size_t>(query.columns()));
  for (int i = 0; i < query.columns(); ++i) {
    columns.push_back(describe(query, i, factors));
  }
  return columns;
}

OpenTable open_table(SQLite::Database& database, const ExportTable& table,
                     const FactorLabels& factors) {
  const FactorLabels own = table.base == "trial" ? factors : FactorLabels();
  std::vector<std::string> names;
  for (const auto& [name, label] : own) {
    names.push_back(name);
  }
  RowQuery rows(database, export_query(table, names), names);
  std::vector<CodebookColumn> columns = describe_columns(rows, own);
  return {std::move(rows), std::move(columns)};
}

const std::vector<std::string>& reading_rules() {
  static const std::vector<std::string> kRules{
      ("Comma-separated values (RFC 4180) in UTF-8; lines end with a line feed, names stand in the "
       "first line."),
      ("An empty cell is a value that is missing (NULL); two quotes with nothing between are a "
       "text that is empty. Every text is in quotes."),
      "Numbers have as many digits as it takes to read back the same double.",
      ("Seeds, hashes and bytes are the letter x and hexadecimal digits: of a seed or a hash the "
       "64 bits, which a number of most programs would round."),
      ("Times in ns are of a clock that only ever goes forward, alike within a session and never "
       "to be compared between sessions."),
      "Lengths on the screen are from its centre, x to the right and y upwards.",
      ("A text that begins with = + - or @ is what somebody typed, and data: import columns of "
       "text as text where a program would take it for a formula.")};
  return kRules;
}

std::string codebook_json(const CodebookHead& head, const std::vector<CodebookFile>& files) {
  ordered_json book;
  book["about"] = about(head);
  book["anonymised"] = head.anonymised;
  book["reading"] = reading_rules();
  book["files"] = ordered_json::object();
  for (const CodebookFile& file : files) {
    ordered_json columns = ordered_json::object();
    for (const CodebookColumn& column : file.columns) {
      ordered_json words{{"meaning", column.meaning}};
      if (!column.type.empty()) {
        words["type"] = column.type;
      }
      if (!column.unit.empty()) {
        words["unit"] = column.unit;
      }
      columns[column.name] = words;
    }
    book["files"][file.name] = {{"rows", file.rows}, {"columns", columns}};
  }
  return book.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string codebook_page(const CodebookHead& head, const std::vector<CodebookFile>& files) {
  std::string page = "# Codebook\n\n" + markdown_text(about(head)) + "\n";
  if (head.anonymised) {
    page += "\n" + anonymised_words() + "\n";
  }
  page += "\n## How to read the files\n\n";
  for (const std::string& rule : reading_rules()) {
    page += "- " + rule + "\n";
  }
  for (const CodebookFile& file : files) {
    page += "\n## " + markdown_text(file.name) + "\n\n" + file.rows +
            ".\n\n| column | meaning | type | unit |\n|---|---|---|---|\n";
    for (const CodebookColumn& column : file.columns) {
      page += "| " + markdown_text(column.name) + " | " + markdown_text(column.meaning) + " | " +
              column.type + " | " + column.unit + " |\n";
    }
  }
  return page;
}

}  // namespace impetus::inline exports
