# Thresholds over participants: means with intervals, differences between conditions, and beside them
# a hierarchical model of all answers.
# SPDX-License-Identifier: MIT

kThresholdFamily <- "thresholds, hierarchical model"
kThresholdAnovaFamily <- "thresholds, repeated-measures ANOVA"

# One row per condition: mean of the participants' thresholds with its 95 % t interval, in the
# factor's unit (a logarithmic scale's mean is geometric).
threshold_means <- function(study, rows) {
  rows <- rows[rows$use, ]
  cells <- split(rows, factor(rows$condition, levels(study$trials$condition_of)), drop = TRUE)
  each_row(cells, function(cell) {
    data.frame(condition = cell$condition[1], participants = nrow(cell),
      as.list(in_unit(study, t_interval(cell$threshold))), cell[1, study$split, drop = FALSE])
  })
}

# Repeated-measures ANOVA of thresholds over the factors that vary, and the hierarchical model.
threshold_tests <- function(study, rows) {
  remarks <- threshold_remarks(study, rows)
  kept <- rows[rows$use, ]
  if (participant_count(kept) < 2) {
    return(combine_outcomes(outcome(remarks = c(remarks,
      "Fewer than two participants have a threshold: no test was made."))))
  }
  anova <- if (length(study$split) > 0) threshold_anova(study, kept)
  say_progress(kHierarchicalStep)
  combine_outcomes(outcome(remarks = remarks), anova, hierarchical_thresholds(study))
}

threshold_anova <- function(study, rows) {
  rows$rating <- rows$threshold
  result <- repeated_measures_tests(rows, study$split, "a threshold")
  if (!is.null(result$rows)) {
    result$rows$family <- kThresholdAnovaFamily
    result$rows$method <- sub("cell means", if (isTRUE(study$log10)) "log₁₀ thresholds" else "thresholds",
      result$rows$method)
    rows[study$split] <- lapply(rows[study$split], droplevels)
    complete <- complete_participants(means_within(rows, within_factors(rows, study$split)))
    result$rows$trials <- sum(rows$trials[as.character(rows$participant) %in% rownames(complete)])
  }
  result
}

# Functions without a threshold, or with one outside the levels shown, by participant; bad fits.
threshold_remarks <- function(study, rows) {
  named <- function(rows) and_words(paste0(as_typed(rows$participant),
    if (length(study$split) > 0) paste0(" (", rows$condition, ")")))
  without <- rows[is.na(rows$threshold), ]
  outside <- rows[!is.na(rows$threshold) & !rows$use, ]
  poor <- sum(rows$deviance_p < kSignificance, na.rm = TRUE)
  c(
    if (nrow(without) > 0) sprintf(
      "No threshold, for the answers do not rise with %s: %s.", plain_name(study$axis), named(without)),
    if (nrow(outside) > 0) sprintf(
      "Threshold outside the levels shown, left out of means and tests: %s.", named(outside)),
    if (poor > 0) sprintf(paste("%s of %d %s worse than 19 of 20 draws from the fit would (deviance,",
      "parametric bootstrap)."), count_of(poor, "function"), sum(!is.na(rows$deviance_p)),
      if (poor == 1) "fits" else "fit")
  )
}

# Probit mixed model of all answers, without lapses: thresholds of each condition with Wald
# intervals, as an outcome. Two intervals: p = 1/2 + 1/2 Phi.
hierarchical_thresholds <- function(study) {
  trials <- study$trials
  # In standard deviations: levels of hundreds of ms make the model ill-conditioned.
  trials$centred <- (trials$x - mean(trials$x)) / stats::sd(trials$x)
  trials$condition <- droplevels(trials$condition_of)
  several <- nlevels(trials$condition) > 1
  link <- if (is.null(study$guess)) "probit" else half_probit()
  attempts <- c("(1 + centred | participant)", "(1 | participant)")
  remarks <- character()
  for (random in attempts) {
    fit <- listen_to(lme4::glmer(stats::reformulate(c("0", if (several) "condition" else "1",
      "centred", random), "positive"), trials, stats::binomial(link),
      control = lme4::glmerControl(optimizer = "bobyqa")))
    poor <- grepl("failed to converge|unidentifiable", fit$complaints)
    if (!is.null(fit$value) && !any(poor) && lme4::fixef(fit$value)[["centred"]] > 0) {
      return(outcome(hierarchical_rows(study, fit$value, trials, random),
        c(remarks, paste("The hierarchical model has no lapses, no guesses but the two intervals'",
          "and one slope for all conditions, so its thresholds differ from the functions', and its",
          "Wald intervals do not allow for that."))))
    }
    remarks <- c(remarks, sprintf("The hierarchical model with %s was not fitted: %s.", random,
      if (is.null(fit$value)) first_words(fit$complaints) else
        if (any(poor)) first_words(fit$complaints[poor]) else "answers do not rise"))
  }
  outcome(remarks = remarks)
}

hierarchical_rows <- function(study, model, trials, random) {
  beta <- lme4::fixef(model)
  covariance <- as.matrix(stats::vcov(model))
  slope <- beta[["centred"]]
  each_row(setdiff(names(beta), "centred"), function(name) {
    gradient <- c(-1 / slope, beta[[name]] / slope^2)
    unit <- stats::sd(trials$x)
    error <- unit * sqrt(drop(t(gradient) %*% covariance[c(name, "centred"), c(name, "centred")] %*%
      gradient))
    x <- mean(trials$x) - unit * beta[[name]] / slope
    limits <- in_unit(study, x + c(-1, 1) * stats::qnorm(0.975) * error)
    condition <- sub("^condition|^\\(Intercept\\)|^1$", "", name)
    test_row(kThresholdFamily, paste0("binomial mixed model, ",
      if (is.null(study$guess)) "probit" else "1/2 + 1/2 probit", ", ", random, "; Wald"),
      trimws(paste("threshold", condition)), NA, NA, NA, p = NA, size_name = name_and_unit(study$axis),
      size = in_unit(study, x), interval = limits, interval_level = 0.95,
      participants = participant_count(trials), trials = nrow(trials))
  })
}

# The link of a choice between two intervals: mean = 1/2 + 1/2 Phi(eta).
half_probit <- function() {
  structure(class = "link-glm", list(
    linkfun = function(mu) stats::qnorm(pmin(pmax(2 * mu - 1, 1e-6), 1 - 1e-6)),
    linkinv = function(eta) pmin(0.5 + stats::pnorm(eta) / 2, 1 - 1e-9),
    mu.eta = function(eta) pmax(stats::dnorm(eta) / 2, 1e-9),
    valideta = function(eta) TRUE, name = "half probit"))
}
