// SPDX-License-Identifier: MIT
#include "experiments/protocol/observer_file.hpp"

#include <utility>

#include "experiments/protocol/validation.hpp"

namespace impetus {
namespace {

using nlohmann::json;

struct ParameterName {
  const char* name;
  double minimum;
};

constexpr double kAny = -1e9;
constexpr ParameterName kParameters[] = {{"baseline", kAny},
                                         {"delay_effect", kAny},
                                         {"threshold_mean_ms", kAny},
                                         {"threshold_sd_ms", 0.0},
                                         {"threshold_width_ms", 1e-3},
                                         {"intercept_sd", 0.0},
                                         {"cut_1_2", kAny},
                                         {"cut_2_3", kAny},
                                         {"lapse_rate", 0.0},
                                         {"reaction_median_ms", 1.0},
                                         {"reaction_sigma_log", 0.0}};

json observer_schema() {
  json parameters{{"type", "object"}, {"additionalProperties", false}};
  for (const auto& [name, minimum] : kParameters) {
    parameters["required"].push_back(name);
    parameters["properties"][name] =
        json{{"type", "object"},
             {"additionalProperties", false},
             {"required", {"value", "unit", "source"}},
             {"properties",
              {{"value", {{"type", "number"}, {"minimum", minimum}, {"maximum", 1e9}}},
               {"unit", {{"type", "string"}}},
               {"source", {{"type", "string"}, {"minLength", 1}}}}}};
  }
  parameters["properties"]["lapse_rate"]["properties"]["value"]["maximum"] = 1;
  return {{"type", "object"},
          {"additionalProperties", false},
          {"required", {"schema_version", "observer", "parameters"}},
          {"properties",
           {{"schema_version", {{"const", 1}}},
            {"observer", {{"const", "causality"}}},
            {"note", {{"type", "string"}}},
            {"parameters", parameters}}}};
}

CausalityParameters parameters_from(const json& object) {
  const auto value = [&](const char* name) { return object[name]["value"].get<double>(); };
  CausalityParameters parameters;
  parameters.baseline = value("baseline");
  parameters.delay_effect = value("delay_effect");
  parameters.threshold_mean_ms = value("threshold_mean_ms");
  parameters.threshold_sd_ms = value("threshold_sd_ms");
  parameters.threshold_width_ms = value("threshold_width_ms");
  parameters.intercept_sd = value("intercept_sd");
  parameters.cuts = {value("cut_1_2"), value("cut_2_3")};
  parameters.lapse_rate = value("lapse_rate");
  parameters.reaction_median_ms = value("reaction_median_ms");
  parameters.reaction_sigma_log = value("reaction_sigma_log");
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
  if (const auto problem = find_schema_problem(observer_schema(), file.document.value)) {
    refuse(file.document, problem->pointer, problem->message);
  }
  file.parameters = parameters_from(file.document.value["parameters"]);
  if (file.parameters.cuts[0] >= file.parameters.cuts[1]) {
    refuse(file.document, "/parameters/cut_2_3/value",
           "expected more than cut_1_2, got " +
               file.document.value["parameters"]["cut_2_3"]["value"].dump());
  }
  return file;
}

}  // namespace impetus
