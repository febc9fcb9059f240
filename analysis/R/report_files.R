# A study file as tables of CSV, and back: the report is made of these tables alone.
#
#   study.sqlite ─ documented views, one transaction ─> data/VIEW.csv, data/columns.csv
#   data/ ─────────────────────────────────────────> a file with the same views, for the analysis
#
# So what was read is one state of the study, also while it is written to; and whoever has the folder
# gets the same report from it. An empty cell is a value that is missing.
# SPDX-License-Identifier: MIT

# What is kept of each view: its columns, and which rows. Free words of participants are not data.
kReportViews <- list(
  enrolment_summary = list(), rated_trial = list(), trial_level = list(), excluded = list(),
  trial_response = list(where = "kind <> 'free_text'"), interrupted_attempt = list(),
  set_aside_attempt = list(), click_trial = list(), trial_click = list(),
  seen_collision = list(columns = c("participant", "protocol", "trial", "phase", "step", "body_a",
    "body_b", "level", "stopped", "imposed_hold_ms", "eccentricity_deg", "gap_arcmin",
    "hidden_share", "time_s", "distance_m", "speed_deg_s", "list", "gaze_eccentricity_deg", "interval",
    sprintf("imposed_spin_%s_rad_s", c("a_x", "a_y", "a_z", "b_x", "b_y", "b_z")))),
  popped_step = list(), gaze_calibration = list(), session_provenance = list())

kReadViews <- c(names(kReportViews), "gaze_sample")  # of which samples are only counted

# Columns of words among those that a view computes; all others that it computes are numbers.
kComputedWords <- c("trial_level.factor", "trial_level.level")

# A protocol's factors and their levels in its own order, and the factors' words, for whoever reads
# the page: no view has them, so they are taken from the protocols as the file keeps them.
kDesignLevelSql <- "SELECT protocol.name AS protocol, protocol.hash AS protocol_hash,
  json_extract(protocol.protocol_json, '$.title') AS title,
  json_extract(factor.value, '$.name') AS factor, json_extract(factor.value, '$.label') AS label,
  factor.key + 1 AS place, level.key + 1 AS number, CAST(level.value AS TEXT) AS level
  FROM protocol, json_each(protocol.protocol_json, '$.design.factors') AS factor,
  json_each(factor.value, '$.levels') AS level WHERE json_valid(protocol.protocol_json)"

# Every trial that was completed, whatever was asked in it: which views tell of rated ones alone.
kShownTrialSql <- "SELECT participant.pseudonym AS participant, protocol.name AS protocol,
  protocol.hash AS protocol_hash, trial.id AS trial, trial.phase AS phase, trial.catch AS catch,
  attempt.intended_hold_ms, attempt.realised_hold_ms, attempt.timed_frames, attempt.late_timed_frames,
  attempt.sync_overridden, attempt.gaze_source, attempt.gaze_latency_p95_ms, attempt.gaze_late,
  attempt.gaze_lost_share FROM attempt JOIN trial ON trial.id = attempt.trial_id
  JOIN enrolment ON enrolment.id = trial.enrolment_id
  JOIN participant ON participant.id = enrolment.participant_id
  JOIN protocol ON protocol.id = enrolment.protocol_id WHERE attempt.outcome = 'completed'"

kMadeCounts <- c("place", "number", "trial", "samples", "blink", "off_screen", "lost", "catch",
  "timed_frames", "late_timed_frames", "sync_overridden", "gaze_late")
kMadeMeasures <- c("span_s", "intended_hold_ms", "realised_hold_ms", "gaze_latency_p95_ms",
  "gaze_lost_share")

# The samples of the gaze in each stimulus, counted; by trial in a file of before schema 13, which does
# not tell two stimuli apart.
gaze_trial_sql <- function(study) {
  fields <- DBI::dbGetQuery(study, "SELECT name FROM pragma_table_info('gaze_sample')")$name
  paste("SELECT protocol, participant, phase, trial, count(*) AS samples,",
    "sum(loss IS 'blink') AS blink, sum(loss IS 'off screen') AS off_screen,",
    "sum(loss IS 'lost') AS lost, CAST(max(time_s) - min(time_s) AS REAL) AS span_s",
    "FROM gaze_sample GROUP BY trial", if ("interval" %in% fields) ", interval")
}

# Writes the tables of the study at `path` to `folder`.
write_report_data <- function(path, folder) {
  study <- withr::local_db_connection(open_study(path, kReadViews))
  DBI::dbExecute(study, "BEGIN")
  columns <- each_row(names(kReportViews), function(view) write_view(study, view, folder))
  made <- list(design_level = DBI::dbGetQuery(study, kDesignLevelSql),
    gaze_trial = DBI::dbGetQuery(study, gaze_trial_sql(study)),
    shown_trial = DBI::dbGetQuery(study, kShownTrialSql))
  DBI::dbExecute(study, "COMMIT")
  columns <- rbind(columns, each_row(names(made), function(name) {
    write_rows(made[[name]], folder, name)
    fields <- names(made[[name]])
    data.frame(view = name, column = fields, type = ifelse(fields %in% kMadeMeasures, "REAL",
      ifelse(fields %in% kMadeCounts, "INTEGER", "TEXT")))
  }))
  write_rows(columns, folder, "columns")
  write_rows(data.frame(study = basename(path),
    read_utc = format(Sys.time(), "%Y-%m-%d %H:%M UTC", tz = "UTC")), folder, "study")
  invisible(folder)
}

write_rows <- function(rows, folder, name) {
  utils::write.csv(rows, file.path(folder, paste0(name, ".csv")), row.names = FALSE, na = "",
    fileEncoding = "UTF-8")
}

write_view <- function(study, view, folder) {
  declared <- DBI::dbGetQuery(study, sprintf("SELECT name, type FROM pragma_table_info('%s')", view))
  kept <- kReportViews[[view]]$columns
  if (!is.null(kept)) declared <- declared[declared$name %in% kept, ]
  name <- paste(view, declared$name, sep = ".")
  type <- ifelse(declared$type != "", declared$type, ifelse(name %in% kComputedWords, "TEXT", "REAL"))
  # A cast keeps an R column from taking the type of its first row.
  ask <- sprintf("CAST(\"%s\" AS %s) AS \"%s\"", declared$name, type, declared$name)
  where <- kReportViews[[view]]$where
  rows <- DBI::dbGetQuery(study, sprintf("SELECT %s FROM %s%s", paste(ask, collapse = ", "), view,
    if (is.null(where)) "" else paste(" WHERE", where)))
  write_rows(rows, folder, view)
  data.frame(view = view, column = declared$name, type = type)
}

# The tables of an earlier report, as they are.
copy_report_data <- function(from, to) {
  file.copy(list.files(from, "[.]csv$", full.names = TRUE), to, overwrite = TRUE)
}

# A new study file with the views of `folder`, named as the study was; its path.
study_of_report_data <- function(folder) {
  columns <- utils::read.csv(file.path(folder, "columns.csv"))
  name <- utils::read.csv(file.path(folder, "study.csv"), colClasses = "character")$study
  path <- file.path(tempfile("study"), basename(name))
  dir.create(dirname(path))
  study <- withr::local_db_connection(DBI::dbConnect(RSQLite::SQLite(), path))
  for (view in unique(columns$view)) {
    mine <- columns[columns$view == view, ]
    class <- c(INTEGER = "numeric", REAL = "numeric", TEXT = "character")[mine$type]
    rows <- utils::read.csv(file.path(folder, paste0(view, ".csv")), colClasses = unname(class),
      na.strings = "", check.names = FALSE, encoding = "UTF-8")
    DBI::dbWriteTable(study, paste0(view, "_rows"), rows,
      field.types = stats::setNames(mine$type, mine$column))
    DBI::dbExecute(study, sprintf("CREATE VIEW %s AS SELECT * FROM %s_rows", view, view))
  }
  known <- paste(columns$view, columns$column, sep = ".")
  if (all(c("seen_collision.interval", "trial_response.detail") %in% known))
    DBI::dbExecute(study, kLeaveStandards)
  with_trials_of_clicks(study)
  path
}

# Of two stimuli the report tells of the one that had the condition's levels.
kLeaveStandards <- "DELETE FROM seen_collision_rows WHERE (trial, interval) IN (
  SELECT trial, 3 - json_extract(detail, '$.test_interval') FROM trial_response_rows
  WHERE kind = 'two_interval')"

# Adds the views shown_trial, where the file has not got it, and clicked_trial to a file of its own.
with_trials_of_clicks <- function(study) {
  known <- DBI::dbGetQuery(study, "SELECT name FROM sqlite_master")$name
  if ("attempt" %in% known) DBI::dbExecute(study, paste("CREATE VIEW shown_trial AS", kShownTrialSql))
  DBI::dbExecute(study, sprintf(kClickedTrialSql,
    if (any(c("attempt", "shown_trial") %in% known)) "shown_trial" else "rated_trial"))  # data of before
}

# Trials with clicks as other trials are described.
kClickedTrialSql <- "CREATE VIEW clicked_trial AS SELECT clicked.*,
  coalesce(rated.protocol_hash, '') AS protocol_hash, coalesce(rated.catch, 0) AS catch,
  CASE clicked.simulated WHEN 1 THEN 'simulated' ELSE 'mouse' END AS device,
  coalesce(rated.timed_frames, 0) AS timed_frames,
  coalesce(rated.late_timed_frames, 0) AS late_timed_frames,
  coalesce(rated.sync_overridden, 0) AS sync_overridden, coalesce(rated.gaze_late, 0) AS gaze_late
  FROM click_trial AS clicked LEFT JOIN %s AS rated USING (trial)"
