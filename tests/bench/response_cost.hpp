// What our response to 64 contacts costs.
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/world/world_settings.hpp"
#include "tests/bench/contact_problem.hpp"
#include "tests/bench/thread_time.hpp"

namespace impetus {

/// Of the stream that problems come from: the same for our solvers and for peers.
inline constexpr std::uint64_t kProblemSeed = 6;
inline constexpr const char* kProblemStream = "contact problems";

struct ResponseCost {
  Spread us;
  int left_approaching{0};
};

/// Over `problems` random ones, restitution .5.
ResponseCost response_cost(const CrowdShape& shape, ResponseMethod method, int problems);

}  // namespace impetus
