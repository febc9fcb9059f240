# SPDX-License-Identifier: MIT
library(testthat)

# Two participants, each cell of delay × speed rated with a number that names it.
labelled_trials <- function() {
  trials <- expand.grid(delay_ms = c(0, 100), speed_deg_s = c(5, 10, 15),
    participant = c("P1", "P2"), stringsAsFactors = FALSE)
  trials$rating <- trials$delay_ms + trials$speed_deg_s + 1000 * (trials$participant == "P2")
  transform(trials, delay_ms = factor(delay_ms), speed_deg_s = factor(speed_deg_s))
}

test_that("every mean stands under the name of its own cell", {
  means <- participant_means(labelled_trials(), c("delay_ms", "speed_deg_s"))
  expect_equal(colnames(means),
    c("0 : 5", "0 : 10", "0 : 15", "100 : 5", "100 : 10", "100 : 15"))
  expect_equal(unname(means["P1", ]), c(5, 10, 15, 105, 110, 115))
  expect_equal(unname(means["P2", "100 : 5"]), 1105)
})

test_that("a participant without a rating in some cell is not complete", {
  trials <- labelled_trials()
  trials <- trials[!(trials$participant == "P1" & trials$delay_ms == 100), ]
  means <- participant_means(trials, c("delay_ms", "speed_deg_s"))
  expect_equal(sum(is.na(means["P1", ])), 3)
  expect_equal(rownames(complete_participants(means)), "P2")
})

test_that("means to be drawn carry their levels", {
  rows <- means_with_intervals(labelled_trials(), c("delay_ms", "speed_deg_s"))
  expect_equal(rows$delay_ms, rep(c("0", "100"), each = 3))
  expect_equal(rows$speed_deg_s, c("5", "10", "15", "5", "10", "15"))
  expect_equal(rows$mean, c(5, 10, 15, 105, 110, 115) + 500)  # P2 is 1000 above P1
})

test_that("means over fewer people than took part say so, and tests count the trials of those kept", {
  trials <- causality_trials(seed = 12, participants = 4, repetitions = 1)
  trials <- trials[!(trials$participant == "P02" & trials$delay_ms == 100), ]
  columns <- c("delay_ms", "speed_deg_s")
  trials[columns] <- lapply(trials[columns], factor)
  base <- "Means: 3 of 4 participants, those with a trial at every level."
  part <- list(trials = trials, factors = stats::setNames(nm = columns), all_simulated = FALSE)
  measure <- list(of = "rating", title = "Mean rating")
  expect_match(means_words(trials, "delay_ms"), base, fixed = TRUE)
  expect_match(factor_figure_caption(part, "delay_ms", measure), base, fixed = TRUE)
  expect_match(pair_figure_caption(part, columns, measure),
    "Means: 3 of 4 participants, those with a trial at every combination.", fixed = TRUE)
  expect_equal(mean_base_words(trials, "speed_deg_s"), "")
  alone <- trials[trials$participant == "P02" | trials$delay_ms == 100, ]
  expect_match(means_words(alone, "delay_ms"),
    "Nobody has a trial at every level: each mean is over those who have it.", fixed = TRUE)
  friedman <- friedman_tests(trials, columns)$rows
  expect_equal(friedman$participants, c(3, 4))
  expect_equal(friedman$trials, c(3 * 27, nrow(trials)))
  first <- transform(trials, delay_ms = factor(delay_ms, c("100", "0", "300")))
  first$late_timed_frames <- 0
  rows <- data_sensitivity(c(part[c("all_simulated", "factors")], list(trials = first,
    enrolments = data.frame(participant = sprintf("P%02d", 1:4), finished_utc = "2026"))), measure)
  expect_equal(rows$participants, c(3, 4))
  expect_equal(rows$trials, c(3 * 27, nrow(trials)))
})
