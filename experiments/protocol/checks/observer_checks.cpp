// SPDX-License-Identifier: MIT
#include "experiments/protocol/checks/observer_checks.hpp"

namespace impetus::inline protocol {
namespace {

void check_scale(const Protocol& protocol, std::size_t observer_points) {
  if (!protocol.script.scale) {
    return;
  }
  const RatingScale& scale = *protocol.script.scale;
  const auto points = static_cast<std::size_t>(scale.maximum - scale.minimum + 1);
  if (points != observer_points) {
    refuse(protocol.document, "/rating",
           "expected a scale of " + std::to_string(observer_points) +
               " points, as the simulated participant rates (one more than its file has cuts), "
               "got " +
               std::to_string(points) + ", from " + std::to_string(scale.minimum) + " to " +
               std::to_string(scale.maximum));
  }
}

}  // namespace

void check_observer(const Protocol& protocol, const ObserverFile& observer) {
  check_scale(protocol, observer.points());
  const auto name = observer.document.value["observer"].get<std::string>();
  if (protocol.script.clicks && !observer.clicks()) {
    refuse(protocol.document, "/clicks",
           "expected none for the simulated participant " + name + ", which does not click");
  }
  if (protocol.script.gaze && !observer.has_eye()) {
    refuse(protocol.document, "/gaze",
           "expected none for the simulated participant " + name + ", which has no eye");
  }
}

}  // namespace impetus::inline protocol
