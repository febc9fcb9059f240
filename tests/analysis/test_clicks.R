# Clicks: planted rates come back, from the models and from the bootstrap.
# SPDX-License-Identifier: MIT
library(testthat)

# Trials as scheduling_part.R reads them, without a file.
click_trials <- function(...) {
  trials <- as_read(gaze_trials(...))
  trials$exposure_s <- 10
  trials$bad_events <- 5L
  trials
}

# The mixed models of clicks, with the interaction.
click_tests <- function(trials) {
  factor_tests(trials, c("scheduling", "bodies"), "clicks", interactions = "scheduling:bodies")
}

planted_ratio <- kPlantedClicksPerS[["tracked"]] / kPlantedClicksPerS[["random"]]

test_that("the negative-binomial model recovers the planted rates and their dispersion (slow)", {
  skip_if_not(run_slow, "--slow not given")
  trials <- click_trials(121, participants = 20)
  result <- with_failing(kVaried, click_tests(trials))  # none was planted
  rows <- result$rows[result$rows$family == kClickRatioFamily, ]
  rows <- rows[startsWith(rows$effect, "scheduling: "), ]
  planted <- kPlantedClicksPerS[kThesisKinds][-1] / kPlantedClicksPerS[1]
  error <- log(rows$effect_size) / rows$statistic
  # Three standard errors: misses for one of three ratios in 120 seeds.
  expect_true(all(abs(log(rows$effect_size) - log(planted)) < 3 * error))
  expect_match(rows$method, "^negative-binomial mixed model")
  theta <- result$models$scheduling$full$theta
  expect_true(theta > kPlantedTheta / 2 && theta < 2 * kPlantedTheta)
  effects <- result$rows[result$rows$family %in% c(kClickFamily, kClickInteractionFamily), ]
  expect_equal(effects$effect, c("scheduling", "bodies", "scheduling:bodies"))
  expect_equal(effects$df1, c(3, 2, 6))
  expect_lt(effects$p[1], 1e-10)
  expect_gt(effects$p[3], 0.001)  # none was planted
})

test_that("the planned contrast of clicks is the planted ratio, overall and at each number", {
  rows <- with_failing(kVaried, contrast_model_tests(click_trials(122, participants = 15), response = "clicks"))$rows
  contrast <- rows[rows$family == kClickContrastFamily, ]
  expect_equal(place_of(contrast$effect),
    c("overall", "at 5 bodies", "at 10 bodies", "at 15 bodies"))
  error <- log(contrast$effect_size) / contrast$statistic
  expect_true(all(abs(log(contrast$effect_size) - log(planted_ratio)) < 3 * error))
  equivalence <- rows[rows$family == kClickEquivalenceFamily, ]
  # Planted .625 is outside .8 to 1.25.
  expect_true(all(equivalence$p > 0.05))
  expect_equal(equivalence$effect_size, contrast$effect_size)
})

test_that("exposure is an offset: twice the time with twice the clicks leaves the ratio", {
  trials <- click_trials(123, participants = 6)
  random <- trials$scheduling == "random"
  longer <- trials
  longer$exposure_s[random] <- 20
  ratio <- function(trials) with_failing(kVaried, contrast_model_tests(trials, response = "clicks"))$rows$effect_size[1]
  expect_equal(ratio(longer), 2 * ratio(trials), tolerance = 1e-3)  # two optimisations
})

test_that("Poisson stands in when the negative binomial does not converge, and says so", {
  trials <- click_trials(124, participants = 5)
  result <- with_failing(paste0("negative-binomial|", kVaried), click_tests(trials))
  expect_match(result$rows$method, "^Poisson mixed model")
  expect_match(result$remarks, paste0("^The mixed model of clicks for the test of scheduling",
    " \\(negative-binomial, intercept and levels for each participant\\) did not converge: planted.$"), all = FALSE)
  expect_match(model_diagnostics(result, "clicks")$checks[1], paste("The model of clicks is a Poisson one;",
    "Pearson's χ² per degree of freedom is [0-9.]+ \\(1 for Poisson counts\\)"))
  none <- with_failing(".", click_tests(trials))
  expect_null(none$rows)
  expect_true("No mixed model of clicks for the test of scheduling is reported." %in% none$remarks)
})

test_that("without the package glmmTMB the models are Poisson, and why is said", {
  assign("requireNamespace", function(...) FALSE, globalenv())
  on.exit(rm("requireNamespace", envir = globalenv()))
  result <- with_failing("Poisson .*(slope|participant:)", contrast_model_tests(click_trials(128, participants = 4), response = "clicks"))
  expect_match(result$rows$method[1], "^Poisson mixed model")
  expect_match(result$remarks[1], "did not converge: the package glmmTMB is not installed.",
    fixed = TRUE)
})

test_that("the Poisson model agrees with a closed form: a ratio of totals", {
  # Equal exposures and every participant in every cell: the estimate is log(sum / sum).
  trials <- click_trials(125, participants = 8)
  row <- with_failing(paste0("negative-binomial|", kVaried), contrast_model_tests(trials, response = "clicks"))$rows[1, ]
  total <- function(kind) sum(trials$clicks[trials$scheduling == kind])
  expect_equal(row$effect_size, total("tracked") / total("random"), tolerance = 1e-3)
})

test_that("kinds without clicks, or two participants, leave no model, in words", {
  trials <- click_trials(126, participants = 3)
  trials$clicks[trials$scheduling == "all-good"] <- 0
  expect_equal(click_tests(trials)$remarks, paste("Nobody clicked at scheduling all-good,",
    "so the mixed model of clicks has no finite ratio and was not fitted; see the other tests."))
  expect_equal(contrast_model_tests(trials[trials$participant != "P01", ], response = "clicks")$remarks,
    "The mixed model of clicks of the planned contrast needs three participants or more and was not fitted.")
})

test_that("the table's totals and rates are counted by hand", {
  trials <- as_read(data.frame(participant = c("P1", "P1", "P2", "P2", "P2"),
    scheduling = c("tracked", "tracked", "tracked", "random", "random"),
    bodies = c(5, 10, 5, 5, 5), clicks = c(3, 1, 0, 4, 2), exposure_s = c(10, 10, 10, 10, NA),
    bad_events = c(6L, 2L, 4L, 8L, 1L)))
  table <- click_table(trials)
  expect_equal(paste(table$scheduling, table$bodies),
    c("tracked 5", "tracked 10", "random 5", "tracked all"))
  expect_equal(table$clicks, c(3, 1, 4, 4))         # the trial without exposure is left out
  expect_equal(table$clicks_per_trial, c(1.5, 1, 4, 4 / 3))
  expect_equal(table$clicks_per_s, c(0.15, 0.1, 0.4, 4 / 30))
  expect_equal(table$bad_events_per_trial, c(5, 2, 8, 4))
  expect_equal(table$clicks_per_bad_event, c(3 / 10, 1 / 2, 4 / 8, 4 / 12))
})

test_that("the bootstrap draws participants, and its ratio is that of the totals", {
  # Two participants, tracked rates .1 and .3, random .2 and .2. Draws: both the first .1 / .2, both
  # the second .3 / .2, one of each .2 / .2; the 2.5th and 97.5th percentiles are the extremes.
  trials <- as_read(data.frame(participant = c("P1", "P1", "P2", "P2"),
    scheduling = c("tracked", "random"), bodies = 5, clicks = c(1, 2, 3, 2), exposure_s = 10))
  row <- click_bootstrap(trials)$rows[1, ]
  expect_equal(c(row$effect_size, row$interval_low, row$interval_high), c(1, 0.5, 1.5))
  expect_true(is.na(row$p))
})

test_that("the planted ratio lies in the bootstrap's interval", {
  rows <- click_bootstrap(click_trials(127, participants = 20))$rows
  expect_true(rows$interval_low[1] < planted_ratio && planted_ratio < rows$interval_high[1])
  expect_equal(nrow(rows), 4)
})
