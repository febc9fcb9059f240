// SPDX-License-Identifier: MIT
#include "engine/dynamics/stop_at_entry.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include "engine/dynamics/body_sets.hpp"

namespace impetus {
namespace {

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

/// An entry of candidate number `pair`.
struct FoundEntry {
  double time{0.0};
  std::size_t pair{0};
};

class StoppingRounds {
 public:
  StoppingRounds(const StepMade& step, std::vector<BodyState>& states,
                 std::vector<PlacedTree>& placed)
      : step_(step),
        states_(states),
        placed_(placed),
        whole_ways_(states.size()),
        ways_(states.size()),
        moved_anew_(states.size(), true),
        entries_(step.candidates.size()) {
    for (std::size_t body = 0; body < states.size(); ++body) {
      whole_ways_[body] = way_of(body, 1.0);
      const double reach_m = step.models[body].tree->bounding_radius_m();
      farthest_m_.push_back(farthest_m(whole_ways_[body], reach_m));
    }
    ways_ = whole_ways_;
  }

  Stopping run() {
    first_ = round();
    bool changed = stop_bodies(first_);
    for (int done = 1; changed && done < kMostStoppingRounds; ++done) {
      changed = stop_bodies(round());
    }
    if (changed) {
      stop_together();
    }
    report();
    return std::move(result_);
  }

 private:
  [[nodiscard]] const BodyPair& bodies(std::size_t pair) const {
    return step_.candidates[pair].pair;
  }

  /// Of a body that takes `share` of the step: its state is where it stops.
  [[nodiscard]] BodyPath way_of(std::size_t body, double share) const {
    const double whole_s = share * step_.dt_s;
    const double waiting_s = std::min(step_.before[body].held_s, whole_s);
    BodyPath way;
    way.start = step_.before[body].pose;
    way.end = states_[body].pose;
    way.begin = step_.dt_s > 0.0 ? waiting_s / step_.dt_s : share;
    way.stop = share;
    return way;
  }

  /// Surely: by how far each of the bodies goes at most in the whole step.
  [[nodiscard]] bool is_slow(std::size_t pair) const {
    const auto& [a, b] = bodies(pair);
    return farthest_m_[at(a)] + farthest_m_[at(b)] <=
           slow_way_m(*step_.models[at(a)].tree, *step_.models[at(b)].tree, step_.greatest_level);
  }

  /// The entries of all fast pairs whose bodies were moved anew.
  std::vector<FoundEntry> round() {
    std::vector<FoundEntry> found;
    for (std::size_t pair = 0; pair < step_.candidates.size(); ++pair) {
      const auto& [a, b] = bodies(pair);
      if ((!moved_anew_[at(a)] && !moved_anew_[at(b)]) || is_slow(pair)) {
        continue;
      }
      const PairOnTheWay on_the_way{placed_[at(a)], placed_[at(b)], ways_[at(a)], ways_[at(b)],
                                    step_.greatest_level};
      if (is_fast(on_the_way)) {
        const Entry entry = time_of_entry(on_the_way);
        const bool of_spheres = placed_[at(a)].of_spheres() && placed_[at(b)].of_spheres();
        result_.work +=
            entry.tests * (of_spheres ? step_.costs.sphere_test : step_.costs.volume_test);
        if (entry.time) {
          found.push_back({*entry.time, pair});
        }
      }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const FoundEntry& x, const FoundEntry& y) { return x.time < y.time; });
    return found;
  }

  /// Whether any body was stopped.
  bool stop_bodies(const std::vector<FoundEntry>& found) {
    std::fill(moved_anew_.begin(), moved_anew_.end(), false);
    bool any = false;
    for (const FoundEntry& entry : found) {
      const std::size_t a = at(bodies(entry.pair).a);
      const std::size_t b = at(bodies(entry.pair).b);
      const auto as_found = [&](std::size_t body) {
        return !moved_anew_[body] || ways_[body].stop >= entry.time;
      };
      if (as_found(a) && as_found(b)) {
        entries_[entry.pair] = entry.time;
        const bool a_stops = stop(a, entry.time);
        const bool b_stops = stop(b, entry.time);
        any = any || a_stops || b_stops;
      }
    }
    return any;
  }

  bool stop(std::size_t body, double share) {
    if (!moves(body) || !(share < ways_[body].stop)) {
      return false;
    }
    states_[body] = step_.before[body];
    advance(step_.models[body], states_[body], share * step_.dt_s, step_.rotation);
    ways_[body] = way_of(body, share);
    moved_anew_[body] = true;
    return true;
  }

  /// Every set of bodies that could meet, of which one is not settled, stops at its first entry.
  void stop_together() {
    BodySets sets(states_.size());
    for (std::size_t pair = 0; pair < step_.candidates.size(); ++pair) {
      const auto& [a, b] = bodies(pair);
      if (moves(at(a)) && moves(at(b))) {
        sets.join(at(a), at(b));
      }
    }
    std::vector<bool> unsettled(states_.size(), false);
    for (std::size_t body = 0; body < states_.size(); ++body) {
      if (moved_anew_[body]) {
        unsettled[sets.name_of(body)] = true;
      }
    }
    std::vector<double> stops(states_.size(), 1.0);
    for (const FoundEntry& entry : first_) {
      for (const std::int32_t body : {bodies(entry.pair).a, bodies(entry.pair).b}) {
        double& stop = stops[sets.name_of(at(body))];
        stop = std::min(stop, entry.time);
      }
    }
    for (std::size_t pair = 0; pair < entries_.size(); ++pair) {
      const auto& [a, b] = bodies(pair);
      if (unsettled[sets.name_of(at(moves(at(a)) ? a : b))]) {
        entries_[pair].reset();
      }
    }
    for (std::size_t body = 0; body < states_.size(); ++body) {
      if (moves(body) && unsettled[sets.name_of(body)]) {
        put_on_whole_way(body, stops[sets.name_of(body)]);
      }
    }
    for (const FoundEntry& entry : first_) {
      const auto& [a, b] = bodies(entry.pair);
      const std::size_t set = sets.name_of(at(moves(at(a)) ? a : b));
      if (unsettled[set] && entry.time == stops[set]) {
        entries_[entry.pair] = entry.time;
      }
    }
  }

  void put_on_whole_way(std::size_t body, double share) {
    states_[body] = step_.before[body];
    advance(step_.models[body], states_[body], share * step_.dt_s, step_.rotation);
    states_[body].pose = pose_at(whole_ways_[body], share);
    ways_[body].stop = share;
  }

  [[nodiscard]] bool moves(std::size_t body) const { return step_.models[body].inverse_mass > 0.0; }

  /// Those pairs that stopped a body where it is now.
  void report() {
    for (std::size_t pair = 0; pair < entries_.size(); ++pair) {
      const auto& [a, b] = bodies(pair);
      if (entries_[pair] &&
          (ways_[at(a)].stop == *entries_[pair] || ways_[at(b)].stop == *entries_[pair])) {
        result_.stopped.push_back({bodies(pair), *entries_[pair]});
      }
    }
  }

  const StepMade& step_;
  std::vector<BodyState>& states_;
  std::vector<PlacedTree>& placed_;
  std::vector<BodyPath> whole_ways_;
  std::vector<double> farthest_m_;  ///< that any point of each body goes
  std::vector<BodyPath> ways_;
  std::vector<bool> moved_anew_;                ///< since the last round
  std::vector<std::optional<double>> entries_;  ///< of each candidate, the last that stopped it
  std::vector<FoundEntry> first_;               ///< of the first round
  Stopping result_;
};

}  // namespace

Stopping stop_at_entry(const StepMade& step, std::vector<BodyState>& states,
                       std::vector<PlacedTree>& placed) {
  return StoppingRounds(step, states, placed).run();
}

}  // namespace impetus
