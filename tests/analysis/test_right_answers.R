# Answers that are right or wrong by what happens, not by the level of a factor.
# SPDX-License-Identifier: MIT
library(testthat)

# In each scenario, yes is right in two of four clips; people are right with these chances.
kRightShare <- c(collide = 0.9, drop = 0.6)
foretold <- function(seed, participants, n = 20) {
  set.seed(seed)
  plan <- shuffled_plan(participants, expand.grid(scenario = names(kRightShare),
    clip = c("a", "b", "c", "d"), repetition = seq_len(n), stringsAsFactors = FALSE))
  yes_is_right <- (plan$clip %in% c("a", "b")) == (plan$scenario == "collide")
  right <- rbinom(nrow(plan), 1, kRightShare[plan$scenario]) == 1
  plan$positive <- as.integer(yes_is_right == right)
  attr(plan, "correct") <- as.integer(right)
  plan
}

foretold_study <- function(answers) {
  path <- write_threshold_study(tempfile("foretold", fileext = ".sqlite"), answers, "what-will-happen")
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "UPDATE response SET correct = ? WHERE attempt_id = ?",
    list(attr(answers, "correct"), seq_len(nrow(answers))))
  DBI::dbDisconnect(study)
  path
}

test_that("the share of right answers is a part of its own, before the answers themselves", {
  parts <- parts_of_protocol(foretold_study(foretold(1, 4)), "what-will-happen")
  expect_equal(vapply(parts, title_of_part, ""), c("Right answers", "Answers yes or no"))
  expect_equal(mean(parts[[1]]$trials$positive), 0.75, tolerance = 0.05)
  expect_equal(mean(parts[[2]]$trials$positive), 0.5, tolerance = 0.1)
})

test_that("accuracy is of those who have every level, as in the figure, or else of who has it", {
  part <- list(kind = "right", factors = c(scenario = "scenario"),
    study = list(factors = "scenario", published = c(hit = 0.8)),
    trials = data.frame(participant = c("A", "A", "B"), scenario = factor(c("drop", "hit", "hit")),
      positive = c(1, 0, 1)))
  rows <- published_accuracy(part)$table$rows
  expect_equal(rows$participants, c(1, 1))
  expect_equal(rows$accuracy, c(1, 0))
  part$trials <- part$trials[-2, ]
  rows <- published_accuracy(part)$table$rows
  expect_equal(rows$participants, c(1, 1))
  expect_equal(rows$accuracy, c(1, 1))
})

test_that("where one factor says what is right, the answers by that factor tell it", {
  answers <- foretold(2, 4)
  attr(answers, "correct") <- as.integer((answers$scenario == "collide") == (answers$positive == 1))
  parts <- parts_of_protocol(foretold_study(answers), "what-will-happen")
  expect_equal(vapply(parts, title_of_part, ""), "Answers yes or no")
})

test_that("accuracy stands beside what was published, with Student's intervals", {
  out <- new_folder()
  suppressMessages(report_page(list(studies = foretold_study(foretold(3, 8)), out = out),
    "what-will-happen"))
  rows <- utils::read.csv(file.path(out, "tables/what-will-happen-answer-right-accuracy.csv"))
  expect_equal(rows$level, names(kRightShare))
  expect_equal(rows$published, c(0.81, 0.75))
  expect_equal(rows$participants, c(8, 8))
  # Of 8 × 80 answers each the standard error is .02 at most.
  expect_equal(rows$accuracy, unname(kRightShare), tolerance = 0.08)
  expect_true(all(rows$low < rows$accuracy & rows$accuracy < rows$high))
  page <- paste(readLines(file.path(out, "report.html"), encoding = "UTF-8"), collapse = " ")
  expect_match(page, "(published: .75)", fixed = TRUE)
})
