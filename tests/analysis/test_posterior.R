# Draws from posteriors that are known.
# SPDX-License-Identifier: MIT

# The logarithm of a normal distribution.
normal <- function(middle, covariance) {
  precision <- solve(covariance)
  function(x) -0.5 * drop(t(x - middle) %*% precision %*% (x - middle))
}

test_that("draws are of the posterior, whatever the first guess of its shape", {
  covariance <- matrix(c(1, 1.8, 1.8, 4), 2)
  set.seed(1)
  sampled <- sample_posterior(normal(c(3, -1), covariance), c(0, 0), 0.01 * diag(2))
  drawn <- do.call(rbind, sampled$chains)
  error <- sqrt(diag(covariance) / sampled$enough)  # of a mean
  expect_true(all(abs(colMeans(drawn) - c(3, -1)) < 4 * error))
  expect_equal(stats::cov(drawn), covariance, tolerance = 0.2)
  expect_true(all(sampled$rhat <= 1.01) && all(sampled$enough >= 400))
})

test_that("what cannot be is never drawn", {
  half <- function(x) if (x < 0) -Inf else -x^2 / 2
  set.seed(1)
  drawn <- do.call(rbind, sample_posterior(half, 1, matrix(1))$chains)
  expect_gte(min(drawn), 0)
  expect_equal(mean(drawn), sqrt(2 / pi), tolerance = 0.15)
})

test_that("chains in two valleys that nobody crosses are told not to agree", {
  chains <- lapply(c(-5, -5, 5, 5), function(middle) {
    matrix(middle + sin(seq_len(500)), ncol = 1)
  })
  expect_gt(judge_chains(chains)$rhat, 2)
})

test_that("how far it is is told, never above all", {
  told <- c()
  set.seed(1)
  sample_posterior(normal(0, matrix(1)), 0, matrix(1), function(share) told <<- c(told, share))
  expect_true(all(told > 0 & told <= 1))
})
