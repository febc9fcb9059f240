# Clicks matched to events by a window of time: descriptive only. At more than one event a
# second this is biased (a true d' of 1.5 comes out as about .8): clicks go to neighbours, and the
# time without events grows short. click_regression.R is the analysis.
#
# Each click belongs to the latest collision that came 200 to 1200 ms before it, whatever its kind;
# to prefer bad ones would make the hits that it counts.
# SPDX-License-Identifier: MIT

kMatchingWindowsS <- list(c(0.2, 1.2), c(0.2, 1.0), c(0.2, 0.8), c(0.3, 1.2), c(0.3, 0.9),
  c(0.2, 1.5))

# For each click the number of its event, or NA. `window_s`: earliest and latest lag, both included.
# 1 ns more at either end: the clock's grain.
matched_event <- function(clicks_s, events_s, window_s) {
  order_of <- order(events_s)
  sorted <- events_s[order_of]
  at <- findInterval(clicks_s - window_s[1] + 1e-9, sorted)
  at[at == 0] <- NA
  at[which(clicks_s - sorted[at] > window_s[2] + 1e-9)] <- NA
  order_of[at]
}

# The time outside of every bad event's window: total seconds, and the clicks in it.
time_without_bad <- function(clicks_s, bad_s, window_s, exposure_s) {
  begin <- pmin(sort(bad_s) + window_s[1], exposure_s)
  end <- pmin(sort(bad_s) + window_s[2], exposure_s)
  starts <- c(0, cummax(end))
  free <- pmax(c(begin, exposure_s) - starts, 0)
  inside <- vapply(clicks_s, function(t) any(t >= begin & t <= end), NA)
  c(seconds = sum(free), clicks = sum(!inside))
}

# Counts of one trial, as a named vector.
matching_counts <- function(clicks_s, events_s, bad, window_s, exposure_s) {
  matched <- matched_event(clicks_s, events_s, window_s)
  without <- time_without_bad(clicks_s, events_s[bad], window_s, exposure_s)
  c(
    bad = sum(bad), hits = sum(unique(stats::na.omit(matched)) %in% which(bad)),
    clicks = length(clicks_s), at_good = sum(matched %in% which(!bad)),
    at_nothing = sum(is.na(matched)), exposure_s = exposure_s,
    free_s = without[["seconds"]], free_clicks = without[["clicks"]])
}

# One row for each window: rates over all participants' trials, and the participants' mean d' and
# criterion with log-linear correction. False alarms: clicks that belong to no bad event; for d',
# clicks in the time free of bad events, which is cut into windows of equal length.
matching_table <- function(trials, events, clicks) {
  each_row(kMatchingWindowsS, function(window_s) {
    counts <- vapply(seq_len(nrow(trials)), function(i) {
      mine <- events$row == i
      matching_counts(clicks$time_s[clicks$row == i], events$time_s[mine], events$bad[mine],
        window_s, trials$exposure_s[i])
    }, numeric(8))
    matching_row(t(counts), as.character(trials$participant), window_s)
  })
}

matching_row <- function(counts, participant, window_s) {
  length_s <- diff(window_s)
  each <- rowsum(counts, participant)
  signal <- t(apply(each, 1, function(n) {
    windows <- floor(n[["free_s"]] / length_s)
    log_linear_d_prime(n[["hits"]], n[["bad"]], min(n[["free_clicks"]], windows), windows)
  }))
  all <- colSums(counts)
  data.frame(from_ms = 1000 * window_s[1], to_ms = 1000 * window_s[2], participants = nrow(each),
    bad_events = all[["bad"]], hit_rate = all[["hits"]] / all[["bad"]],
    false_alarms_per_s = (all[["at_good"]] + all[["at_nothing"]]) / all[["exposure_s"]],
    clicks_at_good = all[["at_good"]], clicks_at_nothing = all[["at_nothing"]],
    free_windows = floor(all[["free_s"]] / length_s),
    false_alarms_per_free_window = all[["free_clicks"]] / (all[["free_s"]] / length_s),
    d_prime = mean(signal[, 1]), criterion = mean(signal[, 2]))
}

matching_words <- function(matching) {
  row <- matching[1, ]
  sprintf(paste("Descriptive only, for it is biased at more than one event a second: with each",
    "click matched to the latest event %.0f to %.0f ms before it, of whatever kind, %s of bad events",
    "(collisions of one sort, merged, so that d′ is not of one collision) were hit, with %.3f false",
    "alarms per second; d′ = %.2f, criterion %.2f (log-linear)."),
    row$from_ms, row$to_ms, if (is.nan(row$hit_rate)) "none" else
      sprintf("%.0f %%", 100 * row$hit_rate), row$false_alarms_per_s, row$d_prime, row$criterion)
}
