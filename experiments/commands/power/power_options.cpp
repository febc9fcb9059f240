// SPDX-License-Identifier: MIT
#include "experiments/commands/power/power_options.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "experiments/commands/named_observer.hpp"
#include "experiments/commands/running/chosen_screen.hpp"
#include "experiments/commands/sentences.hpp"
#include "experiments/commands/shipped_file.hpp"
#include "experiments/questions/response_kinds.hpp"

namespace impetus::inline commands {
namespace {

using nlohmann::json;

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
  const Factor* factor = find_factor(protocol.design, name);
  if (factor == nullptr) {
    throw InputError(option + ": expected a factor of " + protocol.document.name + " (" +
                     listed(protocol.design.factors, &Factor::name) + "), got " + name);
  }
  return *factor;
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
  const std::optional<Adaptive>& adaptive = protocol.design.adaptive;
  const std::vector<Factor>& factors = protocol.design.factors;
  if (adaptive && std::none_of(factors.begin(), factors.end(), [&](const Factor& factor) {
        return factor.name != adaptive->factor && factor.levels.size() > 1;
      })) {
    refuse(protocol.document, "/design/factors",
           "expected a factor beside " + json_text(adaptive->factor) +
               ", between whose levels thresholds can be compared, got none");
  }
  for (const std::string& name : options.factors) {
    if (factor_named(protocol, "--factor", name).levels.size() < 2) {
      throw InputError("--factor: expected a factor that varies, got " + name + ", of one level");
    }
  }
  return options.factors;
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

PowerQuestion question_of(const RunPart& part, const PowerOptions& options,
                          const std::string& response, const std::optional<ObserverFile>& without) {
  PowerQuestion question;
  question.protocol = part.protocol.name;
  question.protocol_hash = part.protocol.hash;
  question.observer = part.lab.observer->document.value.dump();
  question.null_observer = without ? without->document.value.dump() : "";
  question.screen = screen_json(screen_without_window(options.screen_file));
  question.response = response;
  question.model = options.model;
  question.factors = tested_factors(part.protocol, options).dump();
  question.compared = compared_levels(part.protocol, options.compared).dump();
  question.seed = options.seed;
  return question;
}

}  // namespace

std::string screen_json(const ScreenGeometry& screen) {
  const json words{{"width_m", screen.width_m},
                   {"height_m", screen.height_m},
                   {"width_px", screen.width_px},
                   {"height_px", screen.height_px},
                   {"distance_m", screen.viewing_distance_m}};
  return words.dump();
}

RunOptions simulated_run(const std::string& protocol, const std::string& observer,
                         bool allow_rounding) {
  if (read_json(protocol).value.contains("participants")) {
    throw InputError(protocol + ": expected a protocol with participants, got one without");
  }
  RunOptions run;
  run.protocol = protocol;
  run.observers = {observer};
  run.participant = "S01";
  run.allow_rounding = allow_rounding;
  return run;
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
  command.add_option(
      "--screen", options.screen_file,
      "The lab's screen file, for simulated participants to look at (default: an assumed screen)");
  command
      .add_option("--out", options.out,
                  "The folder of the ledger and the results; the same one goes on, and may be "
                  "shared by several processes of one machine")
      ->capture_default_str();
  add_chunk_options(
      command, options,
      "In so many pieces, each a command of its own on any machine that sees the folder; alone, "
      "reads them together once all are done");
}

PowerTask task_of(const PowerOptions& options) {
  PowerTask task;
  task.run = simulated_run(options.protocol, options.observer, options.allow_rounding);
  task.run.screen_file = options.screen_file;
  task.planted = part_from(options.protocol, options.observer, task.run);
  const std::string response = response_of(task.planted.protocol, options.response);
  task.without = null_observer_of(task.planted, options, response);
  task.question = question_of(task.planted, options, response, task.without);
  task.request = request_of(options, task.without.has_value());
  if (options.chunks > 0) {
    require_chunks(options, options.chunks, task.request.studies + task.request.null_studies);
    task.request.chunk = {std::max<std::int64_t>(options.chunk, 1), options.chunks};
  }
  return task;
}

}  // namespace impetus::inline commands
