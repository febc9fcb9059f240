// Crowds in our engine: the scenes that its speed is held against, with the goals beside them.
//
//   impetus_crowd_bench [--only SCENE] [--steps N] [--quick] [MESH]
//
// SPDX-License-Identifier: MIT
#include <array>

#include "tests/bench/bench_scenes.hpp"
#include "tests/bench/crowd_scenes.hpp"
#include "tests/bench/pair_scene.hpp"
#include "tests/bench/small_scenes.hpp"

namespace impetus {
namespace {

constexpr std::array kScenes{
    BenchScene{"pair", print_pair},         BenchScene{"cube", print_cube},
    BenchScene{"elastic", print_elastic},   BenchScene{"implosion", print_implosion},
    BenchScene{"thousand", print_thousand}, BenchScene{"pit", print_pit},
    BenchScene{"growth", print_growth},     BenchScene{"response", print_response},
    BenchScene{"spheres", print_spheres},   BenchScene{"hash", print_hash},
    BenchScene{"shared", print_shared},
};

}  // namespace
}  // namespace impetus

int main(int count, char** arguments) {
  return impetus::run_scenes(count, arguments, impetus::kScenes);
}
