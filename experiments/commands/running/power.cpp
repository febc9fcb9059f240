// `impetus power`: how many participants a study needs, from whole simulated studies.
//
//   options ─> a question ─> its ledger ─> simulated studies, tested (power_studies.hpp)
//                              └──────────> Rscript power.R ─> power.html, figure, table
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/named_observer.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/r_program.hpp"
#include "experiments/commands/running/power_studies.hpp"
#include "experiments/commands/running/run_part.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/exports/r_scripts.hpp"
#include "experiments/power/process_mark.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kLedgerName = "power.sqlite";
constexpr const char* kScratch = "simulating-";  ///< and the process's mark

/// What `impetus power` was asked for.
struct PowerOptions {
  std::string protocol;
  std::string observer;
  std::string null_observer;
  bool no_null{false};
  std::vector<std::int64_t> sizes;
  std::int64_t studies{1000};
  std::string model{"means"};
  std::string response;
  std::vector<std::string> factors;
  std::string compared;
  std::int64_t seed{1};
  std::int64_t jobs{0};
  bool allow_rounding{false};
  std::string screen_file;
  std::string out{"power"};
};

/// The response that is tested: the one asked for, or the first that the protocol has.
std::string response_of(const Protocol& protocol, const std::string& wanted) {
  std::vector<std::string> has;
  for (const ResponseKind& kind : listed_kinds()) {
    const std::string& tested = kind.tested_as;
    if (protocol.document.value.contains(kind.protocol_key) && !tested.empty() &&
        std::find(has.begin(), has.end(), tested) == has.end()) {
      has.push_back(tested);
    }
  }
  if (has.empty()) {
    refuse(protocol.document, "", "expected ratings, answers or clicks to test, got none");
  }
  if (wanted.empty()) {
    return has.front();
  }
  if (std::find(has.begin(), has.end(), wanted) == has.end()) {
    throw InputError("--response: expected what " + protocol.document.name + " asks for (" +
                     json(has).dump() + "), got " + wanted);
  }
  return wanted;
}

const Factor& factor_named(const Protocol& protocol, const std::string& option,
                           const std::string& name) {
  std::string names;
  for (const Factor& factor : protocol.design.factors) {
    if (factor.name == name) {
      return factor;
    }
    names += (names.empty() ? "" : ", ") + factor.name;
  }
  throw InputError(option + ": expected a factor of " + protocol.document.name + " (" + names +
                   "), got " + name);
}

/// "scheduling=tracked,random" as ["scheduling", "tracked", "random"]; [] for "".
json compared_levels(const Protocol& protocol, const std::string& words) {
  if (words.empty()) {
    return json::array();
  }
  const std::size_t equals = words.find('=');
  const std::size_t comma = words.find(',', equals == std::string::npos ? 0 : equals);
  if (equals == std::string::npos || comma == std::string::npos) {
    throw InputError("--compare: expected FACTOR=LEVEL,LEVEL, got " + words);
  }
  const Factor& factor = factor_named(protocol, "--compare", words.substr(0, equals));
  json compared{factor.name, words.substr(equals + 1, comma - equals - 1), words.substr(comma + 1)};
  for (std::size_t i = 1; i < compared.size(); ++i) {
    const auto level = compared[i].get<std::string>();
    const bool known = std::any_of(factor.levels.begin(), factor.levels.end(),
                                   [&](const LevelValue& one) { return to_text(one) == level; });
    if (!known || (i == 2 && compared[1] == compared[2])) {
      throw InputError("--compare: expected two levels of " + factor.name + ", got " + level);
    }
  }
  return compared;
}

json tested_factors(const Protocol& protocol, const PowerOptions& options) {
  if (!options.compared.empty() && !options.factors.empty()) {
    throw InputError("--factor: expected either --factor or --compare, got both");
  }
  for (const std::string& name : options.factors) {
    if (factor_named(protocol, "--factor", name).levels.size() < 2) {
      throw InputError("--factor: expected a factor that varies, got " + name + ", of one level");
    }
  }
  return options.factors;
}

std::string words_of(const ScreenGeometry& screen) {
  const json words{{"width_m", screen.width_m},
                   {"height_m", screen.height_m},
                   {"width_px", screen.width_px},
                   {"height_px", screen.height_px},
                   {"distance_m", screen.viewing_distance_m}};
  return words.dump();
}

/// The participant of the studies without an effect; none when it is not known how to make one.
std::optional<ObserverFile> null_observer_of(const RunPart& part, const PowerOptions& options,
                                             const std::string& response) {
  if (options.null_observer.empty()) {
    return without_effect(*part.lab.observer, response);
  }
  return observer_for(part.protocol, options.protocol, options.null_observer);
}

PowerRequest request_of(const PowerOptions& options, bool null_known) {
  PowerRequest request;
  request.sizes = options.sizes;
  std::sort(request.sizes.begin(), request.sizes.end());
  request.sizes.erase(std::unique(request.sizes.begin(), request.sizes.end()), request.sizes.end());
  request.studies = options.studies;
  request.null_studies = null_known && !options.no_null ? options.studies : 0;
  return request;
}

/// Throws InputError unless the folder is new, empty, or one of an earlier power analysis.
void require_power_folder(const fs::path& folder) {
  if (!fs::exists(folder)) {
    return;
  }
  const std::string expected =
      folder.string() + ": expected a new folder, an empty one or an earlier power analysis, got ";
  if (!fs::is_directory(folder)) {
    throw InputError(expected + "a file");
  }
  if (!fs::is_empty(folder) && !fs::exists(folder / kLedgerName)) {
    throw InputError(expected + "one that holds " +
                     fs::directory_iterator(folder)->path().filename().string());
  }
}

/// A folder of this process in `out`; those of processes that were killed are removed.
class Scratch {
 public:
  explicit Scratch(const fs::path& out) : folder_(out / (kScratch + mark_of_this_process())) {
    for (const auto& entry : fs::directory_iterator(out)) {
      const std::string name = entry.path().filename().string();
      if (name.rfind(kScratch, 0) == 0 && !still_runs(name.substr(std::string(kScratch).size()))) {
        std::error_code ignored;  // another process may be at it, too
        fs::remove_all(entry.path(), ignored);
      }
    }
    fs::create_directories(folder_);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

PowerQuestion question_of(const RunPart& part, const PowerOptions& options,
                          const std::string& response, const std::optional<ObserverFile>& without) {
  PowerQuestion question;
  question.protocol = part.protocol.name;
  question.protocol_hash = part.protocol.hash;
  question.observer = part.lab.observer->document.value.dump();
  question.null_observer = without ? without->document.value.dump() : "";
  question.screen = words_of(assumed_screen());
  question.response = response;
  question.model = options.model;
  question.factors = tested_factors(part.protocol, options).dump();
  question.compared = compared_levels(part.protocol, options.compared).dump();
  question.seed = options.seed;
  return question;
}

std::int64_t jobs_of(const PowerOptions& options) {
  const auto cores = static_cast<std::int64_t>(std::thread::hardware_concurrency());
  return std::max<std::int64_t>(1, options.jobs > 0 ? options.jobs : cores);
}

RunOptions run_options_of(const PowerOptions& options) {
  RunOptions run;
  run.protocol = options.protocol;
  run.observers = {options.observer};
  run.participant = "S01";
  run.allow_rounding = options.allow_rounding;
  run.screen_file = options.screen_file;
  return run;
}

void say_what_is_not_simulated(const PowerOptions& options, const std::string& response) {
  if (!options.no_null) {
    std::fprintf(stderr,
                 "note: no type-I error: how this observer's %s would be without the effect is "
                 "not known; --null FILE gives one\n",
                 response == "rating"   ? "ratings"
                 : response == "answer" ? "answers"
                                        : "clicks");
  }
}

int power(const PowerOptions& options) {
  const BuildingLine told;
  require_power_folder(options.out);
  PowerWork work;
  work.run = run_options_of(options);
  const JsonDocument document = read_json(options.protocol);
  if (document.value.contains("participants")) {
    throw InputError(options.protocol + ": expected a protocol with participants, got one without");
  }
  work.planted = part_from(options.protocol, options.observer, work.run);
  const std::string response = response_of(work.planted.protocol, options.response);
  const auto without = null_observer_of(work.planted, options, response);
  const PowerQuestion question = question_of(work.planted, options, response, without);
  fs::create_directories(options.out);
  const Scratch scratch(options.out);
  const fs::path scripts = write_r_scripts(scratch.folder(), {"power-fits.R", "power.R"});
  if (run_needed_r_script({(scripts / "power-fits.R").string(), "--check", options.model}) != 0) {
    return kCouldNotRun;  // R has said why
  }
  work.ledger = fs::path(options.out) / kLedgerName;
  PowerLedger ledger(work.ledger, question);
  if (!without) {
    say_what_is_not_simulated(options, response);
  }
  solve_what_is_asked(work.planted);
  build_shapes(work.planted);
  work.without = work.planted;
  work.without.lab.observer = without ? without : work.planted.lab.observer;
  work.request = request_of(options, without.has_value());
  work.seed = options.seed;
  work.jobs = jobs_of(options);
  work.script = scripts / "power-fits.R";
  work.scratch = scratch.folder();
  do_power_studies(work, ledger);
  const std::string page = (scripts / "power.R").string();
  if (run_needed_r_script({page, work.ledger.string(), "--out", options.out}) != 0) {
    return kCouldNotRun;
  }
  std::printf("%s: open it in a browser\n", (fs::path(options.out) / "power.html").c_str());
  return kDone;
}

void add_options(CLI::App& command, PowerOptions& options) {
  command.add_option("protocol", options.protocol, "Protocol file, such as protocols/gap.json")
      ->required()
      ->transform([](const std::string& name) { return shipped_file(name); });
  command
      .add_option("--observer", options.observer,
                  "The simulated participant in whom the effect is planted: its name or file")
      ->required();
  command.add_option("--n", options.sizes, "Numbers of participants, such as 10,20,30")
      ->required()
      ->delimiter(',')
      ->check(CLI::Range(2, 1000));
  command
      .add_option("--studies", options.studies,
                  "Studies of each number, with the effect and without")
      ->check(CLI::Range(1, 999999))
      ->capture_default_str();
  command
      .add_option("--model", options.model,
                  "means: ANOVA of participants' means; mixed: the mixed model, which takes a "
                  "thousand times as long")
      ->check(CLI::IsMember({"means", "mixed"}))
      ->capture_default_str();
  command
      .add_option("--response", options.response,
                  "What is tested (default: the first of these that the protocol asks for)")
      ->check(CLI::IsMember({"rating", "answer", "clicks"}));
  command.add_option("--factor", options.factors,
                     "Factors that are tested, a family of their own (default: all that vary)");
  command.add_option("--compare", options.compared,
                     "Two levels of a factor and no others, such as scheduling=tracked,random");
  command.add_option("--null", options.null_observer,
                     "The participant for whom the effect is zero (default: for ratings the same "
                     "with \"effect\" 0, for clicks the same who sees nothing)");
  command.add_flag("--no-null", options.no_null, "Leave out the studies without the effect");
  command.add_option("--seed", options.seed, "Of all studies")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  command
      .add_option("--jobs", options.jobs,
                  "So many studies at a time (default: as many as there are cores)")
      ->check(CLI::Range(1, 1000));
  command.add_flag("--allow-rounding", options.allow_rounding, "Round a delay to whole frames");
  command.add_option("--screen", options.screen_file,
                     "The lab's screen file (default: what `impetus screen` saved)");
  command
      .add_option("--out", options.out,
                  "The folder of the ledger and the results; the same one goes on, and may be "
                  "shared by several processes")
      ->capture_default_str();
}

}  // namespace

void add_power(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<PowerOptions>();
  CLI::App* command = app.add_subcommand(
      "power", "How many participants a study needs: whole simulated studies, tested (needs R)");
  add_options(*command, *options);
  command->callback([options, &chosen] { chosen = [options] { return power(*options); }; });
}

}  // namespace impetus::inline commands
