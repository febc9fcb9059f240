// SPDX-License-Identifier: MIT
#include "tests/bench/descent_limit.hpp"

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "engine/numerics/random_stream.hpp"
#include "tests/bench/thread_time.hpp"

namespace impetus {

#if defined(__x86_64__) && defined(__GNUC__)
namespace {

using Lanes = float __attribute__((vector_size(32)));
using Mask = std::int32_t __attribute__((vector_size(32)));

/// Eight spheres, a lane each.
struct Block {
  std::array<float, 8> x;
  std::array<float, 8> y;
  std::array<float, 8> z;
  std::array<float, 8> radius;
};

/// From b's frame to a's.
struct Transform {
  std::array<float, 9> turn;
  std::array<float, 3> shift;
};

constexpr int kBlocks =
    64;  // of 8 spheres and 128 bytes each: a tree that stays in the first cache
constexpr int kRounds = 200;
constexpr int kRuns = 15;
constexpr double kPairsPerBlock = 64.0;

__attribute__((target("avx2"), always_inline)) inline Lanes lanes_of(
    const std::array<float, 8>& numbers) {
  Lanes lanes;
  std::memcpy(&lanes, numbers.data(), sizeof lanes);
  return lanes;
}

/// Adds to each lane's count, as negative numbers, what overlaps of a and the moved b.
__attribute__((target("avx2"))) void test_block(const Block& a, const Block& b,
                                                const Transform& move, Mask& overlaps) {
  const auto& r = move.turn;
  const Lanes own_x = lanes_of(b.x);
  const Lanes own_y = lanes_of(b.y);
  const Lanes own_z = lanes_of(b.z);
  const Lanes radius = lanes_of(b.radius);
  const Lanes x = r[0] * own_x + r[1] * own_y + r[2] * own_z + move.shift[0];
  const Lanes y = r[3] * own_x + r[4] * own_y + r[5] * own_z + move.shift[1];
  const Lanes z = r[6] * own_x + r[7] * own_y + r[8] * own_z + move.shift[2];
  for (std::size_t lane = 0; lane < 8; ++lane) {
    const Lanes apart_x = x - a.x[lane];
    const Lanes apart_y = y - a.y[lane];
    const Lanes apart_z = z - a.z[lane];
    const Lanes reach = radius + a.radius[lane];
    const Lanes squared = apart_x * apart_x + apart_y * apart_y + apart_z * apart_z;
    overlaps += squared <= reach * reach;
  }
}

__attribute__((target("avx2"))) std::int64_t test_all(const std::vector<Block>& blocks,
                                                      const Transform& move) {
  Mask overlaps{};
  for (int round = 0; round < kRounds; ++round) {
    const auto shift = static_cast<std::size_t>(round);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      test_block(blocks[i], blocks[(i + shift) % blocks.size()], move, overlaps);
    }
  }
  std::int64_t sum = 0;
  for (int lane = 0; lane < 8; ++lane) {
    sum -= overlaps[lane];
  }
  return sum;
}

std::vector<Block> random_blocks() {
  RandomStream random(1, "blocks");
  std::vector<Block> blocks(kBlocks);
  for (Block& block : blocks) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
      block.x[lane] = static_cast<float>(random.uniform());
      block.y[lane] = static_cast<float>(random.uniform());
      block.z[lane] = static_cast<float>(random.uniform());
      block.radius[lane] = static_cast<float>(0.2 * random.uniform());
    }
  }
  return blocks;
}

}  // namespace

double limit_pairs_per_s() {
  if (__builtin_cpu_supports("avx2") == 0) {
    return 0.0;
  }
  const std::vector<Block> blocks = random_blocks();
  const Transform move{{0.8F, -0.6F, 0.0F, 0.6F, 0.8F, 0.0F, 0.0F, 0.0F, 1.0F}, {0.1F, 0.2F, 0.3F}};
  std::vector<double> pairs_per_s;
  volatile std::int64_t kept = 0;  // what is not used is not computed
  for (int run = 0; run < kRuns; ++run) {
    const std::int64_t start_ns = thread_cpu_ns();
    kept = kept + test_all(blocks, move);
    const double took_s = static_cast<double>(thread_cpu_ns() - start_ns) * 1e-9;
    pairs_per_s.push_back(kPairsPerBlock * kBlocks * kRounds / took_s);
  }
  return spread_of(std::move(pairs_per_s)).median;
}

#else

double limit_pairs_per_s() { return 0.0; }

#endif

}  // namespace impetus
