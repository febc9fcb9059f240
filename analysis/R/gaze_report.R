# A gaze-contingent study from its trials to figures, tables and words.
#
#   trials ─┬─> scheduling_tests, click tests ─> <protocol>.csv, .md
#           ├─> means ─────────────────────────> -ratings.png, -clicks.png, and .pdf
#           ├─> click_table ───────────────────> -clicks.csv
#           ├─> click_detection ───────────────> -kernels.png, .pdf, .csv, -gains.csv, -matching.csv
#           ├─> exposure_table ────────────────> -exposure.csv
#           ├─> gaze_quality ──────────────────> -gaze.csv
#           └─> calibration_quality ───────────> -calibration.csv
# SPDX-License-Identifier: MIT

kWithoutLate <- ", without trials marked late"

report_gaze_study <- function(study) {
  study <- with_events(study)
  each <- exposure_by_participant(study)
  tables <- list(clicks = click_table(study$trials), exposure = exposure_table(each),
    gaze = gaze_quality(study), calibration = calibration_quality(study))
  detection <- click_detection(study)
  tables <- c(tables, Filter(Negate(is.null), detection[c("gains", "kernels", "matching")]))
  tests <- gaze_study_tests(study, each, detection$tests)
  data <- c(study_sentences(study), design_sentence(study$trials, study$kinds),
    gaze_sentences(study, tables$gaze), calibration_sentences(tables$calibration), exposure_sentences(study))
  results <- rating_paragraphs(study, tests)
  of_pairs <- function(words) lapply(study$pairs, function(pair) words(tests, pair))
  clicks <- do.call(paragraphs, c(list(click_rate_words(study$trials)),
    of_pairs(click_contrast_words), list(detection$words, click_model_words(tests))))
  exposure <- do.call(paragraphs, of_pairs(exposure_words))

  say_progress("drawing the figures ...")
  path <- function(ending) file.path(study$out, paste0(study$protocol, ending))
  files <- c(write_scheduling_figures(study, path), if (!is.null(detection$kernels))
    write_kernel_figure(detection, study$all_simulated, path("-kernels")))
  write_test_table(tests, path(".csv"))
  for (name in names(tables)) write_table(tables[[name]], path(paste0("-", name, ".csv")))
  write_report(path(".md"), study$title, results, data,
    tests$remarks, c(scheduling_captions(study),
    if (!is.null(detection$kernels)) c("", kernel_caption(detection, study$all_simulated))),
    gaze_sections(clicks, exposure, tables), left_out_section(study))
  say(c(files, path(".csv"), path(paste0("-", names(tables), ".csv")), path(".md"), "",
    paste(data, collapse = " "), "", results, "", clicks, "", exposure, tests$remarks))
}

# Every test of the study, with Holm's correction within each family.
gaze_study_tests <- function(study, each, detection = outcome()) {
  trials <- study$trials
  contrasts <- function(trials, pair, without = "") {
    all_outcomes(contrast_model_tests(trials, without, pair),
      click_contrast_tests(trials, without, pair))
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
    rating_factor_tests(trials, factors,
      interactions = if (length(factors) == 2) "scheduling:bodies"),
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
  do.call(paragraphs, c(
    list(c(scale_words(study$scale), means_words(study$trials, "scheduling"))),
    lapply(study$pairs, function(pair) rating_contrast_words(tests, study$scale, pair)),
    list(sensitivity_words(tests, sum(study$trials$gaze_late), kWithoutLate, planned_pair(study)),
    c(model_words(tests, "scheduling"), odds_words(tests, "scheduling", study$scale),
      other_factor_words(tests, "bodies"), interaction_words(tests),
      anova_words(tests, "scheduling"), friedman_words(tests, "scheduling")))
  ))
}

# Each argument's sentences as one line, empty lines between them; what says nothing is left out.
paragraphs <- function(...) {
  lines <- vapply(Filter(length, list(...)), paste, "", collapse = " ")
  utils::head(as.vector(rbind(lines, rep("", length(lines)))), -1)
}

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

# What is not known of the exposure, and how to fill it in.
exposure_sentences <- function(study) {
  collisions <- study$collisions
  bad <- collisions[collisions$bad, ]
  unmeasured <- bad[is.na(bad$visible_gap_arcmin), ]
  unseen <- sum(is.na(study$trials$exposure_s))
  c(
    if (nrow(unmeasured) > 0) sprintf("The gap was not measured in %s of %s. %s",
      format(nrow(unmeasured), big.mark = ","), count_of(nrow(bad), "bad collision"),
      fill_in_words(study$trials[unique(unmeasured$row), ], "to have it")),
    if (all(is.na(study$trials$merge_within_ms)))
      "The protocol names no merge_within_ms, so every collision is an event of its own.",
    if (unseen > 0) sprintf("No frame was recorded of %s, left out of the rates of clicks.",
      count_of(unseen, "trial"))
  )
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

or_dash <- function(x, format) ifelse(is.na(x), "–", sprintf(format, x))

click_lines <- function(table) {
  markdown_table(
    c("scheduling", "bodies", "trials", "clicks in all", "clicks per trial", "clicks per second",
      "95 % CI", "bad events per trial", "clicks per bad event"),
    sprintf("%s | %s | %d | %d | %.2f | %.3f | %s | %s | %s", table$scheduling, table$bodies,
      table$trials, as.integer(table$clicks), table$clicks_per_trial, table$clicks_per_s,
      ifelse(is.na(table$interval_low), "–",
        sprintf("%.3f to %.3f", table$interval_low, table$interval_high)),
      or_dash(table$bad_events_per_trial, "%.1f"), or_dash(table$clicks_per_bad_event, "%.2f"))
  )
}

exposure_lines <- function(table) {
  cells <- lapply(names(kExposureMeasures), function(measure) {
    or_dash(table[[measure]], if (endsWith(measure, "share")) "%.3f" else "%.1f")
  })
  rows <- do.call(paste, c(list(table$scheduling, table$bodies, table$trials), cells, sep = " | "))
  markdown_table(c("scheduling", "bodies", "trials", kExposureMeasures), rows)
}

write_scheduling_figures <- function(study, path) {
  trials <- study$trials
  draw <- function(of, axes, margin) {
    write_scheduling_figure(trials, of, axes, margin, study$all_simulated,
      path(if (of == "rating") "-ratings" else "-clicks"), study$pairs)
  }
  c(
    draw("rating", rating_axes(study$scale), equivalence_margin(study$scale)),
    draw("clicks", click_axes(), NULL)
  )
}

scheduling_captions <- function(study) {
  cells <- participant_means(study$trials, c("scheduling", "bodies"))
  shown <- nrow(complete_participants(cells))
  people <- count_of(max(shown, 1), who_words(study$all_simulated))
  bars <- "bars: within-participant 95 % confidence intervals (Cousineau–Morey)"
  faint <- paste0("faint points: ", who_words(study$all_simulated), "s")
  pairs <- Filter(function(pair) has_contrast(study$trials, pair), study$pairs)
  beside <- if (length(pairs) > 0) {
    panels <- paste0(letters[seq_along(pairs) + 1], ": ", vapply(pairs, pair_words, ""))
    paste0(" ", paste(panels, collapse = ", "), " of each; black, the mean and its 95 % t interval")
  }
  caption <- function(what, more) {
    paste0("a: mean ", what, " by kind of scheduling, ", people, "; ", if (shown > 1)
      paste0(bars, "; "), faint, ".", if (!is.null(beside)) paste0(beside, more, "."))
  }
  c(
    paste(if (study$thesis) "Ratings (thesis fig. 6.18)." else "Ratings.", caption("rating",
      sprintf("; grey band, the equivalence margin of ±%.2f points",
        equivalence_margin(study$scale)))), "",
    paste(if (study$thesis) "Clicks (thesis fig. 6.19)." else "Clicks.", caption("number of clicks per trial", ""))
  )
}
