// SPDX-License-Identifier: MIT
#include "tests/bench/memory_watch.hpp"

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

double slope(const std::vector<double>& values, std::size_t from) {
  const auto count = static_cast<double>(values.size() - from);
  double mean = 0.0;
  for (std::size_t i = from; i < values.size(); ++i) {
    mean += values[i] / count;
  }
  const double middle = static_cast<double>(from) + (count - 1.0) / 2.0;
  double product = 0.0;
  double squares = 0.0;
  for (std::size_t i = from; i < values.size(); ++i) {
    const double at = static_cast<double>(i) - middle;
    product += at * (values[i] - mean);
    squares += at * at;
  }
  return squares > 0.0 ? product / squares : 0.0;
}

}  // namespace

MemoryWatch::MemoryWatch() {
  kiB_.reserve(100'000);  // so that the watch itself does not grow
  thread_ = std::thread([this] {
    while (!stopping_) {
      kiB_.push_back(resident_kiB());
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
  });
}

MemoryWatch::~MemoryWatch() { stop(0.0); }

MemoryGrowth MemoryWatch::stop(double left_out_s) {
  stopping_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
  if (kiB_.empty()) {
    return {};
  }
  const std::size_t from = std::min(static_cast<std::size_t>(left_out_s), kiB_.size() - 1);
  return {kiB_[from] / 1024.0, kiB_.back() / 1024.0, 60.0 * slope(kiB_, from)};
}

}  // namespace impetus
