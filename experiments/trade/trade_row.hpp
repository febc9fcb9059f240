// What `impetus trade` measured, one number a row: long and tidy, for any tool that reads CSV.
//
// Rows by the clock differ from run to run; all others follow from the scene, the options and the
// seed alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "experiments/trade/estimate.hpp"

namespace impetus::inline trade {

/// One statistic of one measure under one setting. Texts that do not apply are empty, numbers that
/// do not apply are absent.
struct TradeRow : Estimate {
  std::string part;     ///< "scene", "impacts", "crowd", "cut", "parting"
  std::string subject;  ///< what it was measured on: "creature x creature", the scene
  std::string kind;     ///< of tree: tree_kind_names()
  std::optional<int> level{};
  std::string reduction;  ///< of contacts: reduction_names()
  std::string scheduler;
  std::string traversal;                 ///< as in a scene: "depth-first", ...
  std::string phase;                     ///< of a step, that is cut: kCutPhases
  std::optional<std::int64_t> budget{};  ///< units of work a step; absent: unlimited
  std::string measure;                   ///< such as "normal_error"
  std::string unit;                      ///< such as "deg"; "1" of counts and shares
  std::string reference;                 ///< what an error is against: "exact", "finest", ...
  std::string statistic;                 ///< "median", "p95", "p99", "share", "mean", ...
  bool by_clock{false};                  ///< a time, or what follows from times

  /// The statistic and what was found for it.
  void set(const std::string& name, const Estimate& found) {
    statistic = name;
    static_cast<Estimate&>(*this) = found;
  }
};

/// The rows as CSV (RFC 4180) with a line of names first; numbers to nine digits, the same
/// whatever the user's language.
std::string csv_of(const std::vector<TradeRow>& rows);

}  // namespace impetus::inline trade
