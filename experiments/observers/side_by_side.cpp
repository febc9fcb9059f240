// SPDX-License-Identifier: MIT
#include "experiments/observers/side_by_side.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace impetus::inline observers {

void do_side_by_side(std::size_t count, const std::function<void(std::size_t)>& piece) {
  const std::size_t jobs =
      std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), count);
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> thrown(jobs);
  const auto work = [&](std::size_t job) {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        piece(i);
      }
    } catch (...) {
      thrown[job] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t job = 1; job < jobs; ++job) {
      threads.emplace_back(work, job);
    }
    if (jobs > 0) {
      work(0);
    }
  }
  for (const std::exception_ptr& one : thrown) {
    if (one) {
      std::rethrow_exception(one);
    }
  }
}

}  // namespace impetus::inline observers
