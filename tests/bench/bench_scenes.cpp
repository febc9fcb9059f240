// SPDX-License-Identifier: MIT
#include "tests/bench/bench_scenes.hpp"

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

#include "tests/bench/thread_time.hpp"

namespace impetus {
namespace {

void check(const BenchOptions& options, std::span<const BenchScene> scenes) {
  std::string names;
  bool known = false;
  for (const BenchScene& scene : scenes) {
    names += std::string(names.empty() ? "" : ", ") + scene.name;
    known = known || options.asks_for(scene.name);
  }
  if (!known) {
    throw std::invalid_argument("--only: expected one of " + names + ", got \"" + *options.only +
                                "\"");
  }
}

}  // namespace

int run_scenes(int count, char** arguments, std::span<const BenchScene> scenes) {
  try {
    const BenchOptions options = bench_options(count, arguments);
    check(options, scenes);
    const CrowdShape shape = crowd_shape(options.mesh);
    std::printf(
        "%s: %zu triangles; trees of %d and %d leaves; steps of 1/120 s, a radius in ten; a look "
        "at the clock takes %.0f ns\n",
        shape.name.c_str(), shape.mesh.triangles.size(), leaf_count(*shape.coarse),
        leaf_count(*shape.fine), clock_cost_ns());
    for (const BenchScene& scene : scenes) {
      if (options.asks_for(scene.name)) {
        scene.print(shape, options);
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}

}  // namespace impetus
