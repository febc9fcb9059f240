// SPDX-License-Identifier: MIT
#include "experiments/exports/protocol_files.hpp"

#include "experiments/exports/output_file.hpp"
#include "experiments/exports/row_query.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline exports {

std::string protocol_stem(std::int64_t id, const std::string& name, const std::string& hash) {
  return "protocols/" + std::to_string(id) + "-" + file_name_text(name) + "-" +
         file_name_text(hash);
}

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

}  // namespace impetus::inline exports
