# SPDX-License-Identifier: MIT
library(testthat)

source(file.path(root, "tests/analysis/null_model.R"))

# The tests on good data, with the fit of some random parts made to fail.
fit_family_with <- function(failing) {
  trials <- causality_trials(seed = 54, participants = 5)
  trials$delay_ms <- factor(trials$delay_ms)
  real <- fit_rating_model
  on.exit(assign("fit_rating_model", real, globalenv()))
  assign("fit_rating_model", function(trials, factors, random, ...) {
    if (random %in% failing) list(failure = "planted") else real(trials, factors, random, ...)
  }, globalenv())
  suppressMessages(factor_tests(trials, "delay_ms"))
}

test_that("the mixed model gives the published fit of the wine data", {
  # Christensen, clmm2 tutorial (package ordinal): rating ~ temp + contact + (1 | judge), Laplace:
  # temp 3.063, contact 1.835, their errors .5954 and .5125, log-likelihood -81.57
  data(wine, package = "ordinal", envir = environment())
  trials <- data.frame(participant = wine$judge, rating = as.integer(wine$rating),
    temp = wine$temp, contact = wine$contact)
  rows <- one_model_tests(trials, c("temp", "contact"))$rows
  odds <- rows[rows$family == kOddsFamily, ]
  # Published to 4 digits.
  expect_equal(log(odds$effect_size), c(3.063, 1.835), tolerance = 1e-3)
  expect_equal(odds$statistic, c(3.0630 / .5954, 1.8349 / .5125), tolerance = 1e-3)
  expect_equal(log(odds$interval_high), c(3.0630 + 1.96 * .5954, 1.8349 + 1.96 * .5125),
    tolerance = 1e-3)
  full <- fit_rating_model(transform(trials, rating = ordered(rating)), c("temp", "contact"),
    "(1 | participant)")
  expect_equal(full$log_likelihood, -81.57, tolerance = 1e-4)
})

test_that("likelihood-ratio tests compare with the model without the factor", {
  data(wine, package = "ordinal", envir = environment())
  trials <- data.frame(participant = wine$judge, rating = as.integer(wine$rating),
    temp = wine$temp, contact = wine$contact)
  rows <- one_model_tests(trials, c("temp", "contact"))$rows
  cold <- function(formula) as.numeric(logLik(ordinal::clmm(formula, wine)))
  full <- cold(rating ~ temp + contact + (1 | judge))
  reduced <- c(cold(rating ~ contact + (1 | judge)), cold(rating ~ temp + (1 | judge)))
  expected <- 2 * (full - reduced)
  # 1e-4: the optimiser's tolerance from two starting places
  expect_equal(rows$statistic[1:2], expected, tolerance = 1e-4)
})

test_that("planted odds of a delay are recovered, in order and size", {
  set.seed(51)
  plan <- causality_plan(participants = 20)
  planted <- c("0" = 0, "100" = 1.5, "300" = 4)
  person <- factor(plan$participant)
  eta <- planted[as.character(plan$delay_ms)] - 1.5 + rnorm(20, 0, 0.6)[person]
  position <- eta + rlogis(nrow(plan))
  plan$rating <- 1 + (position > -1) + (position > 1.2)
  plan$delay_ms <- factor(plan$delay_ms)
  plan$viewpoint_deg <- factor(plan$viewpoint_deg)
  rows <- one_model_tests(plan, c("delay_ms", "viewpoint_deg"))$rows
  odds <- rows[rows$family == kOddsFamily & startsWith(rows$effect, "delay_ms"), ]
  error <- log(odds$effect_size) / odds$statistic
  # Three standard errors: a right model misses it for one coefficient in 370.
  expect_true(all(abs(log(odds$effect_size) - planted[-1]) < 3 * error))
  expect_lt(odds$effect_size[1], odds$effect_size[2])
  expect_lt(rows$p[rows$effect == "delay_ms"], 1e-10)
})

test_that("a slope of delay for each participant is fitted where it converges", {
  trials <- causality_trials(seed = 3, participants = 12, repetitions = 1)
  trials$delay_ms <- factor(trials$delay_ms)
  result <- suppressMessages(factor_tests(trials, "delay_ms"))
  expect_length(result$remarks, 0)
  expect_match(result$rows$method, "(1 + slope | participant)", fixed = TRUE)
})

test_that("what participants may differ in follows from what is tested", {
  trials <- null_words_trials(seed = 1, participants = 3)
  trials$pair <- factor(ifelse(trials$kind == "odd", "odd", "even"))
  trials$group <- factor(trials$participant)
  # Numbers and two words have a slope; three words none, for they have no order.
  for (factor in c("speed_deg_s", "pair")) {
    expect_equal(random_parts(trials, factor), c("(1 + slope | participant)", "(1 | participant)"))
  }
  expect_equal(random_parts(trials, "kind"),
    c("(1 | participant) + (1 | participant:kind)", "(1 | participant)"))
  expect_equal(random_parts(trials, "kind:pair"), c(
    "(1 | participant) + (1 | participant:kind) + (1 | participant:pair) + (1 | participant:kind:pair)",
    "(1 | participant) + (1 | participant:kind:pair)", "(1 | participant)"))
  # Of what each participant has one level of, nothing can differ within them.
  expect_equal(random_parts(trials, "group"), "(1 | participant)")
  expect_equal(random_parts(trials, "group:kind"), random_parts(trials, "kind"))
  expect_equal(random_parts(trials, character()), "(1 | participant)")
})

test_that("the order of words changes no test of them", {
  trials <- null_words_trials(seed = 2, participants = 8)
  turned <- transform(trials, kind = factor(kind, c("odd", "hard", "soft")))
  p_of <- function(trials) suppressMessages(factor_tests(trials, "kind"))$rows$p[1]
  expect_equal(p_of(turned), p_of(trials), tolerance = 1e-5)
})

test_that("when no slope converges the model falls back to an intercept and says so", {
  result <- fit_family_with(failing = "(1 + slope | participant)")
  expect_match(result$rows$method, "(1 | participant)", fixed = TRUE)
  expect_equal(result$remarks, paste(
    "The mixed model for the test of delay_ms (intercept and slope for each participant) did not",
    "converge: planted."
  ))
})

test_that("when no random part converges no mixed model is reported", {
  result <- fit_family_with(failing = c("(1 + slope | participant)", "(1 | participant)"))
  expect_null(result$rows)
  expect_equal(result$remarks[2:3], c("The mixed model for the test of delay_ms (intercept for each participant) did not converge: planted.",
    "No mixed model for the test of delay_ms is reported."))
})

test_that("identical participants leave no mixed model, in words and without a warning", {
  one <- causality_trials(seed = 4, participants = 1)
  trials <- do.call(rbind, lapply(1:6, function(i) transform(one, participant = paste0("P", i))))
  factors <- c("delay_ms", "speed_deg_s", "viewpoint_deg")
  trials[factors] <- lapply(trials[factors], factor)
  expect_silent(result <- one_model_tests(trials, factors))
  expect_null(result$rows)
  expect_equal(result$remarks, c(
    "The mixed model (intercept for each participant) did not converge: its Hessian is singular.",
    "No mixed model is reported."
  ))
})

test_that("levels that separate the ratings are named and no odds ratio is given", {
  trials <- causality_trials(seed = 52, participants = 5)
  trials$rating <- c("0" = 1, "100" = 2, "300" = 3)[as.character(trials$delay_ms)]
  trials$delay_ms <- factor(trials$delay_ms)
  result <- suppressMessages(factor_tests(trials, "delay_ms"))
  expect_null(result$rows)
  expect_equal(result$remarks, paste(
    "The levels of delay_ms separate the ratings completely, so the mixed model has no finite ratio",
    "and was not fitted; see the other tests."
  ))
})

test_that("levels separate when they share no more than a boundary", {
  separated <- function(a, b) {
    separates(data.frame(rating = c(a, b), f = factor(rep(1:2, c(length(a), length(b))))), "f")
  }
  expect_true(separated(c(1, 1), c(1, 2, 3)))
  expect_true(separated(c(1, 2), c(2, 3)))
  expect_true(separated(c(3, 2), c(1, 2)))
  expect_false(separated(c(1, 2, 3), c(1, 2, 3)))
  expect_false(separated(c(1, 3), c(2, 2)))
})

test_that("two participants are too few for a mixed model", {
  trials <- causality_trials(seed = 53, participants = 2)
  trials$delay_ms <- factor(trials$delay_ms)
  expect_equal(factor_tests(trials, "delay_ms")$remarks,
    "The mixed model needs three participants or more and was not fitted.")
})
