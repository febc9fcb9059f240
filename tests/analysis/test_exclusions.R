# What is left out leaves every analysis, and the report names it.
# SPDX-License-Identifier: MIT
library(testthat)

read_it <- function(path) rating_part(path, "causality")
study_file <- function(trials, ...) write_study(tempfile(fileext = ".sqlite"), trials, ...)

test_that("an excluded participant and an excluded trial are out, and the table says why", {
  trials <- causality_trials(seed = 201, participants = 3, repetitions = 1)
  trials$simulated <- 0
  path <- study_file(trials)
  add_exclusion(path, "P02", NA, "fell asleep")
  add_exclusion(path, "P01", 5, "a phone rang | loudly")
  study <- read_it(path)
  expect_equal(as.vector(table(study$trials$participant)), c(26, 27))
  expect_false(5 %in% study$trials$trial)
  expect_equal(exclusions_sentence(study), paste("Left out: 28 ratings of 2 participants (a phone",
    "rang \\| loudly; fell asleep)."))
  expect_equal(exclusion_lines(study)[-(1:4)], c(
    "| P01 | 5 | 1 | a phone rang \\| loudly | 2026-02-01T09:00:00Z |",
    "| P02 | all | 27 | fell asleep | 2026-02-01T09:00:00Z |"))
  expect_match(participants_sentence(study), "^2 participants, 53 ratings")
})

test_that("a trial excluded in somebody who is excluded whole is counted once, and stays in the table", {
  trials <- causality_trials(seed = 201, participants = 3, repetitions = 1)
  path <- study_file(trials)
  add_exclusion(path, "P01", NA, "slept")
  add_exclusion(path, "P01", 5, "a phone")
  add_exclusion(path, "P02", 30, "a cough")
  study <- read_it(path)
  expect_equal(exclusions_sentence(study),
    "Left out: 28 ratings of 2 participants (slept; a phone; a cough).")
  expect_equal(nrow(study$trials) + sum(study$exclusions$trials), nrow(trials))
  expect_match(exclusion_lines(study), "| P01 | 5 | 0 | a phone |", fixed = TRUE, all = FALSE)
})

test_that("what somebody typed stays text in a report", {
  typed <- c("<script>alert(1)</script>", "[x](y) `z` | *b*", "Robert'); DROP TABLE trial;--",
    "%s%n", "two\nlines \u202e")
  expect_equal(as_typed(typed), c("&lt;script&gt;alert(1)&lt;/script&gt;",
    "\\[x\\](y) \\`z\\` \\| \\*b\\*", "Robert'); DROP TABLE trial;--", "%s%n",
    "two lines \u202e"))
  trials <- causality_trials(seed = 204, participants = 2, repetitions = 1)
  trials$participant <- ifelse(trials$participant == "P01", typed[1], typed[3])
  path <- study_file(trials)
  add_exclusion(path, typed[1], NA, typed[2])
  lines <- exclusion_lines(read_it(path))
  expect_match(lines, "| &lt;script&gt;alert(1)&lt;/script&gt; | all | 27 |", fixed = TRUE, all = FALSE)
  expect_false(any(grepl("<script>", lines, fixed = TRUE)))
})

test_that("an exclusion taken back is none, and one in another protocol's trial is not listed", {
  trials <- causality_trials(seed = 202, participants = 2, repetitions = 1)
  path <- study_file(trials, practice = 1)
  add_exclusion(path, "P01", NA, "too fast")
  add_exclusion(path, "P01", NA, "was not", excluded = 0)
  add_exclusion(path, "P01", 55, "its practice")
  study <- read_it(path)
  expect_equal(nrow(study$trials), 54)
  expect_equal(exclusion_lines(study), "Nobody and no trial was excluded.")
  expect_equal(exclusions_sentence(study), "No rating was excluded.")
})

test_that("when everything is excluded the study is refused in one sentence", {
  path <- study_file(causality_trials(seed = 204, participants = 1, repetitions = 1))
  add_exclusion(path, "P01", NA, "wrong glasses")
  condition <- tryCatch(read_it(path), refusal = identity)
  expect_equal(conditionMessage(condition), paste0(basename(path), ": expected rated main trials ",
    "of 'causality', got only catch trials and excluded ones (27 excluded)"))
})

test_that("catch trials are in no mean and are reported apart, even at a level of their own", {
  trials <- causality_trials(seed = 205, participants = 2, repetitions = 1)
  trials$catch <- 0
  extra <- trials[c(1, 28), ]
  extra$catch <- 1
  extra$delay_ms <- 2000
  extra$rating <- c(3, 2)
  with_catch <- read_it(study_file(rbind(trials, extra)))
  without <- read_it(study_file(trials))
  expect_equal(participant_means(with_catch$trials, "delay_ms"),
    participant_means(without$trials, "delay_ms"))
  expect_equal(nrow(with_catch$catch), 2)
  expect_equal(catch_sentence(with_catch), "2 catch trials are reported apart and are in no test.")
  expect_match(paste(catch_lines(with_catch), collapse = " "),
    "delay \\(ms\\) 2000.*\\| 1 \\| 1 \\| 3.00 \\| 3 to 3 \\|")
})

test_that("catch trials of choices, marks and clicks are told by those, each in its own words", {
  trials <- causality_trials(seed = 206, participants = 1, repetitions = 1)
  trials$delay_ms <- c(50, 50, 250, rep(0, nrow(trials) - 3))
  path <- study_file(trials[setdiff(names(trials), c("speed_deg_s", "viewpoint_deg"))])
  catch <- data.frame(condition = c("a", "a", "b"), participant = c("P01", "P02", "P01"), trial = 1:3,
    answer = c("4", "6", "none"), correct = c(1, 0, NA), positive = NA, clicks = c(0, 3, 2))
  last <- function(study, rows = 3) expect_no_warning(
    catch_lines(c(list(catch = catch[seq_len(rows), ], path = path), study))[-c(1, 2, 4)])
  expect_equal(last(list(response = "answer", kind = "right choice")), c(
    "| condition | trials | participants | share of right answers | range |",
    "| delay (ms) 50 | 2 | 2 | 0.50 | 0 to 1 |", "| delay (ms) 250 | 1 | 1 | – | – |"))
  expect_equal(last(list(response = "answer", kind = "choice none", option = "none")), c(
    "| condition | trials | participants | share of “none” | range |",
    "| delay (ms) 50 | 2 | 2 | 0.00 | 0 to 0 |", "| delay (ms) 250 | 1 | 1 | 1.00 | 1 to 1 |"))
  expect_equal(last(list(response = "mark"), 2), c(
    "| condition | trials | participants | mean mark | range |", "| delay (ms) 50 | 2 | 2 | 5.00 | 4 to 6 |"))
  for (response in c("clicks", "press")) {
    expect_equal(last(list(response = response)), c(
      "| condition | trials | participants | mean clicks | range |",
      "| delay (ms) 50 | 2 | 2 | 1.50 | 0 to 3 |", "| delay (ms) 250 | 1 | 1 | 2.00 | 2 to 2 |"))
  }
})

test_that("trials that a click ends are counted where nobody clicked, and said to be left out", {
  trials <- gaze_trials(seed = 207, participants = 3)
  trials <- trials[trials$bodies == 5, ]
  trials$clicks <- rep(c(1, 1, 0, 1), length.out = nrow(trials))
  without <- which(trials$clicks == 0)
  path <- write_gaze_study(tempfile(fileext = ".sqlite"), trials)
  add_exclusion(path, trials$participant[without[1]], without[1], "a cough")
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "UPDATE protocol SET protocol_json = json_object('clicks',
    json_object('first_ends', 1))")
  DBI::dbDisconnect(study)
  part <- press_part(with_clicked_trials(path), "gaze-contingent")
  expect_equal(nrow(part$trials), sum(trials$clicks))
  expect_false(anyNA(part$trials$press_s))
  left <- length(without) - 1  # one is excluded
  expect_equal(unclicked_sentence(part), sprintf(
    "In %d more trials of 3 participants nobody clicked; they are in no mean and no test.", left))
  expect_match(remarkable_lines(part), sprintf("| without a click | %d | 3 | no time to analyse |",
    left), fixed = TRUE, all = FALSE)
})

test_that("what else happened is counted: late frames, late gaze, interruptions, time-outs", {
  trials <- causality_trials(seed = 206, participants = 2, repetitions = 1)
  trials$late_timed_frames <- ifelse(seq_len(nrow(trials)) %in% c(3, 4), 1, 0)
  path <- study_file(trials)
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "UPDATE attempt SET gaze_late = 1 WHERE trial_id = 30")
  DBI::dbExecute(study, "INSERT INTO attempt (trial_id, session_id, number, outcome, onset_ns,
    intended_hold_ms, realised_hold_ms, timed_frames, late_timed_frames, late_untimed_frames,
    sync_overridden, interrupted_by) SELECT trial_id, session_id, 2, 'interrupted', 0, 0, 0, 0, 0,
    0, 0, 'gaze lost' FROM attempt WHERE trial_id IN (1, 2, 40)")
  DBI::dbExecute(study, "INSERT INTO attempt (trial_id, session_id, number, outcome, onset_ns,
    intended_hold_ms, realised_hold_ms, timed_frames, late_timed_frames, late_untimed_frames,
    sync_overridden, set_aside_in) SELECT trial_id, session_id, 3, 'set aside', 0, 0, 0, 0, 0,
    0, 0, session_id FROM attempt WHERE trial_id = 5")
  DBI::dbExecute(study, "INSERT INTO response (attempt_id, number, kind, question, detail, device,
    question_shown_ns, arrived_ns, arrival_uncertainty_ns, timed_out)
    VALUES (9, 1, 'rating', 'Seen?', '{}', 'none', 0, 0, 0, 1)")
  DBI::dbDisconnect(study)
  lines <- remarkable_lines(read_it(path))[-(1:2)]
  expect_equal(lines, c(
    "| with late timed frames | 2 | 1 | in the analysis |",
    "| with gaze shown too late | 1 | 1 | in the analysis |",
    "| showings interrupted (gaze lost) | 3 | 2 | not data; shown again |",
    "| showings interrupted (set aside with its block) | 1 | 1 | not data; shown again |",
    "| without an answer in time | 1 | 1 | no answer to analyse |",
    "| catch trials | 0 | 0 | apart, below |"))
})

test_that("the report holds the table of what is left out", {
  path <- study_file(causality_trials(seed = 207, participants = 2, repetitions = 1))
  add_exclusion(path, "P01", NA, "spoke all the time")
  out <- new_folder()
  run <- run_script("causality.R", path, "--out", out)
  expect_equal(run$status, 0)
  page <- paste(readLines(file.path(out, "report.html"), encoding = "UTF-8"), collapse = "")
  expect_match(page, paste0("<td>P01</td><td>all</td><td>27</td><td>spoke all the time</td>",
    "<td>2026-02-01T09:00:00Z</td>"), fixed = TRUE)
})
