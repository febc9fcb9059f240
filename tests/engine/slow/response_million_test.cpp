// A million random problems of the response.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/engine/response_problems.hpp"

namespace impetus::response_million_test {

TEST(ResponseMillion, IsSoundInAMillionRandomProblems) { expect_sound_responses(2002, 1'000'000); }

}  // namespace impetus::response_million_test
