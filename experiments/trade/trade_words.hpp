// A choice in words: "within 4 ms, oriented boxes to level 3 with grouped averages: ...".
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "experiments/trade/trade_option.hpp"

namespace impetus {

/// "oriented boxes to level 3 with grouped averages"
std::string words_for(const TradeOption& option);

/// "median normal error 6°, 95 % of gaps below 9 minutes of arc"
std::string error_words(const TradeOption& option);

/// To two digits, without exponents where people would not write them: 0.012, 6.3, 140.
std::string two_digits(double value);

}  // namespace impetus
