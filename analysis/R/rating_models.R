# Cumulative-link mixed models of ratings: the primary analysis.
#
#   rating ~ factors + (1 + slope | participant)     tried first
#   rating ~ factors + (1 | participant)             when that does not converge
#
# A likelihood-ratio test compares two models with the same random part, so the family of tests
# falls back as a whole. (Christensen 2018, package `ordinal`, Laplace approximation)
# SPDX-License-Identifier: MIT

kEffectsFamily <- "mixed model, effects"
kOddsFamily <- "mixed model, odds ratios"

# Likelihood-ratio tests of each factor and odds ratios of each level against the first, as an
# outcome. `factors`: columns of `trials`. `slope_of`: the numeric factor whose effect may differ
# between participants, or none.
mixed_model_tests <- function(trials, factors, slope_of = character()) {
  if (participant_count(trials) < 3) {
    remark <- "The mixed model needs three participants or more and was not fitted."
    return(outcome(remarks = remark))
  }
  separated <- factors[vapply(factors, function(f) separates(trials, f), logical(1))]
  if (length(separated) > 0) {
    return(outcome(remarks = paste0(
      "The levels of ", paste(separated, collapse = " and "), " separate the ratings completely, ",
      "so the mixed model has no finite odds ratio and was not fitted; see the other tests."
    )))
  }
  trials$rating <- factor(trials$rating, ordered = TRUE)
  trials[factors] <- lapply(trials[factors], droplevels)
  remarks <- character()
  if (length(slope_of) == 1) {
    trials$slope <- as.numeric(scale(as.numeric(as.character(trials[[slope_of]]))))
    models <- fit_family(trials, factors, "(1 + slope | participant)")
    if (is.null(models$failure)) return(mixed_model_outcome(models, trials, factors))
    remarks <- paste0(
      "The mixed model with a slope of ", slope_of, " for each participant did not converge (",
      models$failure, "); the one reported has a random intercept only."
    )
  }
  models <- fit_family(trials, factors, "(1 | participant)")
  if (is.null(models$failure)) return(mixed_model_outcome(models, trials, factors, remarks))
  outcome(remarks = c(remarks, paste0(
    "The mixed model with a random intercept did not converge (", models$failure,
    "), so no mixed model is reported."
  )))
}

# Do two levels of the factor share no more than a boundary? Then a coefficient has no finite
# estimate: pushing the two apart raises the likelihood for ever.
separates <- function(trials, factor) {
  lowest <- sort(tapply(trials$rating, droplevels(trials[[factor]]), min))
  highest <- tapply(trials$rating, droplevels(trials[[factor]]), max)[names(lowest)]
  apart <- outer(highest, lowest, `<=`)
  diag(apart) <- FALSE
  any(apart)
}

# The full model and, for each factor, the model without it; or list(failure = words).
fit_family <- function(trials, factors, random) {
  full <- fit_rating_model(trials, factors, random)
  if (!is.null(full$failure)) return(full)
  reduced <- lapply(factors, function(dropped) {
    fit_rating_model(trials, setdiff(factors, dropped), random, like = full$model)
  })
  names(reduced) <- factors
  for (dropped in factors) {
    model <- reduced[[dropped]]
    if (!is.null(model$failure)) return(list(failure = model$failure))
    # A model that contains another cannot be worse; 1e-3 is above the optimiser's tolerance.
    if (logLik(model$model) > logLik(full$model) + 1e-3) {
      return(list(failure = "a smaller model fitted better than one that contains it"))
    }
  }
  list(full = full$model, reduced = lapply(reduced, `[[`, "model"), random = random)
}

# One fit: list(model) or list(failure = words). `like`: a fitted model with the same random part,
# whose variances are the starting place; it is faster, and cold starts miss the optimum when the
# slope has to stand in for the fixed effect that was dropped.
fit_rating_model <- function(trials, factors, random, like = NULL) {
  formula <- stats::reformulate(c(factors, random), "rating")
  arguments <- list(formula = formula, data = trials)
  if (!is.null(like)) {
    fixed <- if (length(factors) > 0) stats::reformulate(factors, "rating") else rating ~ 1
    start <- listen_to(stats::coef(ordinal::clm(fixed, data = trials)))$value
    variances <- utils::tail(like$optRes$par, -length(c(like$alpha, like$beta)))
    # clmm wants one vector for a random intercept and a list for more.
    arguments$start <- if (length(variances) == 1) c(start, variances) else list(start, variances)
  }
  fit <- listen_to(do.call(ordinal::clmm, arguments))
  model <- fit$value
  if (is.null(model)) return(list(failure = first_words(fit$complaints)))
  variances <- listen_to(diag(stats::vcov(model)))$value
  usable <- length(variances) > 0 && all(is.finite(variances)) && all(variances > 0)
  if (usable && model$optRes$convergence == 0) return(list(model = model))
  list(failure = first_words(c(fit$complaints, "its Hessian is singular")))
}

# The first line of the first complaint, without the optimiser's code number.
first_words <- function(complaints) {
  sub("^\\([0-9-]+\\) *", "", trimws(sub("\n.*", "", complaints[1])))
}

mixed_model_outcome <- function(models, trials, factors, remarks = character()) {
  people <- participant_count(trials)
  method <- paste("cumulative-link mixed model, logit,", models$random)
  effects <- lapply(factors, function(dropped) {
    chi_squared <- max(0, 2 * as.numeric(logLik(models$full) - logLik(models$reduced[[dropped]])))
    df <- nlevels(trials[[dropped]]) - 1
    test_row(kEffectsFamily, paste0(method, "; likelihood-ratio test"), dropped, "chi-squared",
      chi_squared, df, p = stats::pchisq(chi_squared, df, lower.tail = FALSE),
      participants = people, trials = nrow(trials))
  })
  outcome(do.call(rbind, c(effects, odds_ratios(models$full, trials, factors, method))), remarks)
}

# Odds of a higher rating at each level against the first of its factor, with 95 % Wald intervals.
odds_ratios <- function(model, trials, factors, method) {
  errors <- sqrt(diag(stats::vcov(model)))
  lapply(names(model$beta), function(coefficient) {
    of <- factors[startsWith(coefficient, factors)]
    of <- of[which.max(nchar(of))]
    against <- paste0(substring(coefficient, nchar(of) + 1), " against ", levels(trials[[of]])[1])
    beta <- model$beta[[coefficient]]
    z <- beta / errors[[coefficient]]
    test_row(kOddsFamily, paste0(method, "; Wald"), paste0(of, ": ", against), "z", z, NA,
      p = 2 * stats::pnorm(-abs(z)), size_name = "odds ratio of a higher rating", size = exp(beta),
      interval = exp(beta + c(-1, 1) * stats::qnorm(0.975) * errors[[coefficient]]),
      interval_level = 0.95, participants = participant_count(trials), trials = nrow(trials))
  })
}
