# Studies of thresholds made up for the tests: answers of observers with known psychometric functions.
# SPDX-License-Identifier: MIT

# Answers of one observer at the levels `x`.
answers_at <- function(x, threshold, spread, guess = 0, lapse = 0.02) {
  p <- guess + (1 - guess - lapse) * pnorm((x - threshold) / spread)
  rbinom(length(x), 1, p)
}

# gap-thresholds: log10 thresholds 1 + .4 at 8 degrees + .1 with 8 distractors + u_i, u_i ~ N(0, .1),
# spread .2; `n` trials at each of seven gaps.
# The attribute mean_shift is the mean of the u_i drawn.
kGapLevelsArcmin <- c(3, 5, 10, 20, 40, 80, 160)
gap_answers <- function(seed, participants, n = 8) {
  set.seed(seed)
  plan <- shuffled_plan(participants, expand.grid(gap_arcmin = kGapLevelsArcmin,
    eccentricity_deg = c(0, 8), distractors = c(0, 8), repetition = seq_len(n)))
  shift <- rnorm(participants, 0, 0.1)
  threshold <- 1 + 0.4 * (plan$eccentricity_deg > 0) + 0.1 * (plan$distractors > 0) +
    shift[factor(plan$participant)]
  plan$positive <- answers_at(log10(plan$gap_arcmin), threshold, 0.2, guess = 0.03)
  attr(plan, "mean_shift") <- mean(shift)
  plan
}

# A study file of these answers; rows with positive NA are planned and not yet done. Columns of
# `trials` beside the design: positive, and timed_out and kind with defaults here.
write_threshold_study <- function(path, trials, protocol, ...) {
  defaults <- list(timed_out = 0, kind = "yes_no")
  for (column in setdiff(names(defaults), names(trials))) trials[[column]] <- defaults[[column]]
  design <- trials[setdiff(names(trials), c("positive", names(defaults)))]
  design$rating <- ifelse(is.na(trials$positive) & trials$timed_out == 0, NA, 1)
  write_study(path, design, protocol = protocol, ...)
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  on.exit(DBI::dbDisconnect(study))
  DBI::dbExecute(study, "DELETE FROM rating")
  trials$trial <- seq_len(nrow(trials))
  done <- trials[!is.na(design$rating), ]
  late <- done$timed_out == 1
  DBI::dbAppendTable(study, "response", data.frame(
    attempt_id = done$trial, number = 1, kind = done$kind, question = "Was there a gap?",
    answer = ifelse(late, NA, ifelse(done$positive == 1, "yes", "no")),
    positive = ifelse(late, NA, done$positive), detail = "{}",
    device = ifelse(late, "none", "simulated"), question_shown_ns = 0, arrived_ns = 5e8,
    arrival_uncertainty_ns = 1e6, timed_out = done$timed_out
  ))
  path
}
