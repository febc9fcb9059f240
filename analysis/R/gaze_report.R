# A gaze-contingent study from its trials to figures, tables and words.
#
#   trials ─┬─> ratings, clicks: tests ─> <protocol>.csv, .md
#           ├─> means ─────────────────> -ratings.png, -clicks.png, and .pdf
#           ├─> click_table ───────────> -clicks.csv
#           ├─> click_detection ───────> -kernels.png, .pdf, .csv, -gains.csv, -matching.csv
#           ├─> exposure_table ────────> -exposure.csv
#           ├─> gaze_quality ──────────> -gaze.csv
#           └─> calibration_quality ───> -calibration.csv
# SPDX-License-Identifier: MIT

kWithoutLate <- ", without trials marked late"

report_gaze_study <- function(study) {
  each <- exposure_by_participant(study)
  tables <- list(clicks = click_table(study$trials), exposure = exposure_table(each),
    gaze = gaze_quality(study), calibration = calibration_quality(study))
  detection <- click_detection(study)
  tables <- c(tables, Filter(Negate(is.null), detection[c("gains", "kernels", "matching")]))
  tests <- gaze_study_tests(study, each, detection$tests)
  data <- c(study_sentences(study), design_sentence(study$trials, study$kinds),
    gaze_sentences(study, tables$gaze), calibration_sentences(tables$calibration),
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
      path_of(study, "-kernels")))
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
  combine_outcomes(
    scheduling_tests(trials),
    for_each_pair(study, function(pair) contrasts(trials, pair)),
    for_each_pair(study, function(pair) {
      contrast_means_tests(trials, equivalence_margin(study$scale), pair)
    }),
    click_model_tests(trials), for_each_pair(study, function(pair) click_bootstrap(trials, pair)),
    if (study$thesis) thesis_tests(trials), detection,
    for_each_pair(study, function(pair) exposure_tests(each, pair)), sensitivity
  )
}

# Tests of ratings over all kinds: mixed model, ANOVA, Friedman.
scheduling_tests <- function(trials) {
  none <- why_no_test(trials)
  if (!is.null(none)) return(outcome(remarks = none))
  factors <- varying_factors(trials, c("scheduling", "bodies"))
  constant <- constant_remarks(setdiff(c("scheduling", "bodies"), factors))
  if (length(factors) == 0) return(constant)
  all_outcomes(constant,
    factor_tests(trials, factors, interactions = if (length(factors) == 2) "scheduling:bodies"),
    repeated_measures_tests(trials, factors), friedman_tests(trials, factors))
}

# The thesis's own test, tracked against random at each number of bodies, of ratings and of clicks.
thesis_tests <- function(trials) {
  two <- contrast_trials(trials)
  if (nlevels(droplevels(two$scheduling)) < 2 || participant_count(two) < 2) return(outcome())
  all_outcomes(
    pooled_tests(two, "scheduling", by = "bodies"),
    pooled_tests(two, "scheduling", by = "bodies", of = "clicks", family = kClickPooledFamily)
  )
}

# Paragraphs of sentences: the planned contrast first, for it is the study's question.
rating_paragraphs <- function(study, tests) {
  paragraphs(c(
    list(c(scale_words(study$scale), means_words(study$trials, "scheduling"))),
    lapply(study$pairs, function(pair) rating_contrast_words(tests, study$scale, pair)),
    list(sensitivity_words(tests, sum(study$trials$gaze_late), kWithoutLate, planned_pair(study)),
      c(factor_words(tests, "scheduling", scale = study$scale), model_words(tests, "bodies"),
        interaction_words(tests), anova_words(tests, "scheduling"),
        anova_interaction_words(tests), friedman_words(tests, "scheduling")))
  ))
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
    "## The gaze", "", gaze_quality_lines(tables$gaze), "", calibration_section(tables$calibration)
  )
}

click_lines <- function(table) {
  table$interval <- ifelse(is.na(table$interval_low), NA,
    sprintf("%.3f to %.3f", table$interval_low, table$interval_high))
  markdown_of(table, c(scheduling = "%s", bodies = "%s", trials = "%d", clicks = "%.0f",
    clicks_per_trial = "%.2f", clicks_per_s = "%.3f", interval = "%s",
    bad_events_per_trial = "%.1f", clicks_per_bad_event = "%.2f"),
    c("scheduling", "bodies", "trials", "clicks in all", "clicks per trial", "clicks per second",
      "95 % CI", "bad events per trial", "clicks per bad event"))
}
