# The tests of simulated studies and how often they reject.
# SPDX-License-Identifier: MIT
library(testthat)

# An empty ledger of a question; its path.
new_ledger <- function(response = "rating", model = "means", factors = "[]", compared = "[]",
                       protocol = "causality") {
  path <- tempfile("power", fileext = ".sqlite")
  ledger <- DBI::dbConnect(RSQLite::SQLite(), path)
  on.exit(DBI::dbDisconnect(ledger))
  tables <- paste(sub("--.*", "", readLines(file.path(root, "experiments/power/ledger.sql"))),
    collapse = "\n")
  for (statement in strsplit(tables, ";", fixed = TRUE)[[1]]) {
    if (nzchar(trimws(statement))) DBI::dbExecute(ledger, statement)
  }
  observer <- '{"parameters": {"effect": {"value": %s, "unit": "logit", "source": "<assumed>"}}}'
  DBI::dbAppendTable(ledger, "question", data.frame(id = 1, created_utc = "2026", protocol = protocol,
    protocol_hash = "0123456789abcdef0", observer = sprintf(observer, 4.5),
    null_observer = sprintf(observer, 0), screen = "{}", response = response, model = model,
    factors = factors, compared = compared, seed = 1))
  path
}

with_ledger <- function(path, act) {
  ledger <- DBI::dbConnect(RSQLite::SQLite(), path)
  on.exit(DBI::dbDisconnect(ledger))
  act(ledger)
}

# Rows of `test` and their studies: p by study, of one factor or several.
fill_ledger <- function(path, rows) {
  key <- unique(rows[c("effect", "number", "participants")])
  with_ledger(path, function(ledger) {
    DBI::dbAppendTable(ledger, "study", cbind(key, seed = key$number, build = "b", simulated_s = 1))
    DBI::dbAppendTable(ledger, "test", cbind(rows, method = "a test", remark = ifelse(is.na(rows$p),
      "nothing varies", "")))
  })
  path
}

# Simulated studies call their participants S01, S02, ...
as_simulated <- function(trials) {
  trials$participant <- sub("^P", "S", trials$participant)
  trials
}

# Two delays and two speeds, so that a model takes seconds.
few_power_trials <- function(seed) {
  trials <- causality_trials(seed, 8)
  trials[trials$delay_ms < 300 & trials$speed_deg_s < 15 & trials$viewpoint_deg == 0, ]
}

test_that("the quick ANOVA is the main effect of the whole one, of any number of levels", {
  trials <- causality_trials(3, 12)
  for (column in c("delay_ms", "speed_deg_s")) trials[[column]] <- factor(trials[[column]])
  trials$viewpoint_deg <- factor(trials$viewpoint_deg)
  factors <- c("delay_ms", "speed_deg_s", "viewpoint_deg")
  whole <- repeated_measures_tests(trials, factors)$rows
  for (factor in factors) {
    expect_equal(greenhouse_geisser_p(participant_means(trials, factor)),
      whole$p[whole$effect == factor], tolerance = 1e-6)
  }
  two <- droplevels(trials[trials$delay_ms != 300, ])
  means <- participant_means(two, "delay_ms")
  expect_equal(greenhouse_geisser_p(means),
    stats::t.test(means[, 1], means[, 2], paired = TRUE)$p.value, tolerance = 1e-9)
  expect_identical(greenhouse_geisser_p(matrix(2, 5, 3)), NA_real_)
})

test_that("of fewer participants than levels too, power's p of a factor is the report's", {
  set.seed(8)
  trials <- expand.grid(participant = sprintf("S%02d", 1:3), delay_ms = factor(50 * (0:4)),
    gap_arcmin = factor(c(0, 5, 10, 20)), repetition = 1:2)
  trials$rating <- sample(1:5, nrow(trials), replace = TRUE)
  factors <- c("delay_ms", "gap_arcmin")
  report <- repeated_measures_tests(trials, factors)$rows
  expect_equal(power_tests_of_means(trials, factors, "rating")$p,
    report$p[match(factors, report$effect)], tolerance = 1e-9)
})

test_that("a study of N is the first N participants, tested as the report tests them", {
  study <- write_study(tempfile(fileext = ".sqlite"), as_simulated(causality_trials(5, 12)))
  ledger <- new_ledger()
  list <- file.path(dirname(study), "studies.tsv")
  writeLines(c("file\teffect\tnumber\tsizes\tseed\tsimulated_s\tbuild",
    paste(basename(study), 1, 4, "5,12", "1000004", 2.5, "a build", sep = "\t")), list)
  write_power_tests(ledger, list)
  kept <- with_ledger(ledger, function(l) DBI::dbGetQuery(l, "SELECT * FROM test JOIN study
    USING (effect, number, participants)"))
  expect_setequal(kept$participants, c(5, 12))
  expect_setequal(kept$factor, c("delay_ms", "speed_deg_s", "viewpoint_deg"))
  expect_true(all(kept$number == 4 & kept$seed == 1000004 & kept$effect == 1))
  part <- rating_part(study, "causality")
  for (size in c(5, 12)) {
    some <- part$trials[part$trials$participant %in% sprintf("S%02d", seq_len(size)), ]
    expected <- repeated_measures_tests(some, unname(part$factors))$rows
    mine <- kept[kept$participants == size, ]
    expect_equal(mine$p, expected$p[match(mine$factor, expected$effect)], tolerance = 1e-6)
  }
  write_power_tests(ledger, list)  # as two processes may that were at the same
  expect_equal(with_ledger(ledger, power_rates)$studies, rep(1, 6))
})

test_that("the mixed model's p is that of the report", {
  study <- write_study(tempfile(fileext = ".sqlite"), as_simulated(few_power_trials(6)))
  part <- rating_part(study, "causality")
  question <- list(response = "rating", model = "mixed", factors = "delay_ms", compared = character())
  mine <- suppressMessages(power_tests(part, question))
  report <- suppressMessages(factor_tests(part$trials, unname(part$factors)))$rows
  expect_equal(nrow(mine), 1)
  expect_equal(mine$p, report$p[report$family == kEffectsFamily & report$effect == "delay_ms"])
  expect_match(mine$method, "cumulative-link mixed model")
})

test_that("two levels are compared in their own trials alone", {
  study <- write_study(tempfile(fileext = ".sqlite"), as_simulated(causality_trials(7, 10)))
  question <- list(protocol = "causality", response = "rating", model = "means",
    factors = character(), compared = c("delay_ms", "0", "100"))
  mine <- power_tests(power_part(study, question), question)
  means <- participant_means(rating_part(study, "causality")$trials, "delay_ms")
  expect_equal(mine$factor, "delay_ms")
  expect_equal(mine$p, stats::t.test(means[, "0"], means[, "100"], paired = TRUE)$p.value,
    tolerance = 1e-9)
})

test_that("thresholds are compared between conditions, and one condition has nothing to test", {
  answers <- as_simulated(gap_answers(1, 6))
  study <- write_threshold_study(tempfile(fileext = ".sqlite"), answers, "gap-thresholds")
  question <- list(protocol = "gap-thresholds", response = "answer", model = "means",
    factors = character(), compared = character())
  part <- power_part(study, question)
  mine <- power_tests(part, question)
  expect_setequal(mine$factor, part$split)
  expect_true(all(is.finite(mine$p)))
  expect_match(mine$method[1], "participants' thresholds")
  question$model <- "mixed"
  expect_error(power_tests(part, question), "take --model means", class = "refusal")
  part$split <- character()
  question$model <- "means"
  expect_error(power_tests(part, question), "expected a factor between whose levels",
    class = "refusal")
})

test_that("clicks are tested by their rate", {
  trials <- as_simulated(gaze_trials(2, 6))
  study <- write_gaze_study(tempfile(fileext = ".sqlite"), trials)
  question <- list(protocol = "gaze-contingent", response = "clicks", model = "means",
    factors = "scheduling", compared = character())
  part <- power_part(study, question)
  mine <- power_tests(part, question)
  expect_equal(mine$p, greenhouse_geisser_p(participant_means(part$trials, "scheduling", "click_rate")))
})

test_that("rates, their exact intervals, and Holm over the factors", {
  p <- c(.001, .04, .04, .3, NA)  # of factor a; of b always .02
  rows <- rbind(
    data.frame(effect = 1, number = 1:5, participants = 10, factor = "a", p = p),
    data.frame(effect = 1, number = 1:5, participants = 10, factor = "b", p = .02))
  rates <- with_ledger(fill_ledger(new_ledger(), rows), power_rates)
  a <- rates[rates$factor == "a", ]
  expect_equal(c(a$studies, a$untested, a$rejected, a$alone), c(5, 1, 3, 3))
  b <- rates[rates$factor == "b", ]
  # Holm doubles the smaller of two: .02 beside .001, .04, .04, .3 and alone.
  expect_equal(c(b$rejected, b$alone), c(5, 5))
  # Clopper and Pearson 1934, 3 of 5: .1466, .9473.
  expect_equal(c(a$alone_low, a$alone_high), c(.14663, .94726), tolerance = 1e-4)
  alone <- with_ledger(fill_ledger(new_ledger(), data.frame(effect = 1, number = 1:4,
    participants = 10, factor = "a", p = c(.03, .049, .051, .2))), power_rates)
  expect_equal(c(alone$rejected, alone$rate), c(2, .5))
})

test_that("the page answers how many, what happens without the effect, and why tests failed", {
  planted <- function(size, rejecting) data.frame(effect = 1, number = 1:200, participants = size,
    factor = "delay_ms", p = rep(c(.001, .5), c(rejecting, 200 - rejecting)))
  without <- function(size, rejecting) {
    rows <- planted(size, rejecting)
    rows$effect <- 0
    rows
  }
  rows <- rbind(planted(10, 120), planted(20, 165), planted(30, 185), without(10, 10),
    without(20, 30), without(30, 9))
  rows$p[rows$effect == 1 & rows$participants == 30 & rows$number == 200] <- NA
  ledger <- fill_ledger(new_ledger(), rows)
  folder <- new_folder()
  dir.create(folder)
  said <- capture.output(write_power_page(ledger, folder))
  page <- paste(readLines(file.path(folder, "power.html"), encoding = "UTF-8"), collapse = "\n")
  expect_match(said, "^delay_ms: 10 participants .600 \\[", all = FALSE)
  # 165 of 200 is above .8, its interval is not; 185 is beyond it.
  expect_match(page, "Of these numbers of participants, 30 is the least", fixed = TRUE)
  expect_match(page, "does not hold .05 for delay (ms) with 20 participants (.150 [", fixed = TRUE)
  expect_match(page, "nothing varies", fixed = TRUE)
  expect_match(page, "&lt;assumed&gt;", fixed = TRUE)
  expect_match(page, "corrects p of all main effects and interactions of the ANOVA together",
    fixed = TRUE)
  expect_match(page, "Without the effect: effect 0; the rest as above.", fixed = TRUE)
  expect_false(grepl("<script|<link|<img|src=|@import|href=\"[^#]", page))
  expect_false(grepl("\\b(NaN|Inf|NULL|NA)\\b", gsub("<svg.*?</svg>", "", page)))
  expect_true(all(file.exists(file.path(folder, c("power.svg", "power.pdf", "power.csv")))))
  kept <- utils::read.csv(file.path(folder, "power.csv"))
  expect_equal(nrow(kept), 6)
})

test_that("a ledger without tests is refused in one sentence", {
  expect_error(with_ledger(new_ledger(), power_rates),
    "expected tests of studies in the ledger, got none: no study is done yet", class = "refusal")
})

test_that("a study with nobody's answers left is one that did not reject", {
  trials <- as_simulated(few_power_trials(2))
  answered <- write_study(tempfile(fileext = ".sqlite"), trials)
  emptied <- write_study(tempfile(fileext = ".sqlite"), trials)
  for (participant in unique(trials$participant)) add_exclusion(emptied, participant, NA, "a rule")
  ledger <- new_ledger(factors = "[\"delay_ms\"]")
  for (number in 1:2) {  # the first alone, without any test
    studies <- tempfile(fileext = ".tsv")
    writeLines(c("file\teffect\tnumber\tsizes\tseed\tsimulated_s\tbuild",
      sprintf("%s\t1\t%d\t4,8\t7\t2.5\tb", basename(c(emptied, answered))[number], number)), studies)
    write_power_tests(ledger, studies)
  }
  rates <- with_ledger(ledger, power_rates)
  expect_equal(rates$participants, c(4, 8))
  expect_equal(cbind(rates$studies, rates$untested), cbind(c(2, 2), c(1, 1)))
  expect_match(paste(with_ledger(ledger, untested_lines), collapse = ""),
    "no answers are left to test", fixed = TRUE)
})

test_that("a table's column that begins like p is not taken for it", {
  shown <- html_table(data.frame(participants = c(5, 10), rate = c(".1", ".2")))
  expect_length(gregexpr("<th", paste(shown, collapse = ""))[[1]], 3)  # thead, and two heads
})

test_that("a model that cannot be fitted is no test, and its reason is kept", {
  trials <- as_simulated(few_power_trials(6))
  trials <- trials[trials$participant %in% c("S01", "S02"), ]
  part <- rating_part(write_study(tempfile(fileext = ".sqlite"), trials), "causality")
  question <- list(response = "rating", model = "mixed", factors = "delay_ms", compared = character())
  mine <- power_tests(part, question)
  expect_true(is.na(mine$p))
  expect_match(mine$remark, "needs three participants or more", fixed = TRUE)
})

test_that("a factor that is called as a column of a view is tested, under its own name", {
  part <- list(factors = c(factor_detail = "factor_detail", delay_ms = "delay_ms"))
  expect_equal(columns_of(part, c("detail", "delay_ms", "none")), c("factor_detail", "delay_ms", "none"))
  trials <- data.frame(participant = rep(c("S1", "S2", "S3"), each = 4), rating = c(1:4, 2:5, 1, 3, 2, 5),
    factor_detail = factor(rep(c("a", "b"), 6)))
  rows <- power_tests(list(factors = c(factor_detail = "factor_detail"), trials = trials,
    response = "rating"), list(factors = "detail", compared = character(), model = "means"))
  expect_equal(rows$factor, "detail")
  expect_false(is.na(rows$p))
})
