# Null studies: no delay, speed or viewpoint has an effect on the average participant, and each
# participant still has an own intercept and an own slope of delay.
#
#   eta = u_i + s_i x,  x the delay's place scaled to mean 0 and standard deviation 1,
#   u_i ~ N(0, .6),  s_i ~ N(0, .7),  cuts (-1, 1.2),  a lapse of .02 rates at random
#
# Each test of delay is then right to reject in .05 of the studies. Whatever it does instead is a
# finding about the test and never a reason for other seeds.
# SPDX-License-Identifier: MIT

kNullInterceptSd <- 0.6
kNullSlopeSd <- 0.7

# The rated trials of one null study, 20 participants x 81 trials, from its seed.
null_trials <- function(seed, participants = 20, slope_sd = kNullSlopeSd) {
  set.seed(seed)
  plan <- causality_plan(participants)
  person <- factor(plan$participant)
  x <- (plan$delay_ms - mean(kDelaysMs)) / sqrt(mean((kDelaysMs - mean(kDelaysMs))^2))
  plan$rating <- ratings_at(rnorm(nlevels(person), 0, kNullInterceptSd)[person] +
    rnorm(nlevels(person), 0, slope_sd)[person] * x)
  columns <- c("delay_ms", "speed_deg_s", "viewpoint_deg")
  plan[columns] <- lapply(plan[columns], factor)
  plan
}

# One row: seed, p of the ANOVA on participants' means and of the pooled one over trials.
null_means_row <- function(seed) {
  trials <- null_trials(seed)
  pooled <- stats::anova(stats::lm(rating ~ delay_ms, trials))
  data.frame(seed = seed, anova_p = greenhouse_geisser_p(participant_means(trials, "delay_ms")),
    pooled_p = pooled[["Pr(>F)"]][1])
}

# One row: seed, p of delay in the mixed model as the analysis fits it, and the random part that
# converged; NA where none did.
null_mixed_row <- function(seed) {
  trials <- null_trials(seed)
  trials$rating <- factor(trials$rating, ordered = TRUE)
  factors <- c("delay_ms", "speed_deg_s", "viewpoint_deg")
  models <- fit_models(trials, factors, "delay_ms", tested = "delay_ms")
  if (!is.null(models$failure)) return(data.frame(seed = seed, mixed_p = NA, random = "none"))
  tests <- model_tests(models, trials, "delay_ms")$rows
  data.frame(seed = seed, mixed_p = tests$p[tests$family == kEffectsFamily],
    random = random_part(models$attempt[["random"]]))
}

# The rate of p < .05 with its exact 95 % interval (Clopper and Pearson 1934); NA is left out.
rejection_rate <- function(p) {
  p <- p[!is.na(p)]
  test <- stats::binom.test(sum(p < 0.05), length(p))
  data.frame(studies = length(p), rejected = sum(p < 0.05), rate = mean(p < 0.05),
    interval_low = test$conf.int[1], interval_high = test$conf.int[2])
}
