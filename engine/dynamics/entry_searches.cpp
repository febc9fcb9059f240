// SPDX-License-Identifier: MIT
#include "engine/dynamics/entry_searches.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <utility>

#include "engine/numerics/at.hpp"

namespace impetus::inline dynamics {
namespace {

/// Of slow_way_m: bodies one of which was stopped are looked at when they move further than this,
/// since stops can bring the same two together step after step.
constexpr double kShareOnceStopped = 0.125;
/// Of a way that was not asked for yet.
constexpr double kUnknown = -1.0;
/// What it takes to look whether a pair is fast, beside a test of nodes.
constexpr std::int64_t kLookUnits = 6;
/// What a search takes, roughly: so many are made ahead as what is left may be enough for.
constexpr std::int64_t kTestsOfSearch = 1'500;

}  // namespace

EntrySearches::EntrySearches(const StepMade& step, const std::vector<BodyState>& states,
                             const std::vector<PlacedTree>& placed, EntryMemory& memory)
    : step_(step), states_(states), placed_(placed), memory_(memory), result_(memory.result) {
  memory_.farthest_m.assign(states_.size(), kUnknown);
}

/// That any point of the body goes on its whole way: found when it is first asked for, and at the
/// latest before anybody is stopped.
double EntrySearches::farthest_of(std::size_t body) {
  double& known_m = memory_.farthest_m[body];
  if (known_m == kUnknown) {
    known_m = farthest_m(way_of(body, 1.0), step_.models[body].tree->bounding_radius_m());
  }
  return known_m;
}

bool EntrySearches::all_are_slow() {
  for (std::size_t pair = 0; pair < step_.candidates.size(); ++pair) {
    if (!is_slow(pair, 1.0)) {
      return false;
    }
  }
  return true;
}

void EntrySearches::find_whole_ways() {
  memory_.whole_ways.clear();
  for (std::size_t body = 0; body < states_.size(); ++body) {
    memory_.whole_ways.push_back(way_of(body, 1.0));
    static_cast<void>(farthest_of(body));
  }
  memory_.ways = memory_.whole_ways;
  memory_.stops.assign(states_.size(), 0);
  memory_.ahead.assign(step_.candidates.size(), {});
  const int workers = step_.workers == nullptr ? 1 : step_.workers->count();
  while (memory_.on_the_way.size() < at(workers)) {
    memory_.on_the_way.push_back({placed_.front(), placed_.front()});
  }
}

BodyPath EntrySearches::way_of(std::size_t body, double share) const {
  const double waiting_s = std::min(step_.before[body].held_s, share * step_.dt_s);
  BodyPath way;
  way.start = step_.before[body].pose;
  way.end = states_[body].pose;
  way.begin = step_.dt_s > 0.0 ? waiting_s / step_.dt_s : share;
  way.stop = share;
  return way;
}

/// Surely: by how far each of the bodies goes at most in the whole step.
bool EntrySearches::is_slow(std::size_t pair, double share) {
  const auto& [a, b] = bodies(pair);
  return farthest_of(at(a)) + farthest_of(at(b)) <=
         share *
             slow_way_m(*step_.models[at(a)].tree, *step_.models[at(b)].tree, step_.greatest_level);
}

double EntrySearches::share_of_slow_way(std::size_t pair) const {
  const auto& [a, b] = bodies(pair);
  return memory_.stops[at(a)] + memory_.stops[at(b)] > 0 ? kShareOnceStopped : 1.0;
}

PairOnTheWay EntrySearches::on_the_way(std::size_t pair, int worker, std::int64_t most_tests) {
  const auto& [a, b] = bodies(pair);
  TreesOnTheWay& trees = memory_.on_the_way[at(worker)];
  trees.a.take_tree_of(placed_[at(a)]);
  trees.b.take_tree_of(placed_[at(b)]);
  return {trees.a,
          trees.b,
          memory_.ways[at(a)],
          memory_.ways[at(b)],
          step_.greatest_level,
          most_tests,
          /*work=*/nullptr,
          step_.entry_rules};
}

std::optional<double> EntrySearches::look_at(std::size_t pair) {
  const SearchedAhead ahead = std::exchange(memory_.ahead[pair], {});
  const double share = share_of_slow_way(pair);
  if (is_slow(pair, share)) {
    return std::nullopt;
  }
  if (!has_work(kLookUnits)) {
    result_.unsearched.push_back(bodies(pair));
    return std::nullopt;
  }
  const std::int64_t most_tests = std::min(kMostEntryTests, step_.most_tests - result_.tests);
  PairOnTheWay searched = on_the_way(pair, 0, most_tests);
  searched.work = step_.work;
  if (ahead.most_tests == 0 && !is_fast(searched, share)) {
    return std::nullopt;
  }
  if (most_tests < 1) {
    result_.unsearched.push_back(bodies(pair));
    return std::nullopt;
  }
  const Entry entry = counts(ahead, most_tests) ? ahead.entry : time_of_entry(searched);
  result_.tests += entry.tests;
  result_.ran_out |= entry.refused || (entry.tests == most_tests && entry.tests < kMostEntryTests);
  const bool of_spheres = searched.a.of_spheres() && searched.b.of_spheres();
  result_.work += entry.tests * (of_spheres ? step_.costs.sphere_test : step_.costs.volume_test);
  return entry.time;
}

/// Whether a search that may make so many tests would find the same; then they are done.
bool EntrySearches::counts(const SearchedAhead& ahead, std::int64_t most_tests) {
  const bool ended_by_itself = ahead.entry.tests < std::min(ahead.most_tests, most_tests);
  return ahead.most_tests > 0 && (ended_by_itself || ahead.most_tests == most_tests) &&
         has_work(ahead.entry.tests);
}

/// Searches the first of `pairs`, which are looked at next, by all workers at once; returns how
/// many pairs to look at before it is to be asked again.
std::size_t EntrySearches::search_ahead(std::span<const std::uint32_t> pairs) {
  if (step_.workers == nullptr || step_.workers->count() < 2) {
    return pairs.size();
  }
  const std::int64_t granted =
      step_.work == nullptr ? kUnlimitedTests : step_.work->granted() - step_.work->done();
  const std::int64_t left = std::min(granted, step_.most_tests - result_.tests);
  const auto count = static_cast<std::size_t>(
      std::clamp<std::int64_t>(left / kTestsOfSearch, 1, static_cast<std::int64_t>(pairs.size())));
  if (count > 1) {
    std::atomic<std::size_t> next{0};
    const auto search_some = [&](int worker) {
      for (std::size_t i = next++; i < count; i = next++) {
        search_ahead(pairs[i], worker, std::min(kMostEntryTests, left));
      }
    };
    step_.workers->run(std::ref(search_some));
  }
  return count;
}

void EntrySearches::search_ahead(std::size_t pair, int worker, std::int64_t most_tests) {
  const double share = share_of_slow_way(pair);
  if (is_slow(pair, share)) {
    return;
  }
  const PairOnTheWay searched = on_the_way(pair, worker, most_tests);
  if (is_fast(searched, share)) {
    memory_.ahead[pair] = {time_of_entry(searched), most_tests};
  }
}

void EntrySearches::leave_fast_pairs() {
  for (std::size_t pair = 0; pair < step_.candidates.size(); ++pair) {
    if (!is_slow(pair, 1.0)) {
      result_.unsearched.push_back(bodies(pair));
    }
  }
}

}  // namespace impetus::inline dynamics
