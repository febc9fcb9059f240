// A choice in words: "within 4 ms, oriented boxes to level 3 with grouped averages: ...".
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/trade/trade_option.hpp"

namespace impetus::inline trade {

/// "oriented boxes to level 3 with grouped averages"
std::string words_for(const TradeOption& option);

/// "median normal error 6°, 95 % of gaps below 9 minutes of arc"
std::string error_words(const TradeOption& option);

/// To two digits, as people write numbers: 0.012, 6.3, 140; "?" when it is not finite.
std::string two_digits(double value);

/// The same, or "< 0.1" of what is less than `least`.
std::string two_digits_from(double least, double value);

}  // namespace impetus::inline trade
