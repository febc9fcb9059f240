// SPDX-License-Identifier: MIT
#include "experiments/power/process_mark.hpp"

#include <unistd.h>

#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace impetus::inline power {
namespace {

/// Of the machine, since it was last switched on.
std::string boot_id() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(file, id);
  return id;
}

/// When a process began, in ticks since the machine was switched on; "" where it does not run.
std::string start_of(const std::string& process) {
  std::ifstream file("/proc/" + process + "/stat");
  const std::string stat{std::istreambuf_iterator<char>(file), {}};
  const std::size_t name_end = stat.rfind(')');  // a name may hold spaces and parentheses
  if (name_end == std::string::npos) {
    return "";
  }
  constexpr int kWordsAfterName = 20;  // proc(5): the name is the 2nd, the start the 22nd
  std::istringstream words(stat.substr(name_end + 1));
  std::string word;
  for (int i = 0; i < kWordsAfterName; ++i) {
    words >> word;
  }
  return word;
}

std::string mark_of(const std::string& process) {
  return boot_id() + ":" + process + ":" + start_of(process);
}

}  // namespace

std::string mark_of_this_process() { return mark_of(std::to_string(getpid())); }

bool is_process_mark(const std::string& words) {
  static const std::regex kMark("[0-9a-f-]*:[0-9]+:[0-9]*");
  return std::regex_match(words, kMark);
}

bool still_runs(const std::string& mark) {
  const std::size_t first = mark.find(':');
  const std::size_t last = mark.rfind(':');
  if (first == last) {
    return false;
  }
  const std::string process = mark.substr(first + 1, last - first - 1);
  return process.find_first_not_of("0123456789") == std::string::npos &&
         !start_of(process).empty() && mark == mark_of(process);
}

}  // namespace impetus::inline power
