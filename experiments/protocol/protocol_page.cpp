// SPDX-License-Identifier: MIT
#include "experiments/protocol/protocol_page.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "experiments/design/between_participants.hpp"
#include "experiments/languages/language_file.hpp"
#include "experiments/protocol/checks/protocol_checks.hpp"
#include "experiments/protocol/design_words.hpp"
#include "experiments/protocol/expected_length.hpp"
#include "experiments/questions/question_order.hpp"
#include "experiments/questions/two_interval.hpp"
#include "experiments/scenes/scene.hpp"
#include "experiments/tables/number_text.hpp"
#include "experiments/tables/plain_text.hpp"

namespace impetus::inline protocol {
namespace {

using nlohmann::json;

std::string number_words(double value) { return design::to_text(LevelValue{value}); }

std::string heading(const std::string& words) { return "\n## " + words + "\n\n"; }

std::string table_row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) {
    line += " " + cell + " |";
  }
  return line + "\n";
}

std::string table_head(const std::vector<std::string>& names) {
  return table_row(names) + table_row(std::vector<std::string>(names.size(), "---"));
}

/// Whether it lies where the studies that come with the program do, which have R scripts.
bool is_shipped(const Protocol& protocol) {
  return std::filesystem::path(protocol.document.name).parent_path().filename() == "protocols";
}

/// The name of its file, as code.
std::string file_code(const Protocol& protocol) {
  return is_shipped(protocol)
             ? "`" + protocol.name + ".json`"
             : markdown_code(std::filesystem::path(protocol.document.name).filename().string());
}

std::string summary(const Protocol& protocol, const Plan& plan) {
  const auto practice = protocol.design.practice.size();
  const auto main = std::count_if(plan.begin(), plan.end(), [](const PlannedTrial& trial) {
    return trial.phase == TrialPhase::kMain;
  });
  std::string words = count_of(main, "trial");
  if (!protocol.has_participants) {
    return words +
           ", simulated without a display: nobody takes part. Everything below is read "
           "from " +
           file_code(protocol) + " and its scene; a change there changes the study.\n";
  }
  if (practice > 0) {
    words += " after " + std::to_string(practice) + " of practice";
  }
  const auto adaptors = std::count_if(plan.begin(), plan.end(),
                                      [](const PlannedTrial& trial) { return !trial.is_asked(); });
  if (adaptors > 0) {
    words += ", among " + std::to_string(adaptors) + " of adaptation";
  }
  return words + ", about " + number_words(std::ceil(expected_minutes(protocol, plan))) +
         " minutes. Everything below is read from " + file_code(protocol) +
         " and its scene; a change there changes the study.\n";
}

std::string factors(const Protocol& protocol) {
  std::string page = heading("What is varied");
  page += table_head({"factor", "levels", "meaning", "value of the scene"});
  for (const Factor& factor : protocol.design.factors) {
    page += table_row({"`" + factor.name + "`", markdown_text(level_list(factor)),
                       markdown_text(factor.label), markdown_code(changed_by(factor))});
  }
  return page;
}

std::string order(const Protocol& protocol) {
  std::string page = heading("How trials are ordered");
  for (const std::string& line : design_lines(protocol.design, markdown_text)) {
    page += "- " + line + "\n";
  }
  const bool has_groups = groups(protocol.design).size() > 1;
  return page + "- Order and seeds follow from the protocol's name, the participant's code" +
         (has_groups ? ", the group" : "") +
         " and the session's seed alone; they are stored before the first trial.\n";
}

/// The order in which questions are told: a random one as kinds are listed.
std::vector<std::size_t> listed_order(Script script) {
  script.question_order.is_drawn = false;
  return order_of_questions(script, 0);
}

/// "500 ms", or "500 to 1500 ms, drawn for each stimulus".
std::string span_words(const FixationTime& cross) {
  return number_words(cross.least_ms) +
         (cross.is_drawn() ? " to " + number_words(cross.most_ms) + " ms, drawn for each stimulus"
                           : " ms");
}

/// What of the scene is not shown moving: "; still for the first 2 s; then hidden, though ...".
std::string showing_words(const Scene& scene) {
  const ShowingSettings& showing = scene.showing;
  return (showing.still_s > 0.0
              ? "; still for the first " + number_words(showing.still_s) + " s" +
                    (showing.flashing ? ", in which what is asked about flashes" : "")
              : "") +
         (showing.hidden_after_s ? std::string("; hidden then, though the scene would go on") : "");
}

/// By which keys and how soon it is to be answered, where the protocol says so.
std::string answering_words(const Question& question, const Design& design) {
  std::string words;
  for (const std::string& key : question.keys()) {
    words += (words.empty() ? "; by the keys " : ", ") + markdown_text(key);
  }
  for (const Factor& factor : design.factors) {
    if (factor.keys_of == question.kind().protocol_key) {
      words = "; by the keys that `" + factor.name + "` says";
    }
  }
  return words + (question.timeout_ms() > 0.0
                      ? "; at most " + number_words(question.timeout_ms()) + " ms to answer"
                      : "");
}

std::string trial(const Protocol& protocol) {
  const Script& script = protocol.script;
  const StimulusLength length = stimulus_length(protocol);
  std::string page = heading("One trial");
  page += table_head({"for", "what"});
  page += table_row({"at least " + number_words(script.timing.interval_ms) + " ms",
                     "blank; the trial before is saved"});
  page += table_row({span_words(script.timing.fixation), "fixation cross"});
  const TwoIntervalQuestion* two = find_two_interval(script);
  std::string what = two != nullptr ? "two stimuli in random order, one with " +
                                          markdown_text(condition_words(two->standard_levels())) +
                                          "; " + number_words(two->between_ms()) +
                                          " ms between them, and the cross again"
                                    : "the stimulus";
  what += showing_words(Scene(protocol.scene.value));
  std::string questions;
  for (const std::size_t place : listed_order(script)) {
    const auto& question = script.asked[place];
    const std::string words = question->explanation(markdown_text);
    if (question->kind().during_stimulus) {
      what += "; " + words;
    } else {
      questions += table_row({"then", words + answering_words(*question, protocol.design)});
    }
  }
  if (script.gaze) {
    what += "; the gaze is followed";
  }
  const std::string span =
      length.shortest_s == length.longest_s
          ? number_words(length.longest_s) + " s"
          : number_words(length.shortest_s) + " to " + number_words(length.longest_s) + " s";
  if (script.question_order.is_drawn) {
    questions += table_row({"", "the questions come in an order that is drawn for each trial"});
  }
  const char* least = protocol.scene.value.contains("goal") ? "at most " : "";
  return page + table_row({least + span, what}) + questions;
}

std::string markers(const MarkerCodes& codes) {
  std::string page = heading("What is marked for another recorder") + table_head({"event", "code"});
  for (std::size_t i = 0; i < kMarkedEvents.size(); ++i) {
    if (const auto code = codes.of(static_cast<MarkedEvent>(i))) {
      page += table_row({std::string(kMarkedEvents[i]), std::to_string(*code)});
    }
  }
  return page;
}

/// Where no factor says otherwise.
std::string sound(const json& said) {
  const auto number = [&](const char* key, double otherwise) {
    return number_words(said.value(key, otherwise));
  };
  const std::string kind = said["kind"].get<std::string>();
  std::string page = heading("What is heard") + "Where no factor says otherwise, " +
                     (kind == "none"   ? "nothing is heard"
                      : kind == "tone" ? "a tone of " + number("frequency_hz", 1000.0) +
                                             " Hz for " + number("duration_ms", 100.0) + " ms"
                      : kind == "file" ? "`" + said.value("file", "") + "`"
                                       : "a sound as of struck " + kind);
  page += said.contains("at_s") ? ", " + number("at_s", 0.0) + " s after onset"
          : said.value("every_contact", false)
              ? ", at each contact, louder or softer by its impulse"
              : ", at the first contact";
  return page + "; " + number("lag_ms", 0.0) +
         " ms after the flip that shows it (below 0: before). When each onset was intended and "
         "when "
         "it left the sound device is recorded.\n";
}

std::string gaze(const GazeTask& task) {
  std::string page = heading("How the gaze is followed");
  if (task.calibration) {
    const CalibrationTask& calibration = *task.calibration;
    page +=
        "- Calibrated by nine points before practice, then validated; repeated when the mean "
        "distance is above " +
        number_words(calibration.accuracy_limit_deg) + "°, " +
        std::to_string(calibration.most_tries) +
        " times at most, then the experimenter decides. At breaks one point is checked: above " +
        number_words(calibration.drift_limit_deg) + "° it is calibrated again." +
        (calibration.show_accuracy ? " Participants are told the distances.\n" : "\n");
  }
  if (task.loss.policy != GazeLossRule::Policy::kKeep) {
    const bool repeated = task.loss.policy == GazeLossRule::Policy::kRepeat;
    page += "- A trial in which the gaze was lost for more than " +
            number_words(100.0 * task.loss.most_lost_share) + " % of the stimulus is " +
            (repeated ? "shown again, " + std::to_string(task.loss.most_repeats) +
                            " times at most, then kept and marked.\n"
                      : "marked.\n");
  }
  page += "- Imposed latency: " + number_words(task.extra_latency_ms) +
          " ms, and what the scene adds.\n";
  if (task.yoked_to) {
    page +=
        "- Recorded regions follow the gaze of another participant: " +
        markdown_text(task.yoked_to->participant) +
        (task.yoked_to->protocol.empty() ? "" : " in " + markdown_text(task.yoked_to->protocol)) +
        ".\n";
  }
  return page;
}

/// What is solved before the plan is stored, as the file asks for it.
std::string solved(const json& document) {
  if (!document.contains("solve")) {
    return "";
  }
  return heading("What is solved before the plan is stored") + "```json\n" +
         document["solve"].dump(2) + "\n```\n";
}

std::string quoted(const Text& text) {
  std::string page = "**" + markdown_text(text.title) + "**\n\n";
  for (const std::string& paragraph : text.paragraphs) {
    page += "> " + markdown_text(paragraph) + "\n>\n";
  }
  return text.paragraphs.empty() ? page : page.substr(0, page.size() - 2) + "\n";
}

std::string resuming(const Script& script) {
  const bool block = script.resume.at == ResumeRule::At::kBlock;
  std::string page = heading("When a session is left");
  page += block ? "It goes on at the start of the block that was begun; the trials of that block "
                  "which were done are kept, set aside, and shown again."
                : "It goes on at the next trial.";
  if (script.resume.refuse_after_h > 0.0) {
    page += " More than " + number_words(script.resume.refuse_after_h) +
            " hours after anything was last recorded it is refused.";
  }
  return page + " Instructions are shown again" +
         (script.gaze && script.gaze->calibration ? ", and the gaze is calibrated anew" : "") +
         ".\n";
}

std::string left_out(const ExclusionRules& rules) {
  std::string page;
  for (const std::string& line : exclusion_lines(rules)) {
    page += "- " + line + "\n";
  }
  return page.empty() ? page : heading("Who is left out of the analysis") + "Whoever\n\n" + page;
}

/// Of what the protocol does not say: in which language, and what it says in place of that.
std::string language_words(const Protocol& protocol) {
  const std::string& title = protocol.script.language.title();
  std::string page = title == english().title()
                         ? ""
                         : "Buttons, hints and all else that is not quoted here are in " +
                               markdown_text(title) + ".\n\n";
  const json texts = protocol.document.value.value("texts", json::object());
  for (auto text = texts.begin(); text != texts.end(); ++text) {
    const auto words = text.value().get<std::string>();
    page += "- " + markdown_code(text.key()) +
            (words.empty() ? " is switched off" : ": “" + markdown_text(words) + "”") + "\n";
  }
  return texts.empty() ? page : page + "\n";
}

/// What is asked before the first trial, and what may be answered.
std::string told_before(const std::vector<Field>& demographics) {
  std::string page;
  for (const Field& field : demographics) {
    std::string values = field.kind == Field::Kind::kText ? "in own words" : "";
    if (field.kind == Field::Kind::kNumber) {
      values = field.has_range()
                   ? number_words(field.minimum) + " to " + number_words(field.maximum)
                   : "a number";
    }
    for (const std::string& option : field.options) {
      values += (values.empty() ? "" : ", ") + markdown_text(option);
    }
    page += "- “" + markdown_text(field.label) + "”: " + values + "\n";
  }
  return page.empty() ? page : "Asked then:\n\n" + page + "\n";
}

std::string words_shown(const Protocol& protocol) {
  const Script& script = protocol.script;
  std::string page = heading("What the participant reads") + language_words(protocol);
  page += quoted(script.welcome) + quoted(script.consent);
  page += "Agreed to, or not: “" + markdown_text(script.consent_statement) + "”\n\n";
  page += told_before(script.demographics);
  for (const Text& text : script.instructions) {
    page += quoted(text);
  }
  for (const Demonstration& demonstration : script.demonstrations) {
    page += quoted(demonstration.text);
  }
  if (script.break_every > 0) {
    page += "Every " + std::to_string(script.break_every) + " trials: " + quoted(script.break_text);
  } else if (breaks_after_blocks(script)) {
    page += "After each block: " + quoted(script.break_text);
  }
  for (const FreeQuestion& question : script.questions) {
    page += "At the end: “" + markdown_text(question.text) + "”\n\n";
  }
  return page + quoted(script.thanks);
}

std::string scene(const Protocol& protocol) {
  const json& value = protocol.scene.value;
  std::string page = heading("The scene");
  page += markdown_text(value["title"].get<std::string>());
  if (value.contains("source")) {
    page += " (" + markdown_text(value["source"].get<std::string>()) + ")";
  }
  page += ".\n\nThe engine, where no factor changes it:\n\n```json\n";
  return page + value["engine"].dump(2) + "\n```\n";
}

std::string recorded(const Protocol& protocol) {
  std::string page = heading("What is recorded");
  page += "Plan, seeds, every step's input and hash, every collision with its level and place";
  if (protocol.script.asked.empty()) {
    return page + ".\n";
  }
  page += ", every frame's flip";
  page += protocol.script.gaze ? ", every gaze sample" : "";
  page += "; and:\n\n" + table_head({"response", "when", "values"});
  for (const auto& question : protocol.script.asked) {
    const ResponseKind& kind = question->kind();
    std::string values =
        kind.table == "response" ? "`answer`, `positive`, `correct`, `timed_out`, `device`" : "";
    for (const DeclaredValue& value : kind.recorded) {
      values += (values.empty() ? "`" : ", `") + value.name + "`";
    }
    page += table_row({kind.name, kind.when, values});
  }
  return page;
}

constexpr const char* kPrintedP =
    "\nOf each test the report prints its own p and, by name, the one corrected after Holm "
    "within "
    "its family of tests; what it says to be found rests on the corrected one.\n";

std::string commands(const Protocol& protocol) {
  const bool people = protocol.has_participants;
  if (!is_shipped(protocol)) {
    return heading("How to run it") + "In the folder of this file:\n\n```sh\nimpetus run " +
           file_name_text(std::filesystem::path(protocol.document.name).stem().string()) +
           ".json --db study.sqlite" + (people ? " --participant P01" : "") +
           "\nimpetus replay study.sqlite\nimpetus report study.sqlite --out report/\n```\n" +
           (people ? kPrintedP : "");
  }
  return heading("How to run it") + "```sh\nbuild/impetus run protocols/" + protocol.name +
         ".json --db study.sqlite" + (people ? " --participant P01" : "") +
         "\nbuild/impetus replay study.sqlite\n"
         "build/impetus report study.sqlite --out report/\n```\n" +
         (people ? kPrintedP : "");
}

}  // namespace

std::string protocol_page(const Protocol& protocol) {
  const Plan plan = plan_for(protocol, "P01", 1);
  std::string page = "# " + markdown_text(protocol.title) + "\n\n";
  const json& document = protocol.document.value;
  if (document.contains("source")) {
    page += markdown_text(document["source"].get<std::string>()) + ".\n\n";
  }
  page += summary(protocol, plan) + factors(protocol) + order(protocol);
  if (protocol.has_participants) {
    page += trial(protocol);
    page += protocol.script.gaze ? gaze(*protocol.script.gaze) : "";
    page += protocol.script.markers ? markers(*protocol.script.markers) : "";
    const json& scene = protocol.scene.value;
    page += scene.contains("sound") ? sound(scene["sound"]) : "";
    page += resuming(protocol.script) + left_out(protocol.exclude_when) + words_shown(protocol);
  }
  return page + solved(document) + scene(protocol) + recorded(protocol) + commands(protocol);
}

}  // namespace impetus::inline protocol
