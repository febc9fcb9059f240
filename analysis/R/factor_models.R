# Mixed models for a design of any factors: each factor is tested in a model of its own in which its
# effect may differ between participants, beside all other factors as fixed effects.
#
#   response ~ all factors + (1 + this factor | participant)     tried first
#   response ~ all factors + (1 | participant)                   when that does not converge
#
# A test of a factor without its slope takes differences between participants for an effect of it
# (Barr 2013): no factor is the one of interest here, so each gets its slope. A slope runs over the
# numbers of a factor, or over 1, 2, 3 where its levels are words.
# SPDX-License-Identifier: MIT

# Ratings: likelihood-ratio tests and odds ratios of each factor, as an outcome with `models` (by
# factor) and `trials` as they were fitted. `tested`: those of the factors that are. `interactions`:
# "a:b" of two factors, tested beside, with a slope of the first factor.
rating_factor_tests <- function(trials, factors, tested = factors, interactions = character()) {
  reason <- why_no_mixed_model(trials, factors)
  if (!is.null(reason)) return(outcome(remarks = reason))
  trials$rating <- factor(trials$rating, ordered = TRUE)
  trials[factors] <- lapply(trials[factors], droplevels)
  fitted <- fit_each_factor(trials, tested, function(factor) {
    models <- fit_family_or_fall_back(trials, factors, factor, tested = factor,
      kind = paste("mixed model for the test of", factor))
    list(models = models, tests = mixed_model_outcome(models, trials, factor))
  })
  if (length(interactions) == 0) return(fitted)
  beside <- interaction_tests(trials, factors, factors[1], interactions)
  c(all_outcomes(fitted, beside), fitted[c("models", "trials")])
}

# Clicks: the same with counts; rate ratios.
click_factor_tests <- function(trials, factors, tested = factors) {
  known <- trials_with_exposure(trials)
  reason <- why_no_factor_of_clicks(known, factors)
  if (!is.null(reason)) return(outcome(remarks = reason))
  fit_each_factor(known, tested, function(factor) {
    models <- fit_count_family(known, factors, factor, paste("mixed model of clicks, for the test of",
      factor), slope_of = factor)
    if (!is.null(models$failure)) return(list(models = models, tests = outcome(remarks = models$remarks)))
    ratios <- lapply(levels(droplevels(known[[factor]]))[-1], function(level) {
      estimate <- sum_of_coefficients(models$full$beta, models$full$covariance, paste0(factor, level))
      ratio_row(kClickRatioFamily, paste0(count_method(models), "; Wald"),
        paste0(factor, ": ", level, " against ", levels(droplevels(known[[factor]]))[1]), estimate,
        "rate ratio", known)
    })
    rows <- do.call(rbind, c(list(count_effect_row(models, factor, known)), ratios))
    list(models = models, tests = outcome(rows, models$remarks))
  })
}

why_no_factor_of_clicks <- function(trials, factors) {
  if (participant_count(trials) < 3) {
    return("The models of clicks need three participants or more and were not fitted.")
  }
  for (factor in factors) {
    clicks <- tapply(trials$clicks, droplevels(trials[[factor]]), sum)
    if (all(clicks > 0)) next
    return(sprintf("Nobody clicked at %s %s, so a rate ratio has no finite estimate and no model was fitted.",
      name_and_unit(factor), and_words(names(clicks)[clicks == 0])))
  }
  NULL
}

# `fit(factor)`: list(models, tests). All tests as one outcome, with models.
fit_each_factor <- function(trials, factors, fit) {
  fits <- stats::setNames(lapply(factors, function(factor) {
    say_progress(model_step(factor))
    fit(factor)
  }), factors)
  result <- do.call(all_outcomes, unname(lapply(fits, `[[`, "tests")))
  c(result, list(models = lapply(fits, `[[`, "models"), trials = trials))
}

# One row for each factor's model: what its random part came out as, and how well it holds.
# `checks_of(model, trials)`: sentences.
model_diagnostics <- function(fitted, checks_of) {
  rows <- lapply(names(fitted$models), function(factor) {
    models <- fitted$models[[factor]]
    if (!is.null(models$failure)) {
      return(data.frame(factor = factor, random = "none converged", spread = NA, checks =
        models$failure))
    }
    data.frame(factor = factor, random = models$random, spread = spread_words(models$full),
      checks = paste(checks_of(models, fitted$trials, factor), collapse = "; "))
  })
  do.call(rbind, rows)
}

# "intercept 0.61, slope 0.70": standard deviations over participants.
spread_words <- function(model) {
  deviations <- if (inherits(model, "merMod")) attr(lme4::VarCorr(model)$participant, "stddev") else
    model$deviations
  if (is.null(deviations)) return(NA_character_)
  paste(ifelse(names(deviations) == "slope", "slope", "intercept"), sprintf("%.2f", deviations),
    collapse = ", ")
}

# Of a cumulative-link mixed model: the optimiser, the fit to each level, and proportional odds.
rating_checks <- function(models, trials, factor) {
  model <- models$full
  values <- eigen(model$Hessian, symmetric = TRUE, only.values = TRUE)$values
  c(
    sprintf("largest gradient %s", format(signif(max(abs(model$gradient)), 2))),
    sprintf("condition number of the Hessian %s", format_number(round(max(values) / min(values)))),
    sprintf("observed and fitted share of a rating at a level differ by %.3f at most",
      largest_misfit(model, trials, factor)),
    proportional_odds_words(trials, factor)
  )
}

# The largest difference between the observed and the fitted share of any rating at any level.
largest_misfit <- function(model, trials, factor) {
  below <- stats::plogis(outer(-model$eta, c(-Inf, model$alpha, Inf), `+`))
  shares <- below[, -1, drop = FALSE] - below[, -ncol(below), drop = FALSE]
  observed <- outer(as.integer(trials$rating), seq_len(ncol(shares)), `==`) + 0
  max(abs(rowsum(shares - observed, trials[[factor]]) / as.vector(table(trials[[factor]]))))
}

# Likelihood ratio of a model without the assumption, for this factor; trials as if independent.
proportional_odds_words <- function(trials, factor) {
  of <- stats::reformulate(factor)
  fits <- listen_to(list(
    alike = ordinal::clm(stats::update(of, rating ~ .), data = trials),
    apart = ordinal::clm(rating ~ 1, nominal = of, data = trials)))$value
  statistic <- if (is.null(fits)) NA else
    2 * as.numeric(stats::logLik(fits$apart) - stats::logLik(fits$alike))
  if (is.na(statistic)) return("proportional odds: could not be tested")
  df <- length(stats::coef(fits$apart)) - length(stats::coef(fits$alike))
  if (df == 0) return("proportional odds: nothing to test with two ratings in use")
  sprintf("proportional odds (over trials): χ²(%d) = %.1f, %s", df, max(0, statistic),
    p_words(stats::pchisq(max(0, statistic), df, lower.tail = FALSE)))
}

click_checks <- function(models, trials, factor) {
  c(sub("[.]$", "", dispersion_remark(models)),
    sprintf("log likelihood %.1f", models$full$log_likelihood))
}
