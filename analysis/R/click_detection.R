# What participants clicked at, from the study's trials to tests, tables and words.
#
#   collisions ───────────┬─> one record per participant ─> gains, kernels, false clicks
#   clicks ───────────────┤   (click_regression.R)       ├─> t tests: the unit is the participant
#   trials with exposure ─┤                              └─> circular shift: these participants alone
#                         └─> merged events ─> matching_table (click_matching.R), descriptive
# SPDX-License-Identifier: MIT

kSensitivityFamily <- "click regression, gain of bad − good collisions (primary)"
kTimingFamily <- "click regression, timing of these participants' clicks"
kGainTFamily <- "click regression, participants' gains"
kTrackedGainFamily <- "click regression, tracked − random"
kGainWords <- c(bad = "gain of bad collisions", good = "gain of good collisions",
  difference = "gain of bad − good collisions")
kGainUnit <- "clicks per collision"

# Adds study$clicks: the time of each click, by the row of its trial; and study$two_intervals: have
# trials two stimuli? Times are of each one's own.
with_click_times <- function(study) {
  study$clicks <- rows_of_trials(study,
    "SELECT trial, CAST(time_s AS REAL) AS time_s FROM trial_click")
  study$two_intervals <- nrow(rows_of_trials(study, "SELECT trial FROM trial_response",
    "AND kind = 'two_interval'")) > 0
  study
}

# Collisions of one sort in a trial that follow each other within less than merge_within_ms, as one
# event at the time of the first, so a quick series is one: row, time_s, bad. Without merge_within_ms
# every collision is one. `study` has trials and collisions.
click_events <- function(study) {
  known <- study$collisions[!is.na(study$collisions$time_s), ]
  known <- known[order(known$row, known$bad, known$time_s), c("row", "time_s", "bad")]
  within_s <- study$trials$merge_within_ms[known$row] / 1000
  within_s[is.na(within_s)] <- 0
  same <- c(FALSE, diff(known$row) == 0 & diff(known$bad) == 0)
  # 1 ns: the clock's own grain, so that a distance of exactly `within_s` parts two events.
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
  records <- participants_records(study, usable, "all")
  fits <- Filter(Negate(is.null), lapply(records, click_gains))
  left_out <- setdiff(names(records), names(fits))
  kinds <- unique(unlist(lapply(study$pairs, function(pair) c(pair$of, pair$against))))
  gains <- rbind(gains_table(fits, "all"), each_row(kinds, function(kind) {
    gains_table(lapply(participants_records(study, usable, kind), click_gains), kind)
  }))
  matching <- matching_table(study$trials[usable, ], renumbered(click_events(study), usable),
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
    return("No trial's exposure is known, so clicks are not regressed on collisions.")
  }
  if (isTRUE(study$two_intervals)) {
    return("A trial has two stimuli, so clicks are not regressed on collisions.")
  }
  if (nrow(study$clicks) == 0) {
    return("Nobody clicked, so there is nothing to regress on collisions: every gain is 0.")
  }
  if (any(!is.na(study$collisions$time_s))) return(NULL)
  "No collision has a time, so clicks are not regressed on collisions."
}

# Rows of `part` whose trial is among `chosen`, numbered by their place there.
renumbered <- function(part, chosen) {
  part$row <- match(part$row, chosen)
  part[!is.na(part$row), ]
}

# A record for each participant, of trials of one kind of scheduling or of "all".
participants_records <- function(study, usable, kind) {
  collisions <- study$collisions[!is.na(study$collisions$time_s), c("row", "time_s", "bad")]
  kinds <- as.character(study$trials$scheduling)
  mine <- usable[kind == "all" | kinds[usable] == kind]
  lapply(split(mine, as.character(study$trials$participant[mine])), function(rows) {
    click_record(data.frame(exposure_s = study$trials$exposure_s[rows]),
      renumbered(collisions, rows), renumbered(study$clicks, rows))
  })
}

gains_table <- function(fits, kind) {
  fits <- Filter(Negate(is.null), fits)
  if (length(fits) == 0) return(NULL)
  errors <- each_row(fits, `[[`, "errors")
  colnames(errors) <- paste0(colnames(errors), "_error")
  data.frame(participant = names(fits), scheduling = kind, each_row(fits, `[[`, "gains"), errors,
    each_row(fits, `[[`, "quiet"),
    clicks_dropped = vapply(fits, `[[`, 0, "dropped"), row.names = NULL)
}

# The gains and the kernels as tables of a report; none without a regression.
click_tables <- function(detection) {
  if (is.null(detection$kernels)) return(list())
  list(
    list(name = "gains", title = "What was clicked at: each participant's gains",
      rows = detection$gains, heads = sentence_case(gsub("_", " ", names(detection$gains)))),
    list(name = "kernels", title = "Clicks per second that a collision adds, by the time since it",
      rows = detection$kernels, heads = c("Collision", "From (ms)", "To (ms)", "Participants", "Mean",
        "95 % CI, from", "to")))
}

# Clicks per collision and second at each lag: means over participants with t intervals.
kernel_table <- function(fits) {
  if (length(fits) == 0) return(NULL)
  kernels <- each_row(fits, `[[`, "kernels")
  steps <- length(kLagEdgesS) - 1
  rows <- t(apply(kernels, 2, t_interval))
  data.frame(collision = rep(c("bad", "good"), each = steps),
    from_ms = 1000 * utils::head(kLagEdgesS, -1), to_ms = 1000 * kLagEdgesS[-1],
    participants = nrow(kernels), rows, row.names = NULL)
}

detection_tests <- function(fits, records, gains, left_out, trials) {
  remarks <- if (length(left_out) > 0) sprintf(
    "The collisions that %s saw do not determine both gains: left out of the click regression.",
    and_words(as_typed(left_out)))
  dropped <- sum(gains$clicks_dropped[gains$scheduling == "all"])
  if (dropped > 0) remarks <- c(remarks, sprintf(paste("%s within 400 ms of the one before or",
    "after the end left out of the click regression."),
    paste(count_of(dropped, "click"), if (dropped == 1) "is" else "are")))
  if (length(fits) < 2) return(outcome(remarks = remarks))  # one participant only describes
  each <- each_row(fits, `[[`, "gains")
  gain_test <- function(gain, family) paired_test(each[, gain], family, kGainWords[[gain]], kGainUnit,
    "additive click-rate regression for each participant; t test over them")
  difference <- gain_test("difference", kSensitivityFamily)
  if (!is.null(difference$rows)) difference$rows$trials <- trials
  all_outcomes(outcome(remarks = remarks), difference,
    gain_test("bad", kGainTFamily), gain_test("good", kGainTFamily),
    timing_test(mean(each[, "difference"]), shifted_differences(records), length(fits), trials))
}

# Does the timing of these participants' clicks follow the collisions? The size is what the mean
# difference exceeds the shifts' own mean by; no interval, for no population is meant.
timing_test <- function(observed, null, participants, trials) {
  outcome(test_row(kTimingFamily, paste0("circular shift of clicks within trials, ", kShifts,
    " draws, participants held fixed"), kGainWords[["difference"]], "mean of the shifts",
    mean(null, na.rm = TRUE), NA, p = two_sided_p(observed, null), size_name = paste(kGainUnit,
      "beyond the shifts"), size = observed - mean(null, na.rm = TRUE),
    participants = participants, trials = trials))
}

# Were bad collisions more or less often clicked at in trials of one kind than of the other? Paired
# over the participants whose trials of both kinds determine it.
pair_gain_tests <- function(gains, pair) {
  first <- gains[gains$scheduling == pair$of, ]
  second <- gains[gains$scheduling == pair$against, ]
  both <- intersect(first$participant, second$participant)
  difference <- first$bad[match(both, first$participant)] -
    second$bad[match(both, second$participant)]
  paired_test(difference, family_of(kTrackedGainFamily, pair),
    paste0(kGainWords[["bad"]], ", ", pair_words(pair)), kGainUnit)
}

detection_words <- function(tests, gains, pairs) {
  all <- gains[gains$scheduling == "all", ]
  if (nrow(all) == 0) {
    return("No participant's collisions determine the gains of the click regression.")
  }
  row <- tests_of(tests, kSensitivityFamily)
  tested <- if (nrow(row) == 0) "" else sprintf(
    ", 95 %% CI [%.3f, %.3f] (t test over participants, %s)", row$interval_low,
    row$interval_high, both_p_words(row))
  tracked <- each_row(pairs, function(pair) tests_of(tests, family_of(kTrackedGainFamily, pair)))
  c(
    sprintf(paste("In the regression of the click rate, a bad collision added %.3f clicks and a good",
      "one %.3f; the difference, sensitivity, was %.3f%s."), mean(all$bad), mean(all$good),
      mean(all$difference), tested),
    timing_words(tests_of(tests, kTimingFamily)),
    false_click_words(all),
    if (NROW(tracked) > 0) sprintf("%s: %+.3f, 95 %% CI [%.3f, %.3f], %s.",
      sentence_case(tracked$effect), tracked$effect_size, tracked$interval_low,
      tracked$interval_high, both_p_words(tracked)))
}

timing_words <- function(row) {
  if (nrow(row) == 0) return(NULL)
  sprintf(paste("Of these participants alone, whether the timing of their clicks follows the",
    "collisions: with each trial's clicks shifted in time the difference was %.3f on average, and",
    "theirs was %.3f above that (circular shift, %s)."), row$statistic, row$effect_size,
    both_p_words(row))
}

# Bias, the rate of false clicks, and what it makes of the gain of bad collisions. `all`: gains of all
# trials.
false_click_words <- function(all) {
  rates <- (all$false_clicks / all$quiet_s)[all$quiet_s > 0]
  if (length(rates) == 0) {
    return("Bad collisions left no time free of them, so the rate of false clicks is not known.")
  }
  interval <- t_interval(rates)
  alone <- implied_d_prime(mean(all$bad), interval[["mean"]])
  c(sprintf(paste("While no bad collision lay 200 to 1200 ms before, participants clicked %.3f times",
    "per second (false clicks, at good collisions or at nothing)%s: %s in %.0f s."),
    interval[["mean"]], if (is.na(interval[["low"]])) "" else
      sprintf(", 95 %% CI [%.3f, %.3f]", interval[["low"]], interval[["high"]]),
    count_of(sum(all$false_clicks), "click"), sum(all$quiet_s)),
    if (!is.na(alone[["d_prime"]])) sprintf(paste("For one bad collision alone in a second",
      "that makes d′ = %.2f, criterion %.2f."), alone[["d_prime"]], alone[["criterion"]]))
}
