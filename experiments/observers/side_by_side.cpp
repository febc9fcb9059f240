// SPDX-License-Identifier: MIT
#include "experiments/observers/side_by_side.hpp"

#include <algorithm>
#include <exception>
#include <future>
#include <thread>
#include <vector>

namespace impetus::inline observers {

std::int64_t core_count() { return std::max<std::int64_t>(1, std::thread::hardware_concurrency()); }

void do_side_by_side(std::size_t count, const std::function<void(std::size_t)>& piece,
                     std::int64_t jobs) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stops{false};
  const auto pieces = static_cast<std::int64_t>(count);
  run_workers(std::min(jobs, pieces), stops, [&](std::int64_t /*any*/) {
    for (std::size_t i = next++; i < count && !stops; i = next++) {
      piece(i);
    }
  });
}

void run_workers(std::int64_t jobs, std::atomic<bool>& stops,
                 const std::function<void(std::int64_t job)>& work) {
  std::exception_ptr failure;  // written by who makes `stops` true
  const auto keep_failure = [&](const std::function<void()>& part) {
    try {
      part();
    } catch (...) {
      if (!stops.exchange(true)) {
        failure = std::current_exception();
      }
    }
  };
  {
    std::vector<std::future<void>> others;  // waited for where this ends
    // A thread that cannot be started is a failure, too.
    keep_failure([&] {
      for (std::int64_t job = 1; job < jobs; ++job) {
        others.push_back(
            std::async(std::launch::async, [&, job] { keep_failure([&, job] { work(job); }); }));
      }
      work(0);
    });
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}

}  // namespace impetus::inline observers
