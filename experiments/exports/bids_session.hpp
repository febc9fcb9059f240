// One sitting as BIDS has it: what its files are called, when its clock begins, its screen.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiments/exports/bids_labels.hpp"

namespace impetus::inline exports {

struct BidsSession {
  std::int64_t id{0};
  std::int64_t protocol_id{0};
  std::string folder;       ///< "sub-P01/ses-01/beh/"
  std::string stem;         ///< "sub-P01_ses-01_task-causality"
  std::string task_name;    ///< of which the task's label holds the letters and digits
  std::string stimulus;     ///< the scene's file within stimuli/
  std::string gaze_source;  ///< "": the gaze was not followed
  bool has_clock{false};    ///< whether anything was shown or sampled
  std::int64_t zero_ns{
      0};  ///< first instant of the sitting that was recorded: second 0 of its files
  double screen_width_m{0.0};
  double screen_height_m{0.0};
  std::int64_t screen_width_px{0};
  std::int64_t screen_height_px{0};
  nlohmann::ordered_json presentation;  ///< StimulusPresentation
};

/// All of the study, by participant; the numbers of `ses` count each one's from 1. Throws
/// StoreError.
std::vector<BidsSession> bids_sessions(SQLite::Database& database, const BidsNames& names);

/// The scene's file within stimuli/.
std::string bids_scene_file(const std::string& task);

}  // namespace impetus::inline exports
