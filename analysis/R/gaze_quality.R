# How good the gaze was and how fast the display followed it, one row per participant.
#
#   gaze_sample ─> samples per second, share lost by reason
#   rated_trial ─> source, sample to flip, trials over the limits
#
# Latency of a trial: the 95th percentile from sample to flip over the steps before which the eye was
# not lost, as recorded; only trials whose detail depends on gaze have one. What blinks and other
# losses cost is told by the shares lost. 60 ms is good, above 70 warns, above 80 the trial is marked
# gaze_late (after Loschky and Wolverton 2007, who found 60 ms to go unnoticed).
# SPDX-License-Identifier: MIT

kGoodLatencyMs <- 60
kWarnLatencyMs <- 70

gaze_quality <- function(study) {
  each_row(sort(unique(as.character(study$trials$participant))), function(who) {
    of <- function(rows) rows[as.character(rows$participant) == who, ]
    gaze_quality_of(of(study$trials), of(study$gaze))
  })
}

# One participant: the trials, the samples counted by trial.
gaze_quality_of <- function(trials, gaze) {
  source <- unique(trials$gaze_source[!is.na(trials$gaze_source)])
  samples <- sum(gaze$samples)
  share <- function(count) if (samples > 0) sum(count) / samples else NA_real_
  latency_ms <- trials$gaze_latency_p95_ms[!is.na(trials$gaze_latency_p95_ms)]
  # n samples span n - 1 intervals.
  intervals <- sum(gaze$samples - 1)
  data.frame(
    participant = as.character(trials$participant[1]),
    gaze_source = if (length(source) > 0) paste(sort(source), collapse = " and ") else "none",
    trials = nrow(trials), trials_followed = sum(!is.na(trials$gaze_source)), samples = samples,
    samples_per_s = if (intervals > 0) intervals / sum(gaze$span_s) else NA_real_,
    blink_share = share(gaze$blink), off_screen_share = share(gaze$off_screen),
    lost_share = share(gaze$lost), trials_timed = length(latency_ms),
    latency_median_ms = if (length(latency_ms) > 0) stats::median(latency_ms) else NA_real_,
    latency_largest_ms = if (length(latency_ms) > 0) max(latency_ms) else NA_real_,
    trials_over_70_ms = sum(latency_ms > kWarnLatencyMs),
    trials_late = sum(trials$gaze_late)
  )
}

# What a reader must know of the gaze before believing a result.
gaze_sentences <- function(study, quality) {
  trials <- study$trials
  c(source_sentences(trials), latency_sentence(trials), late_gaze_sentence(trials, quality))
}

source_sentences <- function(trials) {
  of <- function(source) trials[trials$gaze_source %in% source, ]
  where <- function(some) {
    sprintf("%s of %s", count_of(nrow(some), "trial"),
      count_of(participant_count(some), "participant"))
  }
  mouse <- of("mouse")
  eye <- of("simulated eye")
  none <- of(NA)
  c(
    if (nrow(mouse) > 0) sprintf(paste(
      "GAZE FROM THE MOUSE in %s: the pointer stood in for the eye, and mouse data cannot support",
      "claims about gaze."), where(mouse)),
    if (nrow(eye) > 0) sprintf("Gaze from a simulated eye in %s: it describes a model of the eye.",
      where(eye)),
    if (nrow(none) > 0) sprintf("Gaze was not followed in %s.", where(none))
  )
}

latency_sentence <- function(trials) {
  known <- trials$gaze_latency_p95_ms[!is.na(trials$gaze_latency_p95_ms)]
  if (length(known) == 0) return("No latency from sample to flip is known.")
  sprintf(paste(
    "The 95th percentile from gaze sample to flip, while the eye was not lost, was %s ms by trial; it",
    "was at most %d ms, which is good, in %d of %s whose detail depended on gaze."
  ), paste(unique(sprintf("%.0f", range(known))), collapse = " to "), kGoodLatencyMs,
  sum(known <= kGoodLatencyMs), count_of(length(known), "trial"))
}

late_gaze_sentence <- function(trials, quality) {
  over <- sum(quality$trials_over_70_ms)
  late <- sum(quality$trials_late)
  if (all(is.na(trials$gaze_latency_p95_ms))) return(character())
  if (over == 0) return("In no trial did the 95th percentile exceed 70 ms.")
  sprintf(paste(
    "The 95th percentile exceeds 70 ms in %s; %d of %s %s marked late (above 80 ms). Marked trials are",
    "in every analysis%s."
  ), count_of(over, "trial"), late, count_of(nrow(trials), "trial"),
  if (late == 1) "is" else "are",
  if (late > 0) "; the planned contrast is given without them too" else "")
}

gaze_quality_lines <- function(quality) {
  quality$participant <- as_typed(quality$participant)
  quality$followed <- sprintf("%d of %d", quality$trials_followed, quality$trials)
  shares <- c("blink_share", "off_screen_share", "lost_share")
  quality[shares] <- 100 * quality[shares]
  markdown_of(quality, c(participant = "%s", gaze_source = "%s", followed = "%s",
    samples_per_s = "%.0f", blink_share = "%.1f", off_screen_share = "%.1f", lost_share = "%.1f",
    trials_timed = "%d", latency_median_ms = "%.1f", latency_largest_ms = "%.1f",
    trials_over_70_ms = "%d", trials_late = "%d"),
    c("participant", "gaze source", "trials followed", "samples per second", "blink (%)",
      "off screen (%)", "lost (%)", "trials timed", "sample to flip, p95, median trial (ms)",
      "largest (ms)", "trials > 70 ms", "trials marked late"))
}
