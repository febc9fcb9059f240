// SPDX-License-Identifier: MIT
#include "experiments/connections/loaded_library.hpp"

#include <dlfcn.h>

namespace impetus::inline connections {

LoadedLibrary::LoadedLibrary(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    library_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    name_ = name;
    if (library_ != nullptr) {
      return;
    }
  }
  throw NoSuchLibrary(names.front() + " is not installed");
}

void* LoadedLibrary::address_of(const char* name) const {
  void* found = dlsym(library_, name);
  if (found == nullptr) {
    throw NoSuchLibrary(name_ + " has no " + name);
  }
  return found;
}

}  // namespace impetus::inline connections
