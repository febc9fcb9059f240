// `impetus new`: a study of one's own in a new folder, from a few answers, that runs at once.
//
//   options, or answers on the terminal ─> protocol.json, scene.json, observer.json, protocol.md
//
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

#include "experiments/commands/commands.hpp"
#include "experiments/exports/whole_output.hpp"
#include "experiments/files/protocol_files.hpp"
#include "experiments/protocol/checks/protocol_scene_checks.hpp"
#include "experiments/protocol/new_study.hpp"
#include "experiments/protocol/observer_file.hpp"
#include "experiments/protocol/protocol_page.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

/// What `impetus new` was asked for; what is "" is asked on a terminal, or has its default.
struct NewOptions {
  std::string folder;
  std::string study_template;
  std::vector<std::string> vary;
  std::string ask;
  std::string question;
  std::string language;
  std::string levels;
};

/// What was given; else, on a terminal, what is answered; else the default.
std::string answer(const std::string& given, const std::string& words,
                   const std::string& otherwise) {
  if (!given.empty() || isatty(STDIN_FILENO) == 0) {
    return given.empty() ? otherwise : given;
  }
  std::printf("%s [%s]: ", words.c_str(), otherwise.c_str());
  std::fflush(stdout);
  std::string line;
  std::getline(std::cin, line);
  return line.empty() ? otherwise : line;
}

std::string choose_template(const std::string& given) {
  const std::vector<StudyTemplate> all = study_templates();
  std::string words = "What is shown?\n";
  for (const StudyTemplate& each : all) {
    words += "  " + each.name + ": " + each.words + "\n";
  }
  return answer(given, words + "Template", all.front().name);
}

std::vector<std::string> choose_factors(const std::vector<std::string>& given,
                                        const std::string& study_template) {
  if (!given.empty()) {
    return given;
  }
  for (const StudyTemplate& each : study_templates()) {
    if (each.name == study_template) {
      std::istringstream words(
          answer("",
                 "What is varied? " + listed(each.offered) +
                     ";\none or two of them, with levels: NAME=LEVEL,LEVEL NAME=LEVEL,LEVEL",
                 each.offered.front()));
      return {std::istream_iterator<std::string>(words), {}};
    }
  }
  return {};
}

/// What is asked, in which words, and how levels are chosen for it.
void choose_question(const NewOptions& options, StudyChoices& choices) {
  const std::vector<OfferedQuestion> offered =
      offered_questions(choices.study_template, choices.language);
  std::vector<std::string> names;
  for (const OfferedQuestion& each : offered) {
    names.push_back(each.name);
  }
  choices.ask = answer(options.ask, "What is asked? " + listed(names), names.front());
  choices.question = options.question;
  choices.levels = options.levels.empty() ? "all" : options.levels;
  for (const OfferedQuestion& each : offered) {
    if (each.name == choices.ask && !each.words.empty()) {
      choices.question = answer(options.question, "The question's words", each.words);
    }
    if (each.name == choices.ask && each.detects) {
      choices.levels = answer(options.levels,
                              "Which levels are shown? all of them equally often; or chosen by the "
                              "answers: staircase, quest",
                              "all");
    }
  }
}

StudyChoices choices_from(const NewOptions& options) {
  StudyChoices choices;
  choices.name = fs::path(options.folder).filename().string();
  choices.language = answer(options.language, "The participants' language", "en");
  choices.study_template = choose_template(options.study_template);
  choices.vary = choose_factors(options.vary, choices.study_template);
  choose_question(options, choices);
  return choices;
}

/// Reads what was written as any study is read, so that nothing stays that could not be run.
void write_page(const fs::path& folder) {
  const Protocol protocol = load_protocol(folder / "protocol.json");
  constexpr double kUsualHz = 60.0;
  check_frames(protocol, kUsualHz, /*allow_rounding=*/false);
  check_observer(protocol, load_observer((folder / "observer.json").string(), folder / "x"));
  write_output_file(folder / "protocol.md", protocol_page(protocol));
}

/// The message, with the folder as it would have been called.
std::string as_asked(std::string message, const fs::path& written, const std::string& asked) {
  for (std::size_t at = message.find(written.string()); at != std::string::npos;
       at = message.find(written.string())) {
    message.replace(at, written.string().size(), asked);
  }
  return message;
}

[[noreturn]] void refuse_what_exists(const fs::path& there) {
  throw InputError(there.string() + ": exists already and is not overwritten");
}

void write_study(const NewOptions& options, const std::map<std::string, std::string>& files) {
  WholeFolder folder(options.folder, FolderCheck(refuse_what_exists));
  try {
    for (const auto& [name, text] : files) {
      write_output_file(folder.path() / name, text);
    }
    write_page(folder.path());
  } catch (const InputError& error) {
    throw InputError(as_asked(error.what(), folder.path(), options.folder) +
                     "; nothing was written");
  }
  folder.put_in_place();
}

int make_new_study(NewOptions options) {
  while (options.folder.size() > 1 && options.folder.back() == '/') {
    options.folder.pop_back();
  }
  if (options.folder.empty()) {
    throw InputError("expected a name for the new study, got an empty one");
  }
  if (fs::exists(options.folder)) {
    refuse_what_exists(options.folder);
  }
  write_study(options, make_study(choices_from(options)));
  const std::string at = options.folder + "/";
  std::printf(
      "%s: protocol.json, scene.json, observer.json, and protocol.md, which explains them\n"
      "Try next:\n"
      "  impetus check %sprotocol.json\n"
      "  impetus run %sprotocol.json --db %sstudy.sqlite --observer %sobserver.json "
      "--participants 10\n"
      "  impetus report %sstudy.sqlite --out %sreport/\n",
      options.folder.c_str(), at.c_str(), at.c_str(), at.c_str(), at.c_str(), at.c_str(),
      at.c_str());
  return kDone;
}

}  // namespace

void add_new(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<NewOptions>();
  CLI::App* command = app.add_subcommand(
      "new", "A study of one's own in a new folder; asks for what no option says");
  command
      ->add_option("name", options->folder,
                   "The folder; its name is the protocol's, such as bounce")
      ->required();
  command->add_option("--template", options->study_template, "What is shown, such as two-balls");
  command
      ->add_option("--vary", options->vary,
                   "A factor and its levels, such as restitution=.2,.5,.8; again for another")
      ->allow_extra_args(false);
  command->add_option("--ask", options->ask, "yes-no, detection, rating, two-interval or click");
  command->add_option(
      "--levels", options->levels,
      "all: each is shown equally often (default); staircase or quest: those of the "
      "first factor are chosen by what the participant answered");
  command->add_option("--question", options->question, "The question's words");
  command->add_option("--language", options->language,
                      "The participants': ar, de, en, es, fr, pt or zh (default en)");
  command->callback(
      [options, &chosen] { chosen = [options] { return make_new_study(*options); }; });
}

}  // namespace impetus::inline commands
