# Figures: the planted effect of level, and the names of levels.
# SPDX-License-Identifier: MIT
library(testthat)

# The gap study's planted trials as a study of figures: its levels are 0, 1 and 3.
figure_trials <- function(seed, participants, repetitions = 2) {
  trials <- gap_trials(seed, participants, repetitions)
  trials$level <- c(0, 1, 3)[match(trials$level, c(0, 2, 4))]
  trials$speed_deg_s <- c(6, 9, 12)[match(trials$speed_percent, c(50, 100, 150))]
  trials[names(trials) != "speed_percent"]
}

figure_file <- function(trials) {
  path <- write_study(tempfile(fileext = ".sqlite"), trials, protocol = "figures")
  add_collisions(path, data.frame(trial = seq_len(nrow(trials)), step = 30, level = trials$level,
    gap_arcmin = c(40, 12, 3)[match(trials$level, c(0, 1, 3))], hidden_share = 0.25))
}

test_that("levels of detail have the names of what they are", {
  study <- parts_of_protocol(figure_file(figure_trials(501, 1, 1)), "figures")[[1]]
  expect_equal(levels(study$trials$level), c("spheres", "parts", "deepest"))
  expect_equal(study$depths, "Greatest levels of detail: spheres 0, parts 1, deepest 3.")
})

test_that("the whole script recovers the planted effect of level of 12 participants (slow)", {
  skip_if_not(run_slow, "--slow not given")
  out <- new_folder()
  run <- run_script("figures.R", figure_file(figure_trials(503, 12)), "--out", out)
  expect_equal(run$status, 0)
  table <- read.csv(file.path(out, "tables/figures-rating-tests.csv"))
  expect_true(all(table$p_holm[table$effect == "level"] < 0.01))
})
