# A gaze-contingent study (studies.R) from its views to figures, tables and words.
#
#   rated_trial, trial_level ─> trials     seen_collision ─> collisions
#   click_trial ──────────────> + clicks   gaze_sample ─> gaze (gaze_quality.R)
#   trial_click ──> clicks (click_detection.R)    gaze_calibration ─> calibrations
#
#   trials ─┬─> ratings, clicks: tests ─> <protocol>.csv, .md
#           ├─> means ─────────────────> -ratings.png, -clicks.png, and .pdf
#           ├─> click_table ───────────> -clicks.csv
#           ├─> click_detection ───────> -kernels.png, .pdf, .csv, -gains.csv, -matching.csv
#           ├─> exposure_table ────────> -exposure.csv
#           ├─> gaze_quality ──────────> -gaze.csv
#           └─> calibration_quality ───> -calibration.csv
#
# Invariant: every row of collisions, clicks and gaze belongs to a row of trials, by `row`, so what is
# left out of the trials is left out everywhere.
# SPDX-License-Identifier: MIT

# Adds to a rating study what only this one has. The trials' kinds have the order of the study's. The
# two factors become the columns scheduling and bodies, whatever unit their names carry.
open_gaze_study <- function(study, paths) {
  study <- open_rating_study(study, paths)
  study$trials[names(study$factors)] <- study$trials[study$factors]
  study$factors <- stats::setNames(nm = names(study$factors))
  study <- with_clicks(with_kinds_in_order(study))
  study <- with_events(with_click_times(with_collisions(study)))
  # The samples of each stimulus counted.
  study$gaze <- rows_of_trials(study, paste(
    "SELECT trial, count(*) AS samples, sum(loss IS 'blink') AS blink,",
    "sum(loss IS 'off screen') AS off_screen, sum(loss IS 'lost') AS lost,",
    "CAST(max(time_s) - min(time_s) AS REAL) AS span_s FROM gaze_sample"), each_stimulus)
  # Every calibration, validation and drift check of the participants who have a trial here.
  rows <- each_row(unique(study$trials$path), query_study,
    "SELECT * FROM gaze_calibration WHERE protocol = ? ORDER BY calibration", study$protocol)
  study$calibrations <- rows[rows$participant %in% as.character(study$trials$participant), ]
  study
}

# Groups samples by stimulus; by trial in a file of before schema 13, which does not tell two apart.
each_stimulus <- function(path) {
  fields <- query_study(path, "SELECT name FROM pragma_table_info('gaze_sample')")$name
  if ("interval" %in% fields) "GROUP BY trial, interval" else "GROUP BY trial"
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

# Adds clicks, exposure_s and merge_within_ms to the trials, of both stimuli where a trial has two.
# exposure_s is NA where no frame was recorded; merge_within_ms where the protocol names none.
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
        and_words(as_typed(names(short)[short]))))
}

kWithoutLate <- ", without trials marked late"

report_gaze_study <- function(study) {
  each <- exposure_by_participant(study)
  tables <- list(clicks = click_table(study$trials), exposure = exposure_table(each),
    gaze = gaze_quality(study), calibration = calibration_quality(study))
  detection <- click_detection(study)
  tables <- c(tables, Filter(Negate(is.null), detection[c("gains", "kernels", "matching")]))
  tests <- gaze_study_tests(study, each, detection$tests)
  data <- c(study_sentences(study), design_sentence(study$trials, study$kinds),
    gaze_sentences(study$trials), calibration_sentences(tables$calibration),
    exposure_sentences(study))
  of_pairs <- function(words) lapply(study$pairs, function(pair) words(tests, pair))
  clicks <- paragraphs(c(list(click_rate_words(study$trials)), of_pairs(click_contrast_words),
    list(detection$words, factor_words(tests, "scheduling", "clicks"),
      c(factor_words(tests, "bodies", "clicks"), interaction_words(tests, "clicks")))))
  exposure <- paragraphs(of_pairs(exposure_words))

  say_progress("drawing the figures ...")
  shows_kernels <- !is.null(detection$kernels)
  figures <- c(write_scheduling_figures(study), if (shows_kernels)
    write_figure(function() kernel_figure(detection, study$all_simulated),
      output_path(study, "-kernels")))
  write_outputs(study, tests, rating_paragraphs(study, tests), data, c(scheduling_captions(study),
    if (shows_kernels) c("", kernel_caption(detection, study$all_simulated))),
    gaze_sections(clicks, exposure, tables), figures, tables, c("", clicks, "", exposure))
}

# Every test of the study, with Holm's correction within each family.
gaze_study_tests <- function(study, each, detection = outcome()) {
  trials <- study$trials
  contrasts <- function(trials, pair, without = "") {
    all_outcomes(contrast_model_tests(trials, without, pair),
      contrast_model_tests(trials, without, pair, "clicks"))
  }
  say_progress("fitting the mixed models of ratings and clicks ...")
  on_time <- trials[trials$gaze_late == 0, ]
  sensitivity <- if (nrow(on_time) < nrow(trials)) {
    contrasts(on_time, planned_pair(study), kWithoutLate)
  }
  combine_outcomes(rating_tests(trials, "scheduling", "bodies", interactions = TRUE, margin = NULL),
    for_each_pair(study, function(pair) contrasts(trials, pair)),
    for_each_pair(study, function(pair) {
      contrast_means_tests(trials, equivalence_margin(study$scale), pair)
    }),
    click_model_tests(trials), for_each_pair(study, function(pair) click_bootstrap(trials, pair)),
    if (study$thesis) thesis_tests(trials), detection,
    for_each_pair(study, function(pair) exposure_tests(each, pair)), sensitivity)
}

# The thesis's own test, tracked against random at each number of bodies, of ratings and of clicks.
thesis_tests <- function(trials) {
  two <- contrast_trials(trials)
  if (nlevels(droplevels(two$scheduling)) < 2 || participant_count(two) < 2) return(outcome())
  all_outcomes(pooled_tests(two, "scheduling", by = "bodies"),
    pooled_tests(two, "scheduling", by = "bodies", of = "clicks", family = kClickPooledFamily))
}

# Paragraphs of sentences: the planned contrast first, for it is the study's question.
rating_paragraphs <- function(study, tests) {
  paragraphs(c(
    list(c(scale_words(study$scale), means_words(study$trials, "scheduling"))),
    lapply(study$pairs, function(pair) rating_contrast_words(tests, study$scale, pair)),
    list(sensitivity_words(tests, sum(study$trials$gaze_late), kWithoutLate, planned_pair(study)),
      c(factor_words(tests, "scheduling", scale = study$scale), model_words(tests, "bodies"),
        interaction_words(tests), anova_words(tests, "scheduling"),
        anova_interaction_words(tests), friedman_words(tests, "scheduling")))))
}

# Each one's sentences as one line, empty lines between them; what says nothing is left out.
paragraphs <- function(sentences) {
  lines <- vapply(Filter(length, sentences), paste, "", collapse = " ")
  utils::head(as.vector(rbind(lines, rep("", length(lines)))), -1)
}

gaze_sections <- function(clicks, exposure, tables) {
  c(
    "## Clicks", "", clicks, "", click_lines(tables$clicks), "",
    paste("Intervals: bootstrap over participants. Bad events: bad collisions, merged; the number",
      "of them is what there was to click at."), "",
    if (!is.null(tables$matching)) c("Clicks matched to collisions by windows, descriptive only:",
      "", matching_lines(tables$matching), "", paste("Event-free: free of bad events; windows of the",
      "same length as the one in the first column. d′ and criterion: means over participants."), ""),
    "## What was shown", "", exposure, "", exposure_lines(tables$exposure), "",
    paste("Each number was taken within each participant and then averaged over participants.",
      "Bad: resolved at the bounding sphere."), "",
    "## The gaze", "", gaze_quality_lines(tables$gaze), "", calibration_section(tables$calibration))
}

click_lines <- function(table) {
  table$interval <- ifelse(is.na(table$interval_low), NA,
    sprintf("%.3f to %.3f", table$interval_low, table$interval_high))
  table_as_markdown(table, c(scheduling = "%s", bodies = "%s", trials = "%d", clicks = "%.0f",
    clicks_per_trial = "%.2f", clicks_per_s = "%.3f", interval = "%s",
    bad_events_per_trial = "%.1f", clicks_per_bad_event = "%.2f"),
    c("scheduling", "bodies", "trials", "clicks in all", "clicks per trial", "clicks per second",
      "95 % CI", "bad events per trial", "clicks per bad event"))
}
