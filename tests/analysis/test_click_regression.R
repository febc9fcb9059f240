# The regression of click rates gives back what was planted; matching beside it does not.
# SPDX-License-Identifier: MIT
library(testthat)

test_that("planted gains and baseline come back, within two standard errors about 95 % of the time", {
  set.seed(301)
  planted <- c(bad = 0.5, good = 0.1, difference = 0.4, baseline = 0.05)
  z <- replicate(60, {
    fit <- click_gains(record_of(clicking_participant(0.5, 0.1, 0.05)))
    (fit$gains - planted) / fit$errors
  })
  covered <- rowMeans(abs(z) < 2)
  # Expected .954; five binomial standard errors of 60 draws below it are .82.
  expect_true(all(covered > 0.82))
  # Unbiased: the mean of 60 z lies within 3.5 standard errors of 0.
  expect_true(all(abs(rowMeans(z)) < 3.5 / sqrt(60)))
})

test_that("overlap does not bias it: the same gains come back at three events a second", {
  set.seed(302)
  gains <- replicate(40, click_gains(record_of(
    clicking_participant(0.5, 0.1, 0.05, bad_per_s = 1.5, good_per_s = 1.5)))$gains)
  error <- apply(gains, 1, sd) / sqrt(40)
  expect_true(all(abs(rowMeans(gains) - c(0.5, 0.1, 0.4, 0.05)) < 3.5 * error))
})

test_that("the closed form is that of a least-squares regression over all free bins", {
  set.seed(303)
  record <- record_of(clicking_participant(0.4, 0.2, 0.1, trials = 6))
  fit <- fit_click_rate(record)
  at <- record$first[record$click_trial] + record$click_bin + 1
  free <- rep(TRUE, nrow(record$rows))
  for (i in seq_along(at)) {
    end <- record$first[record$click_trial[i]] + record$bins[record$click_trial[i]]
    free[seq(at[i], end)[-1][1:20]] <- FALSE
  }
  clicked <- tabulate(at, nrow(record$rows)) / kClickBinS
  oracle <- lm.fit(record$rows[free, ], clicked[free])$coefficients
  expect_equal(fit$theta, unname(oracle), tolerance = 1e-8)
})

test_that("lagged counts are those of counting by hand", {
  set.seed(307)
  events <- runif(5, 0, 1.5)
  counts <- lagged_counts(events, 100)
  middle <- (1:100 - 0.5) * kClickBinS
  oracle <- t(vapply(middle, function(t) vapply(1:5, function(k) {
    sum(t - events >= kLagEdgesS[k] & t - events < kLagEdgesS[k + 1])
  }, 0), numeric(5)))
  expect_equal(counts, oracle)
})

test_that("a second click within 400 ms is dropped, and a third that is free is kept", {
  expect_equal(free_clicks(c(1.39, 1, 1.4, 3)), c(1, 1.4, 3))
  drawn <- clicking_participant(0, 0, 0, trials = 1)
  drawn$clicks <- data.frame(row = 1, time_s = c(1, 1.1, 2, 10.3))
  expect_equal(record_of(drawn)$dropped, 2)
})

test_that("what a click blocks is that of multiplying the bins after it, round its trial's end", {
  set.seed(308)
  record <- record_of(clicking_participant(0.4, 0.2, 0.1, trials = 2))
  short <- 7  # bins: it goes round more than twice
  record$rows <- rbind(record$rows, record$rows[seq_len(short) + 100, ])
  record$first <- c(record$first, sum(record$bins))
  record$bins <- c(record$bins, short)
  blocked <- blocked_products(record)
  expect_equal(ncol(blocked), sum(record$bins))
  for (trial in seq_along(record$bins)) {
    bins <- record$bins[trial]
    for (bin in unique(c(0, 3, bins %/% 2, bins - 5, bins - 1))) {
      after <- record$first[trial] + (bin + 1:20) %% bins + 1
      expect_identical(symmetric(blocked[, record$first[trial] + bin + 1], ncol(record$rows)),
        crossprod(record$rows[after, ]))
    }
  }
})

test_that("without any gain, p of the circular shift is uniform", {
  set.seed(304)
  p <- replicate(200, {
    record <- record_of(clicking_participant(0, 0, 0.3, trials = 4))
    null <- shifted_differences(list(record), shifts = 39, seed = sample(1e6, 1))
    two_sided_p(click_gains(record)$gains[["difference"]], null)
  })
  # p is discrete on .05, .1, ... 1; Kolmogorov's distance of 200 draws is below .115 in 99 of 100.
  distance <- max(abs(ecdf(p)(seq(0.05, 1, 0.05)) - seq(0.05, 1, 0.05)))
  expect_lt(distance, 0.115)
})

test_that("with a gain, the circular shift finds it", {
  set.seed(305)
  records <- replicate(4, record_of(clicking_participant(0.5, 0, 0.05)), simplify = FALSE)
  observed <- mean(vapply(records, function(r) click_gains(r)$gains[["difference"]], 0))
  null <- shifted_differences(records, shifts = 199)
  expect_equal(two_sided_p(observed, null), 2 / 200)
  # Shifts are from nothing to the whole trial, so one in ten leaves a click near its own event.
  expect_lt(abs(mean(null)), 0.15 * observed)
  expect_identical(null, shifted_differences(records, shifts = 199))  # seeded
})

test_that("a participant who saw no bad event has no bad gain", {
  expect_null(click_gains(record_of(clicking_participant(0, 0.2, 0.1, bad_per_s = 0))))
})

test_that("d' and criterion are the textbook's, with and without the log-linear correction", {
  # Macmillan and Creelman's formulae by hand: 20 of 25 hits, 10 of 25 false alarms.
  plain <- d_prime(20 / 25, 10 / 25)
  expect_equal(plain[["d_prime"]], 1.09497, tolerance = 1e-5)
  expect_equal(plain[["criterion"]], -0.29414, tolerance = 1e-4)
  expect_equal(log_linear_d_prime(20, 25, 10, 25)[["d_prime"]], 1.04450, tolerance = 1e-5)
  expect_true(is.finite(log_linear_d_prime(25, 25, 0, 25)[["d_prime"]]))
})

test_that("a click belongs to the latest collision 200 to 1200 ms before, whatever its kind", {
  events <- c(3, 1, 1.9)
  expect_equal(matched_event(c(1.1, 1.2, 2.05, 2.2, 3.1, 4.2, 4.21), events, c(0.2, 1.2)),
    c(NA, 2, 2, 3, 3, 1, NA))
})

test_that("time without bad events is cut at their windows, overlapping ones once", {
  # Windows .7 to 1.7 and 1.2 to 2.2 of bad events at .5 and 1, and 9.2 to 10 of one at 9.
  without <- time_without_bad(c(0.1, 1.5, 5, 9.5), c(1, 0.5, 9), c(0.2, 1.2), 10)
  expect_equal(without, c(seconds = 10 - 1.5 - 0.8, clicks = 2))
})

test_that("at more than one event a second matching halves d', and the regression keeps it", {
  # Planted for an event alone: hits Phi(.75), false alarms Phi(-.75) in a second, d' = 1.5.
  baseline <- -log(1 - pnorm(-0.75))
  gain <- -log(1 - pnorm(0.75)) - baseline
  expect_equal(implied_d_prime(gain, baseline)[["d_prime"]], 1.5)
  measured <- function(bad_per_s, good_per_s) {
    set.seed(306)
    drawn <- clicking_participant(gain, 0, baseline, trials = 400, bad_per_s = bad_per_s,
      good_per_s = good_per_s)
    table <- matching_table(drawn$trials, drawn$events, drawn$clicks)
    gains <- click_gains(record_of(drawn))$gains
    c(matching = table$d_prime[1],
      regression = implied_d_prime(gains[["bad"]], gains[["baseline"]])[["d_prime"]])
  }
  sparse <- measured(0.05, 0)
  dense <- measured(0.6, 0.8)
  message(sprintf("true d' 1.5; rare events: matching %.2f, regression %.2f; 1.4 a second: %.2f, %.2f",
    sparse[1], sparse[2], dense[1], dense[2]))
  expect_lt(abs(sparse[["matching"]] - 1.5), 0.25)
  expect_lt(dense[["matching"]], 1.0)
  expect_lt(abs(dense[["regression"]] - 1.5), 0.15)
})
