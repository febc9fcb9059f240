// What a picture of a replay is called as a file.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace impetus::inline viewing {

struct PictureOf {
  std::string study;  ///< the file's name without its folder and ending
  std::int64_t trial{0};
  std::int64_t attempt{1};
  std::int64_t interval{1};
  std::int64_t step{0};
};

/// "study-trial37-step412.png", with the attempt and the interval where they are not the first, and
/// with "-2", "-3", ... for as long as `taken` says that there is one.
std::string picture_name(const PictureOf& picture,
                         const std::function<bool(const std::string&)>& taken);

}  // namespace impetus::inline viewing
