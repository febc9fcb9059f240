// What the study's schema says of its columns, read from the comments of schema.sql.
//
//   -- what holds for the columns below that say nothing
//   column TYPE ...,           -- what it is
//                              -- and more of the same
//
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace impetus::inline store {

/// What the schema says of one column.
struct ColumnWords {
  std::string type;       ///< INTEGER, REAL, TEXT or BLOB
  std::string meaning;    ///< "" when the schema says nothing
  std::string refers_to;  ///< table whose `id` it holds; "" when it holds none
  bool may_be_null{true};
};

/// By table, then by column.
using SchemaWords = std::map<std::string, std::map<std::string, ColumnWords>>;

/// Of this build's schema.
const SchemaWords& schema_words();

/// Of any schema that is written like the study's: a column or several to a line.
SchemaWords read_schema_words(std::string_view sql);

}  // namespace impetus::inline store
