// SPDX-License-Identifier: MIT
#include "experiments/store/schema_words.hpp"

#include <regex>
#include <sstream>
#include <vector>

#include "experiments/store/embedded_schema.hpp"

namespace impetus::inline store {
namespace {

constexpr std::size_t kIndentOfColumns = 2;

/// The parts of a line of SQL between the commas that stand in no parentheses.
std::vector<std::string> parts_of(const std::string& code) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char letter : code) {
    depth += letter == '(' ? 1 : letter == ')' ? -1 : 0;
    if (letter == ',' && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  return parts;
}

std::string joined(const std::string& first, const std::string& second, const char* between) {
  return first.empty() || second.empty() ? first + second : first + between + second;
}

/// Reads one line after another.
class SchemaReader {
 public:
  void read(const std::string& line) {
    static const std::regex begins(R"(CREATE TABLE (\w+) \()");
    std::smatch match;
    if (std::regex_search(line, match, begins)) {
      table_ = match[1];
      above_.clear();
      latest_.clear();
    } else if (line.starts_with(")")) {
      table_.clear();
    } else if (!table_.empty()) {
      read_inside(line);
    }
  }

  [[nodiscard]] SchemaWords words() const { return words_; }

 private:
  void read_inside(const std::string& line) {
    const std::size_t dashes = line.find("--");
    const std::string code = line.substr(0, dashes);
    const std::string comment =
        dashes == std::string::npos ? "" : line.substr(std::min(dashes + 3, line.size()));
    if (code.find_first_not_of(' ') != std::string::npos) {
      read_columns(code, comment);
    } else if (code.size() > kIndentOfColumns) {
      for (const std::string& column : latest_) {
        std::string& meaning = words_[table_][column].meaning;
        meaning = joined(meaning, comment, " ");
      }
    } else {
      above_ = above_is_used_ ? comment : joined(above_, comment, " ");
      above_is_used_ = false;
    }
  }

  void read_columns(const std::string& code, const std::string& comment) {
    static const std::regex column(R"(^\s*(\w+) (INTEGER|REAL|TEXT|BLOB)\b(.*)$)");
    static const std::regex reference(R"(REFERENCES (\w+))");
    if (!comment.empty() && above_is_used_) {
      above_.clear();
    }
    latest_.clear();
    for (const std::string& part : parts_of(code)) {
      std::smatch match;
      if (!std::regex_match(part, match, column)) {
        continue;
      }
      const std::string rest = match[3];
      const bool may_be_null = rest.find("NOT NULL") == std::string::npos &&
                               rest.find("PRIMARY KEY") == std::string::npos;
      ColumnWords words{match[2], joined(comment, above_, "; "), "", may_be_null};
      std::smatch target;
      if (std::regex_search(rest, target, reference)) {
        words.refers_to = target[1];
      }
      latest_.push_back(match[1]);
      words_[table_][match[1]] = words;
    }
    above_is_used_ = true;
    if (!comment.empty()) {
      above_.clear();
    }
  }

  SchemaWords words_;
  std::string table_;
  std::string above_;
  bool above_is_used_{false};
  std::vector<std::string> latest_;  ///< columns of the line before
};

}  // namespace

SchemaWords read_schema_words(std::string_view sql) {
  std::istringstream lines{std::string(sql)};
  SchemaReader reader;
  for (std::string line; std::getline(lines, line);) {
    reader.read(line);
  }
  return reader.words();
}

const SchemaWords& schema_words() {
  static const SchemaWords kWords = read_schema_words(kStudySchemaSql);
  return kWords;
}

}  // namespace impetus::inline store
