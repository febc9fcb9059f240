// SPDX-License-Identifier: MIT
#include "experiments/trade/crowds/cut_trade.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/numerics/at.hpp"
#include "engine/scheduling/eccentricity_metric.hpp"
#include "engine/scheduling/gap_metrics.hpp"
#include "experiments/run/collision_truth.hpp"
#include "experiments/tables/text_table.hpp"
#include "experiments/trade/crowds/trajectory.hpp"
#include "experiments/trade/estimate.hpp"

namespace impetus::inline trade {
namespace {

constexpr std::int64_t kLeastPart = 64;
constexpr double kSeenAfter_s = 0.1;
constexpr double kCourse_s = 1.0;

/// What a phase is granted; of the response, that no passes over all contacts are made.
WorkGrants grants_of(const CutPhase& cut, std::int64_t units) {
  WorkGrants grants;
  grants.of(cut.phase) = units;
  if (cut.phase == WorkPhase::kVisible) {
    grants.of(WorkPhase::kResponse) = 0;
  }
  return grants;
}

/// Grants all, and of one phase no more than it asks for at a time: so it asks for all that it
/// does.
class CountedWork final : public WorkMeter {
 public:
  explicit CountedWork(const CutPhase& cut)
      : phase_(cut.phase), meter_(grants_of(cut, kUnlimitedTests)) {}

  std::int64_t request(WorkPhase phase, std::int64_t total, std::int64_t reserved) override {
    if (phase != phase_) {
      return meter_.request(phase, total, reserved);
    }
    return asked_ = total;
  }

  [[nodiscard]] std::int64_t asked() const { return asked_; }

 private:
  WorkPhase phase_;
  FixedWork meter_;
  std::int64_t asked_{0};
};

std::int64_t units_of(const CutPhase& cut, const Moment& moment) {
  SceneRun run = moment.before;
  CountedWork meter(cut);
  static_cast<void>(run.step(moment.fixation, moment.region, meter));
  return meter.asked();
}

/// What of two states of a body shows of their difference (minutes of arc at the fovea).
double visible_difference(const BodyModel& model, const BodyState& whole, const BodyState& cut,
                          const Viewer& viewer, const Fixation& fixation) {
  const Vector3 apart = cut.pose.position - whole.pose.position +
                        kSeenAfter_s * (velocity(model, cut) - velocity(model, whole));
  const Vector3& place = whole.pose.position;
  const double away_deg =
      visual_angle_deg(viewer, place, on_screen(viewer, fixation.value_or(ScreenPoint{})));
  return kArcminPerDegree * relative_acuity(away_deg) *
         spanned_by_length_deg(apart.norm(), place, viewer);
}

std::vector<bool> touching_bodies(const StepReport& whole, const StepReport& cut,
                                  std::size_t bodies) {
  std::vector<bool> touch(bodies, false);
  for (const StepReport* report : {&whole, &cut}) {
    for (const CollisionReport& collision : report->collisions) {
      touch[at(collision.bodies.a)] = true;
      if (!is_wall(collision.bodies.b)) {
        touch[at(collision.bodies.b)] = true;
      }
    }
  }
  return touch;
}

CutStep compare(const SceneRun& whole, const StepReport& of_whole, const SceneRun& cut,
                const StepReport& of_cut, const Fixation& fixation) {
  const std::vector<BodyModel>& models = whole.world().models();
  const std::vector<bool> touch = touching_bodies(of_whole, of_cut, models.size());
  CutStep step;
  for (std::size_t body = 0; body < models.size(); ++body) {
    const BodyState& expected = whole.world().states()[body];
    const BodyState& got = cut.world().states()[body];
    step.visible_error +=
        visible_difference(models[body], expected, got, whole.input().viewer, fixation);
    if (touch[body]) {
      const Vector3 velocity_m_s = velocity(models[body], expected);
      step.wrong_m_s += (velocity(models[body], got) - velocity_m_s).norm();
      step.moving_m_s += velocity_m_s.norm();
    }
  }
  return step;
}

/// Cuts the phases of a scene at sampled moments of its trajectory.
class CutPhases {
 public:
  CutPhases(const StagedScene& scene, const CutRequest& request, const Progress& progress)
      : scene_(scene), request_(request), progress_(progress) {}

  std::vector<CutCrowd> measure() {
    find_budgets();
    for_each_moment(scene_, request_, progress_, [&](const Moment& moment) {
      try_all(moment);
      follow_some(moment);
    });
    return std::move(crowds_);
  }

 private:
  /// What is to be tried: each phase that asks for something, in each of its orders, by parts of
  /// what it takes in the median moment that asks for something.
  void find_budgets() {
    std::array<std::vector<std::int64_t>, kCutPhases.size()> asked;
    for_each_moment(scene_, request_, progress_, [&](const Moment& moment) {
      ++moments_;
      for (std::size_t i = 0; i < kCutPhases.size(); ++i) {
        const std::int64_t units = units_of(kCutPhases[i], moment);
        if (units > 0) {
          asked[i].push_back(units);
        }
      }
    });
    for (std::size_t i = 0; i < kCutPhases.size(); ++i) {
      if (!asked[i].empty()) {
        const auto middle = asked[i].begin() + static_cast<std::ptrdiff_t>(asked[i].size() / 2);
        std::nth_element(asked[i].begin(), middle, asked[i].end());
        add_parts(kCutPhases[i], *middle);
      }
    }
  }

  void add_parts(const CutPhase& cut, std::int64_t units) {
    const std::size_t orders = cut.has_order ? request_.orders.size() : 1;
    for (std::int64_t part = kLeastPart; part > 0; part /= 2) {
      for (std::size_t order = 0; order < orders; ++order) {
        crowds_.push_back({&cut, order, part, units / part, {}, {}});
      }
    }
  }

  /// Each order's whole step, and beside it those that are cut.
  void try_all(const Moment& moment) {
    for (std::size_t order = 0; order < request_.orders.size(); ++order) {
      SceneRun whole = run_in_order(moment, order);
      FixedWork all(kUnlimitedTests);
      const StepReport& of_whole = whole.step(moment.fixation, moment.region, all);
      for (CutCrowd* crowd : crowds_in(order)) {
        SceneRun cut = run_in_order(moment, order);
        FixedWork meter(grants_of(*crowd->phase, crowd->budget));
        const StepReport& of_cut = cut.step(moment.fixation, moment.region, meter);
        crowd->steps.push_back(compare(whole, of_whole, cut, of_cut, moment.fixation));
      }
    }
  }

  /// Of a few moments, spread over the trajectory.
  void follow_some(const Moment& moment) {
    const std::size_t every = std::max<std::size_t>(1, moments_ / request_.courses);
    if (followed_++ % every != 0) {
      return;
    }
    for (std::size_t order = 0; order < request_.orders.size(); ++order) {
      const SceneRun whole = course_of(moment, order, WorkGrants{});
      for (CutCrowd* crowd : crowds_in(order)) {
        const SceneRun cut = course_of(moment, order, grants_of(*crowd->phase, crowd->budget));
        crowd->elsewhere.push_back(share_elsewhere(whole, cut));
      }
    }
  }

  [[nodiscard]] SceneRun run_in_order(const Moment& moment, std::size_t order) const {
    SceneRun run = moment.before;
    run.world().set_schedule(schedule_of(request_.orders[order], scene_, moment.seed));
    return run;
  }

  /// Those of one order; those that know none are of the first.
  std::vector<CutCrowd*> crowds_in(std::size_t order) {
    std::vector<CutCrowd*> found;
    for (CutCrowd& crowd : crowds_) {
      if (crowd.order_place == order) {
        found.push_back(&crowd);
      }
    }
    return found;
  }

  /// The scene a second after the moment, of which every step is granted as much.
  [[nodiscard]] SceneRun course_of(const Moment& moment, std::size_t order,
                                   const WorkGrants& grants) const {
    SceneRun run = run_in_order(moment, order);
    FixedWork meter(grants);
    for (std::int64_t step = 0; step < std::llround(kCourse_s * scene_.step_hz); ++step) {
      const auto region = run.next_region(moment.fixation);
      static_cast<void>(run.step(moment.fixation, region, meter));
    }
    return run;
  }

  /// Of the bodies.
  [[nodiscard]] double share_elsewhere(const SceneRun& whole, const SceneRun& cut) const {
    std::size_t elsewhere = 0;
    const std::size_t bodies = scene_.looks.size();
    for (std::size_t body = 0; body < bodies; ++body) {
      const bool apart =
          seen_apart(whole.world().states()[body].pose, cut.world().states()[body].pose,
                     scene_.looks[body].mesh != nullptr, whole.input().viewer, request_.thresholds);
      elsewhere += apart ? 1 : 0;
    }
    return static_cast<double>(elsewhere) / static_cast<double>(bodies);
  }

  const StagedScene& scene_;
  const CutRequest& request_;
  const Progress& progress_;
  std::size_t moments_{0};
  std::size_t followed_{0};
  std::vector<CutCrowd> crowds_;
};

}  // namespace

std::vector<CutCrowd> cut_trade(const StagedScene& scene, const CutRequest& request,
                                const Progress& progress) {
  return CutPhases(scene, request, progress).measure();
}

std::vector<TradeRow> cut_rows(const std::vector<CutCrowd>& crowds,
                               const std::vector<TriedOrder>& orders, const std::string& subject) {
  std::vector<TradeRow> rows;
  for (const CutCrowd& crowd : crowds) {
    const auto add = [&](const char* measure, const char* unit, const Estimate& estimate) {
      TradeRow row;
      row.part = "cut";
      row.subject = subject;
      if (crowd.phase->has_order) {
        row.scheduler = orders[crowd.order_place].scheduler;
        row.traversal = orders[crowd.order_place].traversal;
      }
      row.phase = crowd.phase->name;
      row.budget = crowd.budget;
      row.measure = measure;
      row.unit = unit;
      row.reference = crowd.part == 1 ? "whole" : "whole/" + std::to_string(crowd.part);
      row.set("mean", estimate);
      rows.push_back(std::move(row));
    };
    std::vector<double> visible;
    std::vector<double> wrong;
    std::vector<double> moving;
    for (const CutStep& step : crowd.steps) {
      visible.push_back(step.visible_error);
      wrong.push_back(step.wrong_m_s);
      moving.push_back(step.moving_m_s);
    }
    add("visible_error", "arcmin", mean_over(visible));
    add("wrong_velocity", "1", ratio_of_sums(wrong, moving));
    add("elsewhere_after_1s", "1", mean_over(crowd.elsewhere));
  }
  return rows;
}

std::string cut_page(const std::vector<TradeRow>& rows) {
  std::map<std::string, std::vector<std::string>> lines;  // by the cells that begin them
  std::vector<std::string> begins;
  for (const TradeRow& row : rows) {
    if (row.part == "cut") {
      const std::string begin =
          "| " + row.phase + " | " + row.scheduler + " | " + row.measure + ", " + row.unit;
      if (!lines.contains(begin)) {
        begins.push_back(begin);
      }
      lines[begin].push_back(two_digits(row.value));
    }
  }
  if (begins.empty()) {
    return "";
  }
  std::string page =
      "What is given up where a phase of each step is granted a part of what it takes.\n\n"
      "| phase | order | measure |";
  std::string rule = "|---|---|---|";
  for (std::int64_t part = kLeastPart; part > 0; part /= 2) {
    page += part == 1 ? " all |" : " 1/" + std::to_string(part) + " |";
    rule += "---|";
  }
  page += "\n" + rule + "\n";
  for (const std::string& begin : begins) {
    page += begin;
    for (const std::string& value : lines[begin]) {
      page += " | " + value;
    }
    page += " |\n";
  }
  return page;
}

}  // namespace impetus::inline trade
