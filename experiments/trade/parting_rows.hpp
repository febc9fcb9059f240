// When trials part from their reference, as rows of the table.
//
//   first_parting, half_parted   seconds; median over the starts, with its interval; an empty value
//                                when it is not reached by the trial's end
//   not_parted                   share of the starts without any parted body at the end
//   together                     share of the bodies at the end, mean over the starts
//
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiments/trade/parting.hpp"
#include "experiments/trade/trade_row.hpp"

namespace impetus::inline trade {

/// `subject` is the scene's name.
std::vector<TradeRow> parting_rows(const std::vector<PartedTrials>& partings,
                                   const std::string& subject);

}  // namespace impetus::inline trade
