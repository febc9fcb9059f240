// Values that a row may lack: what is not there stays NULL.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Statement.h>

#include <optional>

namespace impetus::inline store {

inline void bind_or_null(SQLite::Statement& statement, int index,
                         const std::optional<double>& value) {
  if (value) {
    statement.bind(index, *value);
  }
}

inline void bind_or_null(SQLite::Statement& statement, int index,
                         const std::optional<bool>& value) {
  if (value) {
    statement.bind(index, *value ? 1 : 0);
  }
}

}  // namespace impetus::inline store
