// SPDX-License-Identifier: MIT
#include "experiments/commands/fitting/fittable.hpp"

#include <string>
#include <vector>

#include "experiments/observers/observer_kinds.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {

void require_fittable(const ObserverFile& observer) {
  if (observer.kind->answers.percept != nullptr) {
    return;
  }
  std::vector<std::string> names;
  for (const ObserverKind& kind : observer_kinds()) {
    if (kind.answers.percept != nullptr) {
      names.push_back(kind.name);
    }
  }
  refuse(observer.document, "/observer",
         "expected a kind that can be fitted (" + listed(names) + "), got " + observer.kind->name);
}

}  // namespace impetus::inline commands
