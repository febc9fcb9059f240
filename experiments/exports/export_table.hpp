// The tables of an export: each holds all columns of one table of the study, after a few that say
// whose they are.
//
//   participant, protocol, slot, ...  |  all columns of `collision`  |  measured gaps
//          who, which                              base                    more
//
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <map>
#include <string>
#include <vector>

namespace impetus::inline exports {

/// One file of an export, and the query that fills it.
struct ExportTable {
  std::string file;     ///< without ".csv"
  std::string base;     ///< the study's table whose rows these are
  std::string rows;     ///< what one row is, in words
  std::string context;  ///< SQL: columns before the base's
  std::string more;     ///< SQL: columns after them
  std::string joins;    ///< SQL, after FROM base; outer ones, so that no row is lost
  std::string order;    ///< SQL
  std::string columns;  ///< SQL: those of the base; "": all of them
};

/// In the order of the codebook.
const std::vector<ExportTable>& export_tables();

/// What the columns mean that are no column of the study, by name.
const std::map<std::string, std::string>& computed_meanings();

/// The query of a table; `factors` are factor names in the order of its parameters ?1, ?2, ...:
/// each becomes a column "factor_NAME". Only trials have factors.
std::string export_query(const ExportTable& table, const std::vector<std::string>& factors);

/// The factors of a study's conditions: label by name; "" where no protocol has one.
using FactorLabels = std::map<std::string, std::string>;

/// Of all trials of the study. Throws StoreError.
FactorLabels factor_labels(SQLite::Database& database);

}  // namespace impetus::inline exports
