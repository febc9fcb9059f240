# SPDX-License-Identifier: MIT
library(testthat)

# Hand values are given to 4 decimals or more; this is their rounding.
kHandRounding <- 1e-4

test_that("a t interval is mean ± t(.975, n - 1) s / sqrt(n)", {
  # 1..5: mean 3, s = sqrt(2.5), t(.975, 4) = 2.776445, half = 2.776445 * 0.707107 = 1.963243
  interval <- t_interval(1:5)
  expect_equal(interval[["low"]], 3 - 1.963243, tolerance = kHandRounding)
  expect_equal(interval[["high"]], 3 + 1.963243, tolerance = kHandRounding)
})

test_that("a single value has a mean and no limits", {
  expect_equal(t_interval(2), c(mean = 2, low = NA, high = NA))
})

test_that("a Cousineau–Morey interval takes out participants' means and widens by sqrt(J/(J-1))", {
  # Participants (1, 2), (2, 4), (3, 3): own means out, grand mean 2.5 in: columns (2, 1.5, 2.5)
  # and (3, 3.5, 2.5), s = .5 each; half = 4.302653 * sqrt(2) * .5 / sqrt(3) = 1.756552
  means <- matrix(c(1, 2, 3, 2, 4, 3), 3, dimnames = list(NULL, c("0", "100")))
  interval <- cousineau_morey(means)
  expect_equal(interval$mean, c(2, 3))
  expect_equal(interval$high - interval$mean, c(1.756552, 1.756552), tolerance = kHandRounding)
})

test_that("a Cousineau–Morey interval does not depend on how participants differ overall", {
  set.seed(11)
  means <- matrix(rnorm(30), 10, dimnames = list(NULL, 1:3))
  shifted <- means + 100 * (1:10)
  width <- function(m) with(cousineau_morey(m), high - low)
  expect_equal(width(means), width(shifted), tolerance = 1e-9)  # rounding of sums near 1000
})

test_that("one participant has means and no Cousineau–Morey limits", {
  interval <- cousineau_morey(matrix(1:3, 1, dimnames = list("P1", 1:3)))
  expect_equal(interval$mean, 1:3)
  expect_true(all(is.na(c(interval$low, interval$high))))
})

test_that("intervals of partial eta squared are Smithson's", {
  # Smithson (2001), p. 619, as computed by apaTables: F(1, 42) = 6.00 and F(6, 42) = 2.65
  expect_equal(unname(eta_squared_interval(6.00, 1, 42)), c(.0117, .2801), tolerance = 5e-3)
  expect_equal(unname(eta_squared_interval(2.65, 6, 42)), c(.0174, .3577), tolerance = 5e-3)
})

test_that("the limits put the observed F at the 5th and 95th percentile", {
  from_eta <- function(eta, df1, df2) eta / (1 - eta) * (df1 + df2 + 1)
  limits <- eta_squared_interval(9, 2, 38)
  at <- vapply(limits, function(eta) pf(9, 2, 38, ncp = from_eta(eta, 2, 38)), 0)
  expect_equal(unname(at), c(.95, .05), tolerance = 1e-6)  # uniroot's tolerance
})

test_that("a lower limit is 0 where p > .05", {
  expect_equal(eta_squared_interval(1.5, 1, 16)[["low"]], 0)
})

test_that("the bootstrap is the same twice and leaves the caller's random numbers alone", {
  means <- matrix(c(1, 2, 3, 4, 2, 3, 1, 5), 4)
  set.seed(5)
  expected <- runif(1)
  set.seed(5)
  first <- bootstrap_interval(means, mean, draws = 50)
  expect_equal(runif(1), expected)
  expect_equal(bootstrap_interval(means, mean, draws = 50), first)
  expect_lt(first[["low"]], first[["high"]])
})
