# Tracked against random: found where planted, never denied where not, in the right direction.
# SPDX-License-Identifier: MIT
library(testthat)

test_that("a participant's difference is that of the means, overall the mean over bodies", {
  trials <- as_read(data.frame(
    participant = "P1", scheduling = c("tracked", "tracked", "random", "tracked", "random",
      "all-bad"), bodies = c(5, 5, 5, 10, 10, 10), rating = c(5, 4, 2, 3, 4, 1)))
  # At 5: 4.5 - 2; at 10: 3 - 4.
  expect_equal(contrast_differences(trials)[1, ], c(overall = 0.75, "5" = 2.5, "10" = -1))
  expect_equal(contrast_differences(trials[-3, ])[1, ], c(overall = NA, "5" = NA, "10" = -1))
})

test_that("a planted difference is found, as large as it was planted", {
  trials <- as_read(gaze_trials(111, participants = 12))
  tests <- combine_outcomes(without_slopes(contrast_model_tests(trials)),
    contrast_means_tests(trials, 0.3))
  rows <- tests_of(tests, kContrastFamily)
  expect_equal(place_of(rows$effect), c("overall", "at 5 bodies", "at 10 bodies", "at 15 bodies"))
  planted <- kPlantedQuality[["tracked"]] - kPlantedQuality[["random"]]
  error <- log(rows$effect_size) / rows$statistic
  # Three standard errors: a right model misses for one of four estimates in 90 seeds.
  expect_true(all(abs(log(rows$effect_size) - planted) < 3 * error))
  expect_lt(rows$p_holm[1], 0.001)
  means <- tests_of(tests, kContrastMeansFamily)
  expect_equal(means$effect_size, unname(colMeans(contrast_differences(trials))))
  expect_lt(means$p_holm[1], 0.01)
  expect_match(paste(rating_contrast_words(tests, kFivePoints), collapse = " "),
    "Tracked was rated better than random overall", fixed = TRUE)
})

test_that("the contrast at a number of bodies is that of a model with this number as the first", {
  trials <- as_read(gaze_trials(112, participants = 6))
  row <- without_slopes(contrast_model_tests(trials))$rows[4, ]
  two <- contrast_trials(trials)
  two$bodies <- stats::relevel(two$bodies, "15")
  two$rating <- factor(two$rating, ordered = TRUE)
  models <- fit_models(two, c("scheduling", "bodies", "scheduling:bodies"), character(),
    tested = character())
  # 1e-3: two optimisations of one likelihood.
  expect_equal(log(row$effect_size), models$full$beta[["schedulingtracked"]], tolerance = 1e-3)
})

test_that("without a planted difference none is claimed, and equivalence speaks", {
  trials <- as_read(gaze_trials(113, participants = 60, difference = FALSE))
  tests <- combine_outcomes(contrast_means_tests(trials, 0.3))
  # 60 participants, s about .45 between their differences: a standard error of .06 for .30.
  equivalence <- tests_of(tests, kEquivalenceFamily, "tracked − random, overall")
  expect_lt(equivalence$p_holm, 0.05)
  expect_gt(tests_of(tests, kContrastMeansFamily, "tracked − random, overall")$p, 0.05)
  expect_match(equivalence$method, "margin ±0.30")
  expect_match(equivalence_verdict(tests_of(tests, kEquivalenceFamily), "±0.30 points"),
    "^Equivalence within ±0.30 points was shown overall")
})

test_that("a large p is never called no difference", {
  row <- function(family, effect, ...) test_row(family, "m, logit, (1 | participant)", effect, ...)
  tests <- combine_outcomes(outcome(rbind(
    row(kContrastFamily, contrast_label(kOverall), "z", 1, NA, p = 0.3, size = 1.5,
      interval = c(0.7, 3.2), interval_level = 0.95),
    row(kEquivalenceFamily, contrast_label(kOverall), "t", 1, 9, p = 0.2, size = 0.2,
      interval = c(-0.1, 0.5), interval_level = 0.9))))
  expect_equal(rating_contrast_words(tests, kFivePoints), c(
    paste("Planned contrast, tracked against random (cumulative-link mixed model of these two",
      "kinds, random intercept for each participant; Holm over 1 test): odds ratio of a higher",
      "rating overall 1.50, 95 % CI [0.70, 3.20], p = .300, Holm-corrected p = .300."),
    "A difference was not detected overall, which is not evidence of its absence.",
    "Equivalence within ±0.30 points was not shown overall."))
})

test_that("which of two is better follows the scale's best end", {
  tests <- combine_outcomes(outcome(test_row(kContrastFamily, "m, (1 | participant)",
    contrast_label("5"), "z", 4, NA, p = 1e-4, size = 3, interval = c(2, 5),
    interval_level = 0.95)))
  expect_true("Tracked was rated better than random at 5 bodies." %in%
    rating_contrast_words(tests, kFivePoints))
  expect_true("Tracked was rated worse than random at 5 bodies." %in%
    rating_contrast_words(tests, transform(kFivePoints, rating_best = 1L)))
})

test_that("the margin of equivalence is the same share of every scale", {
  expect_equal(equivalence_margin(kFivePoints), 0.30)
  expect_identical(equivalence_margin(transform(kFivePoints, rating_maximum = 3L)),
    kEquivalenceMargin)
})

test_that("a contrast that cannot be fitted is said in words", {
  trials <- as_read(gaze_trials(114, participants = 4))
  few <- trials[trials$participant %in% c("P01", "P02"), ]
  expect_equal(contrast_model_tests(few)$remarks,
    "The mixed model of the planned contrast needs three participants or more and was not fitted.")
  expect_equal(contrast_model_tests(trials[trials$scheduling != "random", ])$remarks,
    "There is no contrast of ratings of tracked against random: it needs trials of both.")
  apart <- transform(trials, rating = ifelse(scheduling == "tracked", 5, pmin(rating, 4)))
  expect_match(contrast_model_tests(apart)$remarks, "The levels of scheduling separate the ratings completely")
})

test_that("the thesis's test is of tracked and random alone, at each number of bodies", {
  trials <- as_read(gaze_trials(115, participants = 4))
  tests <- combine_outcomes(thesis_tests(trials))
  here <- trials[trials$scheduling %in% c("tracked", "random") & trials$bodies == 10, ]
  row <- tests_of(tests, kPooledFamily, "scheduling at bodies 10")
  expect_equal(row$statistic,
    oneway.test(rating ~ droplevels(scheduling), here, var.equal = TRUE)$statistic[["F"]])
  clicks <- tests_of(tests, kClickPooledFamily, "scheduling at bodies 10")
  expect_equal(clicks$statistic,
    oneway.test(clicks ~ droplevels(scheduling), here, var.equal = TRUE)$statistic[["F"]])
  expect_match(thesis_words(tests, kPooledFamily), "treats trials as independent; uncorrected p")
})
