// SPDX-License-Identifier: MIT
#include "engine/collision/broad_phase.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "engine/numerics/at.hpp"
#include "engine/numerics/bits.hpp"

namespace impetus::inline collision {
namespace {

using Ends = SweptIntervals::Ends;

template <int kWidth>
IMPETUS_INLINED std::uint32_t meeting_by(const Ends& one, const Ends& others) {
  using Numbers = typename Vectors<kWidth>::Numbers;
  using Bits = typename Vectors<kWidth>::Bits;
  const Numbers none{};
  std::int64_t bits = 0;
  for (int first = 0; first < kLanes; first += kWidth) {
    Numbers least;
    Numbers greatest;
    read(others.least + first, least);
    Bits meet = least <= none + one.greatest[0];
    for (int axis = 0; axis < 2; ++axis) {
      read(others.across_least[axis] + first, least);
      read(others.across_greatest[axis] + first, greatest);
      meet &= least <= none + one.across_greatest[axis][0];
      meet &= none + one.across_least[axis][0] <= greatest;
    }
    for (int lane = 0; lane < kWidth; ++lane) {
      bits |= meet[lane] & kBitOfLane[first + lane];
    }
  }
  return static_cast<std::uint32_t>(bits);
}

/// Far beyond what rounding can do to the test of two spheres, as a share of the numbers in it.
constexpr double kSlack = 1e-14;
/// Squares of less are lost below the smallest number, squares of more are no numbers.
constexpr double kTiny_m = 1e-150;
constexpr double kHuge_m = 1e150;

/// Fewer bodies are swept in one strip; more strips than this would not fit a cache.
constexpr std::size_t kLeastBodiesForStrips = 128;
constexpr double kMostStrips = 256.0;

/// What a body covers along one axis.
struct Span {
  double least{-std::numeric_limits<double>::infinity()};
  double greatest{std::numeric_limits<double>::infinity()};
};

/// What the body covers along the axis; everything when that cannot be told.
Span span_of(const MovedBound& body, int axis) {
  const double place_m = body.bound.centre[axis];
  const double reach_m = body.bound.radius_m + body.travelled_m;
  if (!(std::abs(place_m) < kHuge_m) || !(std::abs(reach_m) < kHuge_m)) {
    return {};
  }
  const double grown_m = reach_m + kSlack * (std::abs(place_m) + std::abs(reach_m)) + kTiny_m;
  return {place_m - grown_m, place_m + grown_m};
}

/// The axis along which the bodies' centres spread most; the first of equals.
int widest_axis(const std::vector<MovedBound>& bodies) {
  int widest = 0;
  double most_m = -1.0;
  for (int axis = 0; axis < 3; ++axis) {
    Span span{kHuge_m, -kHuge_m};
    for (const MovedBound& body : bodies) {
      const double place_m = body.bound.centre[axis];
      if (std::abs(place_m) < kHuge_m) {
        span = {std::min(span.least, place_m), std::max(span.greatest, place_m)};
      }
    }
    if (span.greatest - span.least > most_m) {
      most_m = span.greatest - span.least;
      widest = axis;
    }
  }
  return widest;
}

}  // namespace

bool could_meet(const MovedBound& a, const MovedBound& b) {
  Sphere swept = a.bound;
  swept.radius_m += a.travelled_m + b.travelled_m;
  return overlap(swept, b.bound);
}

void find_among_all(const std::vector<MovedBound>& bodies, std::vector<BodyPair>& pairs) {
  pairs.clear();
  for (std::size_t b = 1; b < bodies.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (!bodies[a].movable && !bodies[b].movable) {
        continue;
      }
      if (could_meet(bodies[a], bodies[b])) {
        pairs.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)});
      }
    }
  }
}

void take_bounds(const std::vector<MovedBound>& bodies, const std::vector<BodyPair>& pairs,
                 std::vector<PairBounds>& candidates) {
  candidates.clear();
  for (const BodyPair& pair : pairs) {
    candidates.push_back({pair, bodies[at(pair.a)].bound, bodies[at(pair.b)].bound});
  }
}

std::vector<PairBounds> candidate_pairs(const std::vector<MovedBound>& bodies) {
  std::vector<BodyPair> pairs;
  find_among_all(bodies, pairs);
  std::vector<PairBounds> candidates;
  take_bounds(bodies, pairs, candidates);
  return candidates;
}

void SweptIntervals::clear() {
  for (std::vector<double>* ends : {&least_, &greatest_, &across_least_[0], &across_least_[1],
                                    &across_greatest_[0], &across_greatest_[1]}) {
    ends->clear();
  }
}

std::size_t SweptIntervals::add(const std::vector<SweptInterval>& sorted) {
  const std::size_t first = least_.size();
  for (const SweptInterval& interval : sorted) {
    least_.push_back(interval.least);
    greatest_.push_back(interval.greatest);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      across_least_[axis].push_back(interval.across_least[axis]);
      across_greatest_[axis].push_back(interval.across_greatest[axis]);
    }
  }
  // Nothing reaches what is not there, not even what has no end.
  const std::size_t behind_gap = least_.size() + kLanes;
  for (std::vector<double>* ends : {&least_, &greatest_, &across_least_[0], &across_least_[1],
                                    &across_greatest_[0], &across_greatest_[1]}) {
    ends->resize(behind_gap, std::numeric_limits<double>::quiet_NaN());
  }
  return first;
}

SweptIntervals::Ends SweptIntervals::from(std::size_t index) const {
  return {&least_[index],
          &greatest_[index],
          {&across_least_[0][index], &across_least_[1][index]},
          {&across_greatest_[0][index], &across_greatest_[1][index]}};
}

std::uint32_t SweptIntervals::meeting(std::size_t index, std::size_t first, LaneWidth width) const {
  const Ends one = from(index);
  const Ends others = from(first);
  // Where vectors hold eight, of four, too: those GCC 12 compares lane by lane.
  return in_lanes(
      std::min(width, LaneWidth::kFour), [&]<int kWidth>() __attribute__((always_inline)) {
        return meeting_by<kWidth>(one, others);
      });
}

void SweepAndPrune::cover(const std::vector<MovedBound>& bodies, int axis) {
  std::vector<std::int32_t>& order = orders_[static_cast<std::size_t>(axis)];
  if (order.size() != bodies.size()) {
    order.resize(bodies.size());
    std::iota(order.begin(), order.end(), 0);
  }
  intervals_.clear();
  for (const std::int32_t body : order) {
    const MovedBound& moved = bodies[static_cast<std::size_t>(body)];
    const Span along = span_of(moved, axis);
    const Span second = span_of(moved, (axis + 1) % 3);
    const Span third = span_of(moved, (axis + 2) % 3);
    intervals_.push_back({along.least,
                          along.greatest,
                          {second.least, third.least},
                          {second.greatest, third.greatest},
                          body,
                          moved.movable});
  }
}

void SweepAndPrune::sort() {
  const auto goes_before = [](const SweptInterval& x, const SweptInterval& y) {
    return x.least != y.least ? x.least < y.least : x.body < y.body;
  };
  std::size_t moves_left = 8 * intervals_.size();
  for (std::size_t i = 1; i < intervals_.size(); ++i) {
    for (std::size_t j = i; j > 0 && goes_before(intervals_[j], intervals_[j - 1]); --j) {
      std::swap(intervals_[j], intervals_[j - 1]);
      if (--moves_left == 0) {
        std::sort(intervals_.begin(), intervals_.end(), goes_before);
        return;
      }
    }
  }
}

/// As many strips as keep them twice as wide as the widest body, of those whose ends are numbers.
void SweepAndPrune::part_into_strips() {
  Span all{kHuge_m, -kHuge_m};
  double widest_m = kTiny_m;
  for (const SweptInterval& interval : intervals_) {
    const double width_m = interval.across_greatest[0] - interval.across_least[0];
    if (width_m < kHuge_m) {
      widest_m = std::max(widest_m, width_m);
      all = {std::min(all.least, interval.across_least[0]),
             std::max(all.greatest, interval.across_greatest[0])};
    }
  }
  const double room = (all.greatest - all.least) / (2.0 * widest_m);
  const bool worth_it = intervals_.size() >= kLeastBodiesForStrips && room >= 2.0;
  strip_count_ = worth_it ? static_cast<std::size_t>(std::min(room, kMostStrips)) : 1;
  strips_begin_m_ = all.least;
  strip_width_m_ = (all.greatest - all.least) / static_cast<double>(strip_count_);
  if (strips_.size() < strip_count_) {
    strips_.resize(strip_count_);
  }
  for (std::vector<SweptInterval>& strip : strips_) {
    strip.clear();
  }
  for (SweptInterval& interval : intervals_) {
    interval.first_strip = static_cast<std::uint16_t>(strip_at(interval.across_least[0]));
    const std::size_t last = strip_at(interval.across_greatest[0]);
    for (std::size_t strip = interval.first_strip; strip <= last; ++strip) {
      strips_[strip].push_back(interval);
    }
  }
}

/// Never falls as the place rises.
std::size_t SweepAndPrune::strip_at(double place_m) const {
  if (strip_count_ == 1) {
    return 0;
  }
  const double strip = (place_m - strips_begin_m_) / strip_width_m_;
  return static_cast<std::size_t>(std::clamp(strip, 0.0, static_cast<double>(strip_count_) - 1.0));
}

void SweepAndPrune::begin_sweep() {
  swept_.clear();
  strip_places_.clear();
  sweeping_.clear();
  for (std::size_t strip = 0; strip < strip_count_; ++strip) {
    const std::size_t begin = swept_.add(strips_[strip]);
    strip_places_.push_back(begin);
    for (std::size_t place = begin; place < begin + strips_[strip].size(); ++place) {
      if (swept_.reaches(place, place + 1)) {
        sweeping_.push_back({strip, place, place + 1});
      }
    }
  }
}

void SweepAndPrune::sweep(PhaseWork* work, std::vector<BodyPair>& pairs) {
  while (!sweeping_.empty()) {
    std::size_t go_on = 0;
    for (Sweeping one : sweeping_) {
      const std::uint32_t meeting = swept_.meeting(one.place, one.next);
      if (work != nullptr && !work->spend(1 + bits_in(meeting))) {
        return;
      }
      find_in_block(one, meeting, pairs);
      one.next += kLanes;
      if (swept_.reaches(one.place, one.next)) {
        sweeping_[go_on++] = one;
      }
    }
    sweeping_.resize(go_on);
  }
}

/// Keeps the pairs of a body and those of its block that it meets, a bit each, in the first strip
/// that both reach.
void SweepAndPrune::find_in_block(const Sweeping& one, std::uint32_t meeting,
                                  std::vector<BodyPair>& pairs) {
  const std::vector<SweptInterval>& intervals = strips_[one.strip];
  const std::size_t begin = strip_places_[one.strip];
  const SweptInterval& x = intervals[one.place - begin];
  for (; meeting != 0; meeting &= meeting - 1) {
    const SweptInterval& y =
        intervals[one.next - begin + static_cast<std::size_t>(std::countr_zero(meeting))];
    const bool is_first_of_both = std::max(x.first_strip, y.first_strip) == one.strip;
    if ((x.movable || y.movable) && is_first_of_both) {
      pairs.push_back({std::min(x.body, y.body), std::max(x.body, y.body)});
    }
  }
}

void SweepAndPrune::find(const std::vector<MovedBound>& bodies, std::vector<BodyPair>& pairs,
                         PhaseWork* work) {
  const int axis = widest_axis(bodies);
  cover(bodies, axis);
  sort();
  std::vector<std::int32_t>& order = orders_[static_cast<std::size_t>(axis)];
  std::transform(intervals_.begin(), intervals_.end(), order.begin(),
                 [](const SweptInterval& interval) { return interval.body; });
  part_into_strips();
  begin_sweep();
  pairs.clear();
  sweep(work, pairs);
  std::erase_if(pairs, [&bodies](const BodyPair& pair) {
    return !could_meet(bodies[at(pair.a)], bodies[at(pair.b)]);
  });
}

/// By a first, then by b, each in the order before.
void SweepAndPrune::put_in_order(std::size_t bodies, std::vector<BodyPair>& pairs) {
  const auto sort_by = [&](std::int32_t BodyPair::*body, const std::vector<BodyPair>& from,
                           std::vector<BodyPair>& to) {
    places_.assign(bodies + 1, 0);
    for (const BodyPair& pair : from) {
      ++places_[at(pair.*body) + 1];
    }
    std::partial_sum(places_.begin(), places_.end(), places_.begin());
    to.resize(from.size());
    for (const BodyPair& pair : from) {
      to[places_[at(pair.*body)]++] = pair;
    }
  };
  sort_by(&BodyPair::a, pairs, half_sorted_);
  sort_by(&BodyPair::b, half_sorted_, pairs);
}

std::vector<PairBounds> SweepAndPrune::candidates(const std::vector<MovedBound>& bodies) {
  std::vector<BodyPair> pairs;
  find(bodies, pairs);
  put_in_order(bodies.size(), pairs);
  std::vector<PairBounds> candidates;
  take_bounds(bodies, pairs, candidates);
  return candidates;
}

}  // namespace impetus::inline collision
