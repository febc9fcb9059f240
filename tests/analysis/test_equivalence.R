# SPDX-License-Identifier: MIT
library(testthat)

test_that("the equivalence test is the worse of two one-sided t tests", {
  differences <- c(-0.10, 0.00, 0.10, 0.20, -0.05, 0.06)
  row <- equivalence_test(differences, "x: 2 against 1", 0.15)$rows
  above <- t.test(differences, mu = -0.15, alternative = "greater")
  below <- t.test(differences, mu = 0.15, alternative = "less")
  expect_equal(row$p, max(above$p.value, below$p.value))
  expect_equal(row$statistic, below$statistic[["t"]])  # the mean is positive: the upper is worse
  expect_equal(c(row$interval_low, row$interval_high),
    as.vector(t.test(differences, conf.level = 0.90)$conf.int))
})

test_that("p < .05 just when the 90 % interval is inside the margin", {
  set.seed(21)
  agree <- replicate(200, {
    row <- equivalence_test(rnorm(12, 0.05, 0.15), "x", 0.15)$rows
    inside <- row$interval_low > -0.15 && row$interval_high < 0.15
    c(inside, row$p < 0.05)
  })
  expect_equal(agree[1, ], agree[2, ])
  expect_true(any(agree[1, ]) && !all(agree[1, ]))
})

test_that("differences that never vary are not tested", {
  result <- equivalence_test(rep(0.1, 5), "speed: 2 against 1", 0.15)
  expect_null(result$rows)
  expect_equal(result$remarks,
    "No equivalence test of speed: 2 against 1: the differences do not vary.")
})

test_that("a viewpoint without planted effect differs by less than .15 points", {
  trials <- causality_trials(seed = 31)
  factors <- c("delay_ms", "speed_deg_s", "viewpoint_deg")
  trials[factors] <- lapply(trials[factors], factor)
  rows <- equivalence_tests(trials, "viewpoint_deg")$rows
  expect_equal(nrow(rows), 3)
  # 20 participants × 27 ratings per level, s about .6 within a cell: the difference of two means
  # has a standard error of .6 * sqrt(2 / 540) = .037, so .15 is four of them.
  expect_true(all(abs(rows$effect_size) < 0.15))
})

test_that("a planted difference of half a point is never called equivalent", {
  trials <- causality_trials(seed = 32)
  factors <- c("delay_ms", "speed_deg_s", "viewpoint_deg")
  trials[factors] <- lapply(trials[factors], factor)
  expect_true(all(equivalence_tests(trials, "delay_ms")$rows$p > 0.95))
})
