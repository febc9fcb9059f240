// Fifty participants at once, each faster than any person.
// SPDX-License-Identifier: MIT
#include "tests/experiments/site/serving_program.hpp"

namespace impetus::serve_fifty_test {

TEST(ServeFifty, FiftyAtOnceAreEachKeptWhole) { expect_kept_at_once(50); }

}  // namespace impetus::serve_fifty_test
