// SPDX-License-Identifier: MIT
#include "engine/numerics/random_stream.hpp"

#include <bit>
#include <cassert>

namespace impetus::inline numerics {

std::uint64_t derived_seed(std::uint64_t seed, std::string_view name) {
  std::uint64_t hash = mix_bits(seed);
  for (const char letter : name) {
    hash = fold_bits(hash, static_cast<unsigned char>(letter));
  }
  return fold_bits(hash, name.size());
}

RandomStream::RandomStream(std::uint64_t seed, std::string_view name) : state_{} {
  std::uint64_t counter = derived_seed(seed, name);
  for (std::uint64_t& word : state_) {
    counter += 0x9e3779b97f4a7c15ULL;
    word = mix_bits(counter);
  }
}

std::uint64_t RandomStream::next_bits() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t shifted = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= shifted;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double RandomStream::uniform() { return static_cast<double>(next_bits() >> 11) * 0x1.0p-53; }

std::uint64_t RandomStream::below(std::uint64_t count) {
  assert(count > 0);
  // Bits past the last whole multiple of `count` would favour the small results: draw again.
  const std::uint64_t first_unbiased = (0 - count) % count;
  while (true) {
    const std::uint64_t bits = next_bits();
    if (bits >= first_unbiased) {
      return bits % count;
    }
  }
}

}  // namespace impetus::inline numerics
