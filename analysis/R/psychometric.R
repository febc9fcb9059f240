# A psychometric function and its fit to one participant's trials.
#
#   p(x) = guess + (1 - guess - lapse) Phi((x - threshold) / spread)
#
# by maximum likelihood, lapse within 0 to .06 (Wichmann and Hill 2001), guess fixed (.5 of two
# intervals) or within 0 to .5 with a prior of Beta(1, 10) (Schütt et al. 2016): levels chosen near the
# threshold say little of it, and a high guess rate there goes with a high threshold. The threshold is
# where the curve is halfway between its ends. Levels that were chosen trial by trial, by a staircase or
# QUEST+, are analysed in the same way: their likelihood is that of the trials as shown. The mean of a
# staircase's reversals is biased and not used.
# SPDX-License-Identifier: MIT

kLargestLapse <- 0.06
kLargestGuess <- 0.5
kGuessPrior <- 10  # the second parameter of its Beta distribution, whose first is 1

# Compiled, as what it is compared by: a bootstrap asks a million times.
psychometric_p <- compiler::cmpfun(function(x, fit) {
  fit$guess + (1 - fit$guess - fit$lapse) * stats::pnorm((x - fit$threshold) / fit$spread)
})

# Trials with equal levels as one row: x, n, positive.
by_level <- function(x, positive) {
  levels <- sort(unique(x))
  at <- match(x, levels)
  data.frame(x = levels, n = tabulate(at, length(levels)),
    positive = as.vector(rowsum(as.numeric(positive), at)))
}

# list(threshold, spread, guess, lapse, deviance) of `data` (by_level); `guess`: fixed, or NULL to
# fit it. NULL where the answers have no rise to fit: all alike, or no more positive at higher x.
fit_psychometric <- function(data, guess = NULL, start = NULL) {
  if (nrow(data) < 2 || sum(data$positive) == 0 || sum(data$positive) == sum(data$n)) return(NULL)
  if (is.null(start) && rises_by(data) <= 0) return(NULL)
  range <- diff(range(data$x))
  unpack <- function(v) list(threshold = v[1], spread = exp(v[2]), lapse = v[3],
    guess = if (is.null(guess)) v[4] else guess)
  shown <- as.list(data)  # whose parts R finds faster
  cost <- function(v) psychometric_cost(shown, unpack(v), is.null(guess))
  slopes <- function(v) psychometric_slopes(shown, unpack(v), is.null(guess))[seq_along(v)]
  lower <- c(min(data$x) - range, log(range / 200), 0, if (is.null(guess)) 0)
  upper <- c(max(data$x) + range, log(range * 4), kLargestLapse, if (is.null(guess)) kLargestGuess)
  starts <- if (!is.null(start)) list(c(start$threshold, log(start$spread), start$lapse,
    if (is.null(guess)) start$guess)) else first_guesses(data, guess)
  fits <- lapply(starts, function(v) {
    listen_to(stats::optim(pmin(pmax(v, lower), upper), cost, slopes, method = "L-BFGS-B",
      lower = lower, upper = upper))$value
  })
  fits <- Filter(Negate(is.null), fits)
  if (length(fits) == 0) return(NULL)
  best <- fits[[which.min(vapply(fits, `[[`, 0, "value"))]]
  fit <- unpack(best$par)
  fit$deviance <- 2 * (saturated_log_likelihood(data) -
    binomial_log_likelihood(shown, psychometric_p(shown$x, fit)))
  fit
}

# Minus the logarithm of likelihood and prior of a function, and its derivatives in threshold,
# log(spread), lapse and guess. `free`: is the guess rate fitted?
psychometric_cost <- compiler::cmpfun(function(data, fit, free) {
  -binomial_log_likelihood(data, psychometric_p(data$x, fit)) -
    if (free) (kGuessPrior - 1) * log1p(-fit$guess) else 0
})

psychometric_slopes <- compiler::cmpfun(function(data, fit, free) {
  z <- (data$x - fit$threshold) / fit$spread
  height <- 1 - fit$guess - fit$lapse
  share <- stats::pnorm(z)
  p <- within_likely(fit$guess + height * share)
  of_p <- (data$n - data$positive) / (1 - p) - data$positive / p
  of_z <- of_p * height * stats::dnorm(z)
  c(-sum(of_z) / fit$spread, -sum(of_z * z), -sum(of_p * share),
    sum(of_p * (1 - share)) + if (free) (kGuessPrior - 1) / (1 - fit$guess) else 0)
})

# Slope of positive on x, by its sign: does the share of positive answers rise?
rises_by <- function(data) {
  middle <- sum(data$n * data$x) / sum(data$n)
  sum((data$x - middle) * data$positive)
}

first_guesses <- function(data, guess) {
  range <- diff(range(data$x))
  middles <- unique(stats::quantile(rep(data$x, data$n), c(0.2, 0.5, 0.8), names = FALSE))
  unlist(lapply(middles, function(middle) lapply(log(range * c(0.02, 0.05, 0.12, 0.25, 0.6)), function(spread) {
    c(middle, spread, 0.01, if (is.null(guess)) 0.05)
  })), recursive = FALSE)
}

binomial_log_likelihood <- compiler::cmpfun(function(data, p) {
  p <- within_likely(p)
  sum(data$positive * log(p) + (data$n - data$positive) * log1p(-p))
})

# `p`, no nearer to 0 and 1 than 1e-9: pmin and pmax take as long as all else.
within_likely <- compiler::cmpfun(function(p) {
  p[p < 1e-9] <- 1e-9
  p[p > 1 - 1e-9] <- 1 - 1e-9
  p
})

saturated_log_likelihood <- function(data) binomial_log_likelihood(data, data$positive / data$n)

# Draws from a fit at the levels that were shown, each fitted again: threshold, spread, deviance as
# columns, NA where a draw has no rise. A parametric bootstrap; uses the random numbers as they are.
# Each draw starts at its own best place of a grid: started at `fit`, a draw from a steep function
# would never leave it, for the likelihood is flat between two levels, and the interval would vanish.
bootstrap_psychometric <- function(data, fit, guess, draws) {
  p <- psychometric_p(data$x, fit)
  grid <- starting_grid(data, fit, guess)
  t(replicate(draws, {
    drawn <- data
    drawn$positive <- stats::rbinom(nrow(data), data$n, p)
    again <- fit_psychometric(drawn, guess, start = best_start(grid, drawn))
    if (is.null(again)) c(NA, NA, NA) else c(again$threshold, again$spread, again$deviance)
  }))
}

# Functions all over the levels shown, and `fit`: list(points, log_p, log_q), a row for each function
# and in log_p and log_q, of its p and 1 - p, a column for each level.
starting_grid <- function(data, fit, guess) {
  range <- diff(range(data$x))
  points <- expand.grid(threshold = seq(min(data$x), max(data$x), length.out = 31),
    spread = range * c(0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8), lapse = c(0, 0.02, 0.05),
    guess = if (is.null(guess)) c(0, 0.1, 0.25) else guess)
  points <- rbind(as.data.frame(fit[names(points)]), points)
  p <- vapply(data$x, function(x) psychometric_p(x, points), numeric(nrow(points)))
  p <- within_likely(p)
  list(points = points, log_p = log(p), log_q = log1p(-p))
}

best_start <- function(grid, data) {
  log_likelihood <- grid$log_p %*% data$positive + grid$log_q %*% (data$n - data$positive)
  as.list(grid$points[which.max(log_likelihood), ])
}
