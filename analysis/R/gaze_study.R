# A gaze-contingent study (studies.R) from its views: each rated trial with its clicks, its
# collisions, its gaze.
#
#   rated_trial, trial_level ─> trials     seen_collision ─> collisions
#   click_trial ──────────────> + clicks   gaze_sample ─> gaze (gaze_quality.R)
#   trial_click ──> clicks (click_detection.R)    gaze_calibration ─> calibrations
#
# Invariant: every row of collisions, clicks and gaze belongs to a row of trials, by `row`, so what is
# left out of the trials is left out everywhere.
# SPDX-License-Identifier: MIT

# Reads what the command line names, as open_rating_study does, and adds what only this study has.
# The trials' kinds have the order of the study's. The two factors become the columns scheduling and
# bodies, whatever unit their names carry.
open_gaze_study <- function(study, words) {
  study <- open_rating_study(study, words)
  study$trials[names(study$factors)] <- study$trials[study$factors]
  study$factors <- stats::setNames(nm = names(study$factors))
  study <- with_clicks(with_kinds_in_order(study))
  study <- with_events(with_click_times(with_collisions(study)))
  # The samples of each trial counted.
  study$gaze <- rows_of_trials(study, paste(
    "SELECT trial, count(*) AS samples, sum(loss IS 'blink') AS blink,",
    "sum(loss IS 'off screen') AS off_screen, sum(loss IS 'lost') AS lost,",
    "CAST(max(time_s) - min(time_s) AS REAL) AS span_s FROM gaze_sample"), "GROUP BY trial")
  # Every calibration, validation and drift check of the participants who have a trial here.
  rows <- each_row(unique(study$trials$path), query_study,
    "SELECT * FROM gaze_calibration WHERE protocol = ? ORDER BY calibration", study$protocol)
  study$calibrations <- rows[rows$participant %in% as.character(study$trials$participant), ]
  study
}

with_kinds_in_order <- function(study) {
  present <- levels(study$trials$scheduling)
  unknown <- setdiff(present, study$kinds)
  if (length(unknown) > 0) {
    refuse(file_names(study), ": expected scheduling to be one of ",
      paste(study$kinds, collapse = ", "), ", got ", paste(unknown, collapse = ", "))
  }
  study$trials$scheduling <- factor(as.character(study$trials$scheduling),
    intersect(study$kinds, present))
  study
}

# Adds clicks, exposure_s and merge_within_ms to the trials. exposure_s is NA where no frame was
# recorded; merge_within_ms where the protocol names none.
with_clicks <- function(study) {
  rows <- rows_of_trials(study, paste(
    "SELECT trial, clicks, CAST(exposure_s AS REAL) AS exposure_s,",
    "CAST(merge_within_ms AS REAL) AS merge_within_ms FROM click_trial"))
  columns <- c("clicks", "exposure_s", "merge_within_ms")
  study$trials[columns] <- rows[match(seq_len(nrow(study$trials)), rows$row), columns]
  silent <- is.na(study$trials$clicks)
  if (any(silent)) {
    refuse(study$trials$file[silent][1], ": expected a protocol that asks for clicks, got '",
      study$protocol, "' without them")
  }
  study
}

# Adds study$collisions: a wall or not, bad (resolved at the bounding sphere, level 0) or not, the
# gap that could be seen of it, where the gaze was.
with_collisions <- function(study) {
  rows <- rows_of_trials(study, paste(
    "SELECT trial, body_a, body_b, level, CAST(time_s AS REAL) AS time_s,",
    "CAST(gap_arcmin AS REAL) AS gap_arcmin, CAST(hidden_share AS REAL) AS hidden_share,",
    "CAST(gaze_eccentricity_deg AS REAL) AS gaze_eccentricity_deg FROM seen_collision"))
  rows$wall <- is_wall(rows$body_a) | is_wall(rows$body_b)
  rows$bad <- rows$level == 0
  rows$visible_gap_arcmin <- rows$gap_arcmin * (1 - rows$hidden_share)
  study$collisions <- rows
  study
}

is_wall <- function(name) startsWith(as.character(name), "wall ")

# Has every participant as many ratings in each cell as the plan has repetitions?
design_sentence <- function(trials, kinds = kSchedulingKinds) {
  cells <- table(as.character(trials$participant), trials$scheduling, trials$bodies)
  most <- max(trials$repetition)
  short <- apply(cells < most, 1, any)
  absent <- setdiff(kinds, levels(droplevels(trials$scheduling)))
  design <- paste(count_of(dim(cells)[2], "kind"), "of scheduling ×",
    count_of(dim(cells)[3], "number"), "of bodies ×", count_of(most, "repetition"))
  c(
    if (length(absent) > 0) sprintf("The design lacks scheduling %s.", and_words(absent)),
    if (!any(short)) sprintf("Every participant has all of the design: %s.", design) else
      sprintf("Of the design, %s, ratings are still missing from %s.", design,
        and_words(as_typed(names(short)[short])))
  )
}
