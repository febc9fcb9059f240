// The pages round a calibration of the gaze, and when the gaze was lost.
// SPDX-License-Identifier: MIT
#pragma once

#include "experiments/record/page.hpp"
#include "experiments/record/record.hpp"

namespace impetus::inline session {

inline constexpr std::size_t kStopChoice = 1;  ///< of calibration_not_passed()

/// Before the points. `by_pointer`: the mouse pointer stands in for the eye.
Page calibration_intro(bool by_pointer, const SessionProgress& progress);

/// What the validation found, in words and as a map: go on, or once more.
Page calibration_results(const CalibrationRecord& validation, const ScreenGeometry& screen,
                         const SessionProgress& progress);

/// The same after the last try: the experimenter decides.
Page calibration_not_passed(const CalibrationRecord& validation, const ScreenGeometry& screen,
                            const SessionProgress& progress);

/// A drift check was worse than its limit: calibrated anew.
Page gaze_has_drifted(const CalibrationRecord& check, const SessionProgress& progress);

/// Too much of the gaze was lost, and the trial is shown again.
Page gaze_was_lost_page(double lost_share, bool by_pointer, const SessionProgress& progress);

/// What is said before a drift check, at the end of a break.
inline constexpr const char* kLookAtTheMiddle =
    "When you go on, a point appears in the middle of the screen. Please look at it until it is "
    "gone.";
inline constexpr const char* kPointAtTheMiddle =
    "When you go on, a point appears in the middle of the screen. Please keep the mouse pointer on "
    "it until it is gone.";

}  // namespace impetus::inline session
