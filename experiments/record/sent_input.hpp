// Input that a self-test sends to itself, to see how long it takes to arrive.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace impetus::inline record {

/// What seems to send it.
enum class InputDevice { kKey, kMouse };

/// Where it was put in: into the program's own queue of events, or into the window system, from
/// which it comes as a real one would.
enum class InputRoute { kQueue, kWindowSystem };

/// One event that was put in.
struct SentInput {
  InputDevice device{InputDevice::kKey};
  InputRoute route{InputRoute::kQueue};
  std::int64_t sent_ns{0};
};

/// One event that came out.
struct ArrivedInput {
  InputDevice device{InputDevice::kKey};
  InputRoute route{InputRoute::kQueue};
  std::int64_t arrived_ns{0};      ///< as a session would stamp it
  std::int64_t uncertainty_ns{0};  ///< it may have arrived this much earlier, as a session says
};

/// All in order of time.
struct InputTrace {
  std::vector<SentInput> sent;
  std::vector<ArrivedInput> arrived;
};

}  // namespace impetus::inline record
