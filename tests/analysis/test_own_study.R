# A study of somebody's own: yes or no by factors that no script knows, some of them words.
# SPDX-License-Identifier: MIT
library(testthat)

# Yes follows restitution; light makes no difference.
bounce_answers <- function(seed, participants, n = 3) {
  set.seed(seed)
  plan <- shuffled_plan(participants, expand.grid(restitution = c(0.2, 0.4, 0.6, 0.8),
    light = c("matt", "dim"), repetition = seq_len(n), stringsAsFactors = FALSE))
  plan$positive <- answers_at(plan$restitution, 0.5, 0.2, guess = 0.05)
  plan
}

# Without a `label` the factors have none.
bounce_protocol <- function(label) jsonlite::toJSON(list(design = list(factors = list(
  c(list(name = "restitution", levels = c(0.2, 0.4, 0.6, 0.8)),
    if (!is.null(label)) list(label = label)),
  c(list(name = "light", levels = c("matt", "dim")),
    if (!is.null(label)) list(label = "Light: how it falls"))))),
  auto_unbox = TRUE)

bounce_study <- function(answers, label = "Restitution of both balls") {
  path <- write_threshold_study(tempfile("bounce", fileext = ".sqlite"), answers, "bounce")
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "UPDATE protocol SET protocol_json = ?", list(bounce_protocol(label)))
  DBI::dbDisconnect(study)
  path
}

# The report of a study: its page as one line, and the folder of its data.
report_of <- function(path) {
  folder <- new_folder()
  data <- file.path(folder, "data")
  dir.create(data, recursive = TRUE)
  suppressMessages({
    write_report_data(path, data)
    write_study_report(folder)
  })
  list(page = paste(readLines(file.path(folder, "report.html"), encoding = "UTF-8"), collapse = " "),
    data = data)
}

test_that("four levels make answers by condition too, and few trials no threshold", {
  page <- report_of(bounce_study(bounce_answers(1, 6)))$page
  for (words in c("Answers yes or no", "Share answered yes by restitution of both balls: 0.2:",
    "answers depended on restitution of both balls", "Odds ratios of a positive answer",
    "A threshold of restitution of both balls needs 40 trials or more", "there are 12.",
    "Share answered yes by light: matt:")) {
    expect_match(page, words, fixed = TRUE)
  }
  expect_false(grepl("Light: how", page, fixed = TRUE))
  expect_null(getOption("impetus.labels"))
})

test_that("words stand in the protocol's order, and a label that is markup is not taken", {
  folder <- new_folder()
  dir.create(folder)
  write_report_data(bounce_study(bounce_answers(2, 2), "<b>Restitution</b>"), folder)
  path <- study_of_report_data(folder)
  words <- design_words(path, "bounce")
  expect_equal(words$impetus.labels[["light"]], "Light")
  expect_false("restitution" %in% names(words$impetus.labels))
  withr::local_options(words)
  expect_equal(levels(parts_of_protocol(path, "bounce")[[1]]$trials$light), c("matt", "dim"))
})

test_that("factors without a label are called by their names", {
  page <- report_of(bounce_study(bounce_answers(5, 2), NULL))$page
  expect_match(page, "Share answered yes by restitution: 0.2:", fixed = TRUE)
})

test_that("the power of such a study is of its factors", {
  question <- list(protocol = "bounce", response = "answer", model = "means",
    factors = character(), compared = character())
  answers <- bounce_answers(3, 8)
  answers$participant <- sub("^P", "S", answers$participant)
  part <- power_part(bounce_study(answers), question)
  found <- power_tests(part, question)
  expect_setequal(found$factor, c("restitution", "light"))
  expect_lt(found$p[found$factor == "restitution"], 1e-4)
  many <- bounce_answers(4, 3, n = 12)
  expect_equal(power_part(bounce_study(many), question)$response, "threshold")
  question$factors <- "restitution"
  expect_equal(power_part(bounce_study(many), question)$response, "answer")
})

test_that("marks on a line are a part of their own, on the line's scale", {
  path <- bounce_study(bounce_answers(5, 6))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, paste("UPDATE response SET kind = 'slider', positive = NULL,",
    "detail = '{\"value\":1,\"minimum\":-50,\"maximum\":100}', answer = CAST((SELECT",
    "100 * (condition ->> 'restitution') FROM attempt JOIN trial ON trial.id = trial_id",
    "WHERE attempt.id = attempt_id) + abs(random() % 9) AS INTEGER)"))
  DBI::dbDisconnect(study)
  report <- report_of(path)
  for (words in c("Marks: ", "by a mark on a line from -50 to 100", "Mean mark by restitution of both",
    "Repeated-measures ANOVA", "Friedman")) {
    expect_match(report$page, words, fixed = TRUE)
  }
  expect_false(grepl("mixed model", report$page, fixed = TRUE))
  part <- parts_of_protocol(study_of_report_data(report$data), "bounce")[[1]]
  expect_equal(unname(part$line), c(-50, 100))
  expect_equal(round(mean(part$trials$mark[part$trials$restitution == "0.8"])), 84, tolerance = 0.02)
})

test_that("of questions to some people each, every part knows of the others' and the design of all", {
  answers <- bounce_answers(5, 5)
  answers$light <- ifelse(answers$participant %in% c("P01", "P02"), "matt", "dim")
  path <- bounce_study(answers[answers$participant != "P05" | answers$restitution == 0.2, ])
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, paste("UPDATE response SET kind = 'slider', positive = NULL,",
    "detail = '{\"value\":1,\"minimum\":0,\"maximum\":10}', answer = abs(random() % 9),",
    "question = (SELECT condition ->> 'light' FROM attempt JOIN trial ON trial.id = trial_id",
    "WHERE attempt.id = attempt_id)"))
  # P05 has been enrolled and has answered nothing.
  DBI::dbExecute(study, paste("DELETE FROM response WHERE attempt_id IN (SELECT attempt.id FROM attempt",
    "JOIN trial ON trial.id = trial_id JOIN enrolment ON enrolment.id = enrolment_id",
    "JOIN participant ON participant.id = participant_id WHERE pseudonym = 'P05')"))
  DBI::dbDisconnect(study)
  folder <- new_folder()
  dir.create(folder)
  write_report_data(path, folder)
  parts <- knowing_of_others(parts_of_protocol(study_of_report_data(folder), "bounce"))
  expect_setequal(vapply(parts, `[[`, "", "question"), c("matt", "dim"))
  words <- vapply(parts, participants_sentence, "")
  expect_match(words, "[0-9] more participants answered other questions of the protocol only[.]")
  expect_match(words, "1 more participant enrolled, without marks.", fixed = TRUE)
  design <- paste(design_lines(parts), collapse = " ")
  expect_match(design, "<td>dim, matt</td>", fixed = TRUE)
  expect_match(design, "24, between participants: 2 and 2", fixed = TRUE)
})

test_that("a choice among several options is a part of each option, and one of right choices", {
  path <- bounce_study(bounce_answers(6, 6))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  # Yes becomes "high"; no is "low" or, in a third of the dim trials, "none".
  DBI::dbExecute(study, paste("UPDATE response SET kind = 'choice', detail = '{\"options\":3}',",
    "answer = CASE WHEN positive = 1 THEN 'high' WHEN attempt_id % 3 = 0 AND (SELECT",
    "condition ->> 'light' FROM attempt JOIN trial ON trial.id = trial_id WHERE attempt.id = attempt_id)",
    "= 'dim' THEN 'none' ELSE 'low' END, correct = positive = ((SELECT condition ->> 'restitution'",
    "FROM attempt JOIN trial ON trial.id = trial_id WHERE attempt.id = attempt_id) > 0.5)"))
  DBI::dbExecute(study, "UPDATE response SET positive = NULL")
  DBI::dbDisconnect(study)
  report <- report_of(path)
  for (words in c("Right choices", "Choices of “high”", "Choices of “none”", "Choices of “low”",
    "Share answered “high” by restitution of both balls: 0.2:", "Participants chose one of 3 answers.")) {
    expect_match(report$page, words, fixed = TRUE)
  }
  parts <- parts_of_protocol(study_of_report_data(report$data), "bounce")
  expect_equal(vapply(parts, `[[`, "", "kind"), c("right choice", "choice high", "choice low",
    "choice none"))
  # Of each trial one option was chosen.
  expect_true(all(rowSums(sapply(parts[-1], function(part) part$trials$positive)) == 1))
  expect_true(all(parts[[4]]$trials$light[parts[[4]]$trials$positive == 1] == "dim"))
})
