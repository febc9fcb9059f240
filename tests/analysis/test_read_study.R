# SPDX-License-Identifier: MIT
library(testthat)

read_causality <- function(path) rating_part(path, "causality")

# The one sentence with which a study is refused, without the folder of temporary files.
refusal <- function(expression) {
  condition <- tryCatch(expression, refusal = identity)
  expect_s3_class(condition, "refusal")
  gsub(paste0(tempdir(), "/"), "", conditionMessage(condition), fixed = TRUE)
}

at <- function(name) file.path(tempdir(), name)

test_that("ratings come back with their factors, and practice is never among them", {
  trials <- causality_trials(seed = 61, participants = 2, repetitions = 1)
  study <- read_causality(write_study(at("a.sqlite"), trials, practice = 6))
  expect_equal(nrow(study$trials), 54)
  expect_equal(unique(study$trials$phase), "main")
  expect_equal(factor_called(study, "speed"), "speed_deg_s")
  key <- function(rows) paste(rows$participant, rows$delay_ms, rows$speed_deg_s, rows$viewpoint_deg)
  expect_equal(study$trials$rating[match(key(trials), key(study$trials))], trials$rating)
  expect_equal(levels(study$trials$delay_ms), c("0", "100", "300"))
})

test_that("every file that is no study is refused in one sentence", {
  expect_equal(refusal(read_causality(at("none.sqlite"))),
    "none.sqlite: expected a study file, found no such file")
  expect_equal(refusal(read_causality(tempdir())),
    paste0(tempdir(), ": expected a study file, got a folder"))
  writeLines(rep("no database", 100), at("words.sqlite"))
  expect_equal(refusal(read_causality(at("words.sqlite"))),
    "words.sqlite: expected a study file, got a file that SQLite cannot read")
  file.create(at("empty.sqlite"))
  expect_equal(refusal(read_causality(at("empty.sqlite"))),
    "empty.sqlite: expected a study file, got a database without the view rated_trial")
})

test_that("a study without the protocol, or without ratings yet, is refused", {
  trials <- causality_trials(seed = 63, participants = 1, repetitions = 1)
  expect_equal(refusal(read_causality(write_study(at("a.sqlite"), trials, protocol = "gap"))),
    "a.sqlite: expected protocol 'causality', got 'gap'")
  DBI::dbDisconnect(new_study(at("a.sqlite")))
  expect_equal(refusal(read_causality(at("a.sqlite"))),
    "a.sqlite: expected protocol 'causality', got no protocol at all")
  trials$rating <- NA_integer_
  expect_equal(refusal(read_causality(write_study(at("a.sqlite"), trials))),
    "a.sqlite: expected rated main trials of 'causality', got none yet")
})

test_that("scales that differ are not pooled", {
  trials <- causality_trials(seed = 64, participants = 2, repetitions = 1)
  trials$best <- ifelse(trials$participant == "P01", 1, 3)
  expect_equal(refusal(read_causality(write_study(at("a.sqlite"), trials))), paste0(
    "expected ratings on one scale, got 1 (very believable) to 3 (very unbelievable), 1 best; ",
    "and 1 (very believable) to 3 (very unbelievable), 3 best: scales that differ are never pooled"
  ))
})

test_that("a trial without a level of a factor is named, with the file", {
  path <- write_study(at("a.sqlite"), causality_trials(seed = 66, participants = 1, repetitions = 1))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "UPDATE trial SET condition = json_remove(condition, '$.speed_deg_s')
    WHERE id = 3")
  DBI::dbDisconnect(study)
  expect_equal(refusal(read_causality(path)), paste("a.sqlite: expected a level of speed_deg_s in every",
    "main trial, trial 3 has none"))
})

test_that("what the analysis rests on is said in words", {
  trials <- causality_trials(seed = 67, participants = 3, repetitions = 1)
  trials$rating[trials$participant == "P02"][20:27] <- NA
  trials$rating[trials$participant == "P03"] <- NA
  trials$simulated <- 0
  trials$late_timed_frames <- ifelse(seq_len(nrow(trials)) == 5, 2, 0)
  trials$sync_overridden <- as.integer(trials$participant == "P01")
  trials$realised_hold_ms <- ifelse(trials$delay_ms == 100, 105.9, trials$delay_ms)
  trials$protocol_hash <- ifelse(trials$participant == "P01", "old", "new")
  path <- write_study(at("a.sqlite"), trials)
  study <- read_causality(path)
  expect_equal(c(participants_sentence(study), exclusions_sentence(study), unbalanced_sentence(study),
    hashes_sentence(study)), c(
    paste("2 participants, 46 ratings in the main phase (19 to 27 each). The study is in",
      "progress: 1 participant has not finished and is included with the ratings given so far.",
      "1 more participant enrolled, without ratings."),
    "No rating was excluded.",
    paste("1 of 2 participants lacks some combination of delay, speed and viewpoint: means by one",
      "factor, Friedman's test and comparisons of two levels take what trials there are, so that they",
      "also hold effects of the other factors; the ANOVA leaves these participants out."),
    "2 versions of protocol 'causality' (different hashes) are pooled here."))
  words <- shown_sentences(path, "causality", analysed_collisions(path, "causality"))
  expect_match(words, "frames were timed, practice included; 2 \\(", all = FALSE)
  expect_match(words, sprintf("100 ms was 105.90 ms (%d trials)", sum(trials$delay_ms == 100 &
    !is.na(trials$rating))), fixed = TRUE, all = FALSE)
})

test_that("simulated participants are named, and never pooled with people", {
  trials <- causality_trials(seed = 68, participants = 3, repetitions = 1)
  all_made_up <- write_study(at("a.sqlite"), trials)
  expect_true(read_causality(all_made_up)$all_simulated)
  expect_match(simulated_lines(all_made_up, "causality"), "SIMULATED: every participant is simulated")
  trials$simulated <- as.integer(trials$participant == "P03")
  mixed <- read_causality(write_study(at("a.sqlite"), trials))
  expect_equal(sort(unique(mixed$trials$participant)), c("P01", "P02"))
  expect_equal(exclusions_sentence(mixed),
    "Left out: 27 ratings of 1 participant (simulated, in a study that has people).")
})

test_that("the page's words are of those who are analysed: people, or simulated ones without any", {
  trials <- causality_trials(seed = 68, participants = 3, repetitions = 1)
  trials$simulated <- as.integer(trials$participant == "P03")
  path <- write_study(at("a.sqlite"), trials)
  expect_match(people_words(path, "causality"), "^2 participants took part")
  expect_null(simulated_lines(path, "causality"))
  expect_equal(participants_table(path, "causality")$left_out,
    c("", "", "simulated, in a study that has people"))
  add_exclusion(add_exclusion(path, "P01", NA, "a pilot"), "P02", NA, "a pilot")
  expect_match(people_words(path, "causality"), "^1 simulated participant took part")
  expect_match(simulated_lines(path, "causality"), "SIMULATED")
  expect_equal(participants_table(path, "causality")$left_out, c("a pilot", "a pilot", ""))
  # Where nobody is left, those who enrolled are who took part.
  add_exclusion(path, "P03", NA, "a pilot")
  expect_match(people_words(path, "causality"), "^2 participants took part")
  expect_null(simulated_lines(path, "causality"))
})

test_that("kinds of scheduling have one order, whatever that of the protocol", {
  expect_equal(in_kinds_order(c("recorded", "all-good", "all-bad", "tracked", "random")), kSchedulingKinds)
  expect_equal(in_kinds_order(c("random", "all-good")), c("all-good", "random"))
  expect_equal(in_kinds_order(c("slips", "launches")), c("slips", "launches"))
})

test_that("a factor of three words or more is told from two words and from numbers", {
  expect_true(has_many_words(factor(c("tracked", "random", "all-good"))))
  expect_false(has_many_words(factor(c("slips", "launches"))))
  expect_false(has_many_words(factor(c(0, 100, 300))))
})

test_that("ratios near 0 are told by their first digits", {
  expect_equal(ratio_size_words(data.frame(effect_size = c(0.00023, 1.61), interval_low = c(3.02e-5, 0.22),
    interval_high = c(0.00175, 11.63), interval_level = 0.95)),
    c("0.00023, 95 % CI [0.000030, 0.0018]", "1.61, 95 % CI [0.22, 11.63]"))
})

test_that("the planted observer's means by delay come out, in order and size", {
  expected <- causality_trials(seed = 1, participants = 1000, repetitions = 1)
  expected <- tapply(expected$rating, expected$delay_ms, mean)
  study <- read_causality(write_study(at("a.sqlite"), causality_trials(seed = 70)))
  means <- participant_means(study$trials, "delay_ms")
  error <- apply(means, 2, sd) / sqrt(nrow(means))
  expect_true(all(diff(colMeans(means)) > 0))
  # Three standard errors over participants; the expectation's own error is a seventh of one.
  expect_true(all(abs(colMeans(means) - expected) < 3 * error))
})
