# Which collisions make people click: a regression of the click rate on the events before it.
#
#   rate(t) = [ baseline of the trial's kind + sum over bad events k_bad(t - s)
#                                            + sum over good events k_good(t - s) ] x free(t)
#
#   k_bad, k_good: steps of 200 ms, from 200 to 1200 ms after the event
#   free(t): 0 for 400 ms after each click, when nobody clicks again, else 1
#
# A kernel's area is its gain: the clicks that one more event adds. Gain of bad minus gain of good
# events is sensitivity; the baseline is bias, a readiness to click at nothing. Overlapping events
# share a click by what the whole record says, so nothing is matched to anything.
#
# The rate is additive, so its coefficients have a closed form that is unbiased whatever the overlap:
# theta = (integral of x x' while free)^-1 (sum of x at the clicks), with a sandwich variance (Lin
# and Ying 1994). Each participant gets an own fit; means with t intervals are over participants.
# The null is a circular shift of each trial's clicks: rates and runs of clicks stay, their timing
# to events goes. It is a null of no timing to either sort; the t test beside allows for both.
# SPDX-License-Identifier: MIT

kLagEdgesS <- seq(0.2, 1.2, by = 0.2)
kRefractoryS <- 0.4
kClickBinS <- 0.02  # lags and refractory period are whole bins
kRefractoryBins <- round(kRefractoryS / kClickBinS)
kShifts <- 999

# One participant's trials as regressors on a grid of time: list(rows, first, bins, click_trial,
# click_bin, dropped). `trials` has kind and exposure_s; `events` has row (of trials), time_s and
# bad; `clicks` has row and time_s. A click within the refractory period of one that counts, or
# after the end, is dropped and counted.
click_record <- function(trials, events, clicks, kinds = unique(trials$kind)) {
  bins <- as.integer(floor(trials$exposure_s / kClickBinS + 1e-9))
  parts <- lapply(seq_len(nrow(trials)), function(i) {
    mine <- events[events$row == i, ]
    cbind(outer(rep(trials$kind[i], bins[i]), kinds, `==`) + 0,
      lagged_counts(mine$time_s[mine$bad], bins[i]), lagged_counts(mine$time_s[!mine$bad], bins[i]))
  })
  kept <- lapply(seq_len(nrow(trials)), function(i) {
    times <- clicks$time_s[clicks$row == i]
    free_clicks(times[times >= 0 & times < bins[i] * kClickBinS])
  })
  list(rows = do.call(rbind, parts), first = cumsum(c(0L, bins))[seq_along(bins)], bins = bins,
    click_trial = rep(seq_along(kept), lengths(kept)),
    click_bin = as.integer(floor(unlist(kept) / kClickBinS + 1e-9)),
    kinds = kinds, dropped = nrow(clicks) - sum(lengths(kept)))
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

# Coefficients of a record: list(theta, covariance), or NULL where the events do not determine them.
fit_click_rate <- function(record) {
  bins <- record$bins[record$click_trial]
  first <- record$first[record$click_trial]
  blocked <- outer(record$click_bin, seq_len(kRefractoryBins), `+`)
  blocked <- (first + blocked)[blocked < bins]
  at_clicks <- record$rows[first + record$click_bin + 1, , drop = FALSE]
  inverse <- inverse_while_free(
    crossprod(record$rows), crossprod(record$rows[blocked + 1, , drop = FALSE]))
  if (is.null(inverse)) return(NULL)
  list(theta = as.vector(inverse %*% colSums(at_clicks)),
    covariance = inverse %*% crossprod(at_clicks) %*% inverse)
}

# The inverse of the integral of x x' while free, of its sums over all bins and over those that are
# not; NULL where there is none.
inverse_while_free <- function(all, blocked) {
  while_free <- all * kClickBinS - blocked * kClickBinS
  if (rcond(while_free) < 1e-9) NULL else solve(while_free)
}

# For each bin the sum of x x' over the refractory time of a click there, round its trial's end: its
# lower triangle, by column, is a column. Whole numbers, as events are counted.
blocked_products <- function(record) {
  size <- ncol(record$rows)
  row <- sequence(size:1, seq_len(size))
  column <- rep(seq_len(size), size:1)
  parts <- Map(function(first, bins) {
    round_the_end <- first + (seq_len(bins + kRefractoryBins) - 1) %% bins + 1
    x <- record$rows[round_the_end, , drop = FALSE]
    sums <- apply(x[, row, drop = FALSE] * x[, column, drop = FALSE], 2, cumsum)
    until <- sums[kRefractoryBins + seq_len(bins), , drop = FALSE] - sums[seq_len(bins), , drop = FALSE]
    storage.mode(until) <- "integer"
    t(until)
  }, record$first, record$bins)
  do.call(cbind, parts)
}

# Linear combinations of theta that have a name: bad and good gain, their difference, the baseline
# (each kind's, weighed by its time).
click_gain_weights <- function(record) {
  steps <- length(kLagEdgesS) - 1
  time <- colSums(record$rows[, seq_along(record$kinds), drop = FALSE])
  zero <- rep(0, steps)
  none <- rep(0, length(time))
  width <- diff(kLagEdgesS)
  rbind(bad = c(none, width, zero), good = c(none, zero, width),
    difference = c(none, width, -width), baseline = c(time / sum(time), zero, zero))
}

# list(gains, errors, kernels, dropped) of one participant; NULL where nothing determines them.
click_gains <- function(record) {
  fit <- fit_click_rate(record)
  if (is.null(fit)) return(NULL)
  weights <- click_gain_weights(record)
  variances <- diag(weights %*% fit$covariance %*% t(weights))
  list(gains = (weights %*% fit$theta)[, 1], errors = sqrt(pmax(variances, 0)),
    kernels = fit$theta[-seq_along(record$kinds)], dropped = record$dropped)
}

# The participants' mean difference of gains in each of `shifts` records whose clicks are shifted by
# whole bins, another number for each trial, round its end. Seeded; the caller's random numbers are
# left as they were.
shifted_differences <- function(records, shifts = kShifts, seed = 1) {
  withr::with_seed(seed, {
    each <- lapply(records, function(record) {
      bins <- record$bins[record$click_trial]
      first <- record$first[record$click_trial]
      weights <- click_gain_weights(record)["difference", ]
      all <- crossprod(record$rows)
      blocked <- blocked_products(record)
      replicate(shifts, {
        shift <- floor(stats::runif(length(record$bins)) * record$bins)
        clicked <- first + (record$click_bin + shift[record$click_trial]) %% bins + 1
        inverse <- inverse_while_free(
          all, symmetric(rowSums(blocked[, clicked, drop = FALSE]), ncol(all)))
        sums <- colSums(record$rows[clicked, , drop = FALSE])
        if (is.null(inverse)) NA else sum(weights * as.vector(inverse %*% sums))
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

# d' and criterion that a gain and a baseline make of one event alone, in a window of one second:
# P(click) = 1 - exp(-(baseline + gain)) with the event, 1 - exp(-baseline) without. NA where a mean
# is not above 0.
implied_d_prime <- function(gain, baseline) {
  if (!isTRUE(baseline > 0) || !isTRUE(gain + baseline > 0)) return(c(d_prime = NA, criterion = NA))
  d_prime(1 - exp(-(baseline + gain)), 1 - exp(-baseline))
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
