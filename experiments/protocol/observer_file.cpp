// SPDX-License-Identifier: MIT
#include "experiments/protocol/observer_file.hpp"

#include <utility>

#include "experiments/models/readable_file.hpp"
#include "experiments/questions/rating.hpp"

namespace impetus::inline protocol {
namespace {

std::filesystem::path find_observer(const std::string& name,
                                    const std::filesystem::path& protocol) {
  if (is_there(name)) {
    return name;
  }
  const auto root = std::filesystem::absolute(protocol).parent_path().parent_path();
  auto beside = root / "experiments" / "observers" / (name + ".json");
  if (!is_there(beside)) {
    throw InputError("--observer " + name + ": expected a file, or the name of one in " +
                     beside.parent_path().string());
  }
  return beside;
}

ObserverFile observer_from(JsonDocument document) {
  const ObserverKind& kind = named_kind(document);
  auto parameters = kind.read(document);
  return {std::move(document), &kind, std::move(parameters)};
}

}  // namespace

ObserverFile load_observer(const std::string& name_or_path, const std::filesystem::path& protocol) {
  return observer_from(read_json(find_observer(name_or_path, protocol)));
}

std::optional<ObserverFile> without_effect(const ObserverFile& observer,
                                           const std::string& response) {
  const bool rated = response == "rating";
  const std::string name = rated ? "effect" : "miss_rate";
  JsonDocument document = observer.document;
  if ((!rated && response != "clicks") || !document.value["parameters"].contains(name)) {
    return std::nullopt;
  }
  document.value["parameters"][name]["value"] = rated ? 0.0 : 1.0;
  document.text = document.value.dump();
  return observer_from(std::move(document));
}

void check_observer(const Protocol& protocol, const ObserverFile& observer) {
  const RatingScale* scale = find_scale(protocol.script);
  const auto points = static_cast<std::int64_t>(observer.parameters->points());
  if (scale != nullptr && scale->points() != points) {
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

}  // namespace impetus::inline protocol
