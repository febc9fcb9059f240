# What participants clicked at, from the study's trials to tests, tables and words.
#
#   collisions ─> events ─┐
#   clicks ───────────────┼─> one record per participant ─> gains, kernels (click_regression.R)
#   trials with exposure ─┘                             └─> circular shift
#                         └─> matching_table (click_matching.R), descriptive
# SPDX-License-Identifier: MIT

kSensitivityFamily <- "click regression, gain of bad − good events (primary)"
kGainTFamily <- "click regression, participants' gains"
kTrackedGainFamily <- "click regression, tracked − random"
kGainWords <- c(bad = "gain of bad events", good = "gain of good events",
  difference = "gain of bad − good events", baseline = "baseline, clicks per second")

# Adds study$clicks: the time of each click, by the row of its trial.
with_click_times <- function(study) {
  study$clicks <- rows_of_trials(study,
    "SELECT trial, CAST(time_s AS REAL) AS time_s FROM trial_click")
  study
}

# Collisions of one sort in a trial that follow each other within merge_within_ms, as one event at
# the time of the first: row, time_s, bad. `study` has trials and collisions.
click_events <- function(study) {
  known <- study$collisions[!is.na(study$collisions$time_s), ]
  known <- known[order(known$row, known$bad, known$time_s), c("row", "time_s", "bad")]
  within_s <- study$trials$merge_within_ms[known$row] / 1000
  within_s[is.na(within_s)] <- 0
  same <- c(FALSE, diff(known$row) == 0 & diff(known$bad) == 0)
  follows <- same & c(FALSE, diff(known$time_s) < within_s[-1] - 1e-9)
  known[!follows, ]
}

# list(tests, gains, kernels, matching, words): everything about what was clicked at. `gains`: one
# row per participant and sort of trials ("all", and each kind of the study's pairs).
click_detection <- function(study) {
  usable <- which(!is.na(study$trials$exposure_s) & study$trials$exposure_s > 2 * kClickBinS)
  reason <- why_no_click_regression(study, usable)
  if (!is.null(reason)) return(list(tests = outcome(remarks = reason), words = reason))
  say_progress(kClickRegressionStep)
  events <- click_events(study)
  records <- participants_records(study, events, usable, "all")
  fits <- Filter(Negate(is.null), lapply(records, click_gains))
  left_out <- setdiff(names(records), names(fits))
  kinds <- unique(unlist(lapply(study$pairs, function(pair) c(pair$of, pair$against))))
  gains <- rbind(gains_table(fits, "all"), each_row(kinds, function(kind) {
    gains_table(lapply(participants_records(study, events, usable, kind), click_gains), kind)
  }))
  matching <- matching_table(study$trials[usable, ], renumbered(events, usable),
    renumbered(study$clicks, usable))
  tests <- all_outcomes(detection_tests(fits, records[names(fits)], gains, left_out,
    length(usable)), if (length(fits) > 1) for_each_pair(study, function(pair) {
      pair_gain_tests(gains, pair)
    }))
  list(tests = tests, gains = gains, kernels = kernel_table(fits), matching = matching,
    words = with_minus_signs(c(detection_words(combine_outcomes(tests), gains, study$pairs),
      matching_words(matching))))
}

why_no_click_regression <- function(study, usable) {
  if (length(usable) == 0) {
    return("No trial's exposure is known, so clicks are not regressed on events.")
  }
  if (nrow(study$clicks) == 0) {
    return("Nobody clicked, so there is nothing to regress on events: every gain is 0.")
  }
  if (any(!is.na(study$collisions$time_s))) return(NULL)
  "No collision has a time, so clicks are not regressed on events."
}

# Rows of `part` whose trial is among `chosen`, numbered by their place there.
renumbered <- function(part, chosen) {
  part$row <- match(part$row, chosen)
  part[!is.na(part$row), ]
}

# A record for each participant, of trials of one kind of scheduling or of "all".
participants_records <- function(study, events, usable, kind) {
  kinds <- as.character(study$trials$scheduling)
  mine <- usable[kind == "all" | kinds[usable] == kind]
  lapply(split(mine, as.character(study$trials$participant[mine])), function(rows) {
    trials <- data.frame(kind = kinds[rows], exposure_s = study$trials$exposure_s[rows])
    click_record(trials, renumbered(events, rows), renumbered(study$clicks, rows))
  })
}

gains_table <- function(fits, kind) {
  fits <- Filter(Negate(is.null), fits)
  if (length(fits) == 0) return(NULL)
  errors <- each_row(fits, `[[`, "errors")
  colnames(errors) <- paste0(colnames(errors), "_error")
  data.frame(participant = names(fits), scheduling = kind, each_row(fits, `[[`, "gains"), errors,
    clicks_dropped = vapply(fits, `[[`, 0, "dropped"), row.names = NULL)
}

# Clicks per event and second at each lag: means over participants with t intervals.
kernel_table <- function(fits) {
  if (length(fits) == 0) return(NULL)
  kernels <- each_row(fits, `[[`, "kernels")
  steps <- length(kLagEdgesS) - 1
  rows <- t(apply(kernels, 2, t_interval))
  data.frame(event = rep(c("bad", "good"), each = steps),
    from_ms = 1000 * utils::head(kLagEdgesS, -1), to_ms = 1000 * kLagEdgesS[-1],
    participants = nrow(kernels), rows, row.names = NULL)
}

detection_tests <- function(fits, records, gains, left_out, trials) {
  remarks <- if (length(left_out) > 0) sprintf(
    "The events that %s saw do not determine both gains: left out of the click regression.",
    and_words(as_typed(left_out)))
  dropped <- sum(gains$clicks_dropped[gains$scheduling == "all"])
  if (dropped > 0) remarks <- c(remarks, sprintf(paste("%s within 400 ms of the one before or",
    "after the end left out of the click regression."),
    paste(count_of(dropped, "click"), if (dropped == 1) "is" else "are")))
  if (length(fits) < 2) return(outcome(remarks = remarks))  # one participant only describes
  each <- each_row(fits, `[[`, "gains")
  interval <- t_interval(each[, "difference"])
  row <- test_row(kSensitivityFamily, paste0("additive click-rate regression for each participant; ",
    "circular shift of clicks within trials, ", kShifts, " draws; interval: t over participants"),
    kGainWords[["difference"]], "mean difference", interval[["mean"]], NA,
    p = two_sided_p(interval[["mean"]], shifted_differences(records)), size_name = "clicks per event",
    size = interval[["mean"]], interval = interval[c("low", "high")], interval_level = 0.95,
    participants = nrow(each), trials = trials)
  all_outcomes(outcome(row, remarks), do.call(all_outcomes, lapply(names(kGainWords), function(gain) {
    paired_test(each[, gain], kGainTFamily, kGainWords[[gain]], gain_unit(gain))
  })))
}

gain_unit <- function(gain) if (gain == "baseline") "clicks per second" else "clicks per event"

# Were bad events more or less often clicked at in trials of one kind than of the other? Paired over
# the participants whose trials of both kinds determine it.
pair_gain_tests <- function(gains, pair) {
  first <- gains[gains$scheduling == pair$of, ]
  second <- gains[gains$scheduling == pair$against, ]
  both <- intersect(first$participant, second$participant)
  if (length(both) < 2) return(outcome())
  do.call(all_outcomes, lapply(c("bad", "baseline"), function(gain) {
    difference <- first[[gain]][match(both, first$participant)] -
      second[[gain]][match(both, second$participant)]
    paired_test(difference, family_of(kTrackedGainFamily, pair),
      paste0(kGainWords[[gain]], ", ", pair_words(pair)), gain_unit(gain))
  }))
}

detection_words <- function(tests, gains, pairs) {
  if (!any(gains$scheduling == "all")) {
    return("No participant's events determine the gains of the click regression.")
  }
  row <- tests_of(tests, kSensitivityFamily)
  mean_of <- function(gain) mean(gains[[gain]][gains$scheduling == "all"])
  tested <- if (nrow(row) == 0) "" else sprintf(
    ", 95 %% CI [%.3f, %.3f] (circular shift of clicks, %s)", row$interval_low,
    row$interval_high, both_p_words(row))
  alone <- implied_d_prime(mean_of("bad"), mean_of("baseline"))
  tracked <- each_row(pairs, function(pair) tests_of(tests, family_of(kTrackedGainFamily, pair)))
  c(
    sprintf(paste("In the regression of the click rate, a bad event added %.3f clicks and a good",
      "one %.3f; the difference, sensitivity, was %.3f%s. The baseline, readiness to click at",
      "nothing, was %.3f clicks per second."), mean_of("bad"), mean_of("good"),
      mean_of("difference"), tested, mean_of("baseline")),
    if (!is.na(alone[["d_prime"]])) sprintf(paste("For one bad event alone in a second that",
      "makes d′ = %.2f, criterion %.2f."), alone[["d_prime"]], alone[["criterion"]]),
    if (NROW(tracked) > 0) sprintf("%s: %+.3f, 95 %% CI [%.3f, %.3f], %s.",
      sentence_case(tracked$effect), tracked$effect_size, tracked$interval_low,
      tracked$interval_high, both_p_words(tracked)))
}
