// One sitting as BIDS has it: what its files are called, when its clock begins, its screen. Names
// are labels of letters and digits alone, for what may be called anything.
// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace impetus::inline exports {

/// Gives each name a label of its own: the name without all but ASCII letters and digits. Where
/// that is nothing, or was given already, capitals apart, a number follows.
class BidsLabels {
 public:
  std::string label_for(std::string_view name);

 private:
  std::set<std::string> given_;  ///< in small letters: many file systems know no others
};

/// By the rows' `id`, in the order of ids.
struct BidsNames {
  std::map<std::int64_t, std::string> participants;  ///< "P01" of sub-P01
  std::map<std::int64_t, std::string> tasks;         ///< "gapthresholds" of task-gapthresholds
};

/// Throws StoreError.
BidsNames bids_names(SQLite::Database& database);

/// A session of a participant, in one task.
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
