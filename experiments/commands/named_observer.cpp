// SPDX-License-Identifier: MIT
#include "experiments/commands/named_observer.hpp"

#include <cstdio>

#include "experiments/commands/shipped_file.hpp"

namespace impetus::inline commands {

ObserverFile observer_for(const Protocol& protocol, const std::filesystem::path& file,
                          const std::string& name_or_path) {
  const std::string name = "experiments/observers/" + name_or_path + ".json";
  const std::string shipped = shipped_file(name);
  const auto beside = std::filesystem::absolute(file).parent_path().parent_path() / name;
  std::error_code ignored;
  const bool is_file = std::filesystem::exists(name_or_path, ignored) &&
                       !std::filesystem::is_directory(name_or_path, ignored);
  const bool is_own = is_file || std::filesystem::exists(beside, ignored) ||
                      !std::filesystem::exists(shipped, ignored);
  ObserverFile observer = load_observer(is_own ? name_or_path : shipped, file);
  check_observer(protocol, observer);
  return observer;
}

void tell_unseen_factors(const Protocol& protocol, const ObserverFile& observer) {
  const std::string sentence = unseen_factors(protocol, observer);
  if (!sentence.empty()) {
    std::fprintf(stderr, "warning: %s\n", sentence.c_str());
  }
}

}  // namespace impetus::inline commands
