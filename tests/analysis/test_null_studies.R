# Null studies: how often each test of delay rejects when there is no effect on the average
# participant. The tables beside were made by null_studies.R, whose seeds are 1, 2, 3 ...; what they
# say is reported as found.
# SPDX-License-Identifier: MIT
library(testthat)

source(file.path(root, "tests/analysis/null_model.R"))
null_table <- function(name) read.csv(file.path(root, "tests/analysis", name))

test_that("the quick ANOVA is the analysis's own main effect, Greenhouse and Geisser's p and all", {
  for (seed in 1:3) {
    trials <- null_trials(seed)
    own <- repeated_measures_tests(trials, "delay_ms")$rows
    expect_equal(greenhouse_geisser_p(participant_means(trials, "delay_ms")), own$p, tolerance = 1e-6)
  }
})

test_that("the committed tables are those of their seeds", {
  means <- null_table("null_studies.csv")
  expect_equal(means$seed, 1:2000)
  for (seed in c(1, 777, 2000)) {
    expect_equal(unlist(means[seed, ]), unlist(null_means_row(seed)), tolerance = 1e-5)
  }
  mixed <- null_table("null_studies_mixed.csv")
  expect_equal(mixed$seed, 1:200)
})

test_that("the ANOVA on participants' means keeps its level where slopes differ; the pooled one does not", {
  means <- null_table("null_studies.csv")
  anova <- rejection_rate(means$anova_p)
  pooled <- rejection_rate(means$pooled_p)
  mixed <- rejection_rate(null_table("null_studies_mixed.csv")$mixed_p)
  say_rate <- function(name, rate) message(sprintf("%s: %d of %d rejected, %.3f [%.3f, %.3f]",
    name, rate$rejected, rate$studies, rate$rate, rate$interval_low, rate$interval_high))
  say_rate("ANOVA on means", anova)
  say_rate("pooled ANOVA", pooled)
  say_rate("mixed model", mixed)
  # .05 of 2,000 with four binomial standard errors: .031 to .069.
  expect_lt(abs(anova$rate - 0.05), 0.02)
  expect_gt(pooled$interval_low, 0.2)
})

test_that("mixed models of words and of their interactions keep their level where participants differ", {
  of_words <- null_table("null_studies_words.csv")
  expect_equal(of_words$seed, 1:200)
  for (p in of_words[c("kind_p", "cells_p")]) {
    # .05 of 200 with four binomial standard errors; with slopes over 1, 2, 3 they rejected .34 and
    # .19 of the first 80.
    expect_lt(rejection_rate(p)$rate, 0.05 + 4 * sqrt(0.05 * 0.95 / 200))
  }
})

test_that("without differences in slope the pooled test is harmless: slopes are what breaks it", {
  p <- vapply(1:150, function(seed) {
    stats::anova(stats::lm(rating ~ delay_ms, null_trials(seed, slope_sd = 0)))[["Pr(>F)"]][1]
  }, 0)
  expect_lt(mean(p < 0.05), 0.05 + 4 * sqrt(0.05 * 0.95 / 150))
})

test_that("all 2,000 come out again, and the first mixed models (slow)", {
  skip_if_not(run_slow, "--slow not given")
  means <- null_table("null_studies.csv")
  again <- do.call(rbind, lapply(means$seed, null_means_row))
  expect_equal(unlist(again), unlist(means), tolerance = 1e-5)
  mixed <- null_table("null_studies_mixed.csv")
  expect_equal(null_mixed_row(1)$mixed_p, mixed$mixed_p[1], tolerance = 0.01)
  of_words <- null_table("null_studies_words.csv")
  expect_equal(null_words_row(1), of_words[1, ], tolerance = 0.01)
})
