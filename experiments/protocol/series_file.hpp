// A series: several protocols that the same participant goes through in a fixed order.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
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

}  // namespace impetus::inline protocol
