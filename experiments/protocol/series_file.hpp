// A series: several protocols that the same participant goes through in a fixed order.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "experiments/settings/setting_rows.hpp"

namespace impetus::inline protocol {

/// Protocols that one participant runs one after the other.
struct Series {
  std::string name;  ///< "": a single protocol
  std::string title;
  std::vector<std::filesystem::path> protocols;  ///< files that exist; their content is unchecked
};

/// The JSON Schema of a series: protocols/series/series.schema.json, as an output of its rows.
OrderedJson series_file_schema();

/// The series in the file, or one of a single protocol when the file is that. Throws InputError
/// with one sentence, "file:/pointer: expected ..., got ...".
Series load_series(const std::filesystem::path& path);

/// The names of a series' protocols, which differ: a study tells them apart by them.
class SeriesNames {
 public:
  explicit SeriesNames(std::string file) : file_(std::move(file)) {}
  /// The next one's. Throws InputError where an earlier one has it.
  void take(const std::string& name);

 private:
  std::string file_;
  std::vector<std::string> taken_;
};

}  // namespace impetus::inline protocol
