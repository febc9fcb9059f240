// Files of recorded gaze: a table with a line of names, separated by commas, tabs or semicolons.
//
//   time    time_s, time_ms, time_us, stimulus_time_s (`impetus export`)
//                                        from the stimulus's onset
//           TIMESTAMP (EyeLink, ms), gaze_timestamp (Pupil, s), Recording timestamp [ms] or [µs]
//           (Tobii)                      of the tracker's clock: from the trial's first sample
//   place   x_deg, x_px, x_m, x_share, and y; AVERAGE_, LEFT_ or RIGHT_GAZE_X (EyeLink),
//           norm_pos_x (Pupil), Gaze point X (Tobii)
//   lost    valid (1 or true counts; 0, false or nothing does not), loss (nothing counts;
//           blink, off screen or lost does not), confidence (Pupil, from .6 to 1 counts),
//           Validity left (Tobii, Valid or 0 counts; Invalid, 1 to 4 or nothing does not);
//           and where a place is nothing
//   trial   trial, trial_id, TRIAL_INDEX numbers or names; lines of one stand together
//
// Nothing is an empty cell, ".", "NA", "n/a", "NaN" or "-NaN"; small and capital letters are the
// same in words. A number has a decimal point. Times are within a day of the onset or of the
// trial's first, places that count within a million; what is none of all this is refused.
//
// Of a file that Impetus exported, lines of completed main trials count, and no others.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "experiments/gaze/recorded_eye.hpp"

namespace impetus::inline files {

/// Throws InputError: a file that cannot be read or is no table (see table_lines.hpp), a line of
/// names without time or place, with two units at once or a name twice, a time that goes back, and
/// each cell of these columns that says none of the above.
GazeRecording load_gaze_recording(const std::filesystem::path& file);

}  // namespace impetus::inline files
