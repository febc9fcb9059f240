// SPDX-License-Identifier: MIT
#include "experiments/protocol/series_file.hpp"

#include <algorithm>

#include "experiments/settings/input_error.hpp"
#include "experiments/settings/json_document.hpp"
#include "experiments/settings/named_file.hpp"
#include "experiments/settings/schema_sentences.hpp"

namespace impetus::inline protocol {
namespace {

const Kind<Series>& series_kind() {
  const Kind<std::string> name = text();
  const Kind<std::filesystem::path> file{name, name.read};
  static const Kind<Series> kind = object<Series>(
      "", rows_of_file<Series>({required("protocols", &Series::protocols, list(file, {2, 20, true}),
                                         "Files, seen from this one, within the folder above its "
                                         "own; links are followed.")},
                               {required("series", &Series::name, text_like("^[a-z][a-z0-9-]*$"),
                                         "Short and stable; it stands beside every session."),
                                required("title", &Series::title, text())}));
  return kind;
}

/// A series is one person's: a protocol in which nobody takes part has no place in it.
void check_people_take_part(const JsonDocument& series, const std::string& place,
                            const std::filesystem::path& protocol) {
  if (read_json(protocol).value.contains("participants")) {
    refuse(series, place,
           "expected a protocol in which people take part, got " +
               series.value[nlohmann::json::json_pointer(place)].dump() + ", in which nobody does");
  }
}

}  // namespace

OrderedJson series_file_schema() {
  return file_schema("Impetus series",
                     "Protocols that the same participant goes through in this order, in one "
                     "sitting or several.",
                     series_kind());
}

Series load_series(const std::filesystem::path& path) {
  const JsonDocument document = read_json(path);
  if (!document.value.contains("series")) {
    return {"", "", {path}};
  }
  require_schema(document, series_file_schema());
  Series series = series_kind().read(document.value);
  for (std::size_t i = 0; i < series.protocols.size(); ++i) {
    const std::string place = item("/protocols", i);
    series.protocols[i] = named_file(document, path, place, "a protocol's file");
    check_people_take_part(document, place, series.protocols[i]);
  }
  return series;
}

void SeriesNames::take(const std::string& name) {
  if (std::find(taken_.begin(), taken_.end(), name) != taken_.end()) {
    throw InputError(file_ + ":/protocols/" + std::to_string(taken_.size()) +
                     ": expected a protocol of another name, got \"" + name + "\" again");
  }
  taken_.push_back(name);
}

}  // namespace impetus::inline protocol
