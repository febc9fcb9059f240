// SPDX-License-Identifier: MIT
#include "experiments/session/calibration_pages.hpp"

#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "experiments/questions/session_pages.hpp"

namespace impetus::inline session {
namespace {

std::string degrees_text(const std::optional<double>& value_deg) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f°", value_deg.value_or(0.0));
  return value_deg ? text : "unknown";
}

std::string percent(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

/// Short ones: a line that is broken is broken after the points of its numbers, too.
std::vector<std::string> accuracy_words(const CalibrationRecord& record) {
  if (!record.accuracy_deg) {
    return {"No gaze was found at any of the points."};
  }
  return {"Your gaze was " + degrees_text(record.accuracy_deg) + " from the points on average; " +
              degrees_text(record.accuracy_limit_deg) + " is allowed.",
          "It was " + degrees_text(record.worst_accuracy_deg) + " from the worst one."};
}

std::int64_t unseen_in(const CalibrationRecord& record) {
  std::int64_t count = 0;
  for (const CalibrationPointRecord& point : record.points) {
    count += point.gaze ? 0 : 1;
  }
  return count;
}

std::vector<std::string> quality_words(const CalibrationRecord& record) {
  std::string samples = percent(record.lost_share) + " of the samples were lost";
  if (record.sampling_hz) {
    samples += "; " + std::to_string(std::lround(*record.sampling_hz)) + " came per second";
  }
  return {"It moved by " + degrees_text(record.precision_rms_deg) + " from sample to sample, by " +
              degrees_text(record.precision_sd_deg) + " about its mean.",
          samples + " (" + record.gaze_source + ")."};
}

PointMap map_of(const CalibrationRecord& record, const ScreenGeometry& screen) {
  PointMap map;
  map.aspect = screen.width_m / screen.height_m;
  for (const CalibrationPointRecord& point : record.points) {
    const ScreenPoint gaze = point.gaze.value_or(ScreenPoint{});
    map.points.push_back({point.shown.x_m / screen.width_m, point.shown.y_m / screen.height_m,
                          point.gaze.has_value(), gaze.x_m / screen.width_m,
                          gaze.y_m / screen.height_m});
  }
  return map;
}

Page with_results(const std::string& title, const CalibrationRecord& validation,
                  const ScreenGeometry& screen, const SessionProgress& progress) {
  Page page = text_page({title, accuracy_words(validation)}, progress);
  const std::int64_t unseen = unseen_in(validation);
  if (unseen > 0 && validation.accuracy_deg) {
    page.paragraphs.push_back("At " + std::to_string(unseen) +
                              (unseen == 1 ? " point" : " points") + " there was no gaze at all.");
  }
  if (validation.accuracy_deg) {
    for (std::string& words : quality_words(validation)) {
      page.paragraphs.push_back(std::move(words));
    }
  }
  page.point_map = map_of(validation, screen);
  return page;
}

}  // namespace

Page calibration_intro(bool by_pointer, const SessionProgress& progress) {
  if (by_pointer) {
    return text_page({"Where you point",
                      {"The mouse pointer stands in for your eyes in this study, so it must be "
                       "where you look.",
                       "Points appear one after the other, twice nine of them. Move the pointer "
                       "onto each as soon as you see it, and keep it there until the next one."}},
                     progress);
  }
  return text_page({"Where you look",
                    {"Now the eye tracker learns where you look.",
                     "Points appear one after the other, twice nine of them. Look at the middle of "
                     "each until it is gone. Please keep your head still."}},
                   progress);
}

Page calibration_results(const CalibrationRecord& validation, const ScreenGeometry& screen,
                         const SessionProgress& progress) {
  if (validation.passed) {
    return with_results("That went well", validation, screen, progress);
  }
  Page page = with_results("Once more, please", validation, screen, progress);
  page.choices = {{"Try again", "space"}};
  return page;
}

Page calibration_not_passed(const CalibrationRecord& validation, const ScreenGeometry& screen,
                            const SessionProgress& progress) {
  Page page = with_results("Your gaze is not known well enough", validation, screen, progress);
  page.paragraphs.emplace_back(
      "Please call the experimenter, who decides whether the study goes on.");
  page.choices = {{"Go on with the study", "g"}, {"Stop here", "s"}};
  return page;
}

Page gaze_has_drifted(const CalibrationRecord& check, const SessionProgress& progress) {
  const std::string found = check.accuracy_deg
                                ? "Your gaze was found " + degrees_text(check.accuracy_deg) +
                                      " from the point in the middle; at most " +
                                      degrees_text(check.accuracy_limit_deg) + " is allowed."
                                : "No gaze was found at the point in the middle.";
  return text_page({"Let us look at the points again", {found}}, progress);
}

Page gaze_was_lost_page(double lost_share, bool by_pointer, const SessionProgress& progress) {
  return text_page(
      {"That one is shown once more",
       {"For " + percent(lost_share) +
            " of the time it was not known where you looked. That happens, and it is no fault of "
            "yours.",
        by_pointer ? "Please keep the mouse pointer on the screen while you watch."
                   : "Please keep looking at the screen while you watch; blink as you always do."}},
      progress);
}

}  // namespace impetus::inline session
