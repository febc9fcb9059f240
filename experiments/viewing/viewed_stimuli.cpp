// SPDX-License-Identifier: MIT
#include "experiments/viewing/viewed_stimuli.hpp"

namespace impetus::inline viewing {

std::string picture_name(const PictureOf& picture,
                         const std::function<bool(const std::string&)>& taken) {
  std::string stem = picture.study + "-trial" + std::to_string(picture.trial);
  stem += picture.attempt > 1 ? "-attempt" + std::to_string(picture.attempt) : "";
  stem += picture.interval > 1 ? "-interval" + std::to_string(picture.interval) : "";
  stem += "-step" + std::to_string(picture.step);
  std::string name = stem + ".png";
  for (int number = 2; taken(name); ++number) {
    name = stem + "-" + std::to_string(number) + ".png";
  }
  return name;
}

}  // namespace impetus::inline viewing
