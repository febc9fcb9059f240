# How well the gaze was calibrated, one row per participant.
#
#   gaze_calibration ─> calibrations and tries, what the correction moved, what validation and drift
#                       checks left
#
# Accuracy is the mean distance from gaze to point in degrees: of a calibration before its correction
# is made, of a validation and a drift check after it. The correction is the affine map of screen
# metres that the session's last calibration gave; it takes what calibration found and leaves what
# validation finds.
# SPDX-License-Identifier: MIT

calibration_quality <- function(study) {
  each_row(sort(unique(as.character(study$trials$participant))), function(who) {
    calibration_quality_of(who, study$calibrations[study$calibrations$participant == who, ])
  })
}

calibration_quality_of <- function(who, rows) {
  of <- function(kind) rows[rows$kind == kind, ]
  last <- function(x) if (length(x) > 0) x[length(x)] else NA_real_
  largest <- function(x) if (all(is.na(x))) NA_real_ else max(x, na.rm = TRUE)
  calibrations <- of("calibration")
  validations <- of("validation")
  drifts <- of("drift check")
  data.frame(participant = who, calibrations = nrow(calibrations),
    accuracy_before_deg = last(calibrations$accuracy_deg),
    shift_mm = last(1000 * sqrt(calibrations$correction_x0_m^2 + calibrations$correction_y0_m^2)),
    stretch = last(pmax(abs(calibrations$correction_xx - 1), abs(calibrations$correction_yy - 1))),
    validation_accuracy_deg = last(validations$accuracy_deg),
    validation_worst_deg = last(validations$worst_accuracy_deg),
    validation_precision_rms_deg = last(validations$precision_rms_deg),
    drift_checks = nrow(drifts), drift_largest_deg = largest(drifts$accuracy_deg),
    not_passed = sum(rows$passed == 0, na.rm = TRUE))
}

# Nothing is said of a study without any calibration, as one with the mouse may be.
calibration_sentences <- function(table) {
  never <- table$participant[table$calibrations == 0]
  known <- table$validation_accuracy_deg[!is.na(table$validation_accuracy_deg)]
  if (all(table$calibrations == 0)) return("The gaze was never calibrated.")
  c(
    if (length(known) > 0) sprintf(
      "Accuracy of the gaze when last validated, after correction: mean %.2f°, worst participant %.2f°.",
      mean(known), max(known)),
    if (length(never) > 0) sprintf("Never calibrated: %s.", and_words(as_typed(never))),
    if (sum(table$not_passed) > 0) sprintf("%s over the protocol's limit, of %s.",
      paste(count_of(sum(table$not_passed), "calibration, validation or drift check"),
        if (sum(table$not_passed) == 1) "was" else "were"),
      and_words(as_typed(table$participant[table$not_passed > 0])))
  )
}

calibration_section <- function(table) {
  if (all(table$calibrations == 0)) return(character())
  table$participant <- as_typed(table$participant)
  table$stretch <- 100 * table$stretch
  c(
    markdown_of(table, c(participant = "%s", calibrations = "%d", accuracy_before_deg = "%.2f",
      shift_mm = "%.1f", stretch = "%.1f", validation_accuracy_deg = "%.2f",
      validation_worst_deg = "%.2f", validation_precision_rms_deg = "%.3f", drift_checks = "%d",
      drift_largest_deg = "%.2f", not_passed = "%d"),
      c("participant", "calibrations", "accuracy before correction (°)", "shift (mm)",
        "stretch (%)", "validation: accuracy (°)", "worst point (°)", "precision, RMS (°)",
        "drift checks", "largest drift (°)", "not passed")),
    "", paste("Accuracy: mean distance from gaze to point. Shift and stretch: of the correction that",
      "the last calibration made, at the screen's centre and the larger of the two axes'. Validation:",
      "the last one, after it."), "")
}
