# How far a piece of work has come.
# SPDX-License-Identifier: MIT
library(testthat)

# The lines that `expression` says, not on a terminal.
said <- function(expression) {
  lines <- character()
  withCallingHandlers(expression, message = function(condition) {
    lines <<- c(lines, sub("\n$", "", conditionMessage(condition)))
    invokeRestart("muffleMessage")
  })
  lines
}

test_that("a step says which of how many it is, and what is left from the steps before", {
  steps <- c(fit = 3, test = 1, draw = 2)
  expect_equal(step_words(steps, 1, 0.2), "(1 of 3; 0 s so far)")
  expect_equal(step_words(steps, 2, 30), "(2 of 3; 30 s so far, about 30 s left)")
  expect_equal(step_words(c(fit = 1, draw = 12), 2, 30), "(2 of 2; 30 s so far)")
  expect_equal(step_words(steps, 3, 400), "(3 of 3; 7 min so far, about 3 min left)")
})

test_that("steps are counted by their words; those that are not needed are passed over", {
  on.exit(end_progress())
  lines <- said({
    expect_steps(c(fit = 1, link = 1, draw = 1, fit = 1))
    for (step in c("fit", "reading", "draw", "fit")) say_progress(step)
  })
  expect_equal(sub(";.*", "", lines), c("fit (1 of 4", "reading", "draw (3 of 4", "fit (4 of 4"))
  expect_equal(said({
    end_progress()
    say_progress("wrote ", "it")
  }), "wrote it")
})

test_that("every step of a report is one that it counted, in its order", {
  trials <- causality_trials(48, participants = 5, repetitions = 2)
  trials <- trials[trials$viewpoint_deg == 0 & trials$speed_deg_s != 5, ]
  folder <- new_folder()
  dir.create(file.path(folder, "data"), recursive = TRUE)
  write_report_data(write_study(tempfile(fileext = ".sqlite"), trials), file.path(folder, "data"))
  lines <- said(write_study_report(folder))
  end_progress()
  expect_equal(lines[1], "protocol causality")
  expect_match(lines[-1], "^(fitting|testing|drawing) .*[.][.][.] \\([0-9]+ of 10; [0-9]+ s so far")
  numbers <- as.integer(sub(".*\\(([0-9]+) of.*", "\\1", lines[-1]))
  expect_false(is.unsorted(numbers, strictly = TRUE))
  expect_equal(tail(numbers, 1), 10)
  expect_match(lines[2], "^fitting the mixed model for delay_ms")
})
