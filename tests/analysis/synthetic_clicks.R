# Trials with events and clicks drawn from the rate that click_regression.R estimates:
#
#   rate(t) = false clicks + gain of every event x lognormal density of its age,
#   median 550 ms, sigma_log .25, and none for 400 ms after a click.
#
# The density has .998 of its area between 200 and 1200 ms.
# SPDX-License-Identifier: MIT

# list(trials, events, clicks) of one participant. `bad_per_s`, `good_per_s`: events, Poisson;
# `bad_per_s` and `false_per_s` may differ between trials and are used in turn.
clicking_participant <- function(gain_bad, gain_good, false_per_s, trials = 30, bad_per_s = 0.5,
                                 good_per_s = 0.5, duration_s = 10) {
  bad_per_s <- rep_len(bad_per_s, trials)
  false_per_s <- rep_len(false_per_s, trials)
  drawn <- lapply(seq_len(trials), function(i) {
    bad <- runif(rpois(1, bad_per_s[i] * duration_s), 0, duration_s)
    good <- runif(rpois(1, good_per_s * duration_s), 0, duration_s)
    sort_of <- rep(c(TRUE, FALSE), c(length(bad), length(good)))
    # A Poisson process of that rate: every event sends a Poisson number of clicks, false clicks too.
    sent <- rpois(length(sort_of), ifelse(sort_of, gain_bad, gain_good))
    times <- rep(c(bad, good), sent) + rlnorm(sum(sent), log(0.55), 0.25)
    times <- c(times, runif(rpois(1, false_per_s[i] * duration_s), 0, duration_s))
    times <- free_clicks(times[times < duration_s])
    list(events = data.frame(row = rep(i, length(sort_of)), time_s = c(bad, good), bad = sort_of),
      clicks = data.frame(row = rep(i, length(times)), time_s = times))
  })
  part <- function(name) do.call(rbind, lapply(drawn, `[[`, name))
  list(trials = data.frame(participant = "P01", kind = "tracked",
    exposure_s = rep(duration_s, trials)), events = part("events"), clicks = part("clicks"))
}

record_of <- function(drawn) click_record(drawn$trials, drawn$events, drawn$clicks)
