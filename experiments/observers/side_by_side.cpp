// SPDX-License-Identifier: MIT
#include "experiments/observers/side_by_side.hpp"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace impetus::inline observers {

void do_side_by_side(std::size_t count, const std::function<void(std::size_t)>& piece) {
  const std::size_t jobs =
      std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), count);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      piece(i);
    }
  };
  std::vector<std::future<void>> others;  // waited for, also where this thread throws
  for (std::size_t job = 1; job < jobs; ++job) {
    others.push_back(std::async(std::launch::async, work));
  }
  work();
  for (std::future<void>& other : others) {
    other.get();
  }
}

}  // namespace impetus::inline observers
