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

# The ratings as response.R reads them.
read_spins <- function(path) with_imposed_spin(parts_of_protocol(path, "response")[[1]])

test_that("a trial's spin is the mean magnitude over both bodies, and none where none was drawn", {
  trials <- response_trials(401, 2, 0.5)
  study <- read_spins(response_file(trials))
  expect_equal(study$trials$imposed_spin_rad_s[order(study$trials$trial)], trials$spin)
})

test_that("a level confounded with random spin is called so", {
  trials <- response_trials(402, 2, 0.5)
  sentences <- function(path) {
    spin_sentences(analysed_collisions(path, "response"), levels_of_trials(path))
  }
  words <- sentences(response_file(trials))
  expect_equal(words, paste("CONFOUNDED: random spin was imposed at some levels of level only (share of",
    "trials: 0: 100 %; 2: 0 %; 4: 0 %), so an effect of it cannot be told from one of randomness."))
  without <- response_file(trials, spin = FALSE)
  expect_length(sentences(without), 0)
  expect_null(spin_imposed(read_spins(without)))
})

test_that("the planted effect of the spin's size comes back", {
  trials <- response_trials(403, 12, 0.7, repetitions = 2)
  study <- read_spins(response_file(trials))
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
  page <- paste(readLines(file.path(out, "report.html"), encoding = "UTF-8"), collapse = " ")
  for (words in c("CONFOUNDED", "No gap has been measured", "needs three participants or more")) {
    expect_match(page, words, fixed = TRUE)
  }
  expect_equal(read.csv(file.path(out, "tables/response-rating-spin.csv"))$level, "root")
  # From data of before, which had less of the spin, the rest is reported.
  data <- file.path(out, "data")
  columns <- read.csv(file.path(data, "columns.csv"))
  late <- columns$view == "seen_collision" & grepl("spin_(a_[yz]|b)", columns$column)
  expect_equal(sum(late), 5)
  utils::write.csv(columns[!late, ], file.path(data, "columns.csv"), row.names = FALSE)
  collisions <- read.csv(file.path(data, "seen_collision.csv"), check.names = FALSE)
  utils::write.csv(collisions[setdiff(names(collisions), columns$column[late])],
    file.path(data, "seen_collision.csv"), row.names = FALSE, na = "")
  expect_null(spin_imposed(read_spins(study_of_report_data(data))))
})
