// SPDX-License-Identifier: MIT
#include "experiments/observers/explained_clicks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "experiments/observers/draws.hpp"

namespace impetus::inline observers {
namespace {

constexpr double kLeast = 1e-300;  ///< what cannot be is only very improbable: a fit goes on
constexpr double kDone = 1e-12;    ///< who waits for its click less probably has it

/// How likely an event waits for its click, or has clicked.
struct Follow {
  double at_s;
  double waits;
  std::size_t group;  ///< of alternatives
  double clicked{0.0};
  double longer{1.0};  ///< the share of clicks that come later than now
};

/// Follows all events through a trial.
class Explanation {
 public:
  Explanation(const ClickHabit& habit, const std::vector<PossibleEvent>& events) : habit_(habit) {
    for (const PossibleEvent& event : events) {
      groups_ += follows_.empty() || !event.is_alternative ? 1 : 0;
      follows_.push_back({event.at_s, event.chance, groups_ - 1});
    }
  }

  /// Until `to_s` no click was made, though it could have been.
  void be_silent(double to_s) {
    if (to_s <= now_s_) {
      return;
    }
    logarithm_ -= habit_.false_per_s * (to_s - now_s_);
    of_groups_.assign(groups_, 0.0);
    for (Follow& one : follows_) {
      of_groups_[one.group] += clicks_until(to_s, one);
    }
    for (double& clicks : of_groups_) {
      logarithm_ += clicks > 0.0 ? std::log(std::max(1.0 - clicks, kLeast)) : 0.0;
    }
    for (Follow& one : follows_) {
      const double silent = std::max(1.0 - of_groups_[one.group], kLeast);
      one.waits /= silent;
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
      one.clicked += clicks_until(to_s, one);
    }
    now_s_ = to_s;
  }

  /// A click, now.
  void take_click() {
    double all = habit_.false_per_s;
    hazards_.clear();
    for (const Follow& one : follows_) {
      hazards_.push_back(is_idle(one, now_s_) ? 0.0 : one.waits * hazard(one));
      all += hazards_.back();
    }
    logarithm_ += std::log(std::max(all, kLeast));
    if (!(all > 0.0)) {
      return;
    }
    of_groups_.assign(groups_, 0.0);
    for (std::size_t i = 0; i < follows_.size(); ++i) {
      of_groups_[follows_[i].group] += hazards_[i] / all;
    }
    for (std::size_t i = 0; i < follows_.size(); ++i) {
      Follow& one = follows_[i];
      const double not_its_groups = 1.0 - of_groups_[one.group];
      one.waits *= not_its_groups;
      one.clicked = hazards_[i] / all + not_its_groups * one.clicked;
    }
  }

  [[nodiscard]] double logarithm() const { return logarithm_; }
  [[nodiscard]] double seen(std::size_t event) const {
    return std::min(1.0, follows_[event].waits + follows_[event].clicked);
  }

 private:
  /// Whether nothing of it changes until `to_s`: it comes later, or has its click.
  [[nodiscard]] static bool is_idle(const Follow& one, double to_s) {
    return to_s <= one.at_s || one.waits < kDone;
  }
  /// z of a waiting time.
  [[nodiscard]] double z(double waited_s) const {
    return std::log(waited_s / habit_.median_s) / habit_.sigma_log;
  }
  /// The chance that it clicks until `to_s`, which is now from now on; it waits no more then.
  double clicks_until(double to_s, Follow& one) const {
    if (is_idle(one, to_s)) {
      return 0.0;
    }
    const double longer = normal_cdf(-z(to_s - one.at_s));
    const double clicks = one.longer > 0.0 ? one.waits * (1.0 - longer / one.longer) : one.waits;
    one.longer = longer;
    one.waits -= clicks;
    return clicks;
  }
  [[nodiscard]] double hazard(const Follow& one) const {
    const double waited_s = now_s_ - one.at_s;
    const double at = z(waited_s);
    const double density = std::exp(-0.5 * at * at) /
                           (waited_s * habit_.sigma_log * std::sqrt(2.0 * std::numbers::pi));
    return one.longer > 0.0 ? density / one.longer : 0.0;
  }

  ClickHabit habit_;
  std::vector<Follow> follows_;
  std::size_t groups_{0};
  std::vector<double> hazards_;
  std::vector<double> of_groups_;
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
  for (std::size_t first = 0; first < events.size();) {
    double chance = events[first++].chance;
    while (first < events.size() && events[first].is_alternative) {
      chance += events[first++].chance;
    }
    chance = std::min(chance, 1.0);
    chances.push_back(0.0);
    for (std::size_t count = chances.size() - 1; count > 0; --count) {
      chances[count] = chances[count] * (1.0 - chance) + chances[count - 1] * chance;
    }
    chances[0] *= 1.0 - chance;
  }
  return chances;
}

}  // namespace impetus::inline observers
