# What a study's clicks say: the test that the words name is one over participants.
# SPDX-License-Identifier: MIT
library(testthat)

# A study as click_detection takes it, of participants whose own gain of bad collisions is given.
# Tracked and random trials alike, and with `quiet` a third kind without bad collisions.
detected_study <- function(gains_bad, bad_per_s = 2, trials = 10, false_per_s = 0.05) {
  kinds <- c("all-good", "tracked", "random")
  each <- lapply(gains_bad, clicking_participant, gain_good = 0, false_per_s = false_per_s,
    trials = trials * 3, bad_per_s = c(0, bad_per_s, bad_per_s), good_per_s = 1)
  part <- function(name) do.call(rbind, lapply(seq_along(each), function(i) {
    rows <- each[[i]][[name]]
    rows$row <- rows$row + (i - 1) * trials * 3
    rows
  }))
  list(trials = data.frame(
    participant = rep(sprintf("P%02d", seq_along(each)), each = trials * 3),
    scheduling = factor(rep(kinds, trials * length(each)), kinds), bodies = factor(5),
    exposure_s = 10, merge_within_ms = 100), collisions = part("events"), clicks = part("clicks"),
    pairs = list(kTrackedRandom))
}

detected <- function(study) {
  detection <- suppressMessages(click_detection(study))
  detection$all <- combine_outcomes(detection$tests)
  detection
}

test_that("the primary test of sensitivity is the t test over participants, as its interval is", {
  set.seed(401)
  # People differ so much that four of them show nothing, though each one's timing is plain.
  detection <- detected(detected_study(c(0.02, 0.05, 0.1, 0.6)))
  row <- tests_of(detection$all, kSensitivityFamily)
  each <- detection$gains$difference[detection$gains$scheduling == "all"]
  expected <- t.test(each)
  expect_equal(row$p, expected$p.value)
  expect_equal(c(row$interval_low, row$interval_high), as.vector(expected$conf.int))
  expect_equal(row$p > 0.05, row$interval_low < 0)
  expect_gt(row$p, 0.05)
  timing <- tests_of(detection$all, kTimingFamily)
  expect_equal(timing$p, 2 / (1 + kShifts))
  expect_equal(timing$effect_size + timing$statistic, mean(each))
  expect_true(is.na(timing$interval_low))
  expect_equal(tests_of(detection$all, kGainTFamily)$effect, unname(kGainWords[c("bad", "good")]))
  words <- paste(detection$words, collapse = " ")
  expect_match(words, sprintf("(t test over participants, %s)", both_p_words(row)), fixed = TRUE)
  expect_match(words, sprintf("Of these participants alone, .* \\(circular shift, %s\\)\\.",
    both_p_words(timing)))
})

test_that("false clicks and d' of one collision come back, at seven bad collisions a second", {
  set.seed(402)
  detection <- detected(detected_study(rep(0.12, 6), bad_per_s = 7))
  all <- detection$gains[detection$gains$scheduling == "all", ]
  # Poisson: three standard errors of the planted .05 per second.
  expect_lt(abs(sum(all$false_clicks) / sum(all$quiet_s) - 0.05), 3 * sqrt(0.05 / sum(all$quiet_s)))
  planted <- implied_d_prime(0.12, 0.05)[["d_prime"]]
  words <- paste(detection$words, collapse = " ")
  told <- as.numeric(sub(".*one bad collision alone in a second that makes d′ = ([0-9.]+),.*", "\\1", words))
  # A tenth of the gain and a seventh of the rate are one standard error each: .15 together.
  expect_lt(abs(told - planted), 0.3)
  expect_match(words, "participants clicked 0.0[3-7][0-9] times per second \\(false clicks,")
  expect_no_match(words, "baseline|readiness")
})

test_that("each collision counts for the regression, however close to the one before", {
  study <- list(trials = data.frame(participant = "P01", scheduling = "random", exposure_s = 10,
    merge_within_ms = 100), clicks = data.frame(row = 1, time_s = 5),
    collisions = data.frame(row = 1, time_s = c(1, 1.02, 1.04, NA), bad = c(TRUE, TRUE, TRUE, TRUE)))
  expect_equal(nrow(click_events(study)), 1)
  record <- participants_records(study, 1, "all")$P01
  expect_equal(colSums(record$rows), rep(c(30, 0), each = 5))  # 3 x 200 ms in bins of 20 ms
})

test_that("without any gain p of the primary test is uniform, for trials with more of both too", {
  set.seed(403)
  p <- replicate(80, {
    each <- replicate(4, click_gains(record_of(clicking_participant(0, 0, c(0.1, 0.8), trials = 6,
      bad_per_s = c(0.5, 3))))$gains[["difference"]])
    paired_test(each, kSensitivityFamily, "gain", kGainUnit)$rows$p
  })
  expect_gt(ks.test(p, "punif")$p.value, 0.01)
})

test_that("the methods say of which test the unit is not the participant, where clicks were counted", {
  part <- list(response = "clicks", trials = data.frame(participant = c("P01", "P02")))
  words <- paste(analysis_words(list(part)), collapse = " ")
  expect_match(words, "holds the participants fixed", fixed = TRUE)
  expect_match(words, "The unit of every test is the participant, but for a circular shift of clicks.",
    fixed = TRUE)
  part$response <- "rating"
  expect_true("The unit of every test is the participant." %in% analysis_words(list(part)))
})
