// `impetus extremes`: what the engine promises at the extremes, and what it does on this machine.
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/extremes/extreme_cases.hpp"
#include "experiments/models/atomic_file.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/provenance/machine_name.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline commands {
namespace {

using nlohmann::json;

/// What `impetus extremes` was asked for.
struct ExtremesOptions {
  bool quick{false};
  bool takes_long{false};
  std::string only;
  std::string json_file;
};

/// Whether a case is asked for: by the beginning of its name or of its family's.
bool is_chosen(const ExtremeCase& extreme, const std::string& only) {
  return extreme.name.starts_with(only) || extreme.family.starts_with(only);
}

std::vector<ExtremeCase> chosen_cases(const std::string& only) {
  std::vector<ExtremeCase> chosen;
  std::string names;
  for (const ExtremeCase& extreme : extreme_cases()) {
    if (is_chosen(extreme, only)) {
      chosen.push_back(extreme);
    }
    names += (names.empty() ? "" : ", ") + extreme.name;
  }
  if (chosen.empty()) {
    throw InputError("--only: expected the beginning of one of the cases " + names + ", got " +
                     only);
  }
  return chosen;
}

std::string with_unit(double number, const std::string& unit) {
  return printed("%.3g%s%s", number, unit.empty() ? "" : " ", unit.c_str());
}

/// The figures of one case, a promise a line.
void print_case(const ExtremeCase& extreme, const std::vector<ExtremeResult>& results,
                double took_s) {
  for (std::size_t i = 0; i < results.size(); ++i) {
    const ExtremePromise& promise = extreme.promises[i];
    const ExtremeResult& result = results[i];
    const std::string took = i == 0 ? printed("%.1f s", took_s) : "";
    std::printf("  %-19s %-10s %-10s %-8s %7s  %s", i == 0 ? extreme.name.c_str() : "",
                with_unit(result.measured, promise.unit).c_str(),
                with_unit(promise.at_most, promise.unit).c_str(), result.kept ? "kept" : "NOT KEPT",
                took.c_str(), promise.sentence.c_str());
    if (!result.kept && !result.worst_at.empty()) {
      std::printf(" (at %s)", result.worst_at.c_str());
    }
    std::printf("\n");
  }
  std::fflush(stdout);
}

json as_json(const ExtremeCase& extreme, const std::vector<ExtremeResult>& results, double took_s) {
  json promises = json::array();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const ExtremePromise& promise = extreme.promises[i];
    promises.push_back({{"promise", promise.sentence},
                        {"at_most", promise.at_most},
                        {"unit", promise.unit},
                        {"measured", results[i].measured},  // null when it is no number
                        {"worst_at", results[i].worst_at},
                        {"kept", results[i].kept}});
  }
  return {{"family", extreme.family},
          {"case", extreme.name},
          {"took_s", took_s},
          {"promises", std::move(promises)}};
}

Length length_of(const ExtremesOptions& options) {
  return options.quick ? Length::kQuick : options.takes_long ? Length::kLong : Length::kUsual;
}

int ask_extremes(const ExtremesOptions& options) {
  using Seconds = std::chrono::duration<double>;
  const std::vector<ExtremeCase> cases = chosen_cases(options.only);
  require_new_file(options.json_file);
  json report{{"build", build_name()}, {"machine", machine_name()}, {"cases", json::array()}};
  std::printf("%s\n%s\n\n  %-19s %-10s %-10s\n", build_name(), machine_name().c_str(), "case",
              "measured", "at most");
  std::string family;
  int asked = 0;
  int broken = 0;
  for (const ExtremeCase& extreme : cases) {
    if (extreme.family != family) {
      family = extreme.family;
      std::printf("%s\n", family.c_str());
      std::fflush(stdout);
    }
    const auto start = std::chrono::steady_clock::now();
    std::vector<ExtremeResult> results;
    {
      ProgressLine line("  " + extreme.name);
      results = run_case(extreme, length_of(options), [&](double share) { line.tell(share); });
    }
    const double took_s = Seconds(std::chrono::steady_clock::now() - start).count();
    print_case(extreme, results, took_s);
    report["cases"].push_back(as_json(extreme, results, took_s));
    for (const ExtremeResult& result : results) {
      ++asked;
      broken += result.kept ? 0 : 1;
    }
  }
  std::printf("\n%d promises, %d not kept\n", asked, broken);
  if (!options.json_file.empty()) {
    write_whole_file(options.json_file, report.dump(2) + "\n");
  }
  return broken == 0 ? kDone : kFound;
}

}  // namespace

void add_extremes(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<ExtremesOptions>(
      app, chosen, ask_extremes, "extremes",
      "Run the engine at its extremes: what is promised, and what is measured here");
  CLI::Option* quick =
      command->add_flag("--quick", options->quick, "A quarter of a minute instead of half");
  command
      ->add_flag("--long", options->takes_long,
                 "Also what takes long: 1e7 steps of one body, 1e6 of a crowd")
      ->excludes(quick);
  command->add_option("--only", options->only, "Cases or families whose names begin so");
  command->add_option("--json", options->json_file, "Write the table into this file as well");
}

}  // namespace impetus::inline commands
