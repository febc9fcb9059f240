// SPDX-License-Identifier: MIT
#include "experiments/exports/earlier_export.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <string>

#include "experiments/exports/own_files.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline exports {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Null where there is none, or no JSON.
json json_in(const fs::path& file) {
  std::ifstream stream(file);
  const json value = json::parse(stream, nullptr, false);
  return value.is_discarded() ? json() : value;
}

/// What is at a pointer; null where nothing is.
json part_of(const json& value, const char* pointer) {
  const json::json_pointer place(pointer);
  return value.contains(place) ? value.at(place) : json();
}

std::optional<OwnName> own_names_of_csv(const fs::path& folder) {
  static const std::regex kProtocol(
      R"(protocols/([0-9]+-[A-Za-z0-9-]*-[0-9a-f]{32}\.(protocol|scene)\.json)?)");
  const json book = json_in(folder / "codebook.json");
  const json about = part_of(book, "/about");
  const json tables = part_of(book, "/files");
  if (!about.is_string() || !about.get<std::string>().starts_with("Exported by ") ||
      !tables.is_object()) {
    return std::nullopt;
  }
  return [tables](const std::string& name) {
    return tables.contains(name) || name == "codebook.json" || name == "codebook.md" ||
           std::regex_match(name, kProtocol);
  };
}

std::optional<OwnName> own_names_of_bids(const fs::path& folder) {
  static const std::regex kBids(
      R"(dataset_description\.json|README|participants\.(tsv|json)|)"
      R"(stimuli/[A-Za-z0-9]+_(protocol|scene)\.json|)"
      R"((sub-[A-Za-z0-9]+)/(ses-[0-9]{2,})/beh/\3_\4_task-[A-Za-z0-9]+_)"
      R"(((events|beh)\.(tsv|json)|recording-eye1_physio\.(tsv\.gz|json)))");
  const json description = json_in(folder / "dataset_description.json");
  if (part_of(description, "/GeneratedBy/0/Name") != "Impetus") {
    return std::nullopt;
  }
  const json listed = part_of(description, "/GeneratedBy/0/Files");
  if (!listed.is_array()) {
    return [](const std::string& name) { return std::regex_match(name, kBids); };
  }
  const std::set<json> files(listed.begin(), listed.end());
  return [files](const std::string& name) { return files.count(name) > 0; };
}

}  // namespace

void require_earlier_export(const fs::path& folder) {
  const std::string expected = folder.string() + ": expected an earlier export to overwrite, got ";
  const std::optional<OwnName> csv = own_names_of_csv(folder);
  const std::optional<OwnName> own = csv ? csv : own_names_of_bids(folder);
  if (!own) {
    throw InputError(expected + "a folder of other files, which --force leaves alone");
  }
  if (const std::string foreign = foreign_name(folder, *own); !foreign.empty()) {
    throw InputError(expected + "one that also holds " + foreign + ", which no export wrote");
  }
}

}  // namespace impetus::inline exports
