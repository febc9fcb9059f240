# Study 6: ratings by number of bodies and scheduler; clicks only where they are asked for.
# SPDX-License-Identifier: MIT
library(testthat)

# Ratings 1 to 5, worse by .8 logits for each step of bodies; the scheduler has no effect.
crowd_trials <- function(seed, participants, repetitions = 3) {
  set.seed(seed)
  plan <- shuffled_plan(participants, expand.grid(scheduler = c("eccentricity", "distance"),
    bodies = c(50, 100, 250), repetition = seq_len(repetitions), stringsAsFactors = FALSE))
  eta <- 1 - 0.8 * match(plan$bodies, c(50, 100, 250)) +
    rnorm(participants, 0, 0.6)[factor(plan$participant)]
  plan$rating <- 1 + rowSums(outer(eta + rlogis(nrow(plan)), c(-2, -0.7, 0.7, 2), ">"))
  cbind(plan, minimum = 1, maximum = 5, best = 5)
}

crowd_file <- function(trials) {
  write_study(tempfile(fileext = ".sqlite"), trials, protocol = "crowd")
}

read_crowd <- function(path) parts_of_protocol(path, "crowd")[[1]]

test_that("the planted effect of the number comes back, and the margin is that of five points", {
  study <- read_crowd(crowd_file(crowd_trials(701, 8)))
  expect_equal(levels(study$trials$bodies), c("50", "100", "250"))
  tests <- combine_outcomes(one_model_tests(study$trials, c("bodies", "scheduler")),
    equivalence_tests(study$trials, "scheduler", equivalence_margin(study$scale)))
  expect_lt(tests_of(tests, kEffectsFamily, "bodies")$p, 0.001)
  expect_match(equivalence_words(tests_of(tests, kEquivalenceFamily), "scheduler"),
    "±0.30 points", fixed = TRUE)
})

test_that("the interaction is tested in whatever order the design has its factors, as are clicks", {
  path <- crowd_file(crowd_trials(702, 4))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "UPDATE protocol SET protocol_json = '{\"clicks\": {}}'")
  DBI::dbExecute(study, "INSERT INTO click VALUES (1, 1, 'mouse', 1, 1, 1), (1, 2, 'mouse', 9, 1, 1)")
  with_trials_of_clicks(study)
  DBI::dbDisconnect(study)
  withr::local_options(impetus.levels = list(scheduler = "distance", bodies = "50"))
  part <- read_crowd(path)
  expect_equal(unname(part$factors), c("scheduler", "bodies"))
  tests <- suppressMessages(results_of_part(part))$tests
  expect_equal(tests_of(tests, kInteractionFamily)$effect, "bodies:scheduler")
  expect_equal(sum(rows_of_view(path, "click_trial", "crowd")$clicks), 2)
})
