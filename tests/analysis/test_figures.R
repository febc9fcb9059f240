# Figures: the planted effect of level, the names of levels, and the script as it is called.
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
  study <- read_studies(figure_file(figure_trials(501, 1, 1)), "figures",
    c(level = "level", speed = "speed", viewpoint = "viewpoint"))
  study <- with_depths_named(keep_people_apart(study), c("spheres", "parts", "deepest"),
    "Greatest levels of detail")
  expect_equal(levels(study$trials$level), c("spheres", "parts", "deepest"))
  expect_equal(study$depths, "Greatest levels of detail: spheres 0, parts 1, deepest 3.")
})

test_that("one participant gives figure, table and words, no test", {
  out <- tempfile("figures of ")
  run <- run_script("figures.R", figure_file(figure_trials(502, 1)), "--out", out)
  expect_equal(run$status, 0)
  files <- file.path(out, paste0("figures", c(".png", ".pdf", ".csv", ".md")))
  expect_equal(run$stdout[1:4], files)
  expect_true(all(file.size(files) > 0))
  report <- readLines(files[4])
  # 6 trials of 3 speeds and 2 repetitions; the gap is planted, the mean rating is the sample's.
  expect_true(any(startsWith(report, "| spheres | 45 | 6 | 40.0 | 0.25 | 0 | ")))
  expect_true(any(grepl("Greatest levels of detail: spheres 0, parts 1, deepest 3.", report,
    fixed = TRUE)))
})

test_that("the whole script recovers the planted effect of level of 12 participants (slow)", {
  skip_if_not(run_slow, "--slow not given")
  out <- tempfile("figures of ")
  run <- run_script("figures.R", figure_file(figure_trials(503, 12)), "--out", out)
  expect_equal(run$status, 0)
  table <- read.csv(file.path(out, "figures.csv"))
  expect_true(all(table$p_holm[table$effect == "level"] < 0.01))
})
