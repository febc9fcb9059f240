// SPDX-License-Identifier: MIT
#include "experiments/observers/explained_clicks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/observers/draws.hpp"

namespace impetus::inline observers {
namespace {

constexpr double kLeast = 1e-300;  ///< what cannot be is only very improbable: a fit goes on

/// How likely an event waits for its click, or has clicked.
struct Follow {
  double at_s;
  double waits;
  double clicked{0.0};
};

/// Follows all events through a trial.
class Explanation {
 public:
  Explanation(const ClickHabit& habit, const std::vector<PossibleEvent>& events) : habit_(habit) {
    for (const PossibleEvent& event : events) {
      follows_.push_back({event.at_s, event.chance});
    }
  }

  /// Until `to_s` no click was made, though it could have been.
  void be_silent(double to_s) {
    if (to_s <= now_s_) {
      return;
    }
    logarithm_ -= habit_.false_per_s * (to_s - now_s_);
    for (Follow& one : follows_) {
      const double still = still_waits(one, to_s);
      const double silent = std::max(1.0 - one.waits * (1.0 - still), kLeast);
      logarithm_ += std::log(silent);
      one.waits *= still / silent;
      one.clicked /= silent;
    }
    now_s_ = to_s;
  }

  /// Until `to_s` no click would have counted.
  void pass_unnoticed(double to_s) {
    if (to_s <= now_s_) {
      return;
    }
    for (Follow& one : follows_) {
      const double clicks = one.waits * (1.0 - still_waits(one, to_s));
      one.waits -= clicks;
      one.clicked += clicks;
    }
    now_s_ = to_s;
  }

  /// A click, now.
  void take_click() {
    double all = habit_.false_per_s;
    std::vector<double> hazards;
    for (const Follow& one : follows_) {
      hazards.push_back(one.waits * hazard(now_s_ - one.at_s));
      all += hazards.back();
    }
    logarithm_ += std::log(std::max(all, kLeast));
    for (std::size_t i = 0; i < follows_.size() && all > 0.0; ++i) {
      const double its = hazards[i] / all;
      follows_[i].waits *= 1.0 - its;
      follows_[i].clicked = its + (1.0 - its) * follows_[i].clicked;
    }
  }

  [[nodiscard]] double logarithm() const { return logarithm_; }
  [[nodiscard]] double seen(std::size_t event) const {
    return std::min(1.0, follows_[event].waits + follows_[event].clicked);
  }

 private:
  /// z of a waiting time.
  [[nodiscard]] double z(double waited_s) const {
    return std::log(waited_s / habit_.median_s) / habit_.sigma_log;
  }
  /// That a click takes longer than this.
  [[nodiscard]] double longer(double waited_s) const {
    return waited_s <= 0.0 ? 1.0 : normal_cdf(-z(waited_s));
  }
  /// Of those who wait now, the share that does at `to_s`.
  [[nodiscard]] double still_waits(const Follow& one, double to_s) const {
    if (to_s <= one.at_s || one.waits <= 0.0) {
      return 1.0;
    }
    const double now = longer(now_s_ - one.at_s);
    return now > 0.0 ? longer(to_s - one.at_s) / now : 0.0;
  }
  [[nodiscard]] double hazard(double waited_s) const {
    if (waited_s <= 0.0) {
      return 0.0;
    }
    const double at = z(waited_s);
    const double density = std::exp(-0.5 * at * at) /
                           (waited_s * habit_.sigma_log * std::sqrt(2.0 * std::numbers::pi));
    const double waits = longer(waited_s);
    return waits > 0.0 ? density / waits : 0.0;
  }

  ClickHabit habit_;
  std::vector<Follow> follows_;
  double now_s_{0.0};
  double logarithm_{0.0};
};

}  // namespace

double explain_clicks(const ClickHabit& habit, const std::vector<double>& clicks_s,
                      double stimulus_s, std::vector<PossibleEvent>& events) {
  Explanation explanation(habit, events);
  for (const double click_s : clicks_s) {
    explanation.be_silent(click_s);
    explanation.take_click();
    explanation.pass_unnoticed(std::min(click_s + habit.refractory_s, stimulus_s));
  }
  explanation.be_silent(stimulus_s);
  for (std::size_t i = 0; i < events.size(); ++i) {
    events[i].chance = explanation.seen(i);
  }
  return explanation.logarithm();
}

std::vector<double> chances_of_count(const std::vector<PossibleEvent>& events) {
  std::vector<double> chances{1.0};
  for (const PossibleEvent& event : events) {
    chances.push_back(0.0);
    for (std::size_t count = chances.size() - 1; count > 0; --count) {
      chances[count] = chances[count] * (1.0 - event.chance) + chances[count - 1] * event.chance;
    }
    chances[0] *= 1.0 - event.chance;
  }
  return chances;
}

}  // namespace impetus::inline observers
