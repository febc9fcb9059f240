// A benchmark of named scenes: what its main() does.
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "tests/bench/bench_options.hpp"
#include "tests/bench/crowd_shape.hpp"

namespace impetus {

struct BenchScene {
  const char* name;
  void (*print)(const CrowdShape&, const BenchOptions&);
};

/// Prints the shape, then the scenes that the command line asks for. Returns what main() does: 2,
/// with a sentence on the standard error, when it could not.
int run_scenes(int count, char** arguments, std::span<const BenchScene> scenes);

}  // namespace impetus
