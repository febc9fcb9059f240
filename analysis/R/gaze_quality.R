# How good the gaze was, how fast the display followed it and how well it was calibrated, one row per
# participant.
#
#   gaze_trial ───────> samples per second, share lost by reason
#   rated_trial ──────> source, sample to flip, trials over the limits
#   gaze_calibration ─> calibrations and tries, what the correction moved, what validation and drift
#                       checks left
#
# Latency of a trial: the 95th percentile from sample to flip over the steps before which the eye was
# not lost, as recorded; only trials whose detail depends on gaze have one. What blinks and other
# losses cost is told by the shares lost. 60 ms is good, above 70 warns, above 80 the trial is marked
# gaze_late (after Loschky and Wolverton 2007, who found 60 ms to go unnoticed).
#
# Accuracy is the mean distance from gaze to point in degrees: of a calibration before its correction
# is made, of a validation and a drift check after it. The correction is the affine map of screen
# metres that the session's last calibration gave; it takes what calibration found and leaves what
# validation finds.
# SPDX-License-Identifier: MIT

kGoodLatencyMs <- 60
kWarnLatencyMs <- 70

# What the page shows of the gaze of a protocol's trials that are analysed, where it was followed: words
# on its calibration and tables as part_results.R has them; NULL elsewhere.
gaze_shown <- function(path, protocol) {
  of <- function(view) analysed_rows(path, protocol, rows_of_view(path, view, protocol))
  trials <- of(shown_view(path))
  trials <- trials[trials$phase == "main", ]
  views <- query_study(path, "SELECT name FROM sqlite_master WHERE type = 'view'")$name
  if (all(is.na(trials$gaze_source)) || !"gaze_trial" %in% views) return(NULL)  # data of before
  gaze <- of("gaze_trial")
  study <- list(trials = trials, gaze = gaze[gaze$phase == "main", ],
    calibrations = rows_of_view(path, "gaze_calibration", protocol))
  calibration <- calibration_quality(study)
  list(words = calibration_sentences(calibration), tables = Filter(Negate(is.null), list(
    list(name = "gaze", title = "The gaze", rows = gaze_quality(study), heads = kGazeHeads),
    if (any(calibration$calibrations > 0)) list(name = "calibration",
      title = "Calibration of the gaze", rows = calibration, heads = kCalibrationHeads,
      note = paste("Accuracy: mean distance from gaze to point. Shift and stretch: of the correction that",
        "the last calibration made, at the screen's centre and the larger of the two axes'. Validation:",
        "the last one, after it.")))))
}

kGazeHeads <- c("Participant", "Source", "Trials", "Trials followed", "Samples", "Samples per second",
  "Share lost in blinks", "off screen", "lost", "Trials timed", "Sample to flip, p95, median trial (ms)",
  "largest (ms)", "Trials over 70 ms", "Trials marked late")
kCalibrationHeads <- c("Participant", "Calibrations", "Accuracy before correction (°)", "Shift (mm)",
  "Stretch", "Validation: accuracy (°)", "worst point (°)", "precision, RMS (°)", "Drift checks",
  "Largest drift (°)", "Not passed")

# `row(who, rows_of)` of each participant; rows_of(table) are those of that one.
for_each_participant <- function(study, row) {
  each_row(sort(unique(as.character(study$trials$participant))), function(who) {
    row(who, function(table) table[as.character(table$participant) == who, ])
  })
}

gaze_quality <- function(study) {
  for_each_participant(study, function(who, rows_of) {
    trials <- rows_of(study$trials)
    gaze <- rows_of(study$gaze)  # the samples counted by trial
    source <- unique(trials$gaze_source[!is.na(trials$gaze_source)])
    samples <- sum(gaze$samples)
    share <- function(count) if (samples > 0) sum(count) / samples else NA_real_
    latency_ms <- trials$gaze_latency_p95_ms[!is.na(trials$gaze_latency_p95_ms)]
    # n samples span n - 1 intervals.
    intervals <- sum(gaze$samples - 1)
    data.frame(participant = who,
      gaze_source = if (length(source) > 0) paste(sort(source), collapse = " and ") else "none",
      trials = nrow(trials), trials_followed = sum(!is.na(trials$gaze_source)), samples = samples,
      samples_per_s = if (intervals > 0) intervals / sum(gaze$span_s) else NA_real_,
      blink_share = share(gaze$blink), off_screen_share = share(gaze$off_screen),
      lost_share = share(gaze$lost), trials_timed = length(latency_ms),
      latency_median_ms = as.numeric(stats::median(latency_ms)),
      latency_largest_ms = largest_known(latency_ms),
      trials_over_70_ms = sum(latency_ms > kWarnLatencyMs), trials_late = sum(trials$gaze_late))
  })
}

largest_known <- function(x) if (all(is.na(x))) NA_real_ else max(x, na.rm = TRUE)

# What a reader must know of the gaze before believing a result.
gaze_sentences <- function(trials) {
  known <- trials$gaze_latency_p95_ms[!is.na(trials$gaze_latency_p95_ms)]
  if (all(is.na(trials$gaze_source))) return("The gaze was not followed.")
  if (length(known) == 0) {
    return(c(source_sentences(trials), "No latency from sample to flip is known."))
  }
  over <- sum(known > kWarnLatencyMs)
  late <- sum(trials$gaze_late)
  c(source_sentences(trials), sprintf(paste(
    "The 95th percentile from gaze sample to flip, while the eye was not lost, was %s ms by trial; it",
    "was at most %d ms, which is good, in %d of %s whose detail depended on gaze."),
    paste(unique(sprintf("%.0f", range(known))), collapse = " to "), kGoodLatencyMs,
    sum(known <= kGoodLatencyMs), count_of(length(known), "trial")),
    if (over == 0) "In no trial did the 95th percentile exceed 70 ms." else sprintf(paste(
    "The 95th percentile exceeds 70 ms in %s; %d of %s %s marked late (above 80 ms). Marked trials",
    "are in every analysis%s."), count_of(over, "trial"), late, count_of(nrow(trials), "trial"),
    if (late == 1) "is" else "are",
    if (late > 0 && participant_count(trials) > 1) "; the tables of sensitivity show the comparisons without them" else ""))
}

source_sentences <- function(trials) {
  vapply(sort(unique(trials$gaze_source), na.last = TRUE), function(source) {
    some <- trials[trials$gaze_source %in% source, ]
    where <- paste(count_of(nrow(some), "trial"), "of",
      count_of(participant_count(some), "participant"))
    if (is.na(source)) return(sprintf("Gaze was not followed in %s.", where))
    switch(source, mouse = sprintf(paste("GAZE FROM THE MOUSE in %s: the pointer stood in for the",
      "eye, and mouse data cannot support claims about gaze."), where),
      "simulated eye" = sprintf("Gaze from a simulated eye in %s: it describes a model of the eye.",
        where),
      sprintf("Gaze from %s in %s.", source, where))
  }, "", USE.NAMES = FALSE)
}

calibration_quality <- function(study) {
  for_each_participant(study, function(who, rows_of) {
    rows <- rows_of(study$calibrations)
    last <- function(x) if (length(x) > 0) x[length(x)] else NA_real_
    calibrations <- rows[rows$kind == "calibration", ]
    validations <- rows[rows$kind == "validation", ]
    drifts <- rows[rows$kind == "drift check", ]
    data.frame(participant = who, calibrations = nrow(calibrations),
      accuracy_before_deg = last(calibrations$accuracy_deg),
      shift_mm = last(1000 * sqrt(calibrations$correction_x0_m^2 + calibrations$correction_y0_m^2)),
      stretch = last(pmax(abs(calibrations$correction_xx - 1), abs(calibrations$correction_yy - 1))),
      validation_accuracy_deg = last(validations$accuracy_deg),
      validation_worst_deg = last(validations$worst_accuracy_deg),
      validation_precision_rms_deg = last(validations$precision_rms_deg),
      drift_checks = nrow(drifts), drift_largest_deg = largest_known(drifts$accuracy_deg),
      not_passed = sum(rows$passed == 0, na.rm = TRUE))
  })
}

# Nothing is said of a study without any calibration, as one with the mouse may be.
calibration_sentences <- function(table) {
  never <- table$participant[table$calibrations == 0]
  known <- table$validation_accuracy_deg[!is.na(table$validation_accuracy_deg)]
  if (all(table$calibrations == 0)) return("The gaze was never calibrated.")
  c(
    if (length(known) > 0) sprintf(
      "Accuracy of the gaze when last validated, after correction: mean %.2f°, worst participant %.2f°.",
      mean(known), max(known)),
    if (length(never) > 0) sprintf("Never calibrated: %s.", and_words(as_typed(never))),
    if (sum(table$not_passed) > 0) sprintf("%s over the protocol's limit, of %s.",
      paste(count_of(sum(table$not_passed), "calibration, validation or drift check"),
        if (sum(table$not_passed) == 1) "was" else "were"),
      and_words(as_typed(table$participant[table$not_passed > 0]))))
}
