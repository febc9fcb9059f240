# Reads the main trials of one protocol from a study file, by the documented views alone.
#
#   rated_trial ─┐
#   trial_level ─┴─> trials: one row per rating, one column per factor
#   enrolment_summary ─> enrolments: one row per participant, planned and completed
#   excluded, ... ─────> trials_analysed.R: what is left out, and what else must be known
#
# Invariant: every rating returned was given on one and the same scale, in the main phase, outside
# catch trials, and is not excluded.
# SPDX-License-Identifier: MIT

kViews <- c("rated_trial", "trial_level", "enrolment_summary", "excluded", "interrupted_attempt",
  "set_aside_attempt", "trial_response")
kScaleColumns <- c("rating_minimum", "rating_maximum", "rating_best", "low_anchor", "high_anchor")

# The main trials of one protocol in a view that has a row per trial: list(protocol, trials, levels,
# enrolments, hashes, path, file, catch, exclusions, interrupted, timed_out). `what`: the words for them;
# `where`: a further condition on the view's rows.
read_trials <- function(path, protocol, view, what, where = "1") {
  study <- read_rows(path, protocol, view, where)
  study$path <- path
  study$file <- basename(path)
  study$protocol <- protocol
  study$hashes <- unique(study$trials$protocol_hash)
  if (nrow(study$trials) > 0) return(without_left_out(study, what))
  late <- study$timed_out[study$timed_out$catch == 0, ]
  refuse_without_answers(study$file, ": expected ", what, " of '", protocol, "', got none ",
    if (nrow(late) == 0) "yet" else sprintf("in time: no answer came in %d trials of %d participants",
      length(unique(late$trial)), length(unique(late$participant))))
}

read_rows <- function(path, protocol, view, where) {
  study <- withr::local_db_connection(open_study(path))
  ask <- function(...) DBI::dbGetQuery(study, paste(...), params = list(protocol))
  enrolments <- ask("SELECT * FROM enrolment_summary WHERE protocol = ?")
  if (nrow(enrolments) == 0) refuse_protocol(study, path, protocol)
  answered <- paste(view, "WHERE protocol = ? AND phase = 'main' AND", where)
  # As text: a view's column may hold numbers and words, an R column cannot.
  levels <- ask("SELECT trial, factor, CAST(level AS TEXT) AS level FROM trial_level",
    "WHERE trial IN (SELECT trial FROM", answered, ")")
  c(list(trials = ask("SELECT * FROM", answered, "ORDER BY participant, slot"), levels = levels,
    enrolments = enrolments), read_remarkable(study, protocol, enrolments))
}

# A read-only connection to a study file, or a refusal where one of `views` is absent.
open_study <- function(path, views = kViews) {
  if (!file.exists(path)) refuse(path, ": expected a study file, found no such file")
  if (dir.exists(path)) refuse(path, ": expected a study file, got a folder")
  study <- tryCatch(
    DBI::dbConnect(RSQLite::SQLite(), path, flags = RSQLite::SQLITE_RO, synchronous = NULL),
    error = function(condition) refuse(path, ": expected a study file, could not open it"))
  present <- tryCatch(
    DBI::dbGetQuery(study, "SELECT name FROM sqlite_master WHERE type = 'view'")$name,
    error = function(condition) NULL)
  absent <- setdiff(views, present)
  if (length(absent) == 0) return(study)
  DBI::dbDisconnect(study)
  if (is.null(present)) refuse(path, ": expected a study file, got a file that SQLite cannot read")
  if (!"rated_trial" %in% present) {
    refuse(path, ": expected a study file, got a database without the view ", absent[1])
  }
  refuse(path, ": expected a study file of this version, got one without the view ", absent[1],
    "; opening it with `impetus run` brings it up to date")
}

# Rows of a query on the views of the file at `path`; `...` stand for its question marks.
query_study <- function(path, query, ...) {
  study <- withr::local_db_connection(open_study(path, "enrolment_summary"))
  DBI::dbGetQuery(study, query, params = if (...length() > 0) list(...))
}

# All rows of a view for one protocol.
rows_of_view <- function(path, view, protocol) {
  query_study(path, sprintf("SELECT * FROM %s WHERE protocol = ?", view), protocol)
}

# What a protocol is called in a report's data; several where it was changed, none in data of before.
protocol_titles <- function(path, protocol) {
  fields <- query_study(path, "SELECT name FROM pragma_table_info('design_level')")$name
  if (!"title" %in% fields) return(character())
  unique(rows_of_view(path, "design_level", protocol)$title)
}

# The rows of "SELECT trial, ... FROM view" for the study's own trials: `row` is the number of their
# row in study$trials, and participant is that row's. `ending`: of the query.
rows_of_trials <- function(study, select, ending = "") {
  rows <- query_study(study$path, paste(select, "WHERE protocol = ? AND phase = 'main'", ending),
    study$protocol)
  rows$row <- match(rows$trial, study$trials$trial)
  rows <- rows[!is.na(rows$row), ]
  rows$participant <- study$trials$participant[rows$row]
  rows
}

refuse_protocol <- function(study, path, protocol) {
  others <- DBI::dbGetQuery(study, "SELECT DISTINCT protocol FROM enrolment_summary")$protocol
  refuse(path, ": expected protocol '", protocol, "', got ",
    if (length(others) == 0) "no protocol at all" else paste0("'", others, "'", collapse = ", "))
}

# The factor `name` of each trial, called `column` where a trial of the `file` has none.
factor_of_trials <- function(trials, levels, column, name, file) {
  mine <- levels[levels$factor == name, ]
  value <- mine$level[match(trials$trial, mine$trial)]
  if (anyNA(value)) {
    refuse(file, ": expected a level of ", column, " in every main trial, trial ",
      trials$trial[is.na(value)][1], " has none")
  }
  number <- suppressWarnings(as.numeric(value))
  if (!anyNA(number)) return(factor(number))
  own <- intersect(getOption("impetus.levels")[[name]], value)
  factor(value, c(own, setdiff(sort(unique(value)), own)))
}

# What a protocol of a report's data calls its factors and how it orders them and their levels,
# as options that label_of(), with_every_factor() and factor_of_trials() go by: labels up to a colon. A
# factor that versions of it call by different words, or by such as would be markup, keeps its name.
design_words <- function(path, protocol) {
  views <- query_study(path, "SELECT name FROM sqlite_master WHERE type = 'view'")$name
  rows <- if ("design_level" %in% views) query_study(path,
    "SELECT DISTINCT factor, label, level FROM design_level WHERE protocol = ? ORDER BY place, number",
    protocol)
  if (NROW(rows) == 0) return(list())
  labels <- vapply(split(trimws(sub(":.*$", "", rows$label)), rows$factor), function(words) {
    if (length(unique(words)) == 1) words[1] else NA_character_
  }, "")
  labels <- labels[!is.na(labels) & nzchar(labels) & !grepl("[][<>&|`*_\\\\[:cntrl:]]", labels)]
  list(impetus.labels = c(labels, stats::setNames(labels, sprintf("factor_%s", names(labels)))),
    impetus.levels = lapply(split(rows$level, factor(rows$factor, unique(rows$factor))),
      in_kinds_order))
}

# Kinds of scheduling stand in one order wherever they are reported, as mixed models go by it.
in_kinds_order <- function(levels) {
  if (all(levels %in% kSchedulingKinds)) intersect(kSchedulingKinds, levels) else levels
}

# The one scale of all ratings, as a one-row data frame; refuses to pool two.
one_scale <- function(study) {
  scales <- unique(rbind(study$trials[kScaleColumns], study$catch[kScaleColumns]))
  if (nrow(scales) == 1) return(scales)
  refuse("expected ratings on one scale, got ", paste(describe_scale(scales), collapse = "; and "),
    ": scales that differ are never pooled")
}

# "1 (very believable) to 3 (very unbelievable), 1 best"
describe_scale <- function(scale) {
  sprintf("%d (%s) to %d (%s), %d best", scale$rating_minimum, scale$low_anchor,
    scale$rating_maximum, scale$high_anchor, scale$rating_best)
}
