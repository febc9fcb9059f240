// SPDX-License-Identifier: MIT
#include "tests/bench/memory_watch.hpp"

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace impetus {
namespace {

double resident_kiB() {
  long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%*d %ld", &pages) != 1) {
      pages = 0;
    }
    std::fclose(file);
  }
  return static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1024.0;
}

double allocated_kiB() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd) / 1024.0;
}

double slope(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double mean = 0.0;
  for (const double value : values) {
    mean += value / count;
  }
  double product = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double at = static_cast<double>(i) - (count - 1.0) / 2.0;
    product += at * (values[i] - mean);
    squares += at * at;
  }
  return squares > 0.0 ? product / squares : 0.0;
}

/// A last part that is shorter than a minute does not count, unless it is all there is.
std::vector<double> least_of_minutes(const std::vector<double>& values, std::size_t from) {
  constexpr std::size_t kMinute = 60;
  std::vector<double> least;
  for (; from + kMinute <= values.size() || least.empty(); from += kMinute) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(from);
    const std::size_t count = std::min(kMinute, values.size() - from);
    least.push_back(*std::min_element(begin, begin + static_cast<std::ptrdiff_t>(count)));
  }
  return least;
}

MemoryGrowth growth_of(const std::vector<double>& values_kiB, std::size_t from) {
  const std::vector<double> least = least_of_minutes(values_kiB, from);
  return {least.front() / 1024.0, least.back() / 1024.0, slope(least)};
}

}  // namespace

MemoryWatch::MemoryWatch() {
  constexpr std::size_t kMost = 100'000;  // so that the watch itself does not grow
  resident_kiB_.reserve(kMost);
  allocated_kiB_.reserve(kMost);
  thread_ = std::thread([this] {
    while (!stopping_) {
      resident_kiB_.push_back(resident_kiB());
      allocated_kiB_.push_back(allocated_kiB());
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
  });
}

MemoryWatch::~MemoryWatch() { stop(0.0); }

MemoryUse MemoryWatch::stop(double left_out_s) {
  stopping_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
  if (resident_kiB_.empty()) {
    return {};
  }
  const std::size_t from = std::min(static_cast<std::size_t>(left_out_s), resident_kiB_.size() - 1);
  return {growth_of(resident_kiB_, from), growth_of(allocated_kiB_, from),
          *std::max_element(resident_kiB_.begin(), resident_kiB_.end()) / 1024.0};
}

}  // namespace impetus
