// SPDX-License-Identifier: MIT
#include "experiments/protocol/observer_file.hpp"
#include "experiments/protocol/factor_values.hpp"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "experiments/models/readable_file.hpp"
#include "experiments/questions/rating.hpp"

namespace impetus::inline protocol {
namespace {

std::filesystem::path find_observer(const std::string& name,
                                    const std::filesystem::path& protocol) {
  std::error_code ignored;
  if (is_there(name) && !std::filesystem::is_directory(name, ignored)) {
    return name;
  }
  const auto root = std::filesystem::absolute(protocol).parent_path().parent_path();
  auto beside = root / "experiments" / "observers" / (name + ".json");
  if (!is_there(beside)) {
    throw InputError("--observer " + name +
                     ": expected a file, or a name that `impetus observers` lists");
  }
  return beside;
}

ObserverFile observer_from(JsonDocument document) {
  const ObserverKind& kind = named_kind(document);
  auto parameters = kind.read(document);
  return {std::move(document), &kind, std::move(parameters)};
}

/// "restitution, angle_deg"
std::string factor_names(const std::vector<Factor>& factors) {
  std::vector<std::string> names;
  for (const Factor& factor : factors) {
    names.push_back(factor.name);
  }
  return listed(names);
}

/// The factor that the participant goes by is the protocol's, and each of its words is known.
void check_factor(const Protocol& protocol, const ObserverFile& observer) {
  const Attention& attention = observer.parameters->attention;
  if (attention.factor.empty()) {
    return;
  }
  const Factor* factor = find_factor(protocol.design, attention.factor);
  if (factor == nullptr) {
    refuse(observer.document, "/of/factor",
           "expected a factor of " + protocol.document.name + " (" +
               factor_names(protocol.design.factors) + "), got \"" + attention.factor + "\"");
  }
  for (const LevelValue& level : factor->levels) {
    const auto* word = std::get_if<std::string>(&level);
    if (word != nullptr && std::find(attention.levels.begin(), attention.levels.end(), *word) ==
                               attention.levels.end()) {
      refuse(observer.document, "/of/levels",
             "expected all levels of " + factor->name + ", from least to most, got none of \"" +
                 *word + "\"");
    }
  }
}

/// Whether a level of the factor changes what the participant looks at.
bool is_looked_at(const Factor& factor, const Attention& attention) {
  const std::vector<std::string> pointers = overridden_by(factor);
  const auto changes = [&](const std::string& part) {
    return std::any_of(pointers.begin(), pointers.end(), [&](const std::string& pointer) {
      return pointer.find(part) != std::string::npos;
    });
  };
  return factor.name == attention.factor ||
         std::any_of(attention.settings.begin(), attention.settings.end(), changes);
}

}  // namespace

ObserverFile load_observer(const std::string& name_or_path, const std::filesystem::path& protocol) {
  return observer_from(read_json(find_observer(name_or_path, protocol)));
}

std::optional<ObserverFile> without_effect(const ObserverFile& observer,
                                           const std::string& response) {
  const bool by_effect = observer.kind->effect_is_of_all || response == "rating";
  const std::string name = by_effect ? "effect" : "miss_rate";
  JsonDocument document = observer.document;
  auto& parameters = document.value["parameters"];
  if (observer.kind->effect_is_of_all) {
    parameters["effect"] = {{"unit", "share"}, {"source", "none, for studies without an effect"}};
  } else if ((!by_effect && response != "clicks") || !parameters.contains(name)) {
    return std::nullopt;
  }
  parameters[name]["value"] = by_effect ? 0.0 : 1.0;
  document.text = document.value.dump();
  return observer_from(std::move(document));
}

const Attention& attention_of(const ObserverFile& observer) {
  const Attention& own = observer.parameters->attention;
  return own.words.empty() ? observer.kind->attention : own;
}

void require_fittable(const ObserverFile& observer) {
  if (observer.kind->answers.percept == nullptr) {
    auto fitted = observer_kinds();
    std::erase_if(fitted, [](const ObserverKind& kind) { return kind.answers.percept == nullptr; });
    const std::string names = listed(fitted, [](const ObserverKind& kind) { return kind.name; });
    refuse(observer.document, "/observer",
           "expected a kind that can be fitted (" + names + "), got " + observer.kind->name);
  }
}

void check_observer(const Protocol& protocol, const ObserverFile& observer) {
  check_factor(protocol, observer);
  const RatingScale* scale = find_scale(protocol.script);
  const auto points = static_cast<std::int64_t>(observer.parameters->points());
  if (scale != nullptr && !observer.kind->has_own_scale && scale->points() != points) {
    refuse(protocol.document, "/rating",
           "expected a scale of " + std::to_string(points) +
               " points, as the simulated participant rates (one more than its file has cuts), "
               "got " +
               std::to_string(scale->points()) + ", from " + std::to_string(scale->minimum) +
               " to " + std::to_string(scale->maximum));
  }
  const std::string& name = observer.kind->name;
  if (takes_clicks(protocol.script) && !observer.kind->clicks) {
    refuse(protocol.document, "/clicks",
           "expected none for the simulated participant " + name + ", which does not click");
  }
  if (protocol.script.gaze && !observer.kind->has_eye) {
    refuse(protocol.document, "/gaze",
           "expected none for the simulated participant " + name + ", which has no eye");
  }
}

std::string unseen_factors(const Protocol& protocol, const ObserverFile& observer) {
  const Attention& attention = attention_of(observer);
  std::vector<Factor> vary = protocol.design.factors;
  vary.erase(std::remove_if(vary.begin(), vary.end(),
                            [](const Factor& factor) { return factor.levels.size() < 2; }),
             vary.end());
  const bool seen = std::any_of(vary.begin(), vary.end(), [&](const Factor& factor) {
    return is_looked_at(factor, attention);
  });
  if (vary.empty() || seen) {
    return "";
  }
  return "the simulated participant " + observer.document.name + " looks at " + attention.words +
         ", which no factor that varies changes (" + factor_names(vary) +
         "): its answers will not depend on them";
}

}  // namespace impetus::inline protocol
