# Which collisions make people click: a regression of the click rate on the collisions before it.
#
#   rate(t) = [ intercept of the trial + sum over bad collisions k_bad(t - s)
#                                      + sum over good collisions k_good(t - s) ] x free(t)
#
#   k_bad, k_good: steps of 200 ms, from 200 to 1200 ms after the collision
#   free(t): 0 for 400 ms after each click, when nobody clicks again, else 1
#
# A kernel's area is its gain: the clicks that one more collision adds. Gain of bad minus gain of
# good collisions is sensitivity. Overlapping collisions share a click by what the whole record says,
# so nothing is matched to anything. Each collision counts: merged into events they hardly differ in
# number between busy and quiet moments, and gains come out a fifth too small.
#
# Every trial has an intercept of its own, so that gains come from the timing within trials alone:
# trials with more bodies have more collisions and other clicks for other reasons. Where collisions
# are dense the intercepts are what little time without them says, so readiness to click at nothing
# is counted and not regressed: clicks per second while no bad collision lay 200 to 1200 ms before.
#
# The rate is additive, so its coefficients have a closed form that is unbiased whatever the overlap:
# theta = (sum of (x - m)(x - m)' while free)^-1 (sum of x - m at the clicks), m the trial's mean
# while free, with a sandwich variance (Lin and Ying 1994, a stratum for each trial). Each
# participant gets an own fit; means with t intervals and tests are over participants.
#
# A circular shift of each trial's clicks keeps their number and their runs and takes away their
# timing to collisions. It draws no participants: what it says is about these ones.
# SPDX-License-Identifier: MIT

kLagEdgesS <- seq(0.2, 1.2, by = 0.2)
kLagSteps <- length(kLagEdgesS) - 1
kRefractoryS <- 0.4
kClickBinS <- 0.02  # lags and refractory period are whole bins
kRefractoryBins <- round(kRefractoryS / kClickBinS)
kShifts <- 999

# One participant's trials as regressors on a grid of time: list(rows, first, bins, click_trial,
# click_bin, blocks, dropped). `trials` has exposure_s; `events` has row (of trials), time_s and
# bad; `clicks` has row and time_s. `blocks`: how many bins of its trial a click takes from the next
# one. A click within the refractory period of one that counts, or after the end, is dropped and
# counted.
click_record <- function(trials, events, clicks) {
  bins <- as.integer(floor(trials$exposure_s / kClickBinS + 1e-9))
  parts <- lapply(seq_len(nrow(trials)), function(i) {
    mine <- events[events$row == i, ]
    cbind(lagged_counts(mine$time_s[mine$bad], bins[i]),
      lagged_counts(mine$time_s[!mine$bad], bins[i]))
  })
  kept <- lapply(seq_len(nrow(trials)), function(i) {
    times <- clicks$time_s[clicks$row == i]
    free_clicks(times[times >= 0 & times < bins[i] * kClickBinS])
  })
  trial <- rep(seq_along(kept), lengths(kept))
  bin <- as.integer(floor(unlist(kept) / kClickBinS + 1e-9))
  list(rows = do.call(rbind, parts), first = cumsum(c(0L, bins))[seq_along(bins)], bins = bins,
    click_trial = trial, click_bin = bin, blocks = pmin(kRefractoryBins, bins[trial] - 1L - bin),
    dropped = nrow(clicks) - length(trial))
}

# How many events were how long ago: bins by steps of the kernel.
lagged_counts <- function(times, bins) {
  times <- sort(times)
  middle <- (seq_len(bins) - 0.5) * kClickBinS
  until <- vapply(kLagEdgesS, function(lag) findInterval(middle - lag, times), numeric(bins))
  until <- matrix(until, bins)
  until[, -ncol(until), drop = FALSE] - until[, -1, drop = FALSE]
}

# The clicks that come when the participant is free to click. 1 ns less: the clock's grain.
free_clicks <- function(times) {
  kept <- numeric()
  for (time in sort(times)) {
    if (length(kept) == 0 || time - kept[length(kept)] >= kRefractoryS - 1e-9) kept <- c(kept, time)
  }
  kept
}

# Running sums over the bins of every trial, each to its end and a refractory period round it, of the
# products of (1, x) with itself: list(sums, start). A bin's lower triangle, by column, is a column of
# `sums`; `start` is the column before each trial's first bin. Whole numbers, as collisions are
# counted. Only differences within a trial mean anything.
running_products <- function(record) {
  size <- 1 + ncol(record$rows)
  row <- sequence(size:1, seq_len(size))
  column <- rep(seq_len(size), size:1)
  long <- record$bins + kRefractoryBins
  bin <- (sequence(long) - 1) %% rep(record$bins, long)
  z <- cbind(1, record$rows[rep(record$first, long) + bin + 1, , drop = FALSE])
  storage.mode(z) <- "integer"
  sums <- vapply(seq_along(row), function(i) c(0L, cumsum(z[, row[i]] * z[, column[i]])),
    integer(nrow(z) + 1))
  list(sums = t(sums), start = cumsum(c(0, long))[seq_along(long)] + 1)
}

# Coefficients of a record whose clicks come `shift` bins later, another number for each trial, round
# its end: list(theta, influence (what each click adds to theta), time_s and sums (of x) while free);
# NULL where the collisions do not determine them. What a click blocks goes with it.
fit_click_rate <- function(record, running = running_products(record),
                           shift = integer(length(record$bins))) {
  trial <- record$click_trial
  bin <- (record$click_bin + shift[trial]) %% record$bins[trial]
  after <- running$start[trial] + bin + 1
  blocked <- running$sums[, after + record$blocks, drop = FALSE] -
    running$sums[, after, drop = FALSE]
  all <- running$sums[, running$start + record$bins, drop = FALSE] -
    running$sums[, running$start, drop = FALSE]
  free <- t(all - blocked %*% outer(trial, seq_along(record$bins), `==`)) * kClickBinS
  size <- ncol(record$rows)
  sums <- free[, 1 + seq_len(size), drop = FALSE]
  means <- sums / free[, 1]
  squares <- symmetric(colSums(free[, -seq_len(1 + size), drop = FALSE]), size) -
    crossprod(sums, means)
  if (rcond(squares) < 1e-9) return(NULL)
  at_clicks <- record$rows[record$first[trial] + bin + 1, , drop = FALSE] -
    means[trial, , drop = FALSE]
  influence <- at_clicks %*% solve(squares)
  list(theta = colSums(influence), influence = influence, time_s = sum(free[, 1]),
    sums = colSums(sums))
}

# Linear combinations of theta that have a name: bad and good gain, their difference.
kGainWeights <- rbind(bad = c(diff(kLagEdgesS), rep(0, kLagSteps)),
  good = c(rep(0, kLagSteps), diff(kLagEdgesS)),
  difference = c(diff(kLagEdgesS), -diff(kLagEdgesS)))

# list(gains, errors, kernels, quiet, dropped) of one participant; NULL where nothing determines them.
# The intercept is the trials' mean, each weighed by its time free to click.
click_gains <- function(record) {
  fit <- fit_click_rate(record)
  if (is.null(fit)) return(NULL)
  of_clicks <- cbind(fit$influence %*% t(kGainWeights),
    intercept = (1 - fit$influence %*% fit$sums)[, 1] / fit$time_s)
  list(gains = colSums(of_clicks), errors = sqrt(colSums(of_clicks^2)), kernels = fit$theta,
    quiet = quiet_clicks(record), dropped = record$dropped)
}

# c(false_clicks, quiet_s): the clicks, and the seconds free to click, while no bad collision lay 200
# to 1200 ms before.
quiet_clicks <- function(record) {
  quiet <- rowSums(record$rows[, seq_len(kLagSteps), drop = FALSE]) == 0
  at <- record$first[record$click_trial] + record$click_bin + 1
  blocked <- rep(at, record$blocks) + sequence(record$blocks)
  c(false_clicks = sum(quiet[at]), quiet_s = (sum(quiet) - sum(quiet[blocked])) * kClickBinS)
}

# The participants' mean difference of gains in each of `shifts` records whose clicks are shifted by
# whole bins, another number for each trial, round its end. Seeded; the caller's random numbers are
# left as they were.
shifted_differences <- function(records, shifts = kShifts, seed = 1) {
  withr::with_seed(seed, {
    each <- lapply(records, function(record) {
      running <- running_products(record)
      replicate(shifts, {
        shift <- floor(stats::runif(length(record$bins)) * record$bins)
        fit <- fit_click_rate(record, running, shift)
        if (is.null(fit)) NA else sum(kGainWeights["difference", ] * fit$theta)
      })
    })
    rowMeans(matrix(unlist(each), shifts), na.rm = TRUE)
  })
}

# The matrix whose lower triangle, by column, is this.
symmetric <- function(triangle, size) {
  whole <- matrix(0, size, size)
  whole[lower.tri(whole, diag = TRUE)] <- triangle
  whole[upper.tri(whole)] <- t(whole)[upper.tri(whole)]
  whole
}

# Two-sided p of an observed value among `null` ones: twice the smaller tail, the observed counted.
two_sided_p <- function(observed, null) {
  tails <- c(sum(null >= observed), sum(null <= observed))
  min(1, 2 * (1 + min(tails)) / (1 + length(null)))
}

# d' and criterion that a gain and a rate of false clicks make of one collision alone, in a window of
# one second: P(click) = 1 - exp(-(rate + gain)) with it, 1 - exp(-rate) without. NA where a mean is
# not above 0.
implied_d_prime <- function(gain, false_per_s) {
  if (!isTRUE(false_per_s > 0) || !isTRUE(gain + false_per_s > 0)) {
    return(c(d_prime = NA, criterion = NA))
  }
  d_prime(1 - exp(-(false_per_s + gain)), 1 - exp(-false_per_s))
}

# d' and criterion of a hit rate and a false-alarm rate (Macmillan and Creelman 2005).
d_prime <- function(hits, false_alarms) {
  z <- stats::qnorm(c(hits, false_alarms))
  c(d_prime = z[1] - z[2], criterion = -(z[1] + z[2]) / 2)
}

# The same from counts, with a half added to each and one to their totals (Hautus 1995), so that
# rates of 0 and 1 have a finite answer.
log_linear_d_prime <- function(hits, signals, false_alarms, noises) {
  d_prime((hits + 0.5) / (signals + 1), (false_alarms + 0.5) / (noises + 1))
}
