// SPDX-License-Identifier: MIT
#include "experiments/commands/power/given_words.hpp"

#include <filesystem>
#include <system_error>
#include <vector>

namespace impetus::inline commands {
namespace {

/// Where the program is, so that the command works wherever the folder is seen.
std::string this_program() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "impetus" : program.string();
}

/// The values in one word where the option takes them so: "20,30".
std::vector<std::string> words_of_values(const CLI::Option& option) {
  const std::vector<std::string>& values = option.results();
  if (option.get_delimiter() == '\0') {
    return values;
  }
  std::string word;
  for (const std::string& value : values) {
    word += (word.empty() ? "" : std::string(1, option.get_delimiter())) + value;
  }
  return {word};
}

std::string option_words(const CLI::Option& option) {
  std::string name = option.get_positional() ? "" : " " + option.get_name();
  if (option.get_items_expected_max() == 0) {
    return name;  // a flag
  }
  std::string words;
  for (const std::string& value : words_of_values(option)) {
    words += name + " " + shell_word(value);
  }
  return words;
}

}  // namespace

std::string shell_word(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-+=./,:@%") == std::string::npos;
  if (plain) {
    return word;
  }
  std::string quoted = "'";
  for (const char letter : word) {
    quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return quoted + "'";
}

std::string given_words(const CLI::App& command, const std::set<std::string>& without) {
  std::string words = shell_word(this_program()) + " " + command.get_name();
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() > 0 && without.count(option->get_name()) == 0) {
      words += option_words(*option);
    }
  }
  return words;
}

}  // namespace impetus::inline commands
