// SPDX-License-Identifier: MIT
#include "experiments/provenance/machine_name.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "experiments/tables/number_text.hpp"

namespace impetus::inline provenance {
namespace {

/// What a file of "key separator value" lines says of the key, without quotation marks; "":
/// nothing.
std::string value_in(const char* file, const std::string& key, char separator) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find(separator);
    if (at == std::string::npos || line.compare(0, key.size(), key) != 0) {
      continue;
    }
    const std::size_t first = line.find_first_not_of(" \t\"", at + 1);
    const std::size_t last = line.find_last_not_of(" \t\"");
    return first == std::string::npos ? "" : line.substr(first, last + 1 - first);
  }
  return "";
}

/// "8 cores, 31.2 GiB".
std::string size_of_machine() {
  constexpr double kGiB = 1024.0 * 1024.0 * 1024.0;
  const double bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  return printed("%ld cores, %.1f GiB", sysconf(_SC_NPROCESSORS_ONLN), bytes / kGiB);
}

}  // namespace

std::string machine_name() {
  utsname names{};
  uname(&names);
  const std::string system = value_in("/etc/os-release", "PRETTY_NAME", '=');
  const std::string processor = value_in("/proc/cpuinfo", "model name", ':');
  return (system.empty() ? "" : system + ", ") + names.sysname + " " + names.release + " " +
         names.machine + ", " + (processor.empty() ? "" : processor + ", ") + size_of_machine();
}

}  // namespace impetus::inline provenance
