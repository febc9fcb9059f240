# What the analysis rests on: who and what is left out, and what else a reader must know of the trials.
#
#   excluded ────────────> exclusions: rows leave the trials, and stand in the report's table
#   rated_trial.catch ───> catch trials: outside the design, reported apart
#   interrupted_attempt,
#   set_aside_attempt,
#   trial_response ──────> counts: showings that were cut short, answers that never came
#
# Invariant: nothing is left out that the report does not name, with its reason.
# SPDX-License-Identifier: MIT

# What the views know of one protocol beside its trials: list(exclusions, interrupted, timed_out),
# `study`: an open study file.
read_remarkable <- function(study, protocol, enrolments) {
  ask <- function(...) DBI::dbGetQuery(study, paste(...), params = list(protocol))
  exclusions <- DBI::dbGetQuery(study, paste(
    "SELECT participant, CAST(trial AS INTEGER) AS trial, reason, decided_utc FROM excluded",
    "ORDER BY participant, trial"))
  exclusions <- exclusions[exclusions$participant %in% enrolments$participant, ]
  list(
    exclusions = exclusions,
    interrupted = ask("SELECT participant, trial, interrupted_by FROM (",
      "SELECT protocol, participant, trial, interrupted_by FROM interrupted_attempt",
      "WHERE phase = 'main' UNION ALL",
      "SELECT protocol, participant, trial, 'set aside with its block' FROM set_aside_attempt)",
      "WHERE protocol = ?"),
    timed_out = ask("SELECT participant, trial, kind, question, catch FROM trial_response",
      "WHERE protocol = ? AND phase = 'main' AND timed_out = 1"))
}

# Those of a part's answers that did not come in time, of trials that would be analysed.
timed_out_of <- function(part) {
  rows <- part$timed_out
  kind <- switch(part$response, rating = "rating", mark = "slider", clicks = , press = "none",
    if (!is.null(part$choices)) "choice" else if (isTRUE(part$kind %in% kThresholdKinds)) part$kind else
      "yes_no")
  if (!is.null(part$question)) rows <- rows[rows$question == part$question, ]
  rows[rows$kind == kind & rows$catch == 0 & !is_excluded(rows, part$exclusions), ]
}

# Which of these rows are excluded: TRUE for each that is.
is_excluded <- function(rows, exclusions) {
  rows$participant %in% exclusions$participant[is.na(exclusions$trial)] |
    rows$trial %in% stats::na.omit(exclusions$trial)
}

# The study without what was excluded and without catch trials: study$trials, study$catch and
# study$exclusions with the number of rows that each took away, every row counted once. `what`:
# "rated main trials". An exclusion of a trial that is not among the rows took nothing away and is
# left out of the table.
without_left_out <- function(study, what) {
  trials <- study$trials
  out <- is_excluded(trials, study$exclusions)
  study$exclusions <- counted_exclusions(study$exclusions, trials)
  is_catch <- trials$catch == 1
  study$catch <- trials[!out & is_catch, ]
  study$trials <- trials[!out & !is_catch, ]
  if (nrow(study$trials) > 0) return(study)
  refuse_without_answers(study$file, ": expected ", what, " of '",
    study$protocol, "', got only catch trials and excluded ones (", sum(out), " excluded)")
}

counted_exclusions <- function(exclusions, trials) {
  if (nrow(exclusions) == 0) return(cbind(exclusions, trials = integer()))
  # A trial of somebody who is excluded whole is counted there alone.
  whole <- is.na(exclusions$trial)
  by_person <- is_excluded(trials, exclusions[whole, ])
  rows_out <- lapply(seq_len(nrow(exclusions)), function(i) is_excluded(trials, exclusions[i, ]))
  exclusions$trials <- mapply(function(out, whole) sum(out & (whole | !by_person)), rows_out, whole)
  exclusions[whole | vapply(rows_out, any, NA), ]
}

# The part of the report: who or which trial is left out, why, since when; then the counts.
left_out_section <- function(study) {
  c(exclusion_lines(study), "", remarkable_lines(study), "", catch_lines(study))
}

exclusion_lines <- function(study) {
  decided <- study$exclusions
  made_up <- study$excluded
  rows <- c(
    sprintf("%s | %s | %d | %s | %s", as_typed(decided$participant),
      ifelse(is.na(decided$trial), "all", decided$trial), decided$trials,
      as_typed(decided$reason), decided$decided_utc),
    sprintf("%s | all | %d | %s | –", as_typed(made_up$participant), made_up$trials, made_up$reason)
  )
  if (length(rows) == 0) return("Nobody and no trial was excluded.")
  c("Left out of every analysis:", "",
    markdown_table(c("participant", "trial", "main trials left out", "reason", "decided"), rows))
}

# Words that somebody typed, as they may stand in a line or a table of Markdown: they stay words.
as_typed <- function(words) {
  words <- gsub("[[:space:][:cntrl:]]+", " ", enc2utf8(as.character(words)))
  gsub("([][\\\\`*_|#~])", "\\\\\\1", with_entities(words))
}

remarkable_lines <- function(study) {
  trials <- study$trials
  reasons <- sort(unique(study$interrupted$interrupted_by), na.last = TRUE)
  row <- function(what, rows, treated) {
    sprintf("%s | %d | %d | %s", what, NROW(rows), participant_count(rows), treated)
  }
  markdown_table(c("main trials", "number", "participants", "treated as"), c(
    row("with late timed frames", trials[trials$late_timed_frames > 0, ], "in the analysis"),
    row("with gaze shown too late", trials[trials$gaze_late %in% 1, ], "in the analysis"),
    vapply(reasons, function(reason) {
      row(sprintf("showings interrupted (%s)", if (is.na(reason)) "not known" else reason),
        study$interrupted[study$interrupted$interrupted_by %in% reason, ], "not data; shown again")
    }, ""),
    row("without an answer in time", timed_out_of(study), "no answer to analyse"),
    if (!is.null(study$unclicked)) row("without a click", study$unclicked, "no time to analyse"),
    row("catch trials", study$catch, "apart, below")))
}

# Catch trials by condition: their ratings, marks or clicks, or the share of right, chosen or positive
# answers.
catch_lines <- function(study) {
  catch <- study$catch
  if (nrow(catch) == 0) return(character())
  measure <- catch_measure(study)
  catch$value <- measure$value
  rows <- vapply(split(catch, catch$condition), function(cell) {
    known <- cell$value[!is.na(cell$value)]
    sprintf("%s | %d | %d | %s", words_of_condition(study, cell$trial[1]), nrow(cell),
      participant_count(cell), if (length(known) == 0) "– | –" else
        sprintf("%.2f | %.0f to %.0f", mean(known), min(known), max(known)))
  }, "")
  c("Catch trials, never pooled with the others:", "",
    markdown_table(c("condition", "trials", "participants", measure$title, "range"), unname(rows)))
}

# "delay at contact (ms) 300, collision spin": the trial's level of each factor.
words_of_condition <- function(study, trial) {
  levels <- query_study(study$path,
    "SELECT factor, CAST(level AS TEXT) AS of FROM trial_level WHERE trial = ?", trial)
  as_typed(paste(vapply(levels$factor, name_and_unit, ""), levels$of, collapse = ", "))
}

# What a study's catch trials are told by: list(title, value), a value for each; NA where there is none.
catch_measure <- function(study) {
  catch <- study$catch
  measure <- function(title, value) list(title = title, value = as.numeric(value))
  if (!is.null(catch$rating)) return(measure("mean rating", catch$rating))
  if (!is.null(study$option)) {
    return(measure(sprintf("share of “%s”", as_typed(study$option)), catch$answer == study$option))
  }
  if (any(c("right", "right choice") %in% study$kind)) {
    return(measure("share of right answers", catch$correct))
  }
  if (isTRUE(study$response %in% c("clicks", "press"))) return(measure("mean clicks", catch$clicks))
  if (identical(study$response, "mark")) return(measure("mean mark", catch$answer))
  measure("share of positive answers", catch$positive)
}

# `study$elsewhere`: the participants of the protocol's other parts, where there are such.
participants_sentence <- function(study) {
  noun <- answer_noun(study)
  per <- table(study$trials$participant)
  left_out <- c(study$excluded$participant,
    study$exclusions$participant[is.na(study$exclusions$trial)])
  enrolled <- study$enrolments[!study$enrolments$participant %in% left_out, ]
  unfinished <- enrolled$completed_trials < enrolled$planned_trials | is.na(enrolled$finished_utc)
  incomplete <- participant_count(enrolled[unfinished & enrolled$participant %in% names(per), ])
  without <- setdiff(enrolled$participant, names(per))
  elsewhere <- length(intersect(without, study$elsewhere))
  waiting <- length(without) - elsewhere
  paste0(sprintf("%s, %s in the main phase (%s each).", count_of(length(per), "participant"),
      count_of(sum(per), noun), paste(unique(range(per)), collapse = " to ")),
    if (incomplete > 0) sprintf(" The study is in progress: %s included with the %ss given so far.",
      if (incomplete == 1) "1 participant has not finished and is" else
        paste(incomplete, "participants have not finished and are"), noun),
    if (elsewhere > 0) sprintf(" %s answered other questions of the protocol only.",
      count_of(elsewhere, "more participant")),
    if (waiting > 0) sprintf(" %s enrolled, without %ss.", count_of(waiting, "more participant"),
      noun))
}

exclusions_sentence <- function(study) {
  columns <- c("participant", "trials", "reason")
  left_out <- rbind(study$excluded[columns], study$exclusions[columns])
  if (nrow(left_out) == 0) return(sprintf("No %s was excluded.", answer_noun(study)))
  sprintf("Left out: %s of %s (%s).", count_of(sum(left_out$trials), answer_noun(study)),
    count_of(participant_count(left_out), "participant"),
    paste(as_typed(unique(left_out$reason)), collapse = "; "))
}

# Of studies of when a click came: how many trials have none, and so no time.
unclicked_sentence <- function(study) {
  if (NROW(study$unclicked) == 0) return(character())
  sprintf("In %s of %s nobody clicked; %s in no mean and no test.",
    count_of(nrow(study$unclicked), "more trial"),
    count_of(participant_count(study$unclicked), "participant"),
    if (nrow(study$unclicked) == 1) "it is" else "they are")
}

catch_sentence <- function(study) {
  if (nrow(study$catch) == 0) return(character())
  be <- if (nrow(study$catch) == 1) "is" else "are"
  sprintf("%s %s reported apart and %s in no test.", count_of(nrow(study$catch), "catch trial"), be, be)
}

# What a participant gives in a trial of this study: a rating, an answer or, with clicks, the trial.
answer_noun <- function(study) {
  if (!is.null(study$scale)) "rating" else if (identical(study$response, "clicks")) "trial" else
    if (identical(study$response, "press")) "click" else
    if (identical(study$response, "mark")) "mark" else "answer"
}

hashes_sentence <- function(study) {
  if (length(study$hashes) == 1) return(character())
  sprintf("%d versions of protocol '%s' (different hashes) are pooled here.",
    length(study$hashes), study$protocol)
}
