# Gaze quality and latency, counted by hand.
# SPDX-License-Identifier: MIT
library(testthat)

# P1 has two trials of mouse gaze at 100 samples per second, P2 one by a simulated eye and one
# without gaze. Trials 1 to 4 in this order.
quality_study <- function() {
  trials <- data.frame(participant = c("P1", "P1", "P2", "P2"), repetition = 1,
    scheduling = c("tracked", "random"), bodies = 5, rating = 3, clicks = 0,
    gaze_source = c("mouse", "mouse", "simulated eye", NA),
    gaze_latency_p95_ms = c(65, 75, 85, NA), gaze_late = c(0, 0, 1, 0))
  path <- write_gaze_study(tempfile(fileext = ".sqlite"), trials)
  loss <- rep(NA_character_, 11)
  add_gaze(path, rbind(
    data.frame(trial = 1, sample = 1:11, taken_ns = 1e9 + (1:11) * 1e7,
      loss = replace(loss, c(2, 5, 6), c("blink", "lost", "lost"))),
    data.frame(trial = 2, sample = 1:11, taken_ns = 2e9 + (1:11) * 1e7,
      loss = replace(loss, 9, "off screen")),
    data.frame(trial = 3, sample = 1:3, taken_ns = 1e9 + (1:3) * 2e6, loss = NA)
  ))
  path
}

test_that("rate, losses and latency of a participant are those counted by hand", {
  table <- gaze_tables(quality_study())$gaze
  expect_equal(table$participant, c("P1", "P2"))
  expect_equal(table$gaze_source, c("mouse", "simulated eye"))
  expect_equal(table$trials_followed, c(2, 1))
  expect_equal(table$samples, c(22, 3))
  expect_equal(table$samples_per_s, c(100, 500))  # 20 intervals in .2 s, 2 in .004 s
  expect_equal(table$blink_share, c(1 / 22, 0))
  expect_equal(table$off_screen_share, c(1 / 22, 0))
  expect_equal(table$lost_share, c(2 / 22, 0))
  expect_equal(table$trials_timed, c(2, 1))
  expect_equal(table$latency_median_ms, c(70, 85))  # of 65 and 75
  expect_equal(table$latency_largest_ms, c(75, 85))
  expect_equal(table$trials_over_70_ms, c(1, 1))
  expect_equal(table$trials_late, c(0, 1))
  expect_equal(length(kGazeHeads), ncol(table))
})

test_that("mouse gaze, missing gaze and late trials are said in words", {
  study <- read_scheduling(quality_study())
  expect_equal(gaze_sentences(study$trials), c(
    paste("GAZE FROM THE MOUSE in 2 trials of 1 participant: the pointer stood in for the eye, and",
      "mouse data cannot support claims about gaze."),
    "Gaze from a simulated eye in 1 trial of 1 participant: it describes a model of the eye.",
    "Gaze was not followed in 1 trial of 1 participant.",
    paste("The 95th percentile from gaze sample to flip, while the eye was not lost, was 65 to 85 ms",
      "by trial; it was at most 60 ms, which is good, in 0 of 3 trials whose detail depended on gaze."),
    paste("The 95th percentile exceeds 70 ms in 2 trials; 1 of 4 trials is marked late (above 80 ms).",
      "Marked trials are in every analysis; the tables of sensitivity show the comparisons without them.")
  ))
})

test_that("a study whose gaze was never sampled has dashes, and no latency", {
  trials <- gaze_trials(141, participants = 1, repetitions = 1)
  trials$gaze_latency_p95_ms <- NA
  path <- write_gaze_study(tempfile(fileext = ".sqlite"), trials)
  study <- read_scheduling(path)
  table <- gaze_tables(path)$gaze
  expect_equal(table$samples, 0)
  expect_true(all(is.na(table[c("samples_per_s", "blink_share", "lost_share", "latency_median_ms")])))
  expect_equal(gaze_sentences(study$trials)[-1], "No latency from sample to flip is known.")
})
