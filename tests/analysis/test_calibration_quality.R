# Calibrations of the gaze, as they were made.
# SPDX-License-Identifier: MIT
library(testthat)

# P1: a calibration that failed, one that did not, a validation, two drift checks. P2: none.
calibrated_study <- function() {
  trials <- gaze_trials(181, participants = 2, repetitions = 1)
  trials$participant <- sub("P0", "P", trials$participant)
  path <- write_gaze_study(tempfile(fileext = ".sqlite"), trials)
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  session <- DBI::dbGetQuery(study,
    "SELECT session FROM rated_trial WHERE participant = 'P1' LIMIT 1")$session
  DBI::dbDisconnect(study)
  add_calibrations(path, data.frame(session_id = session,
    kind = c("calibration", "calibration", "validation", "drift check", "drift check"),
    number = c(1, 2, 1, 1, 1), accuracy_deg = c(1.8, 0.7, 0.2, 0.3, 0.1), passed = c(0, 1, 1, 1, 1),
    worst_accuracy_deg = c(2, 0.9, 0.25, 0.3, 0.1), correction_x0_m = c(NA, 0.003, NA, NA, NA),
    correction_xx = c(NA, 1.02, NA, NA, NA), correction_xy = c(NA, 0, NA, NA, NA),
    correction_y0_m = c(NA, -0.004, NA, NA, NA), correction_yx = c(NA, 0, NA, NA, NA),
    correction_yy = c(NA, 0.99, NA, NA, NA)))
  path
}

test_that("the last calibration's correction and validation, and the largest drift, are those by hand", {
  table <- gaze_tables(calibrated_study())$calibration
  expect_equal(table$calibrations, c(2, 0))
  expect_equal(table$accuracy_before_deg, c(0.7, NA))
  expect_equal(table$shift_mm, c(5, NA))  # 3 and 4 mm
  expect_equal(table$stretch, c(0.02, NA))
  expect_equal(table$validation_accuracy_deg, c(0.2, NA))
  expect_equal(table$validation_worst_deg, c(0.25, NA))
  expect_equal(table$drift_checks, c(2, 0))
  expect_equal(table$drift_largest_deg, c(0.3, NA))
  expect_equal(table$not_passed, c(1, 0))
  expect_equal(length(kCalibrationHeads), ncol(table))
})

test_that("accuracy, who was never calibrated and what did not pass are said in words", {
  table <- gaze_tables(calibrated_study())$calibration
  expect_equal(calibration_sentences(table), c(
    "Accuracy of the gaze when last validated, after correction: mean 0.20°, worst participant 0.20°.",
    "Never calibrated: P2.",
    "1 calibration, validation or drift check was over the protocol's limit, of P1."))
  expect_equal(calibration_sentences(table[2, ]), "The gaze was never calibrated.")
})
