// Files of recorded gaze: a table with a line of names, separated by commas, tabs or semicolons.
//
//   time    time_s, time_ms, time_us, stimulus_time_s (`impetus export`)
//                                        from the stimulus's onset
//           TIMESTAMP (EyeLink, ms), gaze_timestamp (Pupil, s), Recording timestamp [ms] or [µs]
//           (Tobii)                      of the tracker's clock: from the trial's first sample
//   place   x_deg, x_px, x_m, x_share, and y; AVERAGE_, LEFT_ or RIGHT_GAZE_X (EyeLink),
//           norm_pos_x (Pupil), Gaze point X (Tobii)
//   lost    valid (1 or 0), loss (empty: none), confidence (Pupil, from .6 on), Validity left
//           (Tobii); and where a place is empty, ".", "NA" or no number
//   trial   trial, trial_id, TRIAL_INDEX numbers or names; lines of one stand together
//
// Of a file that Impetus exported, lines of completed main trials count, and no others.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/gaze/recorded_eye.hpp"

namespace impetus::inline files {

/// Throws InputError: a file that cannot be read, a line of names without time or place, two units
/// at once, a time that is no number or goes back.
GazeRecording load_gaze_recording(const std::filesystem::path& file);

}  // namespace impetus::inline files
