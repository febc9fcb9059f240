# The script as it is called: exit status, files, words.
# SPDX-License-Identifier: MIT
library(testthat)

test_that("a refusal is one sentence on stderr and exit status 2", {
  run <- run_script("causality.R", "/nowhere/study.sqlite", "--out", new_folder())
  expect_equal(run$status, 2)
  expect_equal(run$stderr,
    "causality.R: /nowhere/study.sqlite: expected a study file, found no such file")
  expect_length(run$stdout, 0)
})

test_that("a call without --out shows the usage", {
  run <- run_script("causality.R", "study.sqlite")
  expect_equal(run$status, 2)
  expect_equal(run$stderr, paste("causality.R: expected one --out and a folder; usage: Rscript",
    "analysis/causality.R study.sqlite --out report/"))
})

test_that("missing packages are named, with what to install", {
  run <- run_script("causality.R", "study.sqlite", "--out", new_folder(),
    environment = c("R_LIBS_SITE=/nowhere", "R_LIBS_USER=/nowhere", "R_LIBS=/nowhere"))
  expect_equal(run$status, 2)
  expect_equal(run$stderr, paste("causality.R: expected these R packages to be installed: RSQLite,",
    "ordinal, lme4, afex, ggplot2, commonmark (on Debian: apt-get install r-cran-rsqlite r-cran-ordinal",
    "r-cran-lme4 r-cran-afex r-cran-ggplot2 r-cran-commonmark)"))
})

test_that("several files, and a file of another study, are refused before anything is written", {
  path <- write_study(tempfile(fileext = ".sqlite"), causality_trials(80, participants = 1))
  out <- new_folder()
  run <- run_script("causality.R", path, path, "--out", out)
  expect_equal(c(run$status, run$stderr), c("2",
    "causality.R: expected one study file, got 2; `impetus merge` makes one of several"))
  run <- run_script("gap.R", path, "--out", out)
  expect_equal(c(run$status, run$stderr), c("2",
    sprintf("gap.R: %s: expected protocol 'gap', got 'causality'", path)))
  expect_false(dir.exists(out))
  data <- tempfile()
  dir.create(data)
  write_report_data(path, data)
  run <- run_script("gap.R", data, "--out", out)
  expect_equal(c(run$status, run$stderr), c("2",
    sprintf("gap.R: %s: expected protocol 'gap', got 'causality'", data)))
  expect_false(dir.exists(out))
})

test_that("one participant gives a page and no test, even in a C locale", {
  path <- write_study(tempfile(fileext = ".sqlite"), causality_trials(81, participants = 1))
  out <- new_folder()
  run <- run_script("causality.R", path, "--out", out, environment = "LC_ALL=C")
  expect_equal(run$status, 0)
  expect_equal(nrow(read.csv(file.path(out, "tables/causality-rating-tests.csv"))), 0)
  page <- paste(readLines(file.path(out, "report.html"), encoding = "UTF-8"), collapse = " ")
  expect_match(page, "One participant: the figure and the means describe; no inferential test")
  expect_match(page, "Dingliana 2002, sec. 6.2.1 and fig. 6.5", fixed = TRUE)
  expect_match(page, "Rscript analysis/causality.R data --out again", fixed = TRUE)
  expect_true(file.exists(file.path(out, "analysis/causality.R")))
})

test_that("levels that separate completely leave the other tests, without a warning", {
  trials <- causality_trials(82, participants = 6)
  trials$rating <- ifelse(trials$delay_ms == 0, 1, pmax(2, trials$rating))
  path <- write_study(tempfile(fileext = ".sqlite"), trials)
  expect_no_warning(found <- suppressMessages(results_of_part(parts_of_protocol(path, "causality")[[1]])))
  table <- found$tests$rows
  expect_setequal(unique(table$family), c("repeated-measures ANOVA", "Friedman", "equivalence"))
  expect_lt(table$p_holm[table$family == "Friedman" & table$effect == "delay_ms"], 0.05)
  expect_match(found$tests$remarks, "separate the ratings completely", all = FALSE)
  pooled <- Filter(function(table) table$name == "sensitivity-pooled", found$tables)[[1]]$rows
  expect_equal(pooled$factor[1:4], c("Delay (ms)", sprintf("Delay (ms) at speed (°/s): %d", kSpeedsDegS)))
})

test_that("ratings that are all equal make no test and say so", {
  trials <- causality_trials(83, participants = 3, repetitions = 1)
  trials$rating <- 2
  path <- write_study(tempfile(fileext = ".sqlite"), trials)
  tests <- suppressMessages(results_of_part(parts_of_protocol(path, "causality")[[1]]))$tests
  expect_equal(nrow(tests$rows), 0)
  expect_equal(tests$remarks[1], "Every rating was 2: nothing varies, so no test was made.")
})

test_that("a large p is never called no difference", {
  row <- function(family, effect, ...) {
    test_row(family, "cumulative-link mixed model, logit, (1 | participant)", effect, ...)
  }
  tests <- combine_outcomes(outcome(rbind(
    row(kEffectsFamily, "delay_ms", "chi-squared", 1.6, 2, p = 0.449),
    row(kEffectsFamily, "speed_deg_s", "chi-squared", 1.2, 2, p = 0.55),
    row(kEquivalenceFamily, "speed_deg_s: 10 against 5", "t", 0.5, 19, p = 0.3, size = 0.2,
      interval = c(-0.1, 0.5))
  )))
  expect_equal(model_words(tests, "delay_ms"), paste(
    "In the cumulative-link mixed model for delay (random intercept for each participant), an effect of",
    "delay was not detected, which is not evidence of its absence: χ²(2) = 1.6, p = .449,",
    "Holm-corrected p = .898."))
  expect_equal(model_words(tests, "speed_deg_s"), paste(
    "In the cumulative-link mixed model for speed (random intercept for each participant), an effect of speed was not",
    "detected, which is not evidence of its absence: χ²(2) = 1.2, p = .550, Holm-corrected p = .898."))
  expect_equal(equivalence_words(level_comparisons(tests, kEquivalenceFamily, "speed_deg_s"),
    "speed_deg_s"), paste(
    "For speed (°/s), equivalence within ±0.15 points was not shown between 10 and 5",
    "(largest difference +0.20, 90 % CI [-0.10, 0.50])."))
})

test_that("words give a test's own p and the corrected one, by name, wherever they stand", {
  row <- function(family, p, ...) test_row(family, "m, margin ±0.15", "a: b", p = p, ...)
  tests <- combine_outcomes(outcome(rbind(
    row("F", 0.004, "F", 6.1, 1.7, 32.4), row("F", 0.02, "F", 5, 2, 38),
    row("R", 0.0002, "z", 3.7, NA, size = 2, interval = c(1.2, 3.1), interval_level = 0.95),
    row("R", 0.3, "z", 1, NA, size = 1.1, interval = c(0.9, 1.3), interval_level = 0.95),
    row("E", 0.001, "t", 4, 9, size = 0.01, interval = c(-0.1, 0.1)),
    row("E", 0.012, "t", 4, 9, size = 0.02, interval = c(-0.1, 0.1)))))
  expect_equal(F_words(tests_of(tests, "F")[1, ]),
    "F(1.7, 32.4) = 6.1, p = .004, Holm-corrected p = .008")
  expect_equal(estimates_words(tests_of(tests, "R")), paste(
    "a: b 2.00, 95 % CI [1.20, 3.10], p < .001, Holm-corrected p < .001;",
    "a: b 1.10, 95 % CI [0.90, 1.30], p = .300, Holm-corrected p = .300"))
  expect_equal(differences_words(tests_of(tests, "R")[2, ]),
    "a: b +1.10, 95 % CI [+0.900, +1.30], p = .300, Holm-corrected p = .300")
  expect_match(equivalence_words(tests_of(tests, "E"), "a"),
    "(two one-sided tests, largest p = .012, Holm-corrected p = .012; largest", fixed = TRUE)
})

test_that("factors are labelled with their units", {
  expect_equal(label_of("speed_deg_s"), "Speed (°/s)")
  expect_equal(label_of("delay_ms"), "Delay (ms)")
  expect_equal(label_of("sphere_tree_level"), "Sphere tree level")
})

test_that("the figure's axis is the whole scale, its ends in the participants' words", {
  trials <- causality_trials(84, participants = 4, repetitions = 1)
  trials$delay_ms <- factor(trials$delay_ms)
  scale <- data.frame(rating_minimum = 1L, rating_maximum = 3L, rating_best = 1L,
    low_anchor = "very believable", high_anchor = "very unbelievable")
  axis <- ggplot2::ggplot_build(factor_plot(trials, "delay_ms", "rating") +
    axis_of_rating(scale, words = TRUE))$layout
  y <- axis$panel_params[[1]]$y
  expect_equal(y$get_labels(), c("very believable  1", "2", "very unbelievable  3"))
  expect_equal(y$continuous_range, c(1 - 0.06, 3 + 0.06))  # 3 % of the scale on either side
})

test_that("the whole script recovers the planted study of 20 participants (slow)", {
  skip_if_not(run_slow, "--slow not given")
  out <- new_folder()
  run <- run_script("causality.R",
    write_study(tempfile(fileext = ".sqlite"), causality_trials(1), practice = 6), "--out", out)
  expect_equal(run$status, 0)
  table <- read.csv(file.path(out, "tables/causality-rating-tests.csv"))
  delay <- table[table$effect == "delay_ms", ]
  expect_equal(nrow(delay), 3)
  expect_true(all(delay$p_holm < 0.01))  # the thesis: "highly significant: > 99%"
  odds <- table$effect_size[grepl("^delay_ms: ", table$effect)]
  expect_true(odds[1] > 1 && odds[2] > odds[1])
  expect_match(table$method[1], "(1 + slope | participant)", fixed = TRUE)
})
