# SPDX-License-Identifier: MIT
library(testthat)

obk <- function() {
  data(obk.long, package = "afex", envir = environment())
  data.frame(participant = factor(obk.long$id), rating = obk.long$value, phase = obk.long$phase,
    hour = obk.long$hour)
}

test_that("the ANOVA agrees with base R's strata and Greenhouse–Geisser on obk.long", {
  trials <- obk()
  rows <- repeated_measures_tests(trials, c("phase", "hour"))$rows
  strata <- summary(aov(rating ~ phase * hour + Error(participant / (phase * hour)), trials))
  F_of <- function(stratum) strata[[paste0("Error: participant:", stratum)]][[1]][["F value"]][1]
  expect_equal(rows$statistic, vapply(c("phase", "hour", "phase:hour"), F_of, 0,
    USE.NAMES = FALSE))
  # Epsilon from the covariance of the phase means: tr(S)^2 / (df tr(S^2)) in orthonormal contrasts.
  contrasts <- qr.Q(qr(contr.helmert(3)))
  covariance <- t(contrasts) %*% cov(participant_means(trials, "phase")) %*% contrasts
  epsilon <- sum(diag(covariance))^2 / (2 * sum(covariance^2))
  expect_equal(rows$df1[1], 2 * epsilon)
  expect_equal(rows$df2[1], 2 * 15 * epsilon)
})

test_that("generalised eta squared is SS / (SS + every error) and lies in its interval", {
  trials <- obk()
  row <- repeated_measures_tests(trials, c("phase", "hour"))$rows[1, ]
  strata <- summary(aov(rating ~ phase * hour + Error(participant / (phase * hour)), trials))
  squares <- lapply(strata, function(s) s[[1]][["Sum Sq"]])
  errors <- sum(vapply(squares, function(s) s[length(s)], 0))
  phase <- squares[["Error: participant:phase"]][1]
  expect_equal(row$effect_size, phase / (phase + errors))
  expect_lt(row$interval_low, row$effect_size)
  expect_gt(row$interval_high, row$effect_size)
})

test_that("a participant with an empty cell is left out and counted", {
  trials <- obk()
  trials <- trials[!(trials$participant == "3" & trials$phase == "pre" & trials$hour == "1"), ]
  result <- repeated_measures_tests(trials, c("phase", "hour"))
  expect_equal(unique(result$rows$participants), 15)
  expect_equal(result$remarks,
    "1 participant without a rating in every cell is left out of the repeated-measures ANOVA.")
})

test_that("epsilon is afex's where afex has one, of interactions and with groups too", {
  data(obk.long, package = "afex", envir = environment())
  trials <- cbind(obk(), treatment = obk.long$treatment)
  compare <- function(factors, between = NULL) {
    model <- summary(suppressMessages(suppressWarnings(afex::aov_ez("participant", "rating", trials,
      within = factors, between = between, fun_aggregate = mean))))
    theirs <- model$pval.adjustments[, "GG eps"]
    fit <- suppressMessages(fit_anova(trials, factors, between))
    own <- epsilon_of_effects(trials, strsplit(names(theirs), ":", fixed = TRUE), factors, between)
    expect_equal(own, unname(theirs), tolerance = 1e-8)
    mine <- match(names(theirs), fit$effect)
    expect_equal(fit$df2[mine], unname(theirs * model$univariate.tests[names(theirs), "den Df"]),
      tolerance = 1e-8)
  }
  compare(c("phase", "hour"))                # 2, 4 and 8 df, 16 participants
  compare(c("phase", "hour"), "treatment")   # the error is that within groups of 5, 5 and 6
})

test_that("an effect of more df than there are participants is corrected as any other", {
  trials <- obk()
  trials <- droplevels(trials[trials$participant %in% c("1", "4", "9"), ])
  result <- repeated_measures_tests(trials, c("phase", "hour"))
  expect_equal(result$remarks, character())
  rows <- result$rows
  expect_match(rows$method, "Greenhouse")
  # The interaction's covariance by hand: what cell means have beyond those of phase, hour and person.
  means <- participant_means(trials, c("phase", "hour"))
  centre <- function(k) diag(k) - 1 / k
  S <- cov(means %*% kronecker(centre(3), centre(5)))
  epsilon <- sum(diag(S))^2 / (8 * sum(S^2))
  expect_lt(epsilon, 2 / 8 + 1e-9)  # two dimensions at most, of three participants
  interaction <- rows[rows$effect == "phase:hour", ]
  expect_equal(c(interaction$df1, interaction$df2), epsilon * c(8, 16))
  expect_equal(interaction$p, pf(interaction$statistic, epsilon * 8, epsilon * 16,
    lower.tail = FALSE))
})

test_that("the interval of generalised eta squared is in the units of its estimate", {
  # Of a main effect: SS of the population's means is lambda times the error's mean square; errors
  # tend to n / (n - 1) of theirs.
  trials <- obk()
  fit <- suppressMessages(fit_anova(trials, c("phase", "hour")))
  fit <- fit[fit$effect == "phase", ]
  lambda <- noncentrality_limits(fit$F, fit$df1, fit$df2)
  at <- vapply(lambda, function(ncp) pf(fit$F, fit$df1, fit$df2, ncp = ncp), 0)
  expect_equal(unname(at), c(.95, .05), tolerance = 1e-6)  # uniroot's tolerance
  errors <- fit$ss / fit$ges - fit$ss
  ss <- lambda * fit$ss_error / fit$df2
  row <- repeated_measures_tests(trials, c("phase", "hour"))$rows[1, ]
  expect_equal(c(row$interval_low, row$interval_high), unname(ss / (ss + errors * 16 / 15)))
})

test_that("Friedman's test gives the published result for the rounding times", {
  # Hollander and Wolfe (1973), p. 140, as in ?friedman.test: chi-squared(2) = 11.143, p = .003805
  times <- matrix(c(
    5.40, 5.50, 5.55, 5.85, 5.70, 5.75, 5.20, 5.60, 5.50, 5.55, 5.50, 5.40, 5.90, 5.85, 5.70,
    5.45, 5.55, 5.60, 5.40, 5.40, 5.35, 5.45, 5.50, 5.35, 5.25, 5.15, 5.00, 5.85, 5.80, 5.70,
    5.25, 5.20, 5.10, 5.65, 5.55, 5.45, 5.60, 5.35, 5.45, 5.05, 5.00, 4.95, 5.50, 5.50, 5.40,
    5.45, 5.55, 5.50, 5.55, 5.55, 5.35, 5.45, 5.50, 5.55, 5.50, 5.45, 5.25, 5.65, 5.60, 5.40,
    5.70, 5.65, 5.55, 6.30, 6.30, 6.25
  ), 22, byrow = TRUE)
  trials <- data.frame(participant = rep(1:22, 3), rating = as.vector(times),
    method = factor(rep(1:3, each = 22)))
  row <- friedman_tests(trials, "method")$rows
  expect_equal(row$statistic, 11.143, tolerance = 1e-4)  # published to 3 decimals
  expect_equal(row$p, 0.003805, tolerance = 1e-3)        # published to 4 digits
  # W of ranks with ties, 12 S / (n^2 (k^3 - k) - n sum(t^3 - t)): Kendall and Babington Smith (1939).
  ranks <- t(apply(times, 1, rank))
  ties <- sum(apply(times, 1, function(row) sum(table(row)^3 - table(row))))
  expect_equal(row$effect_size,
    12 * sum((colSums(ranks) - mean(colSums(ranks)))^2) / (22^2 * (3^3 - 3) - 22 * ties))
  expect_true(is.na(row$interval_low) && is.na(row$interval_high))
})

test_that("the pooled ANOVA is the thesis's: every trial, overall and at each speed", {
  trials <- causality_trials(seed = 41, participants = 4)
  trials$delay_ms <- factor(trials$delay_ms)
  trials$speed_deg_s <- factor(trials$speed_deg_s)
  rows <- pooled_tests(trials, "delay_ms", by = "speed_deg_s")$rows
  expect_equal(rows$effect, c("delay_ms", paste("delay_ms at speed_deg_s", c(5, 10, 15))))
  expect_equal(rows$df2, c(4 * 81 - 3, rep(4 * 27 - 3, 3)))
  expect_equal(rows$statistic[1],
    oneway.test(rating ~ delay_ms, trials, var.equal = TRUE)$statistic[["F"]])
  expect_match(rows$method, "treats trials as independent")
})

test_that("Holm's correction stays within its family", {
  row <- function(family, p) test_row(family, "m", "e", "z", 1, 1, p = p)
  tests <- combine_outcomes(outcome(rbind(row("A", 0.01), row("B", 0.02), row("A", 0.03))))
  expect_equal(tests$rows$p_holm, c(0.02, 0.02, 0.03))  # A: 2 × .01, 1 × .03; B: 1 × .02
})

test_that("the page says what the interval of generalised eta squared is", {
  expect_match(test_lines(combine_outcomes(repeated_measures_tests(obk(), "phase"))$rows),
    "tends to with more participants", fixed = TRUE, all = FALSE)
})
