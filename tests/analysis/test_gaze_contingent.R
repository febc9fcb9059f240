# Study 4: the script as it is called, what it refuses, what it says of its kinds.
# SPDX-License-Identifier: MIT
library(testthat)

gaze_file <- function(trials, ...) {
  write_gaze_study(tempfile(fileext = ".sqlite"), trials, ...)
}

refused <- function(path, expression) {
  condition <- tryCatch(expression, refusal = identity)
  expect_s3_class(condition, "refusal")
  gsub(paste0(dirname(path), "/"), "", conditionMessage(condition), fixed = TRUE)
}

test_that("every trial has its kind, in the order from good to bad, its clicks and its time", {
  trials <- gaze_trials(151, participants = 2, repetitions = 1)
  study <- read_scheduling(gaze_file(trials, practice = 3))
  expect_equal(nrow(study$trials), 24)
  expect_equal(levels(study$trials$scheduling), c("all-good", "tracked", "random", "all-bad"))
  expect_equal(levels(study$trials$bodies), c("5", "10", "15"))
  expect_equal(study$trials$exposure_s, rep(10, 24))
  expect_equal(study$trials$merge_within_ms, rep(100, 24))
})

test_that("clicks are those of their own trial", {
  trials <- gaze_trials(152, participants = 2, repetitions = 1)
  study <- read_scheduling(gaze_file(trials))
  key <- function(rows) paste(rows$participant, rows$scheduling, rows$bodies)
  expect_equal(study$trials$clicks[match(key(trials), key(study$trials))], trials$clicks)
})

test_that("another kind of scheduling is refused", {
  trials <- gaze_trials(154, participants = 1, repetitions = 1)
  trials$scheduling <- sub("all-bad", "worst", trials$scheduling)
  path <- gaze_file(trials)
  expect_equal(refused(path, read_scheduling(path)), paste0(basename(path), ": expected ",
    "scheduling to be one of all-good, tracked, random, all-bad, got worst"))
})

test_that("a protocol that asks for no clicks is refused", {
  path <- gaze_file(gaze_trials(155, participants = 1, repetitions = 1))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "UPDATE protocol SET protocol_json = '{}'")
  DBI::dbDisconnect(study)
  expect_equal(refused(path, read_scheduling(path)), paste0(basename(path), ": expected a ",
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

# The page of a study, made by its script, as one text; and the folder that it is in.
page_of_script <- function(path, script = "gaze-contingent.R") {
  out <- new_folder()
  run <- run_script(script, path, "--out", out)
  expect_equal(run$status, 0, info = paste(run$stderr, collapse = "\n"))
  list(text = paste(readLines(file.path(out, "report.html"), encoding = "UTF-8"), collapse = " "),
    folder = out, table = function(name) read.csv(file.path(out, "tables", paste0(name, ".csv"))))
}

test_that("one participant gives figures, tables and words, no test", {
  trials <- gaze_trials(157, participants = 1)
  page <- page_of_script(add_collisions(gaze_file(trials), random_collisions(trials)))
  figures <- paste0("gaze-contingent-", c("rating-by-scheduling", "clicks-kernels", "clicks-gains",
    "scheduling-rating-tracked-random", "scheduling-clicks-tracked-random"))
  expect_true(all(file.exists(file.path(page$folder, "figures", paste0(figures, ".svg")))))
  expect_equal(nrow(page$table("gaze-contingent-scheduling-tests")), 0)
  expect_match(page$text, "One participant: the figure and the means describe; no inferential test")
  expect_equal(nrow(page$table("gaze-contingent-scheduling-exposure")), 12)
  expect_setequal(page$table("gaze-contingent-clicks-gains")$scheduling, c("all", "tracked", "random"))
})

test_that("without a pair of tracked and random there are figures and words, and no contrast", {
  trials <- gaze_trials(162, participants = 2, repetitions = 1)
  path <- gaze_file(trials[trials$scheduling %in% c("all-good", "all-bad") & trials$bodies == 5, ])
  expect_length(contrasts_drawn(read_scheduling(path)), 0)
  expect_match(page_of_script(path)$text,
    "There is no contrast of ratings of tracked against random: it needs trials of both.", fixed = TRUE)
})

test_that("without recorded frames there is no rate of clicks, and everything else", {
  path <- gaze_file(gaze_trials(163, participants = 2, repetitions = 1))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "DELETE FROM frame")
  DBI::dbDisconnect(study)
  page <- page_of_script(path)$text
  expect_match(page, "No trial&#39;s exposure is known, so there is no rate of clicks|No trial's exposure")
  expect_match(page, "No frame was recorded of 24 trials, left out of the rates of clicks.", fixed = TRUE)
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
  path <- two_stimuli_file()
  study <- with_click_times(read_scheduling(path))
  expect_equal(study$trials$exposure_s, c(20, 20))
  expect_equal(rate_of(study$trials), 6 / 20)
  expect_equal(gaze_tables(path)$gaze$samples_per_s, 100)
  expect_equal(click_detection(study)$words,
    "A trial has two stimuli, so clicks are not regressed on collisions.")
})

test_that("collisions of a trial's standard are not among the condition's", {
  path <- two_stimuli_file()
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "DELETE FROM collision_truth")
  DBI::dbExecute(study, "DELETE FROM collision")
  add_collisions(path, data.frame(trial = c(1, 1, 2, 2), step = 1:4, level = c(3, 0, 0, 3)))
  DBI::dbExecute(study, "UPDATE collision SET interval = 2 WHERE step IN (2, 4)")
  DBI::dbExecute(study, "UPDATE response SET detail =
    json_object('test_interval', CAST(attempt_id AS REAL))")
  DBI::dbDisconnect(study)
  collisions <- analysed_collisions(as_reported(path), "gaze-contingent")
  expect_equal(collisions$level, c(3, 3))
  expect_match(paste(shown_sentences(as_reported(path), "gaze-contingent", collisions), collapse = " "),
    "2 collisions in 2 main trials. .* Of a trial's two stimuli these are of the one that had")
})

test_that("of a file that does not tell the samples of two stimuli apart they are counted by trial", {
  path <- two_stimuli_file()
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "CREATE TABLE sampled AS SELECT participant, protocol, trial, phase, time_s +
    CASE interval WHEN 2 THEN 21 ELSE 0 END AS time_s, loss FROM gaze_sample")
  DBI::dbExecute(study, "DROP VIEW gaze_sample")
  DBI::dbExecute(study, "CREATE VIEW gaze_sample AS SELECT * FROM sampled")
  DBI::dbDisconnect(study)
  expect_equal(gaze_tables(path)$gaze$samples_per_s, 21 / 21.1, tolerance = 1e-6)
})

test_that("trials marked late are in the primary contrast, and out of its sensitivity line", {
  trials <- gaze_trials(159, participants = 4, repetitions = 2)
  trials$gaze_late <- as.integer(seq_len(nrow(trials)) %in% 1:5)
  study <- read_scheduling(gaze_file(trials))
  tests <- without_slopes(with_failing(kVaried, suppressMessages(
    scheduling_tests(study, exposure_by_participant(study)))))
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

test_that("catch trials are apart where clicks alone are asked for, too", {
  trials <- gaze_trials(167, participants = 2, repetitions = 1)
  trials$catch <- rep(0:1, length.out = nrow(trials))
  path <- gaze_file(trials)
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "DELETE FROM rating")
  DBI::dbDisconnect(study)
  reported <- as_reported(path)
  part <- parts_of_protocol(reported, "gaze-contingent")[[1]]
  expect_equal(c(part$response, nrow(part$trials), nrow(part$catch)), c("clicks", "12", "12"))
  expect_equal(part$hashes, "gaze-contingent hash-1")
  # The views of one who is not asked for a rating tell of no frames; the trials do.
  expect_equal(sum(rows_of_view(reported, shown_view(reported), "gaze-contingent")$timed_frames),
    150 * nrow(trials))
})

test_that("clicks of data from before a click could end a trial are clicks", {
  path <- as_reported(gaze_file(gaze_trials(166, participants = 2, repetitions = 1)))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "ALTER TABLE click_trial_rows RENAME COLUMN first_ends TO was_not_there")
  DBI::dbDisconnect(study)
  parts <- parts_of_protocol(path, "gaze-contingent")
  expect_equal(vapply(parts, `[[`, "", "response"), c("rating", "clicks", "scheduling"))
})

test_that("with one number of bodies nothing stands twice in a family", {
  trials <- gaze_trials(165, participants = 3, repetitions = 2)
  study <- read_scheduling(gaze_file(trials[trials$bodies == 10, ]))
  tests <- without_slopes(with_failing(kVaried, suppressMessages(
    scheduling_tests(study, exposure_by_participant(study)))))
  for (family in c(kContrastFamily, kContrastMeansFamily, kClickBootstrapFamily, kEquivalenceFamily,
    kPooledFamily)) {
    expect_equal(nrow(tests_of(tests, family)), 1, info = family)
  }
  expect_equal(tests_of(tests, kContrastMeansFamily)$p_holm, tests_of(tests, kContrastMeansFamily)$p)
})

test_that("a difference's axis says on which side of 0 a kind is better", {
  study <- read_scheduling(gaze_file(gaze_trials(160, participants = 3, repetitions = 1)))
  titles <- function(study) vapply(contrast_figures(study), function(figure) {
    ggplot2::ggplot_build(figure$plot)$layout$panel_scales_y[[1]]$name
  }, "")
  expect_equal(titles(study), c("Rating, tracked − random\n(above 0: tracked is better)",
    "Clicks per trial, tracked − random\n(below 0: tracked is better)"))
  study$scale$rating_best <- study$scale$rating_minimum
  expect_match(titles(study), "below 0: tracked is better", fixed = TRUE)
})

test_that("the whole script recovers the planted study of 10 participants (slow)", {
  skip_if_not(run_slow, "--slow not given")
  trials <- gaze_trials(1)
  page <- page_of_script(add_collisions(gaze_file(trials, practice = 4), random_collisions(trials)))
  p <- function(part, family, effect) {
    table <- page$table(sprintf("gaze-contingent-%s-tests", part))
    table$p_holm[table$family == family & table$effect == effect]
  }
  expect_lt(p("rating", kEffectsFamily, "scheduling"), 0.001)
  expect_lt(p("clicks", kClickFamily, "scheduling"), 0.001)
  expect_lt(p("scheduling", kClickContrastFamily, contrast_label(kOverall)), 0.01)
  expect_gt(p("rating", kEffectsFamily, "bodies"), 0.01)  # none was planted
  expect_length(p("rating", kInteractionFamily, "scheduling:bodies"), 1)
})
