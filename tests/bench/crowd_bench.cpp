// Crowds in our engine: the scenes that its speed is held against, with the goals beside them.
//
//   impetus_crowd_bench [--only SCENE] [--steps N] [--quick] [MESH]
//
// SPDX-License-Identifier: MIT
#include <array>
#include <cstdio>
#include <exception>

#include "tests/bench/crowd_scenes.hpp"
#include "tests/bench/pair_scene.hpp"
#include "tests/bench/small_scenes.hpp"
#include "tests/bench/thread_time.hpp"

namespace impetus {
namespace {

struct BenchScene {
  const char* name;
  void (*print)(const CrowdShape&, const BenchOptions&);
};

constexpr std::array kScenes{
    BenchScene{"pair", print_pair},         BenchScene{"cube", print_cube},
    BenchScene{"elastic", print_elastic},   BenchScene{"implosion", print_implosion},
    BenchScene{"thousand", print_thousand}, BenchScene{"growth", print_growth},
    BenchScene{"response", print_response}, BenchScene{"spheres", print_spheres},
    BenchScene{"hash", print_hash},
};

void print_scenes(const BenchOptions& options) {
  const CrowdShape shape = crowd_shape(options.mesh);
  std::printf(
      "%s: %zu triangles; trees of %d and %d leaves; steps of 1/120 s, a radius in ten;"
      " a look at the clock takes %.0f ns\n",
      shape.name.c_str(), shape.mesh.triangles.size(), leaf_count(*shape.coarse),
      leaf_count(*shape.fine), clock_cost_ns());
  for (const BenchScene& scene : kScenes) {
    if (options.asks_for(scene.name)) {
      scene.print(shape, options);
    }
  }
}

}  // namespace
}  // namespace impetus

int main(int count, char** arguments) {
  try {
    impetus::print_scenes(impetus::bench_options(count, arguments));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
