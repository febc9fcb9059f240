// SPDX-License-Identifier: MIT
#include "experiments/timing/input_delay.hpp"

#include <algorithm>
#include <limits>

namespace impetus::inline timing {
namespace {

template <typename Event>
std::vector<Event> those_of(const std::vector<Event>& events, InputDevice device,
                            InputRoute route) {
  std::vector<Event> own;
  std::copy_if(events.begin(), events.end(), std::back_inserter(own),
               [&](const Event& event) { return event.device == device && event.route == route; });
  return own;
}

}  // namespace

InputDelay input_delay(const InputTrace& trace, InputDevice device, InputRoute route) {
  const std::vector<SentInput> sent = those_of(trace.sent, device, route);
  const std::vector<ArrivedInput> arrived = those_of(trace.arrived, device, route);
  InputDelay delay{device, route, static_cast<std::int64_t>(sent.size()), 0, {}, 0.0};
  std::int64_t within = 0;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const std::int64_t before_ns =
        i + 1 < sent.size() ? sent[i + 1].sent_ns : std::numeric_limits<std::int64_t>::max();
    const auto found = std::find_if(arrived.begin(), arrived.end(), [&](const ArrivedInput& event) {
      return event.arrived_ns >= sent[i].sent_ns;
    });
    if (found == arrived.end() || found->arrived_ns >= before_ns) {
      ++delay.lost;
      continue;
    }
    const std::int64_t took_ns = found->arrived_ns - sent[i].sent_ns;
    delay.delays_ms.push_back(static_cast<double>(took_ns) / 1e6);
    within += took_ns <= found->uncertainty_ns ? 1 : 0;
  }
  if (!delay.delays_ms.empty()) {
    delay.within_uncertainty_share =
        static_cast<double>(within) / static_cast<double>(delay.delays_ms.size());
  }
  return delay;
}

}  // namespace impetus::inline timing
