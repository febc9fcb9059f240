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

test_that("means to be drawn carry their levels and their place on the axis", {
  rows <- means_with_intervals(labelled_trials(), c("delay_ms", "speed_deg_s"))
  expect_equal(rows$x, c(0, 0, 0, 100, 100, 100))
  expect_equal(rows$speed_deg_s, c("5", "10", "15", "5", "10", "15"))
  expect_equal(rows$mean, c(5, 10, 15, 105, 110, 115) + 500)  # P2 is 1000 above P1
})
