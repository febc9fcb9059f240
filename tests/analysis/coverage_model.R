# Studies with planted truths, and where the truth lies to the intervals that the analysis prints.
#
#   seed ──> a study whose truths are known ──> the analysis's own function ──> one row: limits, or
#            "side": -1 the truth lies below the interval, 0 within it, 1 above it
#
# Every truth is that of what is estimated: a conditional odds ratio or rate ratio of a mixed model
# is the planted coefficient's, a mean rating is integrated over the participants.
# SPDX-License-Identifier: MIT

side_of <- function(truth, interval) (truth > interval[[2]]) - (truth < interval[[1]])

# Logits at the delays 0, 100 and 300 ms for the average participant, and how participants differ
# in intercept and in slope of the delay (kNullInterceptSd, kNullSlopeSd). No lapses: no
# cumulative-link model knows them, and they pull every odds ratio towards 1.
kCoverageLogits <- c(-1, 0, 1)
kCoverageCuts <- c(-1, 1.2)

# The delays as the slope sees them: mean 0, standard deviation 1.
kDelayPlaces <- (kDelaysMs - mean(kDelaysMs)) / sqrt(mean((kDelaysMs - mean(kDelaysMs))^2))

# The delays alone, 15 trials of each, rated from 1 to 3; share `lapse` of the trials at random.
coverage_trials <- function(seed, participants = 20, lapse = 0) {
  set.seed(seed)
  plan <- shuffled_plan(participants, expand.grid(delay_ms = kDelaysMs, repetition = 1:15))
  person <- factor(plan$participant)
  at <- match(plan$delay_ms, kDelaysMs)
  eta <- kCoverageLogits[at] + rnorm(participants, 0, kNullInterceptSd)[person] +
    rnorm(participants, 0, kNullSlopeSd)[person] * kDelayPlaces[at]
  position <- eta + rlogis(length(eta))
  rating <- 1 + rowSums(outer(position, kCoverageCuts, ">"))
  lapsed <- runif(length(eta)) < lapse
  plan$rating <- ifelse(lapsed, sample(1:3, length(eta), replace = TRUE), rating)
  plan$delay_ms <- factor(plan$delay_ms)
  plan
}

# The mean rating, from 1, of participants whose place is N(mean, sd) in logits (by quadrature).
mean_rating <- function(mean, sd, cuts) {
  1 + sum(vapply(cuts, function(cut) stats::integrate(function(z) {
    stats::plogis(mean + sd * z - cut) * stats::dnorm(z)
  }, -8, 8, rel.tol = 1e-8)$value, 0))
}

coverage_mean_ratings <- function() {
  vapply(seq_along(kDelaysMs), function(i) mean_rating(kCoverageLogits[i],
    sqrt(kNullInterceptSd^2 + (kNullSlopeSd * kDelayPlaces[i])^2), kCoverageCuts), 0)
}

# Tracked and random trials of 10 s with 15 bodies, 9 of each kind: ratings from 1 to 5 and clicks
# as in synthetic_gaze_study.R, and participants differ in the contrast too: by N(0, .7) logits and
# N(0, .3) in the log of the rate, half of it on either side, so that the planted rate ratio is both
# that of the average participant and that of the totals.
coverage_gaze_trials <- function(seed, participants = 10) {
  set.seed(seed)
  plan <- shuffled_plan(participants, expand.grid(scheduling = c("random", "tracked"),
    bodies = 15, repetition = 1:9, stringsAsFactors = FALSE))
  person <- factor(plan$participant)
  half <- ifelse(plan$scheduling == "tracked", 0.5, -0.5)
  eta <- kPlantedQuality[plan$scheduling] + rnorm(participants, 0, 0.6)[person] +
    half * rnorm(participants, 0, kNullSlopeSd)[person]
  plan$rating <- 1 + rowSums(outer(eta + rlogis(nrow(plan)), kFivePointCuts, ">"))
  rate <- kPlantedClicksPerS[plan$scheduling] * exp(rnorm(participants, 0, 0.3)[person] +
    half * rnorm(participants, 0, 0.3)[person])
  plan$clicks <- rpois(nrow(plan), 10 * rate *
    rgamma(nrow(plan), shape = kPlantedTheta, rate = kPlantedTheta))
  plan$exposure_s <- 10
  as_read(plan)
}

kFivePointCuts <- c(-2, -0.7, 0.7, 2)
kCoverageRateRatio <- kPlantedClicksPerS[["tracked"]] / kPlantedClicksPerS[["random"]]
kCoverageContrastOdds <- exp(kPlantedQuality[["tracked"]] - kPlantedQuality[["random"]])

coverage_contrast <- function() {
  sd <- sqrt(0.6^2 + (kNullSlopeSd / 2)^2)
  mean_rating(kPlantedQuality[["tracked"]], sd, kFivePointCuts) -
    mean_rating(kPlantedQuality[["random"]], sd, kFivePointCuts)
}

# Participants' cell means, normal: mu_j + p_i + s_i x_j + e_ij. With slopes of 0 they are compound
# symmetric, which Cousineau's and Morey's interval and an uncorrected ANOVA assume.
kCellMeans <- c(1.8, 2.0, 2.3)
kOffsetSd <- 0.4
kCellErrorSd <- 0.25
normal_means <- function(slope_sd, participants = 20) {
  offsets <- rnorm(participants, 0, kOffsetSd)
  means <- outer(offsets, kCellMeans, `+`) +
    outer(rnorm(participants, 0, slope_sd), kDelayPlaces) +
    matrix(rnorm(participants * 3, 0, kCellErrorSd), participants)
  dimnames(means) <- list(sprintf("P%02d", seq_len(participants)), kDelaysMs)
  list(means = means, mean_offset = mean(offsets))
}

# What the estimate of generalised eta squared tends to with more participants.
generalised_truth <- function(slope_sd) {
  squares <- sum((kCellMeans - mean(kCellMeans))^2)
  squares / (squares + 3 * kOffsetSd^2 + 3 * kCellErrorSd^2 + slope_sd^2 * sum(kDelayPlaces^2))
}

# The row of anova_row for participants' `means` without afex, at a hundredth of its cost: F,
# Greenhouse and Geisser's degrees of freedom, generalised eta squared.
quick_anova_row <- function(means) {
  n <- nrow(means)
  k <- ncol(means)
  covariance <- stats::cov(means %*% qr.Q(qr(stats::contr.helmert(k))))
  epsilon <- sum(diag(covariance))^2 / ((k - 1) * sum(covariance^2))
  ss <- n * sum((colMeans(means) - mean(means))^2)
  ss_error <- (n - 1) * sum(diag(covariance))
  ss_people <- k * (n - 1) * stats::var(rowMeans(means))
  trials <- data.frame(participant = rownames(means))
  anova_row(data.frame(effect = "delay_ms", df1 = epsilon * (k - 1), df2 = epsilon * (k - 1) * (n - 1),
    F = ss / ss_error * (n - 1), p = NA, ges = ss / (ss + ss_error + ss_people), ss = ss,
    ss_error = ss_error, within = TRUE, independent = n - 1), trials)
}

# Does the difference of two cells lie as far from `truth` as their two intervals together allow:
# the root of the sum of their squared half widths?
side_of_pair <- function(rows, first, second, truth) {
  halves <- (rows$high - rows$low)[c(first, second)] / 2
  difference <- rows$mean[second] - rows$mean[first]
  side_of(truth, difference + c(-1, 1) * sqrt(sum(halves^2)))
}

# One row: sides of everything that has a closed form.
coverage_means_row <- function(seed) {
  rated <- participant_means(coverage_trials(seed), "delay_ms")
  truth <- coverage_mean_ratings()
  contrast <- contrast_means_tests(coverage_gaze_trials(seed), equivalence_margin(kFivePoints))$rows
  contrast <- contrast[contrast$effect == contrast_label(kOverall), ]
  limits <- function(family) unlist(contrast[startsWith(contrast$family, family),
    c("interval_low", "interval_high")])
  bars <- cousineau_morey(rated)
  set.seed(seed)
  even <- normal_means(slope_sd = 0)
  sloped <- normal_means(slope_sd = 0.3)
  even_bars <- cousineau_morey(even$means)
  groups <- data.frame(participant = "P01", rating = rnorm(60, kCellMeans, 0.5),
    delay_ms = factor(kDelaysMs))
  lambda <- 20 * sum((kCellMeans - mean(kCellMeans))^2) / 0.5^2
  interval_of <- function(row) c(row$interval_low, row$interval_high)
  data.frame(
    seed = seed,
    mean = side_of(truth[2], t_interval(rated[, 2])[2:3]),
    contrast = side_of(coverage_contrast(), limits(kContrastMeansFamily)),
    equivalence = side_of(coverage_contrast(), limits(kEquivalenceFamily)),
    bar_own = side_of(kCellMeans[2] + even$mean_offset, even_bars[2, c("low", "high")]),
    bar_difference = side_of_pair(even_bars, 1, 3, kCellMeans[3] - kCellMeans[1]),
    bar_population = side_of(kCellMeans[2], even_bars[2, c("low", "high")]),
    bar_sloped_100 = side_of_pair(bars, 1, 2, truth[2] - truth[1]),
    bar_sloped_300 = side_of_pair(bars, 1, 3, truth[3] - truth[1]),
    eta_between = side_of(as_eta_squared(lambda, 2, 57),
      interval_of(pooled_tests(groups, "delay_ms")$rows)),
    eta_even = side_of(generalised_truth(0), interval_of(quick_anova_row(even$means))),
    eta_sloped = side_of(generalised_truth(0.3), interval_of(quick_anova_row(sloped$means)))
  )
}

# One row: sides of the bootstrap's ratio of click rates, of 10 and of 20 participants.
coverage_bootstrap_row <- function(seed) {
  side <- function(participants) {
    trials <- coverage_gaze_trials(seed, participants)
    parts <- split(trials, droplevels(trials$scheduling))[c("tracked", "random")]
    side_of(kCoverageRateRatio, bootstrap_of_totals(parts, function(rates) rates[[1]] / rates[[2]]))
  }
  data.frame(seed = seed, ratio_10 = side(10), ratio_20 = side(20))
}

# One row: limits of the odds ratio of each delay against 0; NA where no model converged.
coverage_odds_row <- function(seed, lapse = 0) {
  trials <- coverage_trials(seed, lapse = lapse)
  trials$rating <- factor(trials$rating, ordered = TRUE)
  models <- fit_models(trials, "delay_ms", "delay_ms", tested = character())
  none <- data.frame(seed = seed, random = "none", low_100 = NA, high_100 = NA, low_300 = NA,
    high_300 = NA)
  if (!is.null(models$failure)) return(none)
  rows <- ratio_rows("delay_ms", models, trials)
  data.frame(seed = seed, random = random_part(models$attempt[["random"]]),
    low_100 = rows$interval_low[1], high_100 = rows$interval_high[1],
    low_300 = rows$interval_low[2], high_300 = rows$interval_high[2])
}

# One row: limits of the planned contrast's odds ratio and rate ratio, of 10 participants.
coverage_ratios_row <- function(seed) {
  trials <- coverage_gaze_trials(seed)
  part <- function(name, rows, family) {
    row <- rows[startsWith(rows$family, family), ]
    if (NROW(row) == 0) row <- data.frame(method = "none", interval_low = NA, interval_high = NA)
    stats::setNames(data.frame(row$method, row$interval_low, row$interval_high),
      paste0(name, c("", "_low", "_high")))
  }
  odds <- part("odds", contrast_model_tests(trials)$rows, kContrastFamily)
  rates <- part("rates", contrast_model_tests(trials, response = "clicks")$rows, kClickContrastFamily)
  odds$odds <- random_part(odds$odds)
  rates$rates <- paste(sub(" .*", "", rates$rates), random_part(rates$rates), sep = ", ")
  cbind(seed = seed, odds, rates)
}

# One row: limits of the mean gains of 10 participants whose own gains are gamma with these means and
# a coefficient of variation of .5.
kCoverageGains <- c(bad = 0.3, good = 0.1)
coverage_gains_row <- function(seed, participants = 10) {
  set.seed(seed)
  own <- function(mean) rgamma(participants, shape = 4, rate = 4 / mean)
  bad <- own(kCoverageGains[["bad"]])
  good <- own(kCoverageGains[["good"]])
  each <- do.call(rbind, lapply(seq_len(participants), function(i) {
    click_gains(record_of(clicking_participant(bad[i], good[i], 0.1)))$gains
  }))
  limits <- function(gain) as.list(t_interval(each[, gain])[c("low", "high")])
  data.frame(seed = seed, bad = limits("bad"), difference = limits("difference"))
}

# One row: limits of one participant's threshold, 110 ms, from 15 trials at each of seven delays,
# spread 45 ms, lapse .02: answers yes or no with the guess rate fitted, and two intervals.
kCoverageThresholdMs <- 110
coverage_function_row <- function(seed) {
  x <- rep(c(0, 33.333, 66.667, 100, 150, 200, 300), each = 15)
  limits <- function(guess) {
    set.seed(seed)
    trials <- data.frame(participant = "P01", condition_of = "all", x = x,
      positive = answers_at(x, kCoverageThresholdMs, 45, guess = if (is.null(guess)) 0 else guess))
    one_function(trials, guess, kBootstrapDraws)$row[c("low", "high")]
  }
  data.frame(seed = seed, yes_no = limits(NULL), two_interval = limits(0.5))
}

# One row: limits of the mean threshold of 10 participants, 56 trials at seven gaps each, log10
# thresholds N(1, .1), spread .2. `lapsed`: guesses .03 and lapses .02, as synthetic_thresholds.R
# has them, and the interval over participants beside; `pure`: neither, as the hierarchical model
# assumes.
kCoverageGapArcmin <- 10
coverage_threshold_means_row <- function(seed, participants = 10) {
  study_of <- function(guess, lapse) {
    set.seed(seed)
    plan <- shuffled_plan(participants, expand.grid(gap_arcmin = kGapLevelsArcmin,
      repetition = 1:8))
    plan$x <- log10(plan$gap_arcmin)
    own <- rnorm(participants, log10(kCoverageGapArcmin), 0.1)[factor(plan$participant)]
    plan$positive <- answers_at(plan$x, own, 0.2, guess, lapse)
    plan$condition_of <- factor("all")
    list(trials = plan, split = character(), log10 = TRUE, axis = "gap_arcmin", kind = "yes_no")
  }
  wald <- function(study) {
    rows <- hierarchical_thresholds(study)$rows
    if (is.null(rows)) return(list(low = NA, high = NA))
    list(low = rows$interval_low, high = rows$interval_high)
  }
  lapsed <- study_of(0.03, 0.02)
  means <- threshold_means(lapsed, psychometric_functions(lapsed, draws = 0)$rows)
  data.frame(seed = seed, t = means[c("low", "high")], lapsed = wald(lapsed),
    pure = wald(study_of(0, 0)))
}

# The tables: how many studies each has, and how a row is made.
kCoverageTables <- list(
  means = list(studies = 2000, row_of = coverage_means_row),
  odds = list(studies = 200, row_of = coverage_odds_row),
  ratios = list(studies = 100, row_of = coverage_ratios_row),
  bootstrap = list(studies = 400, row_of = coverage_bootstrap_row),
  gains = list(studies = 300, row_of = coverage_gains_row),
  functions = list(studies = 100, row_of = coverage_function_row),
  threshold_means = list(studies = 100, row_of = coverage_threshold_means_row)
)
