// The factors of a study's conditions, and how its protocols label them.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <map>
#include <string>

namespace impetus::inline exports {

/// Label by name; "" where no protocol has one.
using FactorLabels = std::map<std::string, std::string>;

/// Of all trials of the study. Throws StoreError.
FactorLabels factor_labels(SQLite::Database& database);

}  // namespace impetus::inline exports
