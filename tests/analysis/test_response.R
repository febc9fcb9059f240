# Study 3: the imposed spin is a covariate, and its confounding with level is said.
# SPDX-License-Identifier: MIT
library(testthat)

# Ratings of gap_trials with, at the root, an imposed spin about two axes whose size raises the
# logit by `slope` per rad/s; u_i ~ N(0, 1) there, so that its variance is not estimated as 0.
response_trials <- function(seed, participants, slope, repetitions = 1) {
  trials <- gap_trials(seed, participants, repetitions)
  trials$spin <- ifelse(trials$level == 0, runif(nrow(trials), 0, 5), NA)
  root <- trials$level == 0
  trials$rating[root] <- ratings_at(-2.5 + slope * trials$spin[root] +
    rnorm(participants, 0, 1)[factor(trials$participant)][root])
  trials
}

response_file <- function(trials, spin = TRUE) {
  path <- write_study(tempfile(fileext = ".sqlite"), trials[names(trials) != "spin"],
    protocol = "response")
  size <- if (spin) trials$spin else NA
  add_collisions(path, data.frame(trial = seq_len(nrow(trials)), step = 1, level = trials$level,
    imposed_spin_a_x_rad_s = 0.6 * size, imposed_spin_a_y_rad_s = 0.8 * size,
    imposed_spin_a_z_rad_s = 0 * size, imposed_spin_b_x_rad_s = 0 * size,
    imposed_spin_b_y_rad_s = 0 * size, imposed_spin_b_z_rad_s = -size))
}

read_response <- function(path) {
  factors <- c(level = "level", speed = "speed", viewpoint = "viewpoint")
  with_imposed_spin(with_depths_named(keep_people_apart(read_studies(path, "response", factors))))
}

test_that("a trial's spin is the mean magnitude over both bodies, and none where none was drawn", {
  trials <- response_trials(401, 2, 0.5)
  study <- read_response(response_file(trials))
  expect_equal(study$trials$imposed_spin_rad_s[order(study$trials$trial)], trials$spin)
})

test_that("a level confounded with random spin is called so", {
  trials <- response_trials(402, 2, 0.5)
  expect_equal(spin_imposed(read_response(response_file(trials)))$words[1], paste("CONFOUNDED:",
    "random spin was imposed at some levels only (share of trials by level, root: 100 %; middle:",
    "0 %; finest: 0 %), so an effect of level cannot be told from one of randomness; a run with",
    "random spin switched off can."))
  expect_equal(spin_imposed(read_response(response_file(trials, spin = FALSE)))$words,
    "No random spin was imposed, so level is not confounded with randomness.")
})

test_that("the report of any study calls it so, too", {
  trials <- response_trials(402, 2, 0.5)
  sentences <- function(path) {
    spin_sentences(analysed_collisions(path, "response"), levels_of_trials(path))
  }
  words <- sentences(response_file(trials))
  expect_equal(words, paste("CONFOUNDED: random spin was imposed at some levels of level only (share of",
    "trials: 0: 100 %; 2: 0 %; 4: 0 %), so an effect of it cannot be told from one of randomness."))
  expect_length(sentences(response_file(trials, spin = FALSE)), 0)
})

test_that("the planted effect of the spin's size comes back", {
  trials <- response_trials(403, 12, 0.7, repetitions = 2)
  study <- read_response(response_file(trials))
  tests <- without_slopes(combine_outcomes(spin_imposed(study)$tests))
  odds <- tests_of(tests, kSpinOddsFamily)
  error <- log(odds$effect_size) / odds$statistic
  expect_lt(abs(log(odds$effect_size) - 0.7), 3 * error)
  expect_lt(tests_of(tests, kSpinFamily)$p, 0.001)
})

test_that("the script runs with one participant, and says what is confounded and unmeasured", {
  path <- response_file(response_trials(404, 1, 0.5))
  out <- new_folder()
  run <- run_script("response.R", path, "--out", out)
  expect_equal(run$status, 0)
  files <- file.path(out, paste0("response", c(".png", ".pdf", ".csv", ".md")))
  expect_true(all(file.size(files) > 0))
  report <- paste(readLines(files[4]), collapse = " ")
  expect_match(report, "CONFOUNDED")
  expect_match(report, "no gap has been measured")
  expect_match(report, "needs three participants or more")
})
