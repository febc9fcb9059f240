// SPDX-License-Identifier: MIT
#include "experiments/protocol/series_file.hpp"

#include "experiments/protocol/checks/participant_checks.hpp"
#include "experiments/protocol/embedded_series_schema.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/settings/named_file.hpp"
#include "experiments/settings/schema_check.hpp"

namespace impetus::inline protocol {

using nlohmann::json;

namespace {

/// A series is one person's: a protocol in which nobody takes part has no place in it.
void check_people_take_part(const JsonDocument& series, std::size_t place,
                            const std::filesystem::path& protocol) {
  if (!has_participants(read_json(protocol).value)) {
    refuse(series, "/protocols/" + std::to_string(place),
           "expected a protocol in which people take part, got \"" +
               series.value["protocols"][place].get<std::string>() + "\", in which nobody does");
  }
}

}  // namespace

Series load_series(const std::filesystem::path& path) {
  const JsonDocument document = read_json(path);
  if (!document.value.is_object() || !document.value.contains("series")) {
    return {"", "", {path}};
  }
  if (const auto problem = find_schema_problem(json::parse(kSeriesSchemaText), document.value)) {
    refuse(document, problem->pointer, problem->message);
  }
  Series series{
      document.value["series"].get<std::string>(), document.value["title"].get<std::string>(), {}};
  const json& files = document.value["protocols"];
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::filesystem::path file =
        named_file(document, path, "/protocols/" + std::to_string(i), "a protocol's file");
    check_people_take_part(document, i, file);
    series.protocols.push_back(file);
  }
  return series;
}

}  // namespace impetus::inline protocol
