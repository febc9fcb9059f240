// SPDX-License-Identifier: MIT
#include "experiments/commands/nearest_word.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace impetus::inline commands {
namespace {

std::size_t letters_apart(const std::string& x, const std::string& y) {
  std::vector<std::size_t> apart(y.size() + 1);  // of what was read of x, from each beginning of y
  std::iota(apart.begin(), apart.end(), std::size_t{0});
  for (std::size_t i = 0; i < x.size(); ++i) {
    std::size_t diagonal = apart[0];
    apart[0] = i + 1;
    for (std::size_t j = 0; j < y.size(); ++j) {
      const std::size_t changed = diagonal + (x[i] == y[j] ? 0 : 1);
      diagonal = apart[j + 1];
      apart[j + 1] = std::min({changed, apart[j] + 1, diagonal + 1});
    }
  }
  return apart.back();
}

}  // namespace

std::string nearest_word(const std::string& given, const std::vector<std::string>& words) {
  std::string nearest;
  std::size_t least = std::min<std::size_t>(2, given.size() / 2) + 1;
  for (const std::string& word : words) {
    const std::size_t apart = letters_apart(given, word);
    if (apart < least) {
      nearest = word;
      least = apart;
    }
  }
  return nearest;
}

}  // namespace impetus::inline commands
