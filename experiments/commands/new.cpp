// `impetus new`: a study of one's own in a new folder, from a few answers, that runs at once.
//
//   options, or answers on the terminal ─> protocol.json, scene.json, observer.json, protocol.md
//
// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
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

/// Writes a study that is called `name` and reads it again. Throws InputError.
void write_study(const WholeFolder& folder, const std::string& name, const StudyChoices& choices) {
  const std::map<std::string, std::string> files = make_study(choices);
  try {
    for (const auto& [file, text] : files) {
      write_output_file(folder.path() / file, text);
    }
    write_page(folder.path());
  } catch (const InputError& error) {
    throw InputError(as_asked(error.what(), folder.path(), name) + "; nothing was written");
  }
}

/// Asks on a terminal for what no option says. What leads to no study is said at once, and asked
/// again.
class Dialog {
 public:
  explicit Dialog(const NewOptions& options) : options_(options), asks_(isatty(STDIN_FILENO) != 0) {
    choices_.name = fs::path(options.folder).filename().string();
    begin(study_templates().front().name);
  }

  StudyChoices choices() {
    if (asks_) {
      check();
    }
    choose(options_.language, "The participants' language", "en",
           [this](const std::string& given) { choices_.language = given; });
    choose(options_.study_template, template_words(), study_templates().front().name,
           [this](const std::string& given) { begin(given); });
    choose_factors();
    choose_question();
    return choices_;
  }

 private:
  using Take = std::function<void(const std::string& given)>;

  /// Takes what was given; else, on a terminal, what is answered until it leads to a study; else
  /// the default.
  void choose(const std::string& given, const std::string& words, const std::string& otherwise,
              const Take& take) {
    if (!given.empty() || !asks_) {
      take(given.empty() ? otherwise : given);
      if (asks_) {
        check();
      }
      return;
    }
    std::string line;
    do {
      std::printf("%s [%s]: ", words.c_str(), otherwise.c_str());
      std::fflush(stdout);
      line.clear();
      asks_ = static_cast<bool>(std::getline(std::cin, line));
    } while (!is_taken(line.empty() ? otherwise : line, take) && asks_);
  }

  /// Throws InputError where the choices so far, with defaults for the others, are no study.
  void check() const {
    const WholeFolder tried(options_.folder, FolderCheck(refuse_what_exists));
    write_study(tried, options_.folder, choices_);
  }

  bool is_taken(const std::string& given, const Take& take) {
    const StudyChoices before = choices_;
    try {
      take(given);
      check();
      return true;
    } catch (const InputError& error) {
      if (!asks_) {
        throw;
      }
      std::printf("%s\n", error.what());
      choices_ = before;
      return false;
    }
  }

  static std::string template_words() {
    std::string words = "What is shown?\n";
    for (const StudyTemplate& each : study_templates()) {
      words += "  " + each.name + ": " + each.words + "\n";
    }
    return words + "Template";
  }

  /// A template with its own first factor and question, until others are chosen.
  void begin(const std::string& name) {
    choices_.study_template = name;
    choices_.ask = offered_questions(name, choices_.language).front().name;
    choices_.vary = {offered_factors().front()};
  }

  [[nodiscard]] std::vector<std::string> offered_factors() const {
    for (const StudyTemplate& each : study_templates()) {
      if (each.name == choices_.study_template) {
        return each.offered;
      }
    }
    return {""};  // offered_questions() has refused it
  }

  void choose_factors() {
    const std::vector<std::string> offered = offered_factors();
    if (!options_.vary.empty()) {
      choices_.vary = options_.vary;
      if (asks_) {
        check();
      }
      return;
    }
    choose("",
           "What is varied? " + listed(offered) +
               ";\none or two of them, with levels: NAME=LEVEL,LEVEL NAME=LEVEL,LEVEL",
           offered.front(), [this](const std::string& given) {
             std::istringstream words(given);
             choices_.vary = {std::istream_iterator<std::string>(words), {}};
           });
  }

  /// What is asked, in which words, and how levels are chosen for it.
  void choose_question() {
    const std::vector<OfferedQuestion> offered =
        offered_questions(choices_.study_template, choices_.language);
    choose(options_.ask, "What is asked? " + listed(offered, &OfferedQuestion::name),
           offered.front().name, [this](const std::string& given) { choices_.ask = given; });
    choices_.question = options_.question;
    choices_.levels = options_.levels.empty() ? "all" : options_.levels;
    for (const OfferedQuestion& each : offered) {
      if (each.name == choices_.ask && !each.words.empty()) {
        choose(options_.question, "The question's words", each.words,
               [this](const std::string& given) { choices_.question = given; });
      }
      if (each.name == choices_.ask && each.detects && (!asks_ || has_levels_to_choose_from())) {
        choose(options_.levels,
               "Which levels are shown? all of them equally often; or chosen by the answers: "
               "staircase, quest",
               "all", [this](const std::string& given) { choices_.levels = given; });
      }
    }
  }

  /// Whether a staircase has a scale of levels to move on.
  [[nodiscard]] bool has_levels_to_choose_from() const {
    StudyChoices chosen = choices_;
    chosen.levels = "staircase";
    try {
      make_study(chosen);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  const NewOptions& options_;
  bool asks_;
  StudyChoices choices_;
};

int make_new_study(const NewOptions& given) {
  NewOptions options = given;
  while (options.folder.size() > 1 && options.folder.back() == '/') {
    options.folder.pop_back();
  }
  if (options.folder.empty()) {
    throw InputError("expected a name for the new study, got an empty one");
  }
  if (fs::exists(options.folder)) {
    refuse_what_exists(options.folder);
  }
  const StudyChoices choices = Dialog(options).choices();
  WholeFolder folder(options.folder, FolderCheck(refuse_what_exists));
  write_study(folder, options.folder, choices);
  folder.put_in_place();
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
  const auto [command, options] =
      add_command<NewOptions>(app, chosen, make_new_study, "new",
                              "A study of one's own in a new folder; asks for what no option says");
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
}

}  // namespace impetus::inline commands
