# Factors between participants: each participant has one level, so nothing pairs their means.
# SPDX-License-Identifier: MIT
library(testthat)

groups_of_obk <- function() {
  data(obk.long, package = "afex", envir = environment())
  data.frame(participant = factor(obk.long$id), rating = obk.long$value, phase = obk.long$phase,
    treatment = obk.long$treatment)
}

test_that("a factor is between participants when each has one level of it", {
  trials <- groups_of_obk()
  expect_equal(between_factors(trials, c("phase", "treatment")), "treatment")
  expect_equal(within_factors(trials, c("phase", "treatment")), "phase")
  expect_equal(between_factors(trials[trials$participant == "1", ], "treatment"), character())
})

test_that("the ANOVA of a mixed design agrees with base R's strata on obk.long", {
  trials <- groups_of_obk()
  trials <- trials[trials$participant %in% c(1:4, 6:9, 11:14), ]  # as many in each group
  rows <- repeated_measures_tests(trials, c("phase", "treatment"))$rows
  means <- aggregate(rating ~ participant + phase + treatment, droplevels(trials), mean)
  strata <- summary(aov(rating ~ phase * treatment + Error(participant / phase), means))
  treatment <- rows[rows$effect == "treatment", ]
  expect_equal(treatment$statistic, strata[["Error: participant"]][[1]][["F value"]][1])
  expect_equal(c(treatment$df1, treatment$df2), c(2, 9))
  expect_match(treatment$method, "between participants")
  phase <- rows[rows$effect == "phase", ]
  expect_equal(phase$statistic, strata[["Error: participant:phase"]][[1]][["F value"]][1])
  expect_match(phase$method, "Greenhouse")
})

test_that("what is paired within participants is no table's row of a factor between them", {
  trials <- groups_of_obk()
  trials[c("phase", "treatment")] <- lapply(trials[c("phase", "treatment")], factor)
  rows <- data_sensitivity(list(trials = trials, factors = c("phase", "treatment"),
    enrolments = data.frame(participant = character(), finished_utc = character())),
    list(of = "rating"))
  expect_match(rows$comparison, "^phase", ignore.case = TRUE)
  expect_equal(rows$participants, 16)
})

test_that("with factors between participants alone the ANOVA is one of their means", {
  trials <- groups_of_obk()
  row <- repeated_measures_tests(trials, "treatment")$rows
  means <- aggregate(rating ~ participant + treatment, trials, mean)
  table <- anova(lm(rating ~ treatment, means))
  expect_equal(row$statistic, table[["F value"]][1])
  expect_equal(row$p, table[["Pr(>F)"]][1])
  expect_equal(row$effect_size, table[["Sum Sq"]][1] / sum(table[["Sum Sq"]]))
})

test_that("an error that is nothing but rounding is none to test against", {
  trials <- expand.grid(participant = factor(c("a", "b", "c")), speed = factor(c(8, 12)))
  trials$rating <- c(0.1, 0.2, 0.4, 0.4, 0.5, 0.7)  # each .3 more
  outcome <- repeated_measures_tests(trials, "speed")
  expect_equal(NROW(outcome$rows), 0L)
  expect_match(outcome$remarks, "no variance left within participants", fixed = TRUE)
})

test_that("tests that pair a participant's means leave such a factor out and say why", {
  result <- friedman_tests(groups_of_obk(), c("phase", "treatment"))
  expect_equal(result$rows$effect, "phase")
  expect_equal(result$remarks,
    "No Friedman test of treatment: each participant has one level of it.")
  expect_match(equivalence_tests(groups_of_obk(), "treatment")$remarks, "^No equivalence test of")
})

test_that("the mixed model tests it without a slope, and its p is that of groups, not of trials", {
  set.seed(1)
  plan <- causality_plan(participants = 24, repetitions = 1)
  number <- as.integer(factor(plan$participant))
  plan$keys <- factor(ifelse(number %% 2 == 0, "f j", "j f"))
  # People differ by a standard deviation of 1.5, the groups by nothing.
  intercept <- rnorm(24, 0, 1.5)
  plan$rating <- ratings_at(intercept[number])
  plan$participant <- factor(plan$participant)
  plan$delay_ms <- factor(plan$delay_ms)
  result <- suppressMessages(factor_tests(plan, c("delay_ms", "keys")))
  keys <- result$rows[result$rows$effect == "keys", ]
  expect_match(keys$method, "(1 | participant)", fixed = TRUE)
  expect_match(result$rows$method[result$rows$effect == "delay_ms"], "slope", fixed = TRUE)
  naive <- suppressWarnings(chisq.test(table(plan$keys, plan$rating))$p.value)
  expect_gt(keys$p, naive)
  expect_gt(keys$p, 0.05)
})

test_that("means have Student's intervals over the participants of a level", {
  trials <- groups_of_obk()
  rows <- means_with_intervals(trials, "treatment")
  own <- tapply(trials$rating, as.character(trials$participant), mean)
  group <- tapply(as.character(trials$treatment), as.character(trials$participant), `[`, 1)
  interval <- t.test(own[group == "A"])$conf.int
  expect_equal(unlist(rows[rows$cell == "A", c("low", "high")], use.names = FALSE),
    as.numeric(interval))
})

test_that("power tests it by the participants' means", {
  trials <- groups_of_obk()
  row <- power_tests_of_means(trials, "treatment", "rating")
  means <- aggregate(rating ~ participant + treatment, trials, mean)
  expect_equal(row$p, anova(lm(rating ~ treatment, means))[["Pr(>F)"]][1])
  expect_equal(row$method, "ANOVA of participants' means, between participants")
})

test_that("means and methods say how a factor was varied", {
  trials <- groups_of_obk()
  expect_match(means_words(trials, "treatment"), "(Student's 95 % intervals over participants).",
    fixed = TRUE)
  expect_match(means_words(trials, "phase"), "(within-participant 95 % intervals).", fixed = TRUE)
  trials[c("phase", "treatment")] <- lapply(trials[c("phase", "treatment")], factor)
  expect_equal(varied_words(list(trials = trials, factors = c("phase", "treatment"))), paste0(
    "phase (fup, post, pre) was varied within participants; treatment (control, A, B) was varied ",
    "between participants"))
})
