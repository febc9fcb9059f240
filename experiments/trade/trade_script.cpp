// SPDX-License-Identifier: MIT
#include "experiments/trade/trade_script.hpp"

#include "experiments/trade/embedded_trade_script.hpp"

namespace impetus::inline trade {

std::string_view trade_script() { return kTradeScriptText; }

}  // namespace impetus::inline trade
