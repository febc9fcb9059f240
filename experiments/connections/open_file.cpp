// SPDX-License-Identifier: MIT
#include "experiments/connections/open_file.hpp"

#include <unistd.h>

namespace impetus::inline connections {

void OpenFile::close() {
  if (file_ >= 0) {
    ::close(file_);
    file_ = -1;
  }
}

}  // namespace impetus::inline connections
