// Names of BIDS: labels of letters and digits alone, for what may be called anything.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace impetus::inline exports {

/// Gives each name a label of its own: the name without all but ASCII letters and digits. Where
/// that is nothing, or was given already, capitals apart, a number follows.
class BidsLabels {
 public:
  std::string label_for(std::string_view name);

 private:
  std::set<std::string> given_;  ///< in small letters: many file systems know no others
};

/// By the rows' `id`, in the order of ids.
struct BidsNames {
  std::map<std::int64_t, std::string> participants;  ///< "P01" of sub-P01
  std::map<std::int64_t, std::string> tasks;         ///< "gapthresholds" of task-gapthresholds
};

/// Throws StoreError.
BidsNames bids_names(SQLite::Database& database);

}  // namespace impetus::inline exports
