// The limits of a random spin, from what accurate collisions of the same bodies do.
//
//   start turned and shifted a little ──accurate collision──> change of angular velocity
//   so many of them, each component sorted ──> a low and a high percentile, for each body
//
// (Dingliana 2002, sec. 6.2.2: "between two limits that were chosen by inspecting the values
// generated for a series of accurate collisions")
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/protocol/solved_values.hpp"

namespace impetus::inline protocol {

/// What an entry of this kind says beside what each kind does.
RowList<SolveEntry> spin_limits_rows();

/// Throws InputError when fewer starts than asked for lead to a collision, of twice as many.
std::vector<SolvedValue> solve_spin_limits(const SolveTask& task, ShapeLibrary& shapes,
                                           const Progress& progress);

/// The value below which `percent` of the values lie, linear between neighbours (Hyndman and Fan
/// 1996, type 7). `values` has at least one.
double percentile(std::vector<double> values, double percent);

}  // namespace impetus::inline protocol
