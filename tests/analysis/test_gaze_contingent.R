# Study 4: the script as it is called, what it refuses, its figures.
# SPDX-License-Identifier: MIT
library(testthat)

gaze_file <- function(trials, ...) {
  write_gaze_study(tempfile(fileext = ".sqlite"), trials, ...)
}

read_gaze_study <- function(path) {
  open_gaze_study(study_description("gaze-contingent"), path)
}

refused <- function(path, expression) {
  condition <- tryCatch(expression, refusal = identity)
  expect_s3_class(condition, "refusal")
  gsub(paste0(dirname(path), "/"), "", conditionMessage(condition), fixed = TRUE)
}

test_that("every trial has its kind, in the order from good to bad, its clicks and its time", {
  trials <- gaze_trials(151, participants = 2, repetitions = 1)
  study <- read_gaze_study(gaze_file(trials, practice = 3))
  expect_equal(nrow(study$trials), 24)
  expect_equal(levels(study$trials$scheduling), c("all-good", "tracked", "random", "all-bad"))
  expect_equal(levels(study$trials$bodies), c("5", "10", "15"))
  expect_equal(study$trials$exposure_s, rep(10, 24))
  expect_equal(study$trials$merge_within_ms, rep(100, 24))
})

test_that("clicks are those of their own trial", {
  trials <- gaze_trials(152, participants = 2, repetitions = 1)
  study <- read_gaze_study(gaze_file(trials))
  key <- function(rows) paste(rows$participant, rows$scheduling, rows$bodies)
  expect_equal(study$trials$clicks[match(key(trials), key(study$trials))], trials$clicks)
})

test_that("trials of two files are never mixed up", {
  trials <- gaze_trials(153, participants = 2, repetitions = 1)
  files <- vapply(c("P01", "P02"), function(who) gaze_file(trials[trials$participant == who, ]), "")
  add_collisions(files[2], data.frame(trial = 1:12, step = 1, level = 0, time_s = 1,
    gap_arcmin = NA, hidden_share = NA))
  study <- open_gaze_study(study_description("gaze-contingent"), files)
  expect_equal(unique(study$collisions$participant), "P02")
  expect_equal(tapply(study$trials$clicks, study$trials$participant, sum)[["P02"]],
    sum(trials$clicks[trials$participant == "P02"]))
})

test_that("another kind of scheduling is refused", {
  trials <- gaze_trials(154, participants = 1, repetitions = 1)
  trials$scheduling <- sub("all-bad", "worst", trials$scheduling)
  path <- gaze_file(trials)
  expect_equal(refused(path, read_gaze_study(path)), paste0(basename(path), ": expected ",
    "scheduling to be one of all-good, tracked, random, all-bad, got worst"))
})

test_that("a protocol that asks for no clicks is refused", {
  path <- gaze_file(gaze_trials(155, participants = 1, repetitions = 1))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "UPDATE protocol SET protocol_json = '{}'")
  DBI::dbDisconnect(study)
  expect_equal(refused(path, read_gaze_study(path)), paste0(basename(path), ": expected a ",
    "protocol that asks for clicks, got 'gaze-contingent' without them"))
})

test_that("a study file from before clicks and gaze is refused before anything is written", {
  path <- gaze_file(gaze_trials(156, participants = 1, repetitions = 1))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "DROP VIEW gaze_sample")
  DBI::dbDisconnect(study)
  out <- new_folder()
  run <- run_script("gaze-contingent.R", path, "--out", out)
  expect_equal(run$status, 2)
  expect_equal(run$stderr, paste0("gaze-contingent.R: ", path,
    ": expected a study file of this version, got one without the view gaze_sample; opening it ",
    "with `impetus run` brings it up to date"))
  expect_false(dir.exists(out))
})

test_that("one participant gives figures, tables and words, no test", {
  trials <- gaze_trials(157, participants = 1)
  path <- add_collisions(gaze_file(trials), random_collisions(trials))
  out <- new_folder()
  run <- run_script("gaze-contingent.R", path, "--out", out)
  expect_equal(run$status, 0)
  files <- file.path(out, paste0("gaze-contingent", c("-ratings.png", "-ratings.pdf",
    "-clicks.png", "-clicks.pdf", "-kernels.png", "-kernels.pdf", ".csv", "-clicks.csv",
    "-exposure.csv", "-gaze.csv", "-calibration.csv", "-gains.csv", "-kernels.csv",
    "-matching.csv", ".md")))
  expect_equal(run$stdout[1:15], files)
  expect_true(all(file.size(files) > 0))
  expect_equal(nrow(read.csv(files[7])), 0)
  expect_true(paste("One participant: the figure and the means describe; no inferential test",
    "was made.") %in% run$stdout)
  expect_equal(nrow(read.csv(files[9])), 12)
  expect_equal(nrow(read.csv(files[14])), length(kMatchingWindowsS))
})

test_that("without a pair of tracked and random there are figures and words, and no contrast", {
  trials <- gaze_trials(162, participants = 2, repetitions = 1)
  path <- gaze_file(trials[trials$scheduling %in% c("all-good", "all-bad") & trials$bodies == 5, ])
  run <- run_script("gaze-contingent.R", path, "--out", new_folder())
  expect_equal(run$status, 0)
  expect_match(paste(run$stdout, collapse = " "), "The design lacks scheduling tracked and random")
})

test_that("without recorded frames there is no rate of clicks, and everything else", {
  path <- gaze_file(gaze_trials(163, participants = 2, repetitions = 1))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "DELETE FROM frame")
  DBI::dbDisconnect(study)
  out <- new_folder()
  run <- run_script("gaze-contingent.R", path, "--out", out)
  expect_equal(run$status, 0)
  expect_true("No trial's exposure is known, so there is no rate of clicks." %in% run$stdout)
  expect_match(paste(run$stdout, collapse = " "),
    "No frame was recorded of 24 trials, left out of the rates of clicks.", fixed = TRUE)
})

# Two trials with a second stimulus 21 s after the first, in which the eye was sampled at 100 Hz for a
# tenth of a second, as in the first.
two_stimuli_file <- function() {
  trials <- gaze_trials(164, participants = 1, repetitions = 1)[1:2, ]
  trials$clicks <- 6
  path <- add_second_stimulus(gaze_file(trials), 21e9)
  add_gaze(path, data.frame(trial = rep(1:2, each = 22), sample = 1:22,
    taken_ns = c((0:10) * 1e7, 21e9 + (0:10) * 1e7), loss = NA, interval = rep(1:2, each = 11)))
}

test_that("rates of two stimuli are those of the time that both were shown", {
  study <- read_gaze_study(two_stimuli_file())
  expect_equal(study$trials$exposure_s, c(20, 20))
  expect_equal(rate_of(study$trials), 6 / 20)
  expect_equal(gaze_quality(study)$samples_per_s, 100)
  expect_equal(click_detection(study)$words,
    "A trial has two stimuli, so clicks are not regressed on collisions.")
})

test_that("of a file that does not tell the samples of two stimuli apart they are counted by trial", {
  path <- two_stimuli_file()
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "CREATE TABLE sampled AS SELECT participant, protocol, trial, phase, time_s +
    CASE interval WHEN 2 THEN 21 ELSE 0 END AS time_s, loss FROM gaze_sample")
  DBI::dbExecute(study, "DROP VIEW gaze_sample")
  DBI::dbExecute(study, "CREATE VIEW gaze_sample AS SELECT * FROM sampled")
  DBI::dbDisconnect(study)
  expect_equal(gaze_quality(read_gaze_study(path))$samples_per_s, 21 / 21.1, tolerance = 1e-6)
})

test_that("missing trials are named by participant, absent kinds by name", {
  trials <- gaze_trials(158, participants = 3)
  trials$rating[trials$participant == "P02"][1:2] <- NA
  study <- read_gaze_study(gaze_file(trials))
  expect_equal(design_sentence(study$trials), paste("Of the design, 4 kinds of scheduling × 3",
    "numbers of bodies × 3 repetitions, ratings are still missing from P02."))
  expect_match(participants_sentence(study), "1 participant has not finished")
  kept <- read_gaze_study(gaze_file(trials[trials$scheduling != "all-bad" &
    trials$participant == "P01", ]))
  expect_equal(design_sentence(kept$trials), c("The design lacks scheduling all-bad.",
    paste("Every participant has all of the design: 3 kinds of scheduling × 3 numbers of bodies ×",
      "3 repetitions.")))
})

test_that("trials marked late are in the primary contrast, and out of its sensitivity line", {
  trials <- gaze_trials(159, participants = 4, repetitions = 2)
  trials$gaze_late <- as.integer(seq_len(nrow(trials)) %in% 1:5)
  study <- with_events(read_gaze_study(gaze_file(trials)))
  tests <- without_slopes(with_failing(kVaried, suppressMessages(
    gaze_study_tests(study, exposure_by_participant(study)))))
  in_two <- trials$scheduling %in% c("tracked", "random")
  expect_equal(tests_of(tests, kContrastFamily)$trials[1], sum(in_two))
  without <- tests_of(tests, paste0(kContrastFamily, kWithoutLate))
  expect_equal(without$trials[1], sum(in_two & trials$gaze_late == 0))
  expect_match(sensitivity_words(tests, 5, kWithoutLate), paste("^Sensitivity: without the 5",
    "trials marked late, tracked against random: odds ratio of a higher rating overall .*;",
    "for clicks, rate ratio overall "))
  expect_length(sensitivity_words(tests, 0, kWithoutLate), 0)
  # Holm within a family: the sensitivity line does not correct the primary contrast.
  expect_equal(tests_of(tests, kContrastFamily)$p_holm,
    p.adjust(tests_of(tests, kContrastFamily)$p, "holm"))
})

test_that("the rating axis is the whole scale, both its ends in the participants' words", {
  study <- read_gaze_study(gaze_file(gaze_trials(160, participants = 3, repetitions = 1)))
  panel <- kinds_panel(study$trials, "rating") + rating_axes(study$scale)$means
  y <- ggplot2::ggplot_build(panel)$layout$panel_params[[1]]$y
  expect_equal(y$get_labels(), c("not believable  1", "2", "3", "4", "very believable  5"))
  shown <- ggplot2::ggplot_build(panel)$data[[3]]
  expected <- cousineau_morey(participant_means(study$trials, c("bodies", "scheduling")))
  expect_equal(shown$y, expected$mean)
})

test_that("an interval below 0 clicks ends at 0 and is not dropped", {
  study <- read_gaze_study(gaze_file(gaze_trials(161, participants = 3, repetitions = 1)))
  cells <- means_with_intervals(study$trials, c("bodies", "scheduling"), "clicks")
  expect_true(any(cells$low < 0))
  panel <- kinds_panel(study$trials, "clicks") + click_axes()$means
  bars <- ggplot2::ggplot_build(panel)$data[[2]]
  expect_equal(bars$ymin, pmax(cells$low, 0))
})

test_that("the whole script recovers the planted study of 10 participants (slow)", {
  skip_if_not(run_slow, "--slow not given")
  trials <- gaze_trials(1)
  path <- add_collisions(gaze_file(trials, practice = 4), random_collisions(trials))
  out <- new_folder()
  run <- run_script("gaze-contingent.R", path, "--out", out)
  expect_equal(run$status, 0)
  table <- read.csv(file.path(out, "gaze-contingent.csv"))
  p <- function(family, effect) {
    table$p_holm[table$family == family & table$effect == effect]
  }
  expect_lt(p(kEffectsFamily, "scheduling"), 0.001)
  expect_lt(p(kClickFamily, "scheduling"), 0.001)
  expect_lt(p(kClickContrastFamily, contrast_label(kOverall)), 0.01)
  expect_gt(p(kEffectsFamily, "bodies"), 0.01)  # none was planted
  expect_match(table$method[1], "(1 + slope | participant)", fixed = TRUE)
})
