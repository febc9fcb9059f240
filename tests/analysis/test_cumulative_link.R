# The fit of cumulative-link mixed models against the package's slow one, against differences, and
# against a likelihood of the test's own.
# SPDX-License-Identifier: MIT
library(testthat)

# Ratings of participants who differ in level and in how the delay acts on them.
sloped_trials <- function(seed, participants = 6, slope_sd = 0.8) {
  set.seed(seed)
  plan <- causality_plan(participants, repetitions = 1)
  person <- factor(plan$participant)
  plan$slope <- as.numeric(scale(plan$delay_ms))
  plan$rating <- factor(ratings_at(rnorm(participants, 0, 0.8)[person] + plan$slope *
    rnorm(participants, 1, slope_sd)[person]), ordered = TRUE)
  plan[c("delay_ms", "speed_deg_s")] <- lapply(plan[c("delay_ms", "speed_deg_s")], factor)
  plan
}

kRandomParts <- c("(1 | participant)", "(1 + slope | participant)",
  "(1 | participant) + (1 | participant:delay_ms)",
  "(1 | participant) + (1 | participant:delay_ms) + (1 | participant:delay_ms:speed_deg_s)")

test_that("the gradient is that of differences, for every link and every random part", {
  trials <- sloped_trials(11)
  for (link in names(kLinks)) {
    for (random in kRandomParts) {
      data <- link_data(as.integer(trials$rating), model.matrix(~ delay_ms, trials)[, -1],
        as.integer(factor(trials$participant)), random_effects(trials, random), link)
      place <- c(-0.9, 0.8, 0.5, 1.1, c(0.7, -0.3, 0.6)[seq_along(data$parts)])
      at <- function(x) laplace_at(data, x, matrix(0, data$people, ncol(data$Z)))
      differences <- vapply(seq_along(place), function(i) {
        shift <- replace(numeric(length(place)), i, 1e-4)
        (at(place + shift)$value - at(place - shift)$value) / 2e-4
      }, 0)
      # Differences over 2e-4 of a value near 100 keep 1e-7 of a derivative near 10.
      expect_equal(at(place)$gradient, differences, tolerance = 1e-6, info = paste(link, random))
    }
  }
})

# Participants who differ in level and, at random, in each delay and in each cell of delay and speed.
celled_trials <- function(seed, participants = 8) {
  set.seed(seed)
  plan <- causality_plan(participants, repetitions = 2)
  deviations <- function(sd, ...) {
    cell <- interaction(plan$participant, ...)
    rnorm(nlevels(cell), 0, sd)[cell]
  }
  plan$rating <- ordered(ratings_at(deviations(0.7) + deviations(0.9, plan$delay_ms) +
    deviations(0.7, plan$delay_ms, plan$speed_deg_s) + (plan$delay_ms == 300)))
  columns <- c("participant", "delay_ms", "speed_deg_s")
  plan[columns] <- lapply(plan[columns], factor)
  plan
}

test_that("levels and cells within participants deviate as in ordinal::clmm", {
  trials <- celled_trials(17)
  for (random in kRandomParts[c(3, if (run_slow) 4)]) {  # each of the package's takes seconds
    own <- fit_rating_model(trials, "delay_ms", random)
    package <- ordinal::clmm(as.formula(paste("rating ~ delay_ms +", random)), trials)
    expect_equal(own$log_likelihood, package$logLik, tolerance = 1e-6, info = random)
    expect_equal(unname(c(own$alpha, own$beta)), unname(package$coefficients), tolerance = 2e-3)
    expect_equal(sqrt(diag(own$covariance)), sqrt(diag(vcov(package)))[names(own$beta)],
      tolerance = 5e-3, info = random)
    deviations <- vapply(ordinal::VarCorr(package), function(v) attr(v, "stddev")[[1]], 0)
    names(deviations) <- sub("^participant$", "intercept", gsub(":", " × ",
      sub("^participant:", "", names(deviations))))
    expect_equal(own$deviations, deviations[names(own$deviations)], tolerance = 5e-3, info = random)
  }
})

test_that("fits are those of ordinal::clmm: estimates, errors, spread and likelihood", {
  trials <- sloped_trials(12)
  for (link in c("logit", if (run_slow) "cloglog")) {  # each of the package's takes seconds
    own <- fit_rating_model(trials, "delay_ms", "(1 + slope | participant)", link = link)
    package <- ordinal::clmm(rating ~ delay_ms + (1 + slope | participant), trials, link = link)
    # Its own tolerance, 1e-4 in each participant's effects, is in its likelihood and derivatives.
    expect_equal(own$log_likelihood, package$logLik, tolerance = 1e-6, info = link)
    expect_equal(unname(c(own$alpha, own$beta)), unname(package$coefficients), tolerance = 1e-3)
    expect_equal(sqrt(diag(own$covariance)), sqrt(diag(vcov(package)))[names(own$beta)],
      tolerance = 2e-3, info = link)
    expect_equal(unname(own$deviations), unname(attr(ordinal::VarCorr(package)$participant,
      "stddev")), tolerance = 2e-3, info = link)
    effects <- own$eta - as.vector(model.matrix(~ delay_ms, trials)[, -1] %*% own$beta)
    first <- !duplicated(trials$participant)
    slope <- tapply(effects, trials$participant, function(x) diff(range(x))) /
      tapply(trials$slope, trials$participant, function(x) diff(range(x)))
    expect_equal(as.vector(slope), abs(ordinal::ranef(package)$participant$slope), tolerance = 0.01)
  }
})

# Minus the Laplace log likelihood of the wine data by sums over judges, the effect of each by
# Newton's method; place: four thresholds, temp, contact, log deviation.
wine_objective <- function(place, wine = ordinal::wine) {
  edges <- c(-Inf, place[1:4], Inf)
  fixed <- as.vector(model.matrix(~ temp + contact, wine)[, -1] %*% place[5:6])
  slope_of_density <- function(x) ifelse(is.finite(x), dlogis(x) * (1 - 2 * plogis(x)), 0)
  sum(vapply(split(seq_len(nrow(wine)), wine$judge), function(rows) {
    u <- 0
    for (round in 1:30) {
      eta <- fixed[rows] + exp(place[7]) * u
      high <- edges[as.integer(wine$rating[rows]) + 1] - eta
      low <- edges[as.integer(wine$rating[rows])] - eta
      P <- plogis(high) - plogis(low)
      first <- (dlogis(low) - dlogis(high)) / P
      curve <- 1 - exp(2 * place[7]) *
        sum((slope_of_density(high) - slope_of_density(low)) / P - first^2)
      u <- u - (u - exp(place[7]) * sum(first)) / curve
    }
    u^2 / 2 - sum(log(P)) + log(curve) / 2
  }, 0))
}

test_that("errors of the wine data are those of an own likelihood, to more digits than published", {
  model <- fit_rating_model(data.frame(participant = ordinal::wine$judge, ordinal::wine[c("rating",
    "temp", "contact")]), c("temp", "contact"), "(1 | participant)")
  place <- c(model$alpha, model$beta, log(model$deviations))
  expect_equal(model$log_likelihood, -wine_objective(place), tolerance = 1e-9)
  gradient <- vapply(1:7, function(i) {
    shift <- replace(numeric(7), i, 1e-4)
    (wine_objective(place + shift) - wine_objective(place - shift)) / 2e-4
  }, 0)
  expect_lt(max(abs(gradient)), 1e-3)
  errors <- sqrt(diag(solve(optimHess(place, wine_objective, control = list(ndeps =
    rep(1e-4, 7))))))
  expect_equal(unname(sqrt(diag(model$covariance))), unname(errors[5:6]), tolerance = 1e-5)
})

test_that("a fit does not hang on where it starts, nor on the participants' order", {
  trials <- sloped_trials(13)
  random <- "(1 + slope | participant)"
  own <- fit_rating_model(trials, c("delay_ms", "speed_deg_s"), random)
  far <- fit_rating_model(trials, c("delay_ms", "speed_deg_s"), random,
    like = list(spread = c(3, 1, 0.1)))
  turned <- fit_rating_model(trials[rev(seq_len(nrow(trials))), ], c("delay_ms", "speed_deg_s"),
    random)
  for (other in list(far, turned)) {
    expect_equal(other$log_likelihood, own$log_likelihood, tolerance = 1e-7)
    expect_equal(other$beta, own$beta, tolerance = 1e-3)
  }
})

test_that("where participants' slopes follow their intercepts wholly, errors are those at that edge", {
  edges <- 0
  for (seed in 23:27) {
    trials <- sloped_trials(seed, slope_sd = 0)
    own <- fit_rating_model(trials, "delay_ms", "(1 + slope | participant)")
    alone <- fit_rating_model(trials, "delay_ms", "(1 | participant)")
    expect_gte(own$log_likelihood, alone$log_likelihood - 1e-6)
    at_edge <- abs(own$spread[3]) < kNoSpread
    edges <- edges + at_edge
    expect_equal(nrow(own$Hessian), if (at_edge) 6 else 7)
    expect_true(all(diag(own$covariance) > 0))
  }
  expect_gt(edges, 0)
})

test_that("factors that cannot be told apart are a failure, in words", {
  trials <- sloped_trials(15)
  trials$again <- trials$delay_ms
  fit <- fit_rating_model(trials, c("delay_ms", "again"), "(1 | participant)")
  expect_match(fit$failure, "coefficient|cannot be told apart|singular")
})

test_that("ratings far from every threshold lose no digits", {
  data <- list(rating = c(1L, 2L, 3L), link = kLinks$logit)
  terms <- rating_terms(data, c(-1, 1.2), c(30, -30, -30))
  # F(31.2) - F(29) is 1 - F(29) less 1 - F(31.2).
  expect_equal(terms$log_p, c(plogis(-31, log.p = TRUE), log(plogis(-29) - plogis(-31.2)),
    plogis(-31.2, log.p = TRUE)), tolerance = 1e-12)
})
