// SPDX-License-Identifier: MIT
#include "experiments/commands/trading/trade_figure.hpp"

#include "experiments/commands/r_program.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/trade/embedded_trade_script.hpp"

namespace impetus::inline commands {

std::string draw_trade_figure(const std::filesystem::path& folder) {
  const std::string script = (folder / "trade.R").string();
  const std::string table = (folder / "trade.csv").string();
  write_whole_file(script, kTradeScriptText);
  const std::string by_hand = "Rscript " + script + " " + table;
  const std::filesystem::path figure = folder / "trade.svg";
  std::filesystem::remove(figure);
  const int status = run_r_script({script, table});
  if (status == 0 && std::filesystem::exists(figure)) {
    return "figure: " + figure.string() + ", " + (folder / "trade.pdf").string();
  }
  const std::string missing = status == kNoRscript ? "Rscript is missing" : "Rscript failed";
  return "no figure: " + missing + "; with R and ggplot2 (apt-get install r-cran-ggplot2), " +
         by_hand + " draws it";
}

}  // namespace impetus::inline commands
