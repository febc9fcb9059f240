// SPDX-License-Identifier: MIT
#include "experiments/protocol/observer_file.hpp"

#include <utility>
#include <vector>

#include "experiments/protocol/validation.hpp"

namespace impetus {
namespace {

using nlohmann::json;

/// One number of the file and where it goes.
template <typename Parameters>
struct ParameterEntry {
  const char* name;
  double minimum;
  double maximum;
  double Parameters::*place;
};

constexpr double kAny = 1e9;

template <typename Parameters>
std::vector<ParameterEntry<Parameters>> with_rating(
    std::vector<ParameterEntry<Parameters>> entries) {
  const std::vector<ParameterEntry<Parameters>> rating{
      {"baseline", -kAny, kAny, &Parameters::baseline},
      {"effect", -kAny, kAny, &Parameters::effect},
      {"effect_sd", 0.0, kAny, &Parameters::effect_sd},
      {"intercept_sd", 0.0, kAny, &Parameters::intercept_sd},
      {"cut_1_2", -kAny, kAny, &Parameters::cut_1_2},
      {"cut_2_3", -kAny, kAny, &Parameters::cut_2_3},
      {"lapse_rate", 0.0, 1.0, &Parameters::lapse_rate},
      {"reaction_median_ms", 1.0, kAny, &Parameters::reaction_median_ms},
      {"reaction_sigma_log", 0.0, kAny, &Parameters::reaction_sigma_log}};
  entries.insert(entries.end(), rating.begin(), rating.end());
  return entries;
}

std::vector<ParameterEntry<CausalityParameters>> entries_of(const CausalityParameters& /*kind*/) {
  using P = CausalityParameters;
  return with_rating<P>({{"threshold_mean_ms", -kAny, kAny, &P::threshold_mean_ms},
                         {"threshold_sd_ms", 0.0, kAny, &P::threshold_sd_ms},
                         {"threshold_width_ms", 1e-3, kAny, &P::threshold_width_ms}});
}

std::vector<ParameterEntry<GapParameters>> entries_of(const GapParameters& /*kind*/) {
  using P = GapParameters;
  return with_rating<P>({{"threshold_arcmin", 1e-3, kAny, &P::threshold_arcmin},
                         {"width_log10", 1e-3, kAny, &P::width_log10},
                         {"guess_rate", 0.0, 1.0, &P::guess_rate},
                         {"miss_rate", 0.0, 1.0, &P::miss_rate}});
}

json kind_schema() {
  return {{"type", "object"},
          {"required", {"observer"}},
          {"properties", {{"observer", {{"enum", {"causality", "gap"}}}}}}};
}

template <typename Parameters>
json observer_schema(const std::vector<ParameterEntry<Parameters>>& entries) {
  json parameters{{"type", "object"}, {"additionalProperties", false}};
  for (const auto& entry : entries) {
    parameters["required"].push_back(entry.name);
    parameters["properties"][entry.name] = json{
        {"type", "object"},
        {"additionalProperties", false},
        {"required", {"value", "unit", "source"}},
        {"properties",
         {{"value", {{"type", "number"}, {"minimum", entry.minimum}, {"maximum", entry.maximum}}},
          {"unit", {{"type", "string"}}},
          {"source", {{"type", "string"}, {"minLength", 1}}}}}};
  }
  return {{"type", "object"},
          {"additionalProperties", false},
          {"required", {"schema_version", "observer", "parameters"}},
          {"properties",
           {{"schema_version", {{"const", 1}}},
            {"observer", {{"type", "string"}}},
            {"note", {{"type", "string"}}},
            {"parameters", parameters}}}};
}

void require_schema(const JsonDocument& document, const json& schema) {
  if (const auto problem = find_schema_problem(schema, document.value)) {
    refuse(document, problem->pointer, problem->message);
  }
}

template <typename Parameters>
Parameters parameters_from(const JsonDocument& document) {
  Parameters parameters;
  const auto entries = entries_of(parameters);
  require_schema(document, observer_schema(entries));
  for (const auto& entry : entries) {
    parameters.*entry.place =
        document.value["parameters"][entry.name]["value"].template get<double>();
  }
  if (parameters.cut_1_2 >= parameters.cut_2_3) {
    refuse(document, "/parameters/cut_2_3/value",
           "expected more than cut_1_2, got " +
               document.value["parameters"]["cut_2_3"]["value"].dump());
  }
  return parameters;
}

std::filesystem::path find_observer(const std::string& name,
                                    const std::filesystem::path& protocol) {
  if (std::filesystem::exists(name)) {
    return name;
  }
  const auto root = std::filesystem::absolute(protocol).parent_path().parent_path();
  auto beside = root / "experiments" / "observers" / (name + ".json");
  if (!std::filesystem::exists(beside)) {
    throw InputError("--observer " + name + ": expected a file, or the name of one in " +
                     beside.parent_path().string());
  }
  return beside;
}

}  // namespace

ObserverFile load_observer(const std::string& name_or_path, const std::filesystem::path& protocol) {
  ObserverFile file{read_json(find_observer(name_or_path, protocol)), {}};
  require_schema(file.document, kind_schema());
  if (file.document.value["observer"].get<std::string>() == "gap") {
    file.parameters = parameters_from<GapParameters>(file.document);
  } else {
    file.parameters = parameters_from<CausalityParameters>(file.document);
  }
  return file;
}

std::unique_ptr<RatingObserver> make_observer(const ObserverFile& file, std::uint64_t seed,
                                              const std::string& pseudonym, VirtualClock& clock) {
  if (const auto* gap = std::get_if<GapParameters>(&file.parameters)) {
    return std::make_unique<GapObserver>(*gap, seed, pseudonym, clock);
  }
  return std::make_unique<CausalityObserver>(std::get<CausalityParameters>(file.parameters), seed,
                                             pseudonym, clock);
}

}  // namespace impetus
