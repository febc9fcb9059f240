// SPDX-License-Identifier: MIT
#include "experiments/commands/machine_name.hpp"

#include <sys/utsname.h>

namespace impetus {

std::string machine_name() {
  utsname names{};
  uname(&names);
  return std::string(names.sysname) + " " + names.release + " " + names.machine;
}

}  // namespace impetus
