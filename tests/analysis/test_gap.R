# Study 2: the planted effects, what was shown, and the script as it is called.
# SPDX-License-Identifier: MIT
library(testthat)

# The ratings as gap.R reads them.
read_gap <- function(path) with_gaps_shown(parts_of_protocol(path, "gap")[[1]])

# A study file of these trials, with the collision that each planted trial would have.
write_gap_study <- function(trials, truth = TRUE) {
  path <- write_study(tempfile(fileext = ".sqlite"), trials, protocol = "gap")
  add_collisions(path, data.frame(
    trial = which(!is.na(trials$rating)), step = 30,
    level = trials$level[!is.na(trials$rating)],
    gap_arcmin = if (truth) planted_gaps(trials)[!is.na(trials$rating)] else NA,
    hidden_share = 0.25
  ))
}

# One participant; trials 1 to 4 are root, 5 and 6 finest, trial 7 middle; all from 0° but 4.
hand_study <- function() {
  trials <- data.frame(participant = "P01", repetition = 1,
    level = c(0, 0, 0, 0, 4, 4, 2), speed_percent = 100, viewpoint_deg = c(0, 0, 0, 85, 0, 0, 0),
    rating = c(3, 2, 3, 1, 1, 1, 2))
  path <- write_study(tempfile(fileext = ".sqlite"), trials, protocol = "gap")
  # Trial 2 met again at step 60, with a gap that must not count; trial 6 never met.
  add_collisions(path, data.frame(
    trial = c(2, 1, 2, 3, 4, 5, 7), step = c(60, 30, 30, 30, 30, 30, 30),
    level = c(0, 0, 0, 0, 0, 4, 2), gap_arcmin = c(500, 40, 70, 50, 10, 2, NA),
    hidden_share = c(1, 0, 0.5, 0.25, 1, 0, NA)
  ))
}

test_that("the table's medians are those of the first collisions, by level and viewpoint", {
  study <- read_gap(hand_study())
  table <- shown_table(study$trials[!is.na(study$trials$gap_arcmin), ], c("level", "viewpoint_deg"))
  expect_equal(as.character(table$level), c("root", "root", "finest"))
  expect_equal(as.character(table$viewpoint_deg), c("0", "85", "0"))
  expect_equal(table$trials, c(3, 1, 1))
  # Root, 0°: gaps 40, 70, 50 and shares 0, .5, .25; ratings 3, 2, 3.
  expect_equal(table$gap_arcmin, c(50, 10, 2))
  expect_equal(table$hidden_share, c(0.25, 1, 0))
  expect_equal(table$rating, c(8 / 3, 1, 1))
  expect_equal(table$level_used, c("0", "0", "4"))
})

test_that("trials without a gap are counted, by what they lack", {
  study <- read_gap(hand_study())
  expect_equal(shown_notes(study$trials), c(
    "The gap was not measured in 1 trial, left out here: `impetus replay STUDY --truth` measures it.",
    "The bodies never met in 1 trial, left out here.",
    "The bodies met more than once in 1 trial: the first collision counts."
  ))
})

test_that("without truth nothing is set against gaps, and the page says what measures them", {
  path <- write_gap_study(gap_trials(91, participants = 1, repetitions = 1), truth = FALSE)
  study <- read_gap(path)
  expect_null(gaps_shown(study))
  expect_equal(study$depths, "Levels of the sphere tree: root 0, middle 2, finest 4.")
  expect_match(shown_sentences(path, "gap", analysed_collisions(path, "gap")),
    "`impetus replay STUDY --truth` does it", fixed = TRUE, all = FALSE)
})

test_that("levels keep their numbers unless there are three from 0", {
  trials <- gap_trials(92, participants = 1, repetitions = 1)
  study <- read_gap(write_gap_study(trials[trials$level > 0, ]))
  expect_equal(levels(study$trials$level), c("2", "4"))
  expect_null(study$depths)
})

test_that("the planted effects of level, and of level by viewpoint and speed, come back", {
  study <- read_gap(write_gap_study(gap_trials(93, participants = 8)))
  factors <- c("level", "speed_percent", "viewpoint_deg")
  trials <- transform(study$trials, rating = ordered(rating))
  rows <- rbind(one_model_tests(trials, factors)$rows, suppressMessages(interaction_tests(trials,
    factors, c("level:speed_percent", "level:viewpoint_deg")))$rows)
  effects <- rows[rows$family %in% c(kEffectsFamily, kInteractionFamily), ]
  expect_equal(effects$effect,
    c("level", "speed_percent", "viewpoint_deg", "level:speed_percent", "level:viewpoint_deg"))
  expect_equal(effects$df1, c(2, 2, 2, 4, 4))
  expect_lt(effects$p[1], 1e-10)  # chi-squared 46; planted: a z of about 12, so some 140
  odds <- rows[rows$effect %in% c("level: middle against root", "level: finest against root"), ]
  expect_true(1 > odds$effect_size[1] && odds$effect_size[1] > odds$effect_size[2])
  # Planted: b (log10(81) - log10(13)), b = 2.3 on average, between viewpoints at the root,
  # b (log10(4) - log10(1.5)) at the finest; their difference is the coefficient.
  ratio <- rows[rows$effect == "level:viewpoint_deg: finest × 85 against root × 0", ]
  planted <- 2.3 * (log10(81 / 13) - log10(4 / 1.5))
  error <- log(ratio$effect_size) / ratio$statistic
  expect_lt(abs(log(ratio$effect_size) - planted), 3 * error)  # misses for one seed in 370
})

test_that("an interaction's chi-squared compares with the model without it", {
  data(wine, package = "ordinal", envir = environment())
  trials <- data.frame(participant = wine$judge, rating = as.integer(wine$rating),
    temp = wine$temp, contact = wine$contact)
  models <- fit_models(transform(trials, rating = ordered(rating)), c("temp", "contact",
    "temp:contact"), character(), "temp:contact")
  row <- model_tests(models, trials, "temp:contact")$rows[1, ]
  likelihood <- function(formula) as.numeric(logLik(ordinal::clmm(formula, wine)))
  # 1e-3 of a statistic near 0: the optimiser's tolerance, 1e-4, on each log-likelihood near -80.
  expect_equal(row$statistic, 2 * (likelihood(rating ~ temp * contact + (1 | judge)) -
    likelihood(rating ~ temp + contact + (1 | judge))), tolerance = 1e-3)
  expect_equal(row$df1, 1)
})

test_that("a cell rated with one end only leaves the interactions out, in words", {
  trials <- gap_trials(94, participants = 4, repetitions = 1)
  trials$rating[trials$level == 4 & trials$viewpoint_deg == 85] <- 1
  trials$rating <- ordered(trials$rating)
  result <- interaction_tests(trials, c("level", "viewpoint_deg"), "level:viewpoint_deg")
  expect_null(result$rows)
  expect_equal(result$remarks, paste(
    "In a cell of level × viewpoint_deg there is no rating or only the lowest or the highest, so",
    "the mixed model with interactions has no finite estimate and was not fitted."))
})

test_that("the planted odds ratio of a tenfold gap is recovered", {
  study <- read_gap(write_gap_study(gap_trials(95, participants = 8)))
  tests <- combine_outcomes(gap_tests(study$trials))
  odds <- tests_of(tests, kGapOddsFamily)
  error <- log(odds$effect_size) / odds$statistic
  # Planted: 2.3 on average over speeds; lapses and leaving speed out take some of it: a model of 60
  # participants (seed 7) gives 2.10 ± .06. Three standard errors of the two together.
  expect_lt(abs(log(odds$effect_size) - 2.10), 3 * sqrt(error^2 + 0.06^2))
  expect_lt(tests_of(tests, kGapFamily)$p, 0.001)
  expect_match(gap_words(tests), "ratings depended on it")
})

test_that("the script reports on one participant: question, figures and table, no test", {
  path <- write_gap_study(gap_trials(96, participants = 1))
  out <- new_folder()
  run <- run_script("gap.R", path, "--out", out)
  expect_equal(run$status, 0)
  expect_true(all(file.exists(file.path(out, "figures", paste0("gap-rating-by-", c("level",
    "viewpoint_deg-and-level"), ".svg")))))
  # 9 trials of 3 speeds and 3 repetitions; the gap is planted, the mean rating is the sample's.
  gaps <- read.csv(file.path(out, "tables/gap-rating-gaps.csv"))
  root <- gaps[gaps$level == "root" & gaps$viewpoint_deg == 45, ]
  expect_equal(unlist(root[c("trials", "gap_arcmin", "hidden_share")], use.names = FALSE),
    c(9, 57, 0.25))
  page <- paste(readLines(file.path(out, "report.html"), encoding = "UTF-8"), collapse = " ")
  for (words in c("does a gap at contact, left by a coarse level", "The thesis: A strong effect of level",
    "root 0, middle 2, finest 4", "One participant: the figure and the means describe")) {
    expect_match(page, words, fixed = TRUE)
  }
})

test_that("the figure says root, middle, finest from left to right", {
  study <- read_gap(write_gap_study(gap_trials(97, participants = 3, repetitions = 1)))
  x <- ggplot2::ggplot_build(factor_plot(study$trials, "level", "rating"))$layout
  expect_equal(x$panel_params[[1]]$x$get_labels(), c("root", "middle", "finest"))
  means <- means_with_intervals(study$trials, c("level", "viewpoint_deg"))
  expect_equal(means$level, rep(c("root", "middle", "finest"), each = 3))
})

test_that("a study file without collisions' view is refused", {
  path <- write_gap_study(gap_trials(98, participants = 1, repetitions = 1))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "DROP VIEW seen_collision")
  DBI::dbDisconnect(study)
  run <- run_script("gap.R", path, "--out", tempfile())
  expect_equal(run$status, 2)
  expect_equal(run$stderr, paste0("gap.R: ", path,
    ": expected a study file of this version, got one without the view seen_collision; opening it ",
    "with `impetus run` brings it up to date"))
})

test_that("the whole script recovers the planted gap study of 20 participants (slow)", {
  skip_if_not(run_slow, "--slow not given")
  out <- new_folder()
  run <- run_script("gap.R", write_gap_study(gap_trials(1)), "--out", out)
  expect_equal(run$status, 0)
  table <- read.csv(file.path(out, "tables/gap-rating-tests.csv"))
  expect_true(all(table$p_holm[table$effect == "level"] < 0.01))  # the thesis: "> 99%"
  expect_true(all(c(kGapFamily, kInteractionFamily, kInteractionOddsFamily) %in% table$family))
})
