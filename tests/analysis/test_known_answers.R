# The analyses against answers that are known: published ones on data that come with R's packages, and
# others by hand or by a maximum likelihood of the test's own.
# SPDX-License-Identifier: MIT
library(testthat)

# Equal to the digits that were printed.
expect_printed <- function(found, printed, digits) expect_equal(round(found, digits), printed)

test_that("ratings of wine come out as published (Randall 1989; Christensen 2018, tutorial on clmm)", {
  wine <- ordinal::wine
  trials <- data.frame(participant = wine$judge, rating = wine$rating, temp = wine$temp,
    contact = wine$contact)
  models <- fit_models(trials, c("temp", "contact"), character())
  model <- models$full
  expect_printed(model$log_likelihood, -81.57, 2)
  expect_printed(unname(model$beta), c(3.0630, 1.8349), 4)
  expect_printed(unname(model$alpha), c(-1.6237, 1.5134, 4.2285, 6.0888), 4)
  errors <- sqrt(diag(model$covariance))[c("tempwarm", "contactyes")]
  # Those printed are of derivatives by differences, off by 3e-5: .59539 and .51256 by the likelihood
  # of test_cumulative_link.R.
  expect_lt(max(abs(errors - c(0.5954, 0.5125))), 1e-4)
  expect_printed(model$deviations[["intercept"]]^2, 1.279, 3)
  rows <- model_tests(models, trials, c("temp", "contact"))$rows
  odds <- rows[rows$family == kOddsFamily, ]
  expect_printed(odds$statistic, c(5.145, 3.580), 3)
  expect_printed(log(odds$effect_size), c(3.0630, 1.8349), 4)
  # 3.0630 ± 1.96 · .5954
  expect_printed(log(c(odds$interval_low[1], odds$interval_high[1])), c(1.896, 4.230), 3)
})

test_that("the repeated measures of O'Brien and Kaiser (1985) come out as afex's documentation prints them", {
  data <- afex::obk.long
  trials <- data.frame(participant = data$id, rating = data$value, data[c("treatment", "gender",
    "phase", "hour")])
  rows <- suppressMessages(fit_anova(trials, c("phase", "hour"), between = c("treatment", "gender")))
  printed <- read.table(text = "
    effect                       df1   df2   F     ges  p
    treatment                    2     10    3.94  .278 .055
    gender                       1     10    3.66  .152 .085
    treatment:gender             2     10    2.86  .218 .104
    phase                        1.60  15.99 16.13 .217 .000
    treatment:phase              3.20  15.99 4.85  .143 .013
    gender:phase                 1.60  15.99 0.28  .005 .709
    treatment:gender:phase       3.20  15.99 0.64  .021 .612
    hour                         1.84  18.41 16.69 .183 .000
    treatment:hour               3.68  18.41 0.09  .002 .979
    gender:hour                  1.84  18.41 0.45  .006 .628
    treatment:gender:hour        3.68  18.41 0.62  .016 .641
    phase:hour                   3.60  35.96 1.18  .024 .335
    treatment:phase:hour         7.19  35.96 0.35  .014 .930
    gender:phase:hour            3.60  35.96 0.93  .019 .449
    treatment:gender:phase:hour  7.19  35.96 0.74  .029 .646", header = TRUE)
  rows <- rows[match(printed$effect, rows$effect), ]
  for (column in c("df1", "df2", "F")) expect_printed(rows[[column]], printed[[column]], 2)
  for (column in c("ges", "p")) expect_printed(rows[[column]], printed[[column]], 3)
})

test_that("Greenhouse and Geisser's epsilon is that of the covariance, by hand", {
  data <- afex::obk.long
  trials <- data.frame(participant = data$id, rating = data$value, phase = data$phase)
  row <- repeated_measures_tests(trials, "phase")$rows
  means <- participant_means(trials, "phase")
  S <- stats::cov(means %*% qr.Q(qr(stats::contr.helmert(3))))
  epsilon <- sum(diag(S))^2 / (2 * sum(S^2))
  expect_equal(row$df1, 2 * epsilon, tolerance = 1e-6)
  expect_equal(row$df2, 15 * 2 * epsilon, tolerance = 1e-6)
})

test_that("sleepstudy: participants' slopes give the published fixed effects (Bates 2015)", {
  # In a balanced study the mixed model's fixed effects and their errors are those of the
  # participants' own lines: 251.405 (6.825) and 10.467 (1.546).
  data <- lme4::sleepstudy
  lines <- t(vapply(split(data, data$Subject), function(one) {
    stats::coef(stats::lm(Reaction ~ Days, one))
  }, numeric(2)))
  for (i in 1:2) {
    interval <- t_interval(lines[, i])
    error <- (interval[["high"]] - interval[["low"]]) / (2 * stats::qt(0.975, 17))
    expect_printed(interval[["mean"]], c(251.405, 10.467)[i], 3)
    expect_printed(error, c(6.825, 1.546)[i], 3)
  }
  # And the paired t test of the slopes against nothing: t = 6.771, as lme4 prints.
  expect_printed(paired_test(lines[, 2], "f", "e", "s")$rows$statistic, 6.771, 3)
})

# Log likelihood of counts with a normal intercept for each participant, the integral over it by the
# trapezoid rule from -8 to 8 standard deviations. `log_p(y, mu)`: of one count.
counts_log_likelihood <- function(design, y, person, beta, deviation, log_p) {
  u <- seq(-8, 8, length.out = 161)
  eta <- outer(as.vector(design %*% beta), deviation * u, `+`)
  each <- rowsum(matrix(log_p(rep(y, length(u)), exp(as.vector(eta))), nrow(eta)), person)
  each <- sweep(each, 2, stats::dnorm(u, log = TRUE) + log(u[2] - u[1]), `+`)
  top <- apply(each, 1, max)
  sum(top + log(rowSums(exp(each - top))))
}

test_that("models of epil's counts are at the maximum of a likelihood of the test's own", {
  epil <- MASS::epil
  trials <- data.frame(participant = factor(epil$subject), clicks = epil$y, exposure_s = 1,
    epil[c("lbase", "trt", "lage", "V4")])
  terms <- c("lbase", "trt", "lage", "V4", "lbase:trt")
  design <- stats::model.matrix(~ lbase * trt + lage + V4, epil)
  person <- trials$participant
  poisson <- fit_count_model(trials, terms, "(1 | participant)", "Poisson")
  # As lme4's own summary prints them, to what its optimisers share.
  expect_printed(unname(poisson$beta[colnames(design)]),
    c(1.833, 0.883, -0.334, 0.481, -0.160, 0.339), 3)
  best <- stats::optim(c(poisson$beta[colnames(design)], 0.5), function(v) {
    -counts_log_likelihood(design, epil$y, person, v[1:6], abs(v[7]),
      function(y, mu) stats::dpois(y, mu, log = TRUE))
  }, method = "BFGS", control = list(reltol = 1e-10), hessian = TRUE)
  expect_equal(unname(poisson$beta[colnames(design)]), unname(best$par[1:6]), tolerance = 2e-3)
  errors <- sqrt(diag(solve(best$hessian)))[1:6]
  expect_equal(unname(sqrt(diag(poisson$covariance))[colnames(design)]), unname(errors),
    tolerance = 0.02)
  skip_if_not_installed("glmmTMB")
  negative <- fit_count_model(trials, terms, "(1 | participant)", "negative-binomial")
  best <- stats::optim(c(negative$beta[colnames(design)], 0.5, log(7)), function(v) {
    -counts_log_likelihood(design, epil$y, person, v[1:6], abs(v[7]),
      function(y, mu) stats::dnbinom(y, size = exp(v[8]), mu = mu, log = TRUE))
  }, method = "BFGS", control = list(reltol = 1e-10))
  expect_equal(unname(negative$beta[colnames(design)]), unname(best$par[1:6]), tolerance = 5e-3)
  expect_equal(negative$theta, exp(unname(best$par[8])), tolerance = 0.02)
  expect_equal(negative$log_likelihood, -best$value, tolerance = 1e-3)
})

test_that("the offset is an offset: twice the exposure, half the rate, and nothing else", {
  epil <- MASS::epil
  trials <- data.frame(participant = factor(epil$subject), clicks = epil$y, exposure_s = 1,
    trt = epil$trt, lbase = epil$lbase)
  one <- fit_count_model(trials, c("lbase", "trt"), "(1 | participant)", "Poisson")
  trials$exposure_s <- 2
  two <- fit_count_model(trials, c("lbase", "trt"), "(1 | participant)", "Poisson")
  expect_equal(two$beta[["(Intercept)"]], one$beta[["(Intercept)"]] - log(2), tolerance = 1e-4)
  expect_equal(two$beta[-1], one$beta[-1], tolerance = 1e-3)
})

test_that("d' and criterion of 20 hits of 25 and 10 false alarms of 25 are those by hand", {
  # z(.8) = .84162, z(.4) = -.25335: d' = 1.09497, c = -(.84162 - .25335) / 2 = -.29414
  plain <- d_prime(20 / 25, 10 / 25)
  expect_printed(plain[["d_prime"]], 1.09497, 5)
  expect_printed(plain[["criterion"]], -0.29414, 5)
  # (20.5 / 26, 10.5 / 26): z = .80072 and -.24378 (Hautus 1995)
  corrected <- log_linear_d_prime(20, 25, 10, 25)
  expect_printed(corrected[["d_prime"]], 1.04450, 5)
})

# The best of a fine grid over all parameters, refined thrice around its best.
grid_fit <- function(data, guess) {
  box <- list(threshold = range(data$x), spread = c(0.02, 1) * diff(range(data$x)),
    lapse = c(0, kLargestLapse), guess = if (is.null(guess)) c(0, kLargestGuess) else c(guess, guess))
  whole <- box
  for (round in 1:8) {
    grid <- expand.grid(lapply(box, function(ends) unique(seq(ends[1], ends[2], length.out = 13))))
    value <- vapply(seq_len(nrow(grid)), function(i) {
      p <- grid$guess[i] + (1 - grid$guess[i] - grid$lapse[i]) *
        pnorm((data$x - grid$threshold[i]) / grid$spread[i])
      sum(dbinom(data$positive, data$n, p, log = TRUE))
    }, 0)
    best <- as.list(grid[which.max(value), ])
    box <- Map(function(ends, middle, all) {
      pmin(pmax(middle + c(-1, 1) * diff(ends) / 4, all[1]), all[2])
    }, box, best, whole)
  }
  best
}

test_that("psychometric fits are at the maximum that a search over a grid finds", {
  set.seed(7)
  for (guess in list(0.5, NULL)) {
    x <- rep(seq(1, 7), each = 40)
    floor <- if (is.null(guess)) 0.05 else guess
    p <- floor + (1 - floor - 0.02) * pnorm((x - 4) / 1.2)
    data <- by_level(x, rbinom(length(x), 1, p))
    fit <- fit_psychometric(data, guess)
    found <- grid_fit(data, guess)
    expect_equal(fit$threshold, found$threshold, tolerance = 0.01)
    expect_equal(fit$spread, found$spread, tolerance = 0.03)
    likelihood <- function(fit) sum(dbinom(data$positive, data$n, psychometric_p(data$x, fit),
      log = TRUE))
    expect_gt(likelihood(fit), likelihood(found) - 1e-3)
  }
})

test_that("without guesses and lapses a psychometric fit is a probit regression", {
  data <- data.frame(x = 1:7, n = 50, positive = c(0, 2, 8, 25, 42, 48, 50))
  model <- stats::glm(cbind(positive, n - positive) ~ x, stats::binomial("probit"), data)
  fit <- fit_psychometric(data, guess = 0)
  expect_equal(fit$lapse, 0, tolerance = 1e-3)
  expect_equal(fit$threshold, unname(-coef(model)[1] / coef(model)[2]), tolerance = 1e-3)
  expect_equal(fit$spread, unname(1 / coef(model)[2]), tolerance = 1e-2)
  expect_equal(fit$deviance, model$deviance, tolerance = 1e-3)
})
