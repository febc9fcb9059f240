// What every column of an export means, as data and as a page, from the words of the schema.
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/exports/export_table.hpp"
#include "experiments/exports/row_query.hpp"

namespace impetus::inline exports {

/// "ms" of "delay_ms", "deg/s" of "speed_deg_s"; "" when the name states none.
std::string unit_of(std::string_view column);

/// What is to be known of one column.
struct CodebookColumn {
  std::string name;
  std::string type;     ///< integer, number, text, bits or bytes; "" where rows differ
  std::string unit;     ///< "": none
  std::string meaning;  ///< in words
};

/// One file of an export.
struct CodebookFile {
  std::string name;
  std::string rows;  ///< what one row is
  std::vector<CodebookColumn> columns;
};

/// What an export's texts are about, besides its columns.
struct CodebookHead {
  std::string build;        ///< of the program that exports
  std::string study_build;  ///< of the program that made the study
  bool anonymised{false};
};

/// The columns of a query. `factors` are the labels of the columns
/// "factor_NAME" by name.
std::vector<CodebookColumn> describe_columns(const RowQuery& query,
                                             const std::map<std::string, std::string>& factors);

/// A table of the study, row by row, with what is known of its columns.
struct OpenTable {
  RowQuery rows;
  std::vector<CodebookColumn> columns;
};

/// `factors` are factor_labels(). Throws StoreError.
OpenTable open_table(SQLite::Database& database, const ExportTable& table,
                     const FactorLabels& factors);

/// How cells are to be read, a sentence each.
const std::vector<std::string>& reading_rules();

std::string codebook_json(const CodebookHead& head, const std::vector<CodebookFile>& files);
std::string codebook_page(const CodebookHead& head, const std::vector<CodebookFile>& files);

}  // namespace impetus::inline exports
