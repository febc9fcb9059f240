# Study 4, yoked: pairs from the table, tracked − recorded planned and random − recorded beside it.
# SPDX-License-Identifier: MIT
library(testthat)

kYokedKinds <- c("tracked", "recorded", "random")

yoked_file <- function(trials) {
  write_gaze_study(tempfile(fileext = ".sqlite"), trials, protocol = "gaze-contingent-yoked")
}

read_yoked <- function(path) read_scheduling(path, "gaze-contingent-yoked")

# Models of an intercept alone, which is what was planted.
yoked_tests <- function(study) {
  without_slopes(with_failing(kVaried, suppressMessages(
    scheduling_tests(study, exposure_by_participant(study)))))
}

test_that("every study that is described has its script, and compares kinds that it has", {
  names <- sub("[.]dcf$", "", list.files(file.path(root, "analysis/studies")))
  expect_length(names, 12)
  expect_true(all(file.exists(file.path(root, "analysis", paste0(names, ".R")))))
  studies <- lapply(names, study_description)
  for (study in Filter(function(study) study$kind == "scheduling", studies)) {
    for (pair in study$pairs) expect_true(all(c(pair$of, pair$against) %in% study$kinds))
    expect_true(planned_pair(study)$planned)
  }
})

test_that("families are named by their pair, those of a pair beside it apart from the planned one's", {
  families <- c(kContrastFamily, kContrastMeansFamily, kEquivalenceFamily, kClickContrastFamily,
    kClickEquivalenceFamily, kClickBootstrapFamily, kExposureFamily, kTrackedGainFamily)
  expect_equal(vapply(families, family_of, "", kTrackedRandom, USE.NAMES = FALSE), families)
  pairs <- study_description("gaze-contingent-yoked")$pairs
  expect_equal(family_of(kContrastFamily, pairs[[1]]),
    "planned contrast tracked − recorded, mixed model")
  expect_equal(family_of(kContrastFamily, pairs[[2]]), "contrast random − recorded, mixed model")
  expect_equal(family_of(kEquivalenceFamily, pairs[[2]]), "equivalence, random − recorded")
  expect_length(intersect(vapply(families, family_of, "", pairs[[1]]),
    vapply(families, family_of, "", pairs[[2]])), 0)
})

test_that("kinds stand as tracked, recorded, random; another is refused", {
  trials <- gaze_trials(171, participants = 1, repetitions = 1, kinds = kYokedKinds)
  expect_equal(levels(read_yoked(yoked_file(trials))$trials$scheduling), kYokedKinds)
  trials$scheduling <- sub("random", "all-bad", trials$scheduling)
  path <- yoked_file(trials)
  condition <- tryCatch(read_yoked(path), refusal = identity)
  expect_equal(conditionMessage(condition), paste0(basename(path), ": expected scheduling to be one ",
    "of tracked, recorded, random, got all-bad"))
})

test_that("a planted advantage of one's own gaze is found, and recorded and random are not told apart", {
  trials <- gaze_trials(172, participants = 10, repetitions = 3, kinds = kYokedKinds)
  study <- read_yoked(add_collisions(yoked_file(trials), random_collisions(trials)))
  tests <- yoked_tests(study)
  pairs <- study$pairs
  overall <- function(family, pair) {
    tests_of(tests, family_of(family, pair), contrast_label(kOverall, pair))
  }
  # Planted: 1.2 logits between tracked and both others; recorded and random are the same.
  planned <- overall(kContrastFamily, pairs[[1]])
  expect_lt(planned$p_holm, 0.001)
  error <- diff(log(c(planned$interval_low, planned$interval_high))) / (2 * qnorm(0.975))
  expect_lt(abs(log(planned$effect_size) - 1.2), 3 * error)  # 3: one seed of 400 beyond
  expect_gt(overall(kContrastFamily, pairs[[2]])$p_holm, 0.05)
  expect_lt(overall(kClickContrastFamily, pairs[[1]])$effect_size, 1)
  differences <- contrast_differences(study$trials, pair = pairs[[2]])
  expect_equal(overall(kContrastMeansFamily, pairs[[2]])$effect_size,
    mean(differences[, kOverall]))
  expect_length(grep("tracked − random|as in the thesis", tests$rows$family), 0)
  words <- unlist(lapply(pairs, function(pair) paste(rating_contrast_words(tests, study$scale, pair),
    collapse = " ")))
  expect_match(words, paste("^Planned contrast, tracked against recorded .* Tracked was rated better",
    "than recorded overall"), all = FALSE)
  expect_match(words, "^Beside it, random against recorded ", all = FALSE)
  expect_match(exposure_words(tests, pairs[[1]])[1], paste("^Tracking kept bad collisions away from",
    "the gaze \\(tracked − recorded\\)"))
  expect_no_match(exposure_words(tests, pairs[[2]]), "Tracking")
})

test_that("the script's page has both pairs, and nothing of the thesis", {
  trials <- gaze_trials(173, participants = 1, repetitions = 1, kinds = kYokedKinds)
  path <- add_collisions(yoked_file(trials), random_collisions(trials))
  out <- new_folder()
  run <- run_script("gaze-contingent-yoked.R", path, "--out", out)
  expect_equal(run$status, 0)
  figures <- paste0("gaze-contingent-yoked-scheduling-", c("rating-tracked-recorded",
    "rating-random-recorded", "clicks-random-recorded"), ".pdf")
  expect_true(all(file.exists(file.path(out, "figures", figures))))
  gains <- read.csv(file.path(out, "tables/gaze-contingent-yoked-clicks-gains.csv"))
  expect_setequal(gains$scheduling, c("all", kYokedKinds))
  page <- readLines(file.path(out, "report.html"), encoding = "UTF-8")
  expect_no_match(paste(page, collapse = " "), "[Aa]s in the thesis")
})
