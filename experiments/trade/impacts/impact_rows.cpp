// SPDX-License-Identifier: MIT
#include "experiments/trade/impacts/impact_rows.hpp"

#include <algorithm>

#include "experiments/trade/estimate.hpp"

namespace impetus::inline trade {
namespace {

/// Fills the columns that rows share, and takes the rows that are made of them.
class RowMaker {
 public:
  RowMaker(TradeRow shared, std::vector<TradeRow>& rows)
      : shared_(std::move(shared)), rows_(rows) {}

  RowMaker& of(const char* measure, const char* unit, const char* reference, bool by_clock) {
    shared_.measure = measure;
    shared_.unit = unit;
    shared_.reference = reference;
    shared_.by_clock = by_clock;
    return *this;
  }

  RowMaker& add(const char* statistic, const Estimate& estimate) {
    TradeRow& row = rows_.emplace_back(shared_);
    row.set(statistic, estimate);
    return *this;
  }

 private:
  TradeRow shared_;
  std::vector<TradeRow>& rows_;
};

TradeRow row_of(const ImpactMeasures& measures, TreeKind kind, int level) {
  TradeRow row;
  row.part = "impacts";
  row.subject = measures.subject;
  row.kind = name_of(kind);
  row.level = level;
  return row;
}

void add_bounds(const ImpactMeasures& measures, const BoundsMeasures& bounds,
                std::vector<TradeRow>& rows) {
  RowMaker maker(row_of(measures, bounds.kind, bounds.level), rows);
  const auto add = [&](const char* measure, const char* unit, const char* reference,
                       const std::vector<double>& values, const char* high, double p) {
    maker.of(measure, unit, reference, false)
        .add("median", quantile_of(values, 0.5))
        .add(high, quantile_of(values, p));
  };
  add("tests", "1", "", bounds.tests, "p99", 0.99);
  add("overlaps", "1", "", bounds.overlaps, "p99", 0.99);
  maker.of("descent_time", "us", "", true)
      .add("mean", mean_of(bounds.refine_us))
      .add("median", quantile_of(bounds.refine_us, 0.5))
      .add("p99", quantile_of(bounds.refine_us, 0.99));
  Estimate bytes;
  bytes.n = 1;
  bytes.value = bounds.bytes;
  maker.of("memory", "B", "", false).add("total", bytes);
  const auto impacts = static_cast<std::int64_t>(bounds.tests.size());
  maker.of("missed", "1", "exact", false).add("share", share_of(bounds.missed, impacts));
  maker.of("false_collisions", "1", "exact", false)
      .add("share", share_of(bounds.false_collisions, bounds.collisions));
  add("gap", "1", "exact", bounds.gaps, "p95", 0.95);
  add("gap_seen", "arcmin", "exact", bounds.gaps_arcmin, "p95", 0.95);
}

void add_errors(const ErrorSamples& errors, const char* reference, bool spins, RowMaker& maker) {
  const auto add = [&](const char* measure, const char* unit, const std::vector<double>& values) {
    maker.of(measure, unit, reference, false)
        .add("median", quantile_of(values, 0.5))
        .add("p95", quantile_of(values, 0.95));
  };
  add("normal_error", "deg", errors.normal_deg);
  add("point_error", "1", errors.point);
  add("linear_error", "1", errors.linear);
  if (spins) {
    add("angular_error", "1", errors.angular);
  }
}

void add_contacts(const ImpactMeasures& measures, const ContactMeasures& contacts,
                  std::vector<TradeRow>& rows) {
  TradeRow row = row_of(measures, contacts.kind, contacts.level);
  row.reduction = contacts.reduction;
  RowMaker maker(row, rows);
  maker.of("contacts", "1", "", false).add("median", quantile_of(contacts.contacts, 0.5));
  maker.of("pair_time", "us", "", true)
      .add("mean", mean_of(contacts.pair_us))
      .add("median", quantile_of(contacts.pair_us, 0.5))
      .add("p99", quantile_of(contacts.pair_us, 0.99));
  add_errors(contacts.exact, "exact", measures.spins, maker);
  add_errors(contacts.finest, "finest", measures.spins, maker);
}

void append(const std::vector<double>& from, std::vector<double>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

void append(const ErrorSamples& from, ErrorSamples& to) {
  append(from.normal_deg, to.normal_deg);
  append(from.point, to.point);
  append(from.linear, to.linear);
  append(from.angular, to.angular);
}

void append(const BoundsMeasures& from, BoundsMeasures& to) {
  to.bytes += from.bytes;
  append(from.tests, to.tests);
  append(from.overlaps, to.overlaps);
  append(from.refine_us, to.refine_us);
  to.missed += from.missed;
  to.collisions += from.collisions;
  to.false_collisions += from.false_collisions;
  append(from.gaps, to.gaps);
  append(from.gaps_arcmin, to.gaps_arcmin);
}

void append(const ContactMeasures& from, ContactMeasures& to) {
  append(from.contacts, to.contacts);
  append(from.pair_us, to.pair_us);
  append(from.exact, to.exact);
  append(from.finest, to.finest);
}

/// Adds to the one of `to` for which `is_same` says so, or as a new one.
template <typename Measures, typename IsSame>
void append_each(const std::vector<Measures>& from, std::vector<Measures>& to,
                 const IsSame& is_same) {
  for (const Measures& each : from) {
    const auto same =
        std::find_if(to.begin(), to.end(), [&](const Measures& x) { return is_same(x, each); });
    if (same == to.end()) {
      to.push_back(each);
    } else {
      append(each, *same);
    }
  }
}

}  // namespace

std::vector<TradeRow> impact_rows(const ImpactMeasures& measures) {
  std::vector<TradeRow> rows;
  for (const BoundsMeasures& bounds : measures.bounds) {
    add_bounds(measures, bounds, rows);
  }
  for (const ContactMeasures& contacts : measures.contacts) {
    add_contacts(measures, contacts, rows);
  }
  return rows;
}

ImpactMeasures pooled(const std::vector<ImpactMeasures>& measures, const std::string& name) {
  ImpactMeasures all;
  all.subject = name;
  all.spins = false;
  for (const ImpactMeasures& each : measures) {
    all.spins = all.spins || each.spins;
    all.approaches += each.approaches;
    all.touching += each.touching;
    append_each(each.bounds, all.bounds, [](const BoundsMeasures& x, const BoundsMeasures& y) {
      return x.kind == y.kind && x.level == y.level;
    });
    append_each(each.contacts, all.contacts,
                [](const ContactMeasures& x, const ContactMeasures& y) {
                  return x.kind == y.kind && x.level == y.level && x.reduction == y.reduction;
                });
  }
  return all;
}

}  // namespace impetus::inline trade
