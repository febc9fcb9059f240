// SPDX-License-Identifier: MIT
#include "experiments/protocol/null_observer.hpp"

#include <utility>

namespace impetus::inline protocol {

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
  ObserverParameters parameters = read_parameters(document);
  return ObserverFile{std::move(document), std::move(parameters)};
}

}  // namespace impetus::inline protocol
