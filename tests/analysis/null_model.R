# Null studies: no delay, speed or viewpoint has an effect on the average participant, and each
# participant still has an own intercept and an own slope of delay.
#
#   eta = u_i + s_i x,  x the delay's place scaled to mean 0 and standard deviation 1,
#   u_i ~ N(0, .6),  s_i ~ N(0, .7),  cuts (-1, 1.2),  a lapse of .02 rates at random
#
# Of words, a second kind of null study: delays are kinds without an order, and what participants
# differ in is normal for each kind (.7), each speed (.5) and each cell of both (.5).
#
# Each test of delay, of the kind, and of the kind by speed is then right to reject in .05 of the studies. Whatever it does instead is a
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

# The rated trials of one null study whose levels are words.
null_words_trials <- function(seed, participants = 20) {
  set.seed(seed)
  plan <- causality_plan(participants)
  plan$kind <- factor(c("0" = "hard", "100" = "soft", "300" = "odd")[as.character(plan$delay_ms)])
  deviations <- function(sd, ...) {
    cell <- interaction(plan$participant, ...)
    rnorm(nlevels(cell), 0, sd)[cell]
  }
  plan$rating <- ordered(ratings_at(deviations(kNullInterceptSd) + deviations(0.7, plan$kind) +
    deviations(0.5, plan$speed_deg_s) + deviations(0.5, plan$kind, plan$speed_deg_s)))
  columns <- c("speed_deg_s", "viewpoint_deg")
  plan[columns] <- lapply(plan[columns], factor)
  plan
}

# One row: seed, p of the kind and of the kind by speed in the mixed models, and their random parts.
null_words_row <- function(seed) {
  trials <- null_words_trials(seed)
  factors <- c("kind", "speed_deg_s", "viewpoint_deg")
  row <- function(name, terms, tested) {
    models <- fit_models(trials, terms, tested, tested)
    found <- if (is.null(models$failure)) list(model_tests(models, trials, tested)$rows$p[1],
      random_part(models$attempt[["random"]])) else list(NA, "none")
    stats::setNames(as.data.frame(found), paste0(name, c("_p", "_random")))
  }
  interaction <- "kind:speed_deg_s"
  cbind(seed = seed, row("kind", factors, "kind"),
    row("cells", c(factors, interaction), interaction))
}

# The rate of p < .05 with its exact 95 % interval (Clopper and Pearson 1934); NA is left out.
rejection_rate <- function(p) {
  p <- p[!is.na(p)]
  test <- stats::binom.test(sum(p < 0.05), length(p))
  data.frame(studies = length(p), rejected = sum(p < 0.05), rate = mean(p < 0.05),
    interval_low = test$conf.int[1], interval_high = test$conf.int[2])
}
