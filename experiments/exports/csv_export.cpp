// SPDX-License-Identifier: MIT
#include "experiments/exports/csv_export.hpp"

#include <SQLiteCpp/Database.h>

#include <nlohmann/json.hpp>

#include "experiments/exports/export_table.hpp"
#include "experiments/exports/row_query.hpp"
#include "experiments/exports/whole_output.hpp"
#include "experiments/tables/csv_line.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline exports {
namespace {

// The protocols of a study and their scenes, as files again.

/// "protocols/NAME-HASH": what the files of a protocol are called in an export, before their
/// endings. Letters and digits alone, whatever name and hash hold; `id` keeps such names apart.
std::string protocol_stem(std::int64_t id, const std::string& name, const std::string& hash) {
  return "protocols/" + std::to_string(id) + "-" + file_name_text(name) + "-" +
         file_name_text(hash);
}

/// Writes STEM.protocol.json and STEM.scene.json of each, byte for byte; returns how many files.
/// Throws StoreError.
std::int64_t write_protocol_files(SQLite::Database& database, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "protocols");
  RowQuery query(database,
                 "SELECT id, name, hash, protocol_json, scene_json FROM protocol ORDER BY id");
  std::int64_t files = 0;
  while (query.step()) {
    const std::string stem = protocol_stem(query.integer(0), query.text(1), query.text(2));
    write_output_file(folder / (stem + ".protocol.json"), query.bytes(3));
    write_output_file(folder / (stem + ".scene.json"), query.bytes(4));
    files += 2;
  }
  return files;
}

/// Writes the rows of queries, and counts.
class CsvWriter {
 public:
  explicit CsvWriter(const std::filesystem::path& folder) : folder_(folder) {}

  void write(RowQuery& query, const std::vector<CodebookColumn>& columns, const std::string& name) {
    OutputFile file(folder_ / name);
    std::vector<std::string> names;
    names.reserve(columns.size());
    for (const CodebookColumn& column : columns) {
      names.push_back(column.name);
    }
    file.write(csv_line(names));
    while (query.step()) {
      file.write(row(query, columns));
      ++report_.rows;
    }
    file.close();
    ++report_.files;
  }

  [[nodiscard]] ExportReport& report() { return report_; }

 private:
  std::string row(const RowQuery& query, const std::vector<CodebookColumn>& columns) {
    std::string line;
    for (int i = 0; i < query.columns(); ++i) {
      line += i == 0 ? "" : ",";
      line += cell(query, i, columns[static_cast<std::size_t>(i)].type == "bits");
    }
    return line + "\n";
  }

  std::string cell(const RowQuery& query, int column, bool bits) {
    switch (query.type(column)) {
      case SQLITE_INTEGER:
        return bits ? bits_text(query.integer(column)) : std::to_string(query.integer(column));
      case SQLITE_FLOAT:
        return exact_number(query.number(column));
      case SQLITE_TEXT:
        return text_cell(query.bytes(column));
      case SQLITE_BLOB:
        return bytes_text(query.bytes(column));
      default:
        return "";
    }
  }

  std::string text_cell(std::string_view text) {
    const std::string plain = as_utf8(text);
    report_.mended_texts += plain == text ? 0 : 1;
    report_.formula_like_texts += looks_like_formula(plain) ? 1 : 0;
    return csv_text(plain);
  }

  std::filesystem::path folder_;
  ExportReport report_;
};

CodebookFile write_table(SQLite::Database& database, const ExportTable& table,
                         const FactorLabels& factors, CsvWriter& writer) {
  OpenTable open = open_table(database, table, factors);
  CodebookFile file{table.file + ".csv", table.rows, std::move(open.columns)};
  writer.write(open.rows, file.columns, file.name);
  return file;
}

}  // namespace

ExportReport export_csv(StudyFile& study, const CodebookHead& head,
                        const std::filesystem::path& folder) {
  SQLite::Database& database = study.database();
  const FactorLabels factors = factor_labels(database);
  CsvWriter writer(folder);
  std::vector<CodebookFile> files;
  for (const ExportTable& table : export_tables()) {
    files.push_back(write_table(database, table, factors, writer));
  }
  writer.report().files += write_protocol_files(database, folder);
  write_output_file(folder / "codebook.json", codebook_json(head, files));
  write_output_file(folder / "codebook.md", codebook_page(head, files));
  writer.report().files += 2;
  return writer.report();
}

}  // namespace impetus::inline exports
