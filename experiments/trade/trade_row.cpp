// SPDX-License-Identifier: MIT
#include "experiments/trade/trade_row.hpp"

#include "experiments/tables/csv_line.hpp"

namespace impetus::inline trade {
namespace {

std::string line_of(const TradeRow& row) {
  return csv_line({row.part, row.subject, row.kind, row.level ? std::to_string(*row.level) : "",
                   row.reduction, row.scheduler, row.traversal, row.phase,
                   row.budget ? std::to_string(*row.budget) : "", row.measure, row.unit,
                   row.reference, row.statistic, std::to_string(row.n), csv_number(row.value),
                   csv_number(row.low), csv_number(row.high), row.by_clock ? "true" : "false"});
}

}  // namespace

std::string csv_of(const std::vector<TradeRow>& rows) {
  std::string text = csv_line({"part", "subject", "kind", "level", "reduction", "scheduler",
                               "traversal", "phase", "budget", "measure", "unit", "reference",
                               "statistic", "n", "value", "low", "high", "by_clock"});
  for (const TradeRow& row : rows) {
    text += line_of(row);
  }
  return text;
}

}  // namespace impetus::inline trade
