# Kinds of scheduling compared with each other: a part of the report of a study that is described so
# (studies.R). Each response alone is a part of its own, as in any study.
#
#   rated_trial, trial_level ─> trials         seen_collision ─> collisions, events
#   click_trial ──────────────> + clicks
#
#   trials ─┬─> pairs of kinds: ratings and clicks (planned_contrast.R), exposure (exposure.R)
#           ├─> click_table, exposure_table
#           └─> figures: each participant's differences (scheduling_figure.R)
#
# Invariant: every row of collisions belongs to a row of trials, by `row`, so what is left out of the
# trials is left out everywhere.
# SPDX-License-Identifier: MIT

kWithoutLate <- ", without trials marked late"

# The trials' kinds have the order of the study's. Its two factors become the columns scheduling and
# bodies, whatever unit their names carry.
scheduling_part <- function(path, study) {
  part <- rating_part(path, study$protocol)
  part$response <- "scheduling"
  part$pairs <- study$pairs
  part$thesis <- study$thesis
  design <- list(factors = c(part$factors, part$constant))
  for (name in study$factors) {
    column <- factor_called(design, name)
    if (is.null(column)) {
      refuse(part$file, ": expected one factor '", name, "' or '", name, "_<unit>', got ",
        paste(design$factors, collapse = ", "))
    }
    part$trials[[name]] <- part$trials[[column]]
  }
  part <- with_collisions(with_clicks(with_kinds_in_order(part, study$kinds)))
  with_events(part)
}

with_kinds_in_order <- function(part, kinds) {
  present <- levels(part$trials$scheduling)
  unknown <- setdiff(present, kinds)
  if (length(unknown) > 0) {
    refuse(part$file, ": expected scheduling to be one of ", paste(kinds, collapse = ", "),
      ", got ", paste(unknown, collapse = ", "))
  }
  part$trials$scheduling <- factor(as.character(part$trials$scheduling), intersect(kinds, present))
  part
}

# Adds clicks, exposure_s and merge_within_ms to the trials, of both stimuli where a trial has two.
# exposure_s is NA where no frame was recorded; merge_within_ms where the protocol names none.
with_clicks <- function(study) {
  rows <- rows_of_trials(study, paste(
    "SELECT trial, clicks, CAST(exposure_s AS REAL) AS exposure_s,",
    "CAST(merge_within_ms AS REAL) AS merge_within_ms FROM click_trial"))
  columns <- c("clicks", "exposure_s", "merge_within_ms")
  study$trials[columns] <- rows[match(seq_len(nrow(study$trials)), rows$row), columns]
  if (anyNA(study$trials$clicks)) {
    refuse(study$file, ": expected a protocol that asks for clicks, got '",
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

# What the page shows of the pairs (part_results.R): the planned one first, for it is the question.
scheduling_results <- function(part) {
  each <- exposure_by_participant(part)
  clicks <- click_table(part$trials)
  tests <- scheduling_tests(part, each)
  of_pairs <- function(words) lapply(part$pairs, function(pair) words(pair))
  list(part = part, tests = tests, figures = contrast_figures(part),
    paragraphs = lapply(c(
      of_pairs(function(pair) rating_contrast_words(tests, part$scale, pair)),
      list(sensitivity_words(tests, sum(part$trials$gaze_late), kWithoutLate, planned_pair(part)),
        click_rate_words(part$trials)),
      of_pairs(function(pair) click_contrast_words(tests, pair)),
      of_pairs(function(pair) exposure_words(tests, pair))), with_minus_signs),
    tables = Filter(Negate(is.null), list(
      if (!is.null(clicks)) list(name = "clicks", title = "Clicks by kind", rows = clicks,
        heads = c("Scheduling", "Bodies", "Participants", "Trials", "Clicks in all", "Per trial",
          "Time (s)", "Clicks per second", "95 % CI, from", "to", "Bad events per trial",
          "Clicks per bad event"),
        note = paste0(if (any(!is.na(clicks$interval_low)))
          "Intervals: bootstrap over participants. ", "Bad events: bad collisions, merged; the number",
          " of them is what there was to click at.")),
      list(name = "exposure", title = "What was shown, by kind", rows = exposure_table(each),
        heads = c("Scheduling", "Bodies", "Participants", "Trials",
          sentence_case(unname(kExposureMeasures))),
        note = paste(c("Each number was taken within each participant and then averaged over",
          "participants. Bad: resolved at the bounding sphere.", exposure_sentences(part)),
          collapse = " ")))))
}

# Every test of the pairs, with Holm's correction within each family.
scheduling_tests <- function(part, each) {
  trials <- part$trials
  contrasts <- function(trials, pair, without = "") {
    all_outcomes(contrast_model_tests(trials, without, pair),
      contrast_model_tests(trials, without, pair, "clicks"))
  }
  say_progress(kContrastStep)
  on_time <- trials[trials$gaze_late == 0, ]
  sensitivity <- if (nrow(on_time) < nrow(trials)) {
    contrasts(on_time, planned_pair(part), kWithoutLate)
  }
  combine_outcomes(for_each_pair(part, function(pair) contrasts(trials, pair)),
    for_each_pair(part, function(pair) {
      contrast_means_tests(trials, equivalence_margin(part$scale), pair)
    }),
    for_each_pair(part, function(pair) click_bootstrap(trials, pair)),
    if (part$thesis) thesis_tests(trials),
    for_each_pair(part, function(pair) exposure_tests(each, pair)), sensitivity)
}

# The thesis's own test, tracked against random at each number of bodies, of ratings and of clicks.
thesis_tests <- function(trials) {
  two <- contrast_trials(trials)
  if (nlevels(droplevels(two$scheduling)) < 2 || participant_count(two) < 2) return(outcome())
  by <- varying_factors(two, "bodies")
  all_outcomes(pooled_tests(two, "scheduling", by),
    pooled_tests(two, "scheduling", by, "clicks", kClickPooledFamily))
}
