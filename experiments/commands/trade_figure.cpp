// SPDX-License-Identifier: MIT
#include "experiments/commands/trade_figure.hpp"

#include <spawn.h>
#include <sys/wait.h>

#include <vector>

#include "experiments/models/atomic_file.hpp"
#include "experiments/trade/trade_script.hpp"

extern char** environ;

namespace impetus {
namespace {

constexpr int kNoProgram = 127;

/// The exit status of a program on the user's path; 127 when there is none of the name.
int status_of(std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, pointers.front(), nullptr, nullptr, pointers.data(), environ) != 0) {
    return kNoProgram;
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

std::string draw_trade_figure(const std::filesystem::path& folder) {
  const std::string script = (folder / "trade.R").string();
  const std::string table = (folder / "trade.csv").string();
  write_whole_file(script, trade_script());
  const std::string by_hand = "Rscript " + script + " " + table;
  const std::filesystem::path figure = folder / "trade.svg";
  std::filesystem::remove(figure);
  const int status = status_of({"Rscript", "--vanilla", script, table});
  if (status == 0 && std::filesystem::exists(figure)) {
    return "figure: " + figure.string() + ", " + (folder / "trade.pdf").string();
  }
  const std::string missing = status == kNoProgram ? "Rscript is missing" : "Rscript failed";
  return "no figure: " + missing + "; with R and ggplot2 (apt-get install r-cran-ggplot2), " +
         by_hand + " draws it";
}

}  // namespace impetus
