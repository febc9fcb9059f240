// What is done about bodies that move further in a step than they are thick.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/scheduling/priority.hpp"

namespace impetus {

/// (Dingliana 2002, sec. 5.3.2)
enum class Tunnelling {
  kIgnored,      ///< bodies are tested where the step ends
  kCapped,       ///< fast pairs stay at levels whose nodes are thicker than the way: Alg. 5.3.1
  kStopAtEntry,  ///< fast pairs are tested along their way, and stopped where they first touch
};

/// A pair that would have passed into or through each other unseen, and was stopped.
struct StoppedAtEntry {
  BodyPair bodies;
  double fraction{0.0};  ///< of the step that both were moved
};

}  // namespace impetus
