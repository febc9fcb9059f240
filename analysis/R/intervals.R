# Confidence intervals for means over participants and for shares of variance.
# SPDX-License-Identifier: MIT

# Student's t interval of the mean of `x`: c(mean, low, high); no limits for fewer than two values.
t_interval <- function(x, level = 0.95) {
  n <- length(x)
  half <- if (n > 1) stats::qt((1 + level) / 2, n - 1) * stats::sd(x) / sqrt(n) else NA
  c(mean = mean(x), low = mean(x) - half, high = mean(x) + half)
}

# Within-participant intervals of the columns' means, one row per column of `means`.
#
# Each participant's own mean is taken out, the grand mean put back (Cousineau 2005), and the
# standard error widened by sqrt(J / (J - 1)) for J columns (Morey 2008). They show what a
# comparison between the columns can show, not how people differ. Precondition: no NA.
cousineau_morey <- function(means, level = 0.95) {
  n <- nrow(means)
  columns <- ncol(means)
  normalised <- means - rowMeans(means) + mean(means)
  widening <- sqrt(columns / (columns - 1))
  half <- if (n > 1 && columns > 1) {
    stats::qt((1 + level) / 2, n - 1) * widening * apply(normalised, 2, stats::sd) / sqrt(n)
  } else {
    rep(NA_real_, columns)
  }
  data.frame(
    cell = colnames(means), mean = colMeans(means), low = colMeans(means) - half,
    high = colMeans(means) + half, row.names = NULL
  )
}

# Interval of partial eta squared from the noncentral F: c(low, high) (Smithson 2001; Steiger 2004).
#
# A limit is lambda / (lambda + df1 + df2 + 1), where the noncentrality lambda puts the observed F
# at the tail's probability. 90 % by convention: its lower limit exceeds 0 just when p < .05.
eta_squared_interval <- function(F, df1, df2, level = 0.90) {
  tail <- (1 - level) / 2
  c(
    low = as_eta_squared(noncentrality_at(F, df1, df2, 1 - tail), df1, df2),
    high = as_eta_squared(noncentrality_at(F, df1, df2, tail), df1, df2)
  )
}

as_eta_squared <- function(lambda, df1, df2) lambda / (lambda + df1 + df2 + 1)

# The noncentrality at which P(F' <= F) = probability; 0 where even the central F is below it.
noncentrality_at <- function(F, df1, df2, probability) {
  below <- function(lambda) stats::pf(F, df1, df2, ncp = lambda) - probability
  if (below(0) <= 0) return(0)
  upper <- max(1, F * df1)
  while (suppressWarnings(below(upper)) > 0) upper <- 2 * upper
  suppressWarnings(stats::uniroot(below, c(0, upper), tol = 1e-9 * upper)$root)
}

# Percentile bootstrap over participants (rows) of `statistic(means)`: c(low, high). Its tails are
# those that the normal law gives Student's t interval, wider by sqrt(n / (n - 1)): plain percentiles
# of n participants are too narrow (Hesterberg 2015, "expanded percentile"). Seeded, so that a table is
# the same every time it is made; the caller's random numbers are left as they were.
bootstrap_interval <- function(means, statistic, level = 0.95, draws = 2000, seed = 1) {
  values <- with_seed(seed, replicate(draws, {
    statistic(means[sample(nrow(means), replace = TRUE), , drop = FALSE])
  }))
  n <- nrow(means)
  tail <- if (n < 2) (1 - level) / 2 else
    stats::pnorm(-sqrt(n / (n - 1)) * stats::qt((1 + level) / 2, n - 1))
  limits <- stats::quantile(values, c(tail, 1 - tail), na.rm = TRUE)
  c(low = limits[[1]], high = limits[[2]])
}

# `expression` with random numbers from `seed`; the caller's are left as they were.
with_seed <- function(seed, expression) {
  if (exists(".Random.seed", globalenv())) {
    before <- get(".Random.seed", globalenv())
    on.exit(assign(".Random.seed", before, globalenv()))
  }
  set.seed(seed)
  expression
}
