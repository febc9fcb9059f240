// SPDX-License-Identifier: MIT
#include "experiments/models/building_watch.hpp"

#include <utility>

namespace impetus::inline models {
namespace {

Progress& present() {
  static Progress heard;
  return heard;
}

}  // namespace

BuildingWatch::BuildingWatch(Progress heard) { present() = std::move(heard); }

BuildingWatch::~BuildingWatch() { present() = {}; }

const Progress& BuildingWatch::heard() { return present(); }

}  // namespace impetus::inline models
