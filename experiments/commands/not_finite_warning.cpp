// SPDX-License-Identifier: MIT
#include "experiments/commands/not_finite_warning.hpp"

#include <cstdio>

namespace impetus {

void tell_not_finite(const StudyWriter& writer) {
  if (writer.not_finite_attempts() > 0) {
    std::fprintf(stderr,
                 "warning: in %lld trials the state of a body was no longer a finite number; it "
                 "was taken out, and the study's notes name it\n",
                 static_cast<long long>(writer.not_finite_attempts()));
  }
}

}  // namespace impetus
