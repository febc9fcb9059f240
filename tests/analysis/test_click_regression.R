# The regression of click rates gives back what was planted; matching beside it does not.
# SPDX-License-Identifier: MIT
library(testthat)

test_that("planted gains and intercept come back, within two standard errors about 95 % of the time", {
  set.seed(301)
  planted <- c(bad = 0.5, good = 0.1, difference = 0.4, intercept = 0.05)
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

# The clicks of a record as a regressand, with an intercept for each trial: list(fit, free).
regressed_bins <- function(record) {
  at <- record$first[record$click_trial] + record$click_bin + 1
  trial <- rep(seq_along(record$bins), record$bins)
  free <- rep(TRUE, nrow(record$rows))
  for (i in seq_along(at)) {
    after <- at[i] + 1:20
    after <- after[after <= length(trial)]
    free[after[trial[after] == trial[at[i]]]] <- FALSE
  }
  clicked <- tabulate(at, nrow(record$rows)) / kClickBinS
  list(fit = lm.fit(cbind(record$rows, outer(trial, unique(trial), `==`))[free, ], clicked[free]),
    trial = trial, free = free)
}

test_that("the closed form is a least-squares regression over free bins, an intercept per trial", {
  set.seed(303)
  record <- record_of(clicking_participant(0.4, 0.2, 0.1, trials = 6))
  oracle <- regressed_bins(record)
  expect_equal(fit_click_rate(record)$theta, unname(oracle$fit$coefficients[1:10]), tolerance = 1e-8)
  weights <- tabulate(oracle$trial[oracle$free])
  expect_equal(click_gains(record)$gains[["intercept"]],
    weighted.mean(oracle$fit$coefficients[-(1:10)], weights), tolerance = 1e-8)
})

test_that("shifted clicks are those of a record that has them there, within a trial", {
  set.seed(308)
  record <- record_of(clicking_participant(0.4, 0.2, 0.1, trials = 3))
  record$blocks[] <- 5L  # short, so that no click's time goes beyond the end
  shift <- c(0L, 3L, 7L)
  moved <- record
  moved$click_bin <- (record$click_bin + shift[record$click_trial]) %% 500L
  expect_equal(fit_click_rate(record, shift = shift), fit_click_rate(moved))
  expect_equal(fit_click_rate(record, shift = record$bins), fit_click_rate(record))
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

test_that("running sums are those of multiplying the bins, round their trial's end", {
  set.seed(309)
  record <- record_of(clicking_participant(0.4, 0.2, 0.1, trials = 2))
  short <- 7  # bins: a refractory period goes round more than twice
  record$rows <- rbind(record$rows, record$rows[seq_len(short) + 100, ])
  record$first <- c(record$first, sum(record$bins))
  record$bins <- c(record$bins, short)
  running <- running_products(record)
  for (trial in seq_along(record$bins)) {
    bins <- record$bins[trial]
    for (until in unique(c(0, 3, bins %/% 2, bins, bins + 20))) {
      inside <- record$first[trial] + (seq_len(until) - 1) %% bins + 1
      sums <- running$sums[, running$start[trial] + until] - running$sums[, running$start[trial]]
      expect_equal(symmetric(sums, 11),
        crossprod(cbind(rep(1, until), record$rows[inside, , drop = FALSE])))
    }
  }
})

test_that("trials with more events and more clicks at random show no gain", {
  # Between trials clicks rise with bad events, within them they come at any time.
  set.seed(310)
  gains <- replicate(40, click_gains(record_of(clicking_participant(0, 0, c(0.1, 0.9),
    bad_per_s = c(0.5, 3))))$gains[c("bad", "good", "difference")])
  # Unbiased: within 3.5 standard errors of 0. With one intercept for all trials bad would be .2.
  expect_true(all(abs(rowMeans(gains)) < 3.5 * apply(gains, 1, sd) / sqrt(40)))
  expect_lt(sd(gains["bad", ]) / sqrt(40), 0.02)
})

test_that("the shifts of such trials are centred on 0", {
  set.seed(311)
  records <- replicate(3, record_of(clicking_participant(0, 0, c(0.1, 0.9),
    bad_per_s = c(0.5, 3))), simplify = FALSE)
  null <- shifted_differences(records, shifts = 199)
  expect_lt(abs(mean(null)), 4 * sd(null) / sqrt(199))
})

test_that("false clicks are counted where no bad event came before, however dense the others", {
  set.seed(312)
  quiet <- rowSums(replicate(20, quiet_clicks(record_of(clicking_participant(0.15, 0, 0.05,
    bad_per_s = c(0, 2, 7), good_per_s = 2)))))
  # Poisson: three standard errors of the planted .05 per second.
  expect_lt(abs(quiet[["false_clicks"]] / quiet[["quiet_s"]] - 0.05),
    3 * sqrt(0.05 / quiet[["quiet_s"]]))
  drawn <- clicking_participant(0, 0, 0, trials = 1)
  drawn$events <- data.frame(row = 1, time_s = c(2, 5), bad = c(TRUE, FALSE))
  drawn$clicks <- data.frame(row = 1, time_s = c(1, 2.7, 5.7))
  # 10 s less the second from 2.2 to 3.2 and .4 s after each click; the click at 2.7 frees none.
  expect_equal(quiet_clicks(record_of(drawn)), c(false_clicks = 2, quiet_s = 10 - 1 - 0.8))
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
  false_per_s <- -log(1 - pnorm(-0.75))
  gain <- -log(1 - pnorm(0.75)) - false_per_s
  expect_equal(implied_d_prime(gain, false_per_s)[["d_prime"]], 1.5)
  measured <- function(bad_per_s, good_per_s) {
    set.seed(306)
    drawn <- clicking_participant(gain, 0, false_per_s, trials = 400, bad_per_s = bad_per_s,
      good_per_s = good_per_s)
    table <- matching_table(drawn$trials, drawn$events, drawn$clicks)
    fit <- click_gains(record_of(drawn))
    c(matching = table$d_prime[1],
      regression = implied_d_prime(fit$gains[["bad"]],
        fit$quiet[["false_clicks"]] / fit$quiet[["quiet_s"]])[["d_prime"]])
  }
  sparse <- measured(0.05, 0)
  dense <- measured(0.6, 0.8)
  message(sprintf("true d' 1.5; rare events: matching %.2f, regression %.2f; 1.4 a second: %.2f, %.2f",
    sparse[1], sparse[2], dense[1], dense[2]))
  expect_lt(abs(sparse[["matching"]] - 1.5), 0.25)
  expect_lt(dense[["matching"]], 1.0)
  expect_lt(abs(dense[["regression"]] - 1.5), 0.15)
})
