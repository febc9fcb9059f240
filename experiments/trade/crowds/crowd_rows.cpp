// SPDX-License-Identifier: MIT
#include "experiments/trade/crowds/crowd_rows.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "experiments/trade/crowds/removal_curve.hpp"
#include "experiments/trade/estimate.hpp"

namespace impetus::inline trade {
namespace {

/// One of the two errors, as the table calls it.
struct NamedError {
  const char* name;
  ErrorOf error;
};
constexpr std::array<NamedError, 2> kErrors{
    {{"visible_gap", &VisibleError::gap}, {"visible_bound", &VisibleError::bound}}};

/// What an order is compared with, as the table calls it.
struct Reference {
  const char* name;
  VisibleError OrderedStep::*removed;
};
constexpr std::array<Reference, 3> kReferences{{{"random", &OrderedStep::by_chance},
                                                {"breadth-first", &OrderedStep::breadth_first},
                                                {"hindsight", &OrderedStep::in_hindsight}}};

constexpr double kThousand = 1e3;
constexpr double kNsPerUs = 1e3;

template <typename Steps, typename Value>
std::vector<double> each(const Steps& steps, const Value& value) {
  std::vector<double> values;
  values.reserve(steps.size());
  for (const auto& step : steps) {
    values.push_back(static_cast<double>(value(step)));
  }
  return values;
}

/// Adds `more` to `sums`, step by step.
void add_to(std::vector<double>& sums, const std::vector<double>& more) {
  sums.resize(more.size(), 0.0);
  for (std::size_t i = 0; i < more.size(); ++i) {
    sums[i] += more[i];
  }
}

/// Fills in the rows of one scene.
class Rows {
 public:
  Rows(const CrowdTrade& trade, const std::string& subject) : trade_(trade) {
    row_.part = "crowd";
    row_.subject = subject;
  }

  std::vector<TradeRow> all() {
    add_steps();
    for (const OrderedCrowd& ordered : trade_.orders) {
      name(ordered.order);
      row_.budget = ordered.budget;
      add_errors(ordered);
      add_costs(ordered);
    }
    row_.budget.reset();
    for (const OrderedCrowd& first : trade_.orders) {
      if (first.budget == trade_.orders.front().budget) {
        name(first.order);
        add_areas(first.order);
      }
    }
    return std::move(rows_);
  }

 private:
  void name(const TriedOrder& order) {
    row_.scheduler = order.scheduler;
    row_.traversal = order.traversal;
  }

  void add(const std::string& measure, const char* unit, const char* reference,
           const char* statistic, const Estimate& estimate, bool by_clock = false) {
    TradeRow row = row_;
    row.measure = measure;
    row.unit = unit;
    row.reference = reference;
    row.set(statistic, estimate);
    row.by_clock = by_clock;
    rows_.push_back(std::move(row));
  }

  void add_mean(const char* measure, const char* unit, const char* reference,
                const std::vector<double>& values) {
    add(measure, unit, reference, "mean", mean_over(values));
  }

  void add_steps() {
    const std::vector<SampledStep>& steps = trade_.steps;
    add_mean("pairs", "1", "", each(steps, [](const auto& step) { return step.pairs; }));
    add_mean("finest_work", "unit", "",
             each(steps, [](const auto& step) { return step.finest_work; }));
    for (const auto& [measure, error] : kErrors) {
      add_mean(measure, "arcmin", "roots",
               each(steps, [error = error](const auto& step) { return step.at_roots.*error; }));
      add_mean(measure, "arcmin", "finest",
               each(steps, [error = error](const auto& step) { return step.at_finest.*error; }));
    }
  }

  void add_errors(const OrderedCrowd& ordered) {
    for (const auto& [measure, error] : kErrors) {
      const auto left =
          each(ordered.steps, [error = error](const auto& step) { return step.left.*error; });
      const auto roots =
          each(trade_.steps, [error = error](const auto& step) { return step.at_roots.*error; });
      add_mean(measure, "arcmin", "", left);
      add(measure, "1", "roots", "share", ratio_of_sums(left, roots));
      add_removed(measure, error, {&ordered});
    }
  }

  /// Of one budget, or of all of them.
  void add_removed(const char* measure, ErrorOf error,
                   const std::vector<const OrderedCrowd*>& budgets) {
    const std::string removed_name = std::string(measure) + "_removed";
    std::vector<double> removed;
    std::vector<double> work;
    for (const OrderedCrowd* ordered : budgets) {
      add_to(removed, each(ordered->steps, [&](const auto& step) { return step.removed.*error; }));
      add_to(work, each(ordered->steps, [](const auto& step) {
               return static_cast<double>(step.work) / kThousand;
             }));
    }
    add(removed_name, "arcmin/1000", "", "ratio", ratio_of_sums(removed, work));
    for (const Reference& reference : kReferences) {
      std::vector<double> as_much;
      for (const OrderedCrowd* ordered : budgets) {
        add_to(as_much, each(ordered->steps,
                             [&](const auto& step) { return step.*reference.removed.*error; }));
      }
      add(removed_name, "1", reference.name, "ratio", ratio_of_sums(removed, as_much));
    }
  }

  void add_areas(const TriedOrder& order) {
    std::vector<const OrderedCrowd*> budgets;
    for (const OrderedCrowd& ordered : trade_.orders) {
      if (ordered.order.scheduler == order.scheduler &&
          ordered.order.traversal == order.traversal) {
        budgets.push_back(&ordered);
      }
    }
    for (const auto& [measure, error] : kErrors) {
      add_removed(measure, error, budgets);
    }
  }

  void add_costs(const OrderedCrowd& ordered) {
    add_mean("work", "unit", "", each(ordered.steps, [](const auto& step) { return step.work; }));
    add_mean("contacts", "1", "",
             each(ordered.steps, [](const auto& step) { return step.contacts; }));
    const auto energy = each(ordered.steps, [](const auto& step) { return step.energy_change; });
    Estimate most;
    most.n = static_cast<std::int64_t>(energy.size());
    if (!energy.empty()) {
      most.value = *std::max_element(energy.begin(), energy.end());
    }
    add("energy_change", "1", "before", "greatest", most);
    const auto us = each(ordered.steps,
                         [](const auto& step) { return static_cast<double>(step.ns) / kNsPerUs; });
    add("time", "us", "", "median", quantile_of(us, 0.5), /*by_clock=*/true);
    add("time", "us", "", "p99", quantile_of(us, 0.99), /*by_clock=*/true);
  }

  const CrowdTrade& trade_;
  TradeRow row_;  ///< what the next rows have in common
  std::vector<TradeRow> rows_;
};

}  // namespace

std::vector<TradeRow> crowd_rows(const CrowdTrade& trade, const std::string& subject) {
  return Rows(trade, subject).all();
}

}  // namespace impetus::inline trade
