// SPDX-License-Identifier: MIT
#include "engine/scheduling/priority_memory.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace impetus::inline scheduling {
namespace {

bool comes_before(const BodyPair& x, const BodyPair& y) {
  return std::pair(x.a, x.b) < std::pair(y.a, y.b);
}

}  // namespace

void PriorityMemory::raise(std::vector<MeasuredPair>& pairs, std::int64_t steps) {
  ++step_;
  if (steps == 0) {
    memory_.clear();
    touching_.clear();
    return;
  }
  const std::int64_t since = std::max<std::int64_t>(0, step_ - steps);
  seen_.clear();
  for (MeasuredPair& pair : pairs) {
    int& list = pair.scheduled.list;
    seen_.push_back(remembered(pair.scheduled.pair));
    seen_.back().last_in[static_cast<std::size_t>(list)] = step_;
    if (touched(pair.scheduled.pair)) {
      const auto highest = std::find_if(seen_.back().last_in.begin(), seen_.back().last_in.end(),
                                        [since](std::int64_t step) { return step >= since; });
      list = static_cast<int>(highest - seen_.back().last_in.begin());
    }
  }
  remember_seen(since);
}

void PriorityMemory::remember_seen(std::int64_t since) {
  const auto by_pair = [](const Remembered& x, const Remembered& y) {
    return comes_before(x.pair, y.pair);
  };
  std::sort(seen_.begin(), seen_.end(), by_pair);
  others_.clear();
  for (const Remembered& old : memory_) {
    const bool recent = *std::max_element(old.last_in.begin(), old.last_in.end()) >= since;
    if (recent && !std::binary_search(seen_.begin(), seen_.end(), old, by_pair)) {
      others_.push_back(old);
    }
  }
  memory_.clear();
  std::merge(seen_.begin(), seen_.end(), others_.begin(), others_.end(),
             std::back_inserter(memory_), by_pair);
}

PriorityMemory::Remembered PriorityMemory::remembered(const BodyPair& pair) const {
  const auto found = std::lower_bound(
      memory_.begin(), memory_.end(), pair,
      [](const Remembered& x, const BodyPair& y) { return comes_before(x.pair, y); });
  if (found != memory_.end() && found->pair == pair) {
    return *found;
  }
  Remembered unknown{pair};
  unknown.last_in.fill(kNever);
  return unknown;
}

void PriorityMemory::note_touching(const std::vector<BodyPair>& touching) {
  touching_ = touching;
  for (BodyPair& pair : touching_) {
    pair.b = is_wall(pair.b) ? kEnclosure : pair.b;
  }
  std::sort(touching_.begin(), touching_.end(), comes_before);
}

bool PriorityMemory::touched(const BodyPair& pair) const {
  return std::binary_search(touching_.begin(), touching_.end(), pair, comes_before);
}

}  // namespace impetus::inline scheduling
