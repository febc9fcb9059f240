# The intervals that coverage_model.R plants truths for, and how often each held its truth.
# SPDX-License-Identifier: MIT

# table, column: of sides, or what the names of its limits begin with, and then low, high and truth;
# level: nominal; interval, holds: in words, what it is and what it is to hold.
kCoverageIntervals <- local({
  sides <- function(table, column, level, interval, holds) {
    data.frame(table, column, level, low = NA, high = NA, truth = NA, interval, holds)
  }
  limits <- function(table, column, truth, interval, holds,
                     names = paste0(column, c(".low", ".high"))) {
    data.frame(table, column, level = 0.95, low = names[1], high = names[2], truth, interval, holds)
  }
  rbind(
    sides("means", "mean", 0.95, "t of participants' mean ratings, 20 participants",
      "mean rating of the population"),
    sides("means", "contrast", 0.95, "t of the planned contrast, 10 participants",
      "difference of mean ratings"),
    sides("means", "equivalence", 0.90, "the same, of the equivalence test",
      "difference of mean ratings"),
    sides("means", "bar_own", 0.95, "Cousineau–Morey, compound symmetry, 20 participants",
      "a cell's mean of the participants shown (their own offsets not in it)"),
    sides("means", "bar_difference", 0.95, "two of these bars, root of the sum of squares",
      "difference of two cells"),
    sides("means", "bar_population", 0.95, "Cousineau–Morey, read as what it is not",
      "a cell's mean of the population"),
    sides("means", "bar_sloped_100", 0.95, "two bars, own slopes of the delay",
      "difference of two neighbouring delays"),
    sides("means", "bar_sloped_300", 0.95, "two bars, own slopes of the delay",
      "difference of first and last delay"),
    sides("means", "eta_between", 0.90, "η², noncentral F, independent trials",
      "λ / (λ + number of trials)"),
    sides("means", "eta_even", 0.90, "generalised η², compound symmetry, 20 participants",
      "what its estimate tends to"),
    sides("means", "eta_sloped", 0.90, "generalised η², own slopes, Greenhouse–Geisser",
      "what its estimate tends to"),
    limits("odds", "100", exp(1), "Wald of an odds ratio, mixed model, 20 participants",
      "odds ratio of the middle delay, average participant", c("low_100", "high_100")),
    limits("odds", "300", exp(2), "Wald of an odds ratio, mixed model, 20 participants",
      "odds ratio of the last delay, average participant", c("low_300", "high_300")),
    limits("ratios", "odds", kCoverageContrastOdds,
      "Wald of the planned contrast's odds ratio, 10 participants",
      "odds ratio, average participant", c("odds_low", "odds_high")),
    limits("ratios", "rates", kCoverageRateRatio, "Wald of a rate ratio of clicks, 10 participants",
      "rate ratio, average participant", c("rates_low", "rates_high")),
    sides("bootstrap", "ratio_10", 0.95, "bootstrap of a rate ratio, 10 participants",
      "ratio of the population's rates"),
    sides("bootstrap", "ratio_20", 0.95, "bootstrap of a rate ratio, 20 participants",
      "ratio of the population's rates"),
    limits("gains", "bad", kCoverageGains[["bad"]], "t of the gain of bad collisions, 10 participants",
      "mean gain of the population"),
    limits("gains", "difference", kCoverageGains[["bad"]] - kCoverageGains[["good"]],
      "t of the gain of bad − good collisions, 10 participants", "mean difference of the population"),
    limits("functions", "yes_no", kCoverageThresholdMs,
      "parametric bootstrap, one function of 105 trials, yes or no", "the participant's threshold"),
    limits("functions", "two_interval", kCoverageThresholdMs,
      "parametric bootstrap, one function of 105 trials, two intervals",
      "the participant's threshold"),
    limits("threshold_means", "t", kCoverageGapArcmin, "t of thresholds, 10 participants",
      "mean threshold of the population"),
    limits("threshold_means", "lapsed", kCoverageGapArcmin,
      "Wald of the hierarchical threshold; guesses .03, lapses .02",
      "mean threshold of the population"),
    limits("threshold_means", "pure", kCoverageGapArcmin,
      "the same; no guesses, no lapses", "mean threshold of the population")
  )
})

# Where the truth lies to an interval of kCoverageIntervals in each study of its table; NA where
# there is no interval.
sides_in <- function(rows, interval) {
  if (is.na(interval$truth)) return(rows[[interval$column]])
  (interval$truth > rows[[interval$high]]) - (interval$truth < rows[[interval$low]])
}

# kCoverageIntervals with how many studies have each interval, how many held the truth, the share and
# its exact 95 % interval (Clopper and Pearson 1934), and how often the truth lay below and above.
# `folder`: of the tables.
coverage_rates <- function(folder) {
  rates <- lapply(seq_len(nrow(kCoverageIntervals)), function(i) {
    interval <- kCoverageIntervals[i, ]
    path <- file.path(folder, sprintf("coverage_%s.csv", interval$table))
    if (!file.exists(path)) return(NULL)
    side <- sides_in(utils::read.csv(path), interval)
    side <- side[!is.na(side)]
    exact <- stats::binom.test(sum(side == 0), length(side))$conf.int
    data.frame(interval[c("table", "column", "level", "interval", "holds")],
      studies = length(side), held = sum(side == 0), rate = mean(side == 0),
      rate_low = exact[1], rate_high = exact[2], below = sum(side < 0), above = sum(side > 0),
      row.names = NULL)
  })
  do.call(rbind, rates)
}

# The rates as the table of analysis/README.md.
coverage_lines <- function(rates) {
  markdown_table(
    c("interval", "is to hold", "nominal", "studies", "held", "95 % interval",
      "truth below, above"),
    sprintf("%s | %s | %.2f | %d | %.3f | %.3f to %.3f | %d, %d", rates$interval, rates$holds,
      rates$level, rates$studies, rates$rate, rates$rate_low, rates$rate_high, rates$below,
      rates$above)
  )
}
