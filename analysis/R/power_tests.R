# The tests of simulated studies, for a power analysis: those that the report of a real one makes.
#
#   study file ─> its part (ratings, answers, clicks) ─> its first N participants ─> p of each factor
#
#   model "means"   repeated-measures ANOVA of participants' means, Greenhouse–Geisser: the cheap one
#         "mixed"   the mixed model of the response with the factor's slope for each participant
#
# Participants of a simulated study are S01, S02, ...; the study of N of them is the first N, so that
# one simulation serves all sizes.
# SPDX-License-Identifier: MIT

testing_packages <- function(model) if (model == "mixed") c("ordinal", "lme4", "glmmTMB")

power_packages <- function(model) {
  c("RSQLite", "ggplot2", "commonmark", testing_packages(model))
}

# A ledger that other processes write to as well.
open_ledger <- function(path) {
  ledger <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(ledger, "PRAGMA busy_timeout = 60000")
  ledger
}

# What a ledger asks, as a list; `factors` and `compared` as words.
power_question <- function(ledger) {
  question <- as.list(DBI::dbGetQuery(ledger, "SELECT * FROM question"))
  for (list in c("factors", "compared")) {
    question[[list]] <- DBI::dbGetQuery(ledger,
      sprintf("SELECT value FROM question, json_each(%s) ORDER BY key", list))$value
  }
  question
}

# The part of a simulated study that the question is about.
power_part <- function(path, question) {
  protocol <- question$protocol
  part <- switch(question$response,
    rating = rating_part(path, protocol),
    clicks = click_part(with_clicked_trials(path), protocol),
    answer = answers_tested(answer_part(path, protocol, intersect(kThresholdKinds,
      rows_of_view(path, "trial_response", protocol)$kind)[1]), question))
  with_levels_compared(part, question$compared)
}

# Thresholds where levels were chosen trial by trial, or where there are enough trials for them and
# another factor to compare them by; else answers by condition, each factor among those tested.
answers_tested <- function(part, question) {
  axis <- threshold_factor(part)
  if (is.null(axis) || (!is_tracked(part) && axis %in% question$factors)) return(part)
  thresholds <- threshold_part(part)
  if (is_tracked(part)) return(thresholds)
  if (length(thresholds$split) == 0 || !is.null(why_no_function(thresholds)$why)) return(part)
  thresholds
}

# Simulated studies are thrown away, so the view may be made in the file itself.
with_clicked_trials <- function(path) {
  study <- withr::local_db_connection(DBI::dbConnect(RSQLite::SQLite(), path))
  with_trials_of_clicks(study)
  path
}

# Only the trials of two levels of a factor, where the question compares those.
with_levels_compared <- function(part, compared) {
  if (length(compared) == 0) return(part)
  column <- columns_of(part, compared[1])
  part$trials <- part$trials[as.character(part$trials[[column]]) %in% compared[2:3], ]
  part$trials[part$factors] <- lapply(part$trials[part$factors], droplevels)
  part
}

# The part with the first `count` participants of a simulated study.
first_participants <- function(part, count) {
  number <- as.integer(sub("^S", "", as.character(part$trials$participant)))
  part$trials <- part$trials[number <= count, ]
  part
}

# The columns of a part that hold these factors of the protocol (with_every_factor).
columns_of <- function(part, factors) {
  renamed <- paste0("factor_", factors)
  ifelse(renamed %in% part$factors & !factors %in% part$factors, renamed, factors)
}

# One row per factor tested: factor, p (NA: no test could be made), method, remark.
power_tests <- function(part, question) {
  tested <- if (length(question$compared) > 0) columns_of(part, question$compared[1]) else
    if (length(question$factors) > 0) columns_of(part, question$factors) else
      if (part$response == "threshold") part$split else unname(part$factors)
  if (length(tested) == 0) {
    refuse(part$file, ": expected a factor between whose levels the ", part$response,
      "s can be compared, got none")
  }
  rows <- if (part$response == "threshold") power_tests_of_thresholds(part, tested, question) else
    if (question$model == "mixed") power_tests_of_models(part, tested) else
      power_tests_of_means(part$trials, tested, switch(part$response, rating = "rating",
        clicks = "click_rate", "positive"))
  own <- sub("^factor_", "", rows$factor)
  rows$factor <- ifelse(columns_of(part, own) == rows$factor, own, rows$factor)
  rows
}

power_row <- function(factor, p, method, remark = "") {
  data.frame(factor = factor, p = p, method = method,
    remark = if (is.na(p) && remark == "") "nothing varies" else remark)
}

power_tests_of_means <- function(trials, tested, of) {
  each_row(tested, function(factor) {
    method <- "repeated-measures ANOVA of participants' means, Greenhouse–Geisser"
    if (is.null(trials[[factor]])) return(power_row(factor, NA, method, "no such factor varies"))
    trials[[factor]] <- droplevels(trials[[factor]])
    if (length(between_factors(trials, factor)) > 0) return(power_between(trials, factor, of))
    means <- complete_participants(participant_means(trials, factor, of))
    if (nrow(means) < 2 || ncol(means) < 2) {
      return(power_row(factor, NA, method, "fewer than two participants with every level"))
    }
    power_row(factor, greenhouse_geisser_p(means), method)
  })
}

# A factor of which each participant has one level: their means in all that they saw.
power_between <- function(trials, factor, of) {
  method <- "ANOVA of participants' means, between participants"
  groups <- tapply(as.character(trials[[factor]]), as.character(trials$participant), `[`, 1)
  means <- tapply(trials[[of]], as.character(trials$participant), mean)
  if (min(table(groups)) < 2) {
    return(power_row(factor, NA, method, "fewer than two participants with every level"))
  }
  p <- stats::oneway.test(means ~ groups, var.equal = TRUE)$p.value
  power_row(factor, if (is.finite(p)) p else NA, method)
}

power_tests_of_models <- function(part, tested) {
  factors <- varying_factors(part$trials, unname(part$factors))
  result <- suppressMessages(factor_tests(part$trials, factors, part$response,
    intersect(tested, factors)))
  of <- response_model(part$response)
  each_row(tested, function(factor) {
    row <- if (!is.null(result$rows)) tests_of(result, of$effects, factor)
    if (NROW(row) == 0) {
      return(power_row(factor, NA, of$model, c(result$remarks, "no test was made")[1]))
    }
    power_row(factor, row$p, row$method)
  })
}

# Thresholds of each participant and condition, without intervals, as means are tested.
power_tests_of_thresholds <- function(part, tested, question) {
  if (question$model == "mixed") {
    refuse("--model mixed: no mixed model tests thresholds between conditions; take --model means")
  }
  rows <- psychometric_functions(part, draws = 0)$rows
  rows <- rows[rows$use, ]
  result <- power_tests_of_means(rows, tested, "threshold")
  result$method <- sub("participants' means", "participants' thresholds", result$method)
  result
}

# Tests the studies listed in a table of files, and writes all that is found in one transaction. A study
# in which nobody answered, or everybody is excluded, has no row of a test: power_page.R counts it.
write_power_tests <- function(ledger_path, list_path) {
  ledger <- withr::local_db_connection(open_ledger(ledger_path))
  question <- power_question(ledger)
  studies <- utils::read.delim(list_path, colClasses = c(file = "character", sizes = "character",
    build = "character"))
  found <- lapply(split(studies, seq_len(nrow(studies))), function(study) {
    part <- tryCatch(power_part(file.path(dirname(list_path), study$file), question),
      without_answers = function(condition) NULL)
    lapply(as.integer(strsplit(study$sizes, ",")[[1]]), function(size) {
      key <- data.frame(effect = study$effect, number = study$number, participants = size)
      of_size <- if (!is.null(part)) first_participants(part, size)
      list(
        study = cbind(key, seed = study$seed, build = study$build, simulated_s = study$simulated_s),
        test = if (NROW(of_size$trials) > 0) cbind(key, power_tests(of_size, question)))
    })
  })
  found <- unlist(unname(found), recursive = FALSE)
  DBI::dbExecute(ledger, "BEGIN IMMEDIATE")
  for (table in c("study", "test")) {
    rows <- each_row(found, `[[`, table)
    if (is.null(rows)) next
    names <- names(rows)
    DBI::dbExecute(ledger, sprintf("INSERT OR IGNORE INTO %s (%s) VALUES (%s)", table,
      paste(names, collapse = ", "), paste0(":", names, collapse = ", ")), params = as.list(rows))
  }
  DBI::dbExecute(ledger, "COMMIT")
  invisible(NULL)
}
