// The tables of an export, and the factors of a study that become columns of its trials. The
// queries stand in export_tables.sql.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <map>
#include <string>
#include <vector>

namespace impetus::inline exports {

/// One file of an export, and the query that fills it.
struct ExportTable {
  std::string file;  ///< without ".csv"
  std::string base;  ///< the study's table whose rows these are
  std::string rows;  ///< what one row is, in words
  std::string query;
};

/// In the order of the codebook.
const std::vector<ExportTable>& export_tables();

/// What the columns mean that are no column of the study, by name.
const std::map<std::string, std::string>& computed_meanings();

/// The query of a table with its factors, whose names are its parameters ?1, ?2, ... in this order:
/// each becomes a column "factor_NAME". Only trials have factors.
std::string export_query(const ExportTable& table, const std::vector<std::string>& factors);

/// The factors of a study's conditions: label by name; "" where no protocol has one.
using FactorLabels = std::map<std::string, std::string>;

/// Of all trials of the study. Throws StoreError.
FactorLabels factor_labels(SQLite::Database& database);

}  // namespace impetus::inline exports
