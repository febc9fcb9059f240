// SPDX-License-Identifier: MIT
#include "engine/dynamics/stop_at_entry.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>

#include "engine/dynamics/centres_at_walls.hpp"
#include "engine/dynamics/entry_searches.hpp"
#include "engine/numerics/at.hpp"
#include "engine/numerics/disjoint_sets.hpp"

namespace impetus::inline dynamics {
namespace {

/// What it takes to stop two bodies, and to find the way of a body, beside a test of nodes.
constexpr std::int64_t kStopUnits = 60;
constexpr std::int64_t kWayUnits = 6;

bool comes_before(const BodyPair& x, const BodyPair& y) {
  return x.a != y.a ? x.a < y.a : x.b < y.b;
}

/// Stops the bodies of one step, entry after entry.
class StopsInOrder {
 public:
  StopsInOrder(const StepMade& step, std::vector<BodyState>& states,
               const std::vector<PlacedTree>& placed, EntryMemory& memory)
      : step_(step),
        states_(states),
        memory_(memory),
        result_(memory.result),
        searches_(step, states, placed, memory) {
    result_.stopped.clear();
    result_.unsearched.clear();
    result_.work = 0;
    result_.tests = 0;
    result_.ran_out = false;
  }

  void run() {
    if (searches_.all_are_slow()) {
      return;
    }
    if (!searches_.has_work(kWayUnits * static_cast<std::int64_t>(states_.size()))) {
      searches_.leave_fast_pairs();
      sort_unsearched();
      return;
    }
    look_at_all();
    memory_.first = memory_.pending;
    if (!memory_.found.empty()) {
      list_candidates_of_bodies();
    }
    while (const std::optional<std::size_t> next = earliest()) {
      if (!searches_.has_work(kStopUnits)) {
        leave_entries();
        break;
      }
      if (!stop_pair(*next)) {
        stop_together();
        break;
      }
    }
    report();
  }

 private:
  [[nodiscard]] const BodyPair& bodies(std::size_t pair) const {
    return step_.candidates[pair].pair;
  }

  [[nodiscard]] bool moves(std::size_t body) const { return step_.models[body].inverse_mass > 0.0; }

  void look_at_all() {
    searches_.find_whole_ways();
    memory_.pending.assign(step_.candidates.size(), std::nullopt);
    memory_.last.assign(step_.candidates.size(), std::nullopt);
    memory_.found.clear();
    memory_.looked_at.resize(step_.candidates.size());
    std::iota(memory_.looked_at.begin(), memory_.looked_at.end(), 0U);
    look_at(memory_.looked_at);
  }

  void look_at(std::span<const std::uint32_t> pairs) {
    searches_.look_at(
        pairs, [this](std::size_t pair, std::optional<double> time) { note_entry(pair, time); });
  }

  static bool comes_later(const FoundEntry& x, const FoundEntry& y) {
    return x.time > y.time || (x.time == y.time && x.pair > y.pair);
  }

  void note_entry(std::size_t pair, std::optional<double> time) {
    memory_.pending[pair] = time;
    if (time) {
      memory_.found.push_back({*time, pair});
      std::push_heap(memory_.found.begin(), memory_.found.end(), comes_later);
    }
  }

  /// The pair whose entry comes next; the first of equals. Entries on ways that have changed since
  /// are forgotten.
  [[nodiscard]] std::optional<std::size_t> earliest() {
    while (!memory_.found.empty()) {
      const FoundEntry next = memory_.found.front();
      if (memory_.pending[next.pair] == next.time) {
        return next.pair;
      }
      std::pop_heap(memory_.found.begin(), memory_.found.end(), comes_later);
      memory_.found.pop_back();
    }
    return std::nullopt;
  }

  /// Nobody stops any more.
  void leave_entries() {
    for (std::size_t pair = 0; pair < memory_.pending.size(); ++pair) {
      if (memory_.pending[pair]) {
        result_.unsearched.push_back(bodies(pair));
      }
    }
  }

  void list_candidates_of_bodies() {
    std::vector<std::uint32_t>& first = memory_.first_of_body;
    first.assign(states_.size() + 2, 0);
    for (const PairBounds& candidate : step_.candidates) {
      ++first[at(candidate.pair.a) + 2];
      ++first[at(candidate.pair.b) + 2];
    }
    for (std::size_t body = 2; body < first.size(); ++body) {
      first[body] += first[body - 1];
    }
    memory_.candidates_of_body.resize(first.back());
    for (std::size_t pair = 0; pair < step_.candidates.size(); ++pair) {
      for (const std::int32_t body : {bodies(pair).a, bodies(pair).b}) {
        memory_.candidates_of_body[first[at(body) + 1]++] = static_cast<std::uint32_t>(pair);
      }
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> candidates_of(std::size_t body, bool any) const {
    const std::uint32_t begin = memory_.first_of_body[body];
    const std::uint32_t end = any ? memory_.first_of_body[body + 1] : begin;
    return std::span(memory_.candidates_of_body).subspan(begin, end - begin);
  }

  /// Anew, at the candidates of the bodies that have stopped, in their order, each once.
  void look_at_candidates_of(std::span<const std::uint32_t> of_a,
                             std::span<const std::uint32_t> of_b) {
    memory_.looked_at.clear();
    std::set_union(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(),
                   std::back_inserter(memory_.looked_at));
    look_at(memory_.looked_at);
  }

  /// Stops both bodies at the pair's entry. False when one was stopped too often.
  bool stop_pair(std::size_t pair) {
    const double time = *memory_.pending[pair];
    const std::size_t a = at(bodies(pair).a);
    const std::size_t b = at(bodies(pair).b);
    if (std::max(memory_.stops[a], memory_.stops[b]) >= step_.most_stops) {
      return false;
    }
    memory_.pending[pair].reset();
    memory_.last[pair] = time;
    const bool a_stops = stop(a, time);
    const bool b_stops = stop(b, time);
    look_at_candidates_of(candidates_of(a, a_stops), candidates_of(b, b_stops));
    return true;
  }

  /// From where it was before the step, through `share` of it.
  void move(std::size_t body, double share) {
    states_[body] = step_.before[body];
    const Fall fall = step_.falls.empty() ? Fall{} : step_.falls[body];
    advance(step_.models[body], states_[body], share * step_.dt_s, step_.rotation, fall);
    if (step_.walls != nullptr) {
      keep_centre_inside(*step_.walls, fall.gravity_m_s2, step_.models[body],
                         step_.before[body].pose.position, states_[body]);
    }
  }

  bool stop(std::size_t body, double share) {
    if (!moves(body) || !(share < memory_.ways[body].stop)) {
      return false;
    }
    move(body, share);
    memory_.ways[body] = searches_.way_of(body, share);
    ++memory_.stops[body];
    return true;
  }

  /// Every set of bodies that could meet, of which a pair still has an entry, stops at its first.
  void stop_together() {
    DisjointSets sets(states_.size());
    for (const PairBounds& candidate : step_.candidates) {
      if (moves(at(candidate.pair.a)) && moves(at(candidate.pair.b))) {
        sets.join(at(candidate.pair.a), at(candidate.pair.b));
      }
    }
    const auto set_of = [&](std::size_t pair) {
      const auto& [a, b] = bodies(pair);
      return sets.name_of(at(moves(at(a)) ? a : b));
    };
    std::vector<double> stops(states_.size(), 1.0);
    std::vector<bool> unsettled(states_.size(), false);
    for (std::size_t pair = 0; pair < memory_.pending.size(); ++pair) {
      const std::size_t set = set_of(pair);
      unsettled[set] = unsettled[set] || memory_.pending[pair].has_value();
      stops[set] = std::min(stops[set], memory_.first[pair].value_or(1.0));
    }
    for (std::size_t body = 0; body < states_.size(); ++body) {
      const std::size_t set = sets.name_of(body);
      if (moves(body) && unsettled[set]) {
        put_on_whole_way(body, stops[set]);
      }
    }
    for (std::size_t pair = 0; pair < memory_.pending.size(); ++pair) {
      const std::size_t set = set_of(pair);
      if (unsettled[set]) {
        memory_.last[pair] = memory_.first[pair] == stops[set] ? memory_.first[pair] : std::nullopt;
      }
    }
  }

  void put_on_whole_way(std::size_t body, double share) {
    move(body, share);
    states_[body].pose = pose_at(memory_.whole_ways[body], share);
    memory_.ways[body].stop = share;
  }

  /// Those pairs that stopped a body where it is now, and those that were not searched.
  void report() {
    sort_unsearched();
    for (std::size_t pair = 0; pair < memory_.last.size(); ++pair) {
      const auto& [a, b] = bodies(pair);
      if (memory_.last[pair] && (memory_.ways[at(a)].stop == *memory_.last[pair] ||
                                 memory_.ways[at(b)].stop == *memory_.last[pair])) {
        result_.stopped.push_back({bodies(pair), *memory_.last[pair]});
      }
    }
  }

  void sort_unsearched() {
    std::vector<BodyPair>& pairs = result_.unsearched;
    std::sort(pairs.begin(), pairs.end(), comes_before);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    result_.ran_out |= !pairs.empty();
  }

  const StepMade& step_;
  std::vector<BodyState>& states_;
  EntryMemory& memory_;
  Stopping& result_;
  EntrySearches searches_;
};

}  // namespace

const Stopping& stop_at_entry(const StepMade& step, std::vector<BodyState>& states,
                              const std::vector<PlacedTree>& placed, EntryMemory& memory) {
  StopsInOrder(step, states, placed, memory).run();
  return memory.result;
}

bool Stopping::lacked_tests(BodyPair bodies) const {
  return std::binary_search(unsearched.begin(), unsearched.end(), bodies, comes_before);
}

}  // namespace impetus::inline dynamics
