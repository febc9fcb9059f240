// A library that is loaded when it is first used, so that nobody needs it who does not use it.
// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace impetus::inline connections {

/// It is not on this machine, or another than was expected; what() says it in words.
class NoSuchLibrary : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Stays loaded until the program ends.
class LoadedLibrary {
 public:
  /// The first of these names that there is. Throws NoSuchLibrary.
  explicit LoadedLibrary(const std::vector<std::string>& names);

  /// Throws NoSuchLibrary where it has no function of this name.
  template <typename Function>
  void find(const char* name, Function& function) const {
    function = reinterpret_cast<Function>(address_of(name));
  }

 private:
  [[nodiscard]] void* address_of(const char* name) const;

  void* library_{nullptr};
  std::string name_;
};

}  // namespace impetus::inline connections
