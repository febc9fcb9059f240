# What was shown, counted by hand.
# SPDX-License-Identifier: MIT
library(testthat)

# Two participants with one trial each of tracked and random at 5 bodies; trials 1 to 4 are
# P1 tracked, P1 random, P2 tracked, P2 random.
exposure_file <- function(merge_within_ms = 100) {
  trials <- data.frame(participant = c("P1", "P1", "P2", "P2"), repetition = 1,
    scheduling = c("tracked", "random"), bodies = 5, rating = c(4, 3, 5, 2), clicks = c(1, 2, 0, 4),
    region_covered_share = c(0.2, 0.4, 0.3, 0.4))
  path <- write_gaze_study(tempfile(fileext = ".sqlite"), trials, merge_within_ms)
  row <- function(trial, time_s, level, body_b = "b", gaze = NA, gap = NA, hidden = NA) {
    data.frame(trial = trial, step = round(time_s * 100), level = level, body_b = body_b, time_s = time_s,
      gaze_eccentricity_deg = gaze, gap_arcmin = gap, hidden_share = hidden)
  }
  add_collisions(path, rbind(
    # P1 tracked: bad at 1.00, 1.05, 1.14 (one event) and 2.00; good at 1.02, between them.
    row(1, 1.00, 0, gaze = 8, gap = 40, hidden = 0.5), row(1, 1.05, 0, gaze = 10, gap = 30, hidden = 0),
    row(1, 1.14, 0, gaze = 9, gap = 20, hidden = 1), row(1, 2.00, 0, "wall +x", gaze = 3, gap = 24, hidden = 0.25),
    row(1, 1.02, 4, gaze = 1, gap = 0, hidden = 0),
    # P1 random: bad at 3, good with a wall at 4.
    row(2, 3, 0, gaze = 2, gap = 50, hidden = 0.2), row(2, 4, 4, "wall -z", gaze = 6, gap = 1, hidden = 0),
    # P2 tracked: nothing. P2 random: good only, and not known where the gaze was.
    row(4, 5, 4)
  ))
  path
}

exposure_study <- function(...) {
  path <- exposure_file(...)
  read_scheduling(path)
}

test_that("the levels that were looked at are told by how far from the gaze they were", {
  told <- levels_looked_at(analysed_collisions(exposure_file(), "gaze-contingent"))
  expect_equal(told$level, c("within 2°", "2° to 5°", "5° to 10°"))
  expect_equal(told$collisions, c(2, 1, 4))  # the one at 10 degrees is the last of its kind
  expect_equal(told$share, c("28.6 %", "14.3 %", "57.1 %"))
  expect_equal(told$reached, c(2, 0, 1))
  expect_equal(told$median, c(25, 24, 25))
})

test_that("what was shown is that of the trials that are analysed", {
  path <- exposure_file()
  collisions <- function() analysed_collisions(path, "gaze-contingent")
  shown <- function() collision_sentences(collisions())[1]
  expect_equal(shown(), "8 collisions in 3 main trials.")
  add_exclusion(path, "P1", 1, "a phone rang")
  expect_equal(shown(), "3 collisions in 2 main trials.")
  expect_equal(sum(levels_reached(collisions())$collisions), 3)
  expect_equal(participants_table(path, "gaze-contingent")$left_out, c("1 trial", ""))
  add_exclusion(path, "P1", NA, "fell asleep")
  expect_equal(shown(), "1 collision in 1 main trial.")
  expect_equal(sum(levels_reached(collisions())$collisions), 1)
})

test_that("collisions of one sort closer than the limit are one event, however long the series", {
  events <- function(time_s, within_ms) with_events(list(
    trials = data.frame(merge_within_ms = within_ms),
    collisions = data.frame(row = rep(1L, length(time_s)), time_s, bad = rep(TRUE, length(time_s)))))$trials
  expect_equal(events(c(1, 1.09, 1.18, 1.3), 100)$bad_events, 2)
  expect_equal(events(c(1.3, 1, 1.18, 1.09), 100)$bad_events, 2)  # in any order
  expect_equal(events(c(1, 1.1, 1.2), 100)$bad_events, 3)         # exactly the limit apart
  expect_equal(events(c(1, 1), NA)$bad_events, 2)                 # no limit: each its own
  expect_equal(events(numeric(), 100)$bad_events, 0)
  expect_equal(events(c(1, NA), 100)$bad_events, NA_integer_)
  expect_equal(events(c(1, NA), 100)$good_events, 0)
})

test_that("events are merged within a trial and a sort", {
  trials <- exposure_study()$trials
  expect_equal(trials$bad_events, c(2, 1, 0, 0))
  expect_equal(trials$good_events, c(1, 1, 0, 1))
})

test_that("without merge_within_ms every collision is an event, and it is said", {
  study <- exposure_study(merge_within_ms = NA)
  expect_true(all(is.na(study$trials$merge_within_ms)))
  expect_equal(study$trials$bad_events, c(4, 1, 0, 0))
  expect_true("The protocol names no merge_within_ms, so every collision is an event of its own." %in%
    exposure_sentences(study))
})

test_that("the measures of a participant are those counted by hand", {
  each <- exposure_by_participant(exposure_study())
  tracked <- each[each$participant == "P1" & each$scheduling == "tracked", ]
  expect_equal(unlist(tracked[names(kExposureMeasures)]), c(
    body_per_trial = 4, body_bad_share = 3 / 4, wall_per_trial = 1, wall_bad_share = 1,
    bad_events_per_trial = 2, good_events_per_trial = 1,
    body_bad_gap_arcmin = 20,     # 40 × .5, 30 × 1, 20 × 0
    wall_bad_gap_arcmin = 18,     # 24 × .75
    eccentricity_deg = 8,         # of 1, 3, 8, 9, 10
    bad_eccentricity_deg = 8.5,   # of 3, 8, 9, 10
    covered_share = 0.2
  ))
  nothing <- each[each$participant == "P2" & each$scheduling == "tracked", ]
  expect_equal(nothing$body_per_trial, 0)
  expect_true(is.na(nothing$body_bad_share) && is.na(nothing$bad_eccentricity_deg))
})

test_that("the table averages over the participants who have a number", {
  table <- exposure_table(exposure_by_participant(exposure_study()))
  expect_equal(as.character(table$scheduling), c("tracked", "random"))
  expect_equal(table$trials, c(2, 2))
  expect_equal(table$body_per_trial, c(2, 1))
  expect_equal(table$body_bad_share, c(3 / 4, 1 / 2))  # P2 tracked has no collision
  expect_equal(table$wall_bad_share, c(1, 0))
  expect_equal(table$bad_events_per_trial, c(1, 0.5))
  expect_equal(table$body_bad_gap_arcmin, c(20, 40))
  expect_equal(table$wall_bad_gap_arcmin, c(18, NA))  # random's wall collision was good
  expect_equal(table$covered_share, c(0.25, 0.4))
  expect_equal(names(table)[-(1:4)], names(kExposureMeasures))
})

test_that("the tests of exposure are paired t tests over participants", {
  each <- exposure_by_participant(exposure_study())
  rows <- combine_outcomes(exposure_tests(each))$rows
  share <- rows[rows$effect == kExposureMeasures[["covered_share"]], ]
  expected <- t.test(c(0.2 - 0.4, 0.3 - 0.4))
  expect_equal(c(share$effect_size, share$p, share$interval_low),
    c(expected$estimate[[1]], expected$p.value, expected$conf.int[1]))
})

test_that("a planted difference of exposure is said, apart from what tracking is for", {
  set.seed(131)
  trials <- gaze_trials(131, participants = 6, repetitions = 1)
  path <- add_collisions(write_gaze_study(tempfile(fileext = ".sqlite"), trials),
    random_collisions(trials))
  study <- read_scheduling(path)
  tests <- combine_outcomes(exposure_tests(exposure_by_participant(study)))
  words <- exposure_words(tests)
  expect_match(words[1], paste("^Tracking kept bad collisions away from the gaze \\(tracked −",
    "random\\): eccentricity of bad collisions from the gaze, median \\(°\\) \\+"))
  expect_match(words[2], "eccentricity of collisions from the gaze, median \\(°\\) \\+")
  expect_match(words[3], "^A difference was not detected, which is not evidence of its absence, in")
})

test_that("gaps that were not measured are counted, with the command to fill them", {
  study <- exposure_study()
  study$collisions$visible_gap_arcmin[study$collisions$row == 2] <- NA
  expect_equal(exposure_sentences(study), paste("The gap was not measured in 1 of 5 bad",
    "collisions: `impetus replay STUDY --truth` measures it."))
})
