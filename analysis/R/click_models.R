# Mixed models of how often a participant clicked.
#
#   clicks ~ factors + (random | participant) + offset(log(exposure_s))
#
# The random part and the distribution are the first of these that converge:
#   negative binomial, slope and intercept     Poisson, slope and intercept
#   negative binomial, intercept               Poisson, intercept
# The negative binomial's variance is mu + mu^2 / theta (`glmmTMB`, nbinom2; Brooks 2017); Poisson
# (`lme4`) is what is left when that package is missing, or when counts vary so little that theta
# runs away. Models that are compared have the same distribution and random part.
# SPDX-License-Identifier: MIT

kClickFamily <- "clicks, effects"
kClickRatioFamily <- "clicks, rate ratios"
kClickInteractionFamily <- "clicks, interaction"
kClickContrastFamily <- "clicks, planned contrast tracked / random"
kClickEquivalenceFamily <- "clicks, equivalence of rates"
kClickPooledFamily <- "clicks, pooled ANOVA, as in the thesis"
kRateMargin <- c(0.8, 1.25)

kCountAttempts <- list(
  c("negative-binomial", "(1 + slope | participant)"),
  c("negative-binomial", "(1 | participant)"),
  c("Poisson", "(1 + slope | participant)"),
  c("Poisson", "(1 | participant)")
)

# Likelihood-ratio tests of scheduling, bodies and their interaction, and rate ratios against the
# first level, as an outcome.
click_model_tests <- function(trials) {
  trials <- trials_with_exposure(trials)
  reason <- why_no_click_model(trials, "scheduling")
  if (!is.null(reason)) return(outcome(remarks = reason))
  factors <- varying_factors(trials, c("scheduling", "bodies"))
  fitted <- click_factor_tests(trials, factors)
  models <- fitted$models$scheduling
  if (is.null(models) || !is.null(models$failure)) return(outcome(fitted$rows, fitted$remarks))
  result <- outcome(fitted$rows, c(fitted$remarks, dispersion_remark(models)))
  if (length(factors) < 2 || has_cell_without_clicks(trials)) return(result)
  both <- fit_count_family(trials, c(factors, "scheduling:bodies"), "scheduling:bodies",
    "mixed model of clicks with interaction")
  if (!is.null(both$failure)) return(all_outcomes(result, outcome(remarks = both$remarks)))
  row <- count_effect_row(both, "scheduling:bodies", trials)
  row$family <- kClickInteractionFamily
  all_outcomes(result, outcome(row, both$remarks))
}

# Rate ratios of one kind to the other, overall and at each number of bodies, and their equivalence tests.
click_contrast_tests <- function(trials, without = "", pair = kTrackedRandom) {
  two <- contrast_trials(trials_with_exposure(trials), pair)
  reason <- why_no_click_model(two, "scheduling")
  if (!is.null(reason)) return(outcome(remarks = reason))
  fit <- function(terms, kind) fit_count_family(two, terms, character(), paste(kind, "of clicks"))
  row <- function(models, coefficients, place) {
    estimate <- sum_of_coefficients(models$full$beta, models$full$covariance, coefficients)
    method <- sprintf("%s of %s trials; Wald", count_method(models), pair_words(pair, " and "))
    label <- contrast_label(place, pair)
    ratio <- ratio_row(paste0(family_of(kClickContrastFamily, pair), without), method, label,
      estimate, "rate ratio", two)
    rbind(ratio, if (without == "") rate_equivalence_row(estimate, label, two,
      family_of(kClickEquivalenceFamily, pair)))
  }
  contrast_rows(two, c("scheduling", varying_factors(two, "bodies")), fit, row,
    has_cell_without_clicks(two))
}

# Two one-sided z tests of the log ratio against ratios of .8 and 1.25, with a 90 % interval.
rate_equivalence_row <- function(estimate, label, trials, family = kClickEquivalenceFamily) {
  above <- (estimate[["estimate"]] - log(kRateMargin[1])) / estimate[["error"]]
  below <- (estimate[["estimate"]] - log(kRateMargin[2])) / estimate[["error"]]
  p <- c(stats::pnorm(above, lower.tail = FALSE), stats::pnorm(below))
  limits <- estimate[["estimate"]] + c(-1, 1) * stats::qnorm(0.95) * estimate[["error"]]
  method <- sprintf("two one-sided z tests, margin %.2f to %.2f", kRateMargin[1], kRateMargin[2])
  test_row(family, method, label, "z", if (p[1] > p[2]) above else below, NA,
    p = max(p), size_name = "rate ratio", size = exp(estimate[["estimate"]]),
    interval = exp(limits), interval_level = 0.90, participants = participant_count(trials),
    trials = nrow(trials))
}

trials_with_exposure <- function(trials) {
  trials[!is.na(trials$exposure_s) & trials$exposure_s > 0, ]
}

why_no_click_model <- function(trials, factor) {
  if (participant_count(trials) < 3) {
    return("The models of clicks need three participants or more and were not fitted.")
  }
  clicks <- tapply(trials$clicks, trials[[factor]], sum)
  if (length(clicks) < 2 || anyNA(clicks)) {
    return("The models of clicks need trials of two kinds of scheduling and were not fitted.")
  }
  if (all(clicks > 0)) return(NULL)
  sprintf("Nobody clicked in %s, so a rate ratio has no finite estimate and was not fitted.",
    paste(names(clicks)[clicks == 0], collapse = " and "))
}

has_cell_without_clicks <- function(trials) {
  clicks <- tapply(trials$clicks, list(trials$scheduling, droplevels(trials$bodies)), sum)
  anyNA(clicks) || any(clicks == 0)
}

# The full model and, for each tested term, the model without it, by the first of kCountAttempts
# that converges for all: list(full, reduced, distribution, random, remarks), or failure and remarks.
# `slope_of`: the factor whose effect may differ between participants.
fit_count_family <- function(trials, terms, tested, kind = "mixed model of clicks",
                             slope_of = "scheduling") {
  factors <- unique(c(slope_of, unlist(strsplit(terms, ":", fixed = TRUE))))
  trials[factors] <- lapply(trials[factors], droplevels)
  trials$slope <- as.numeric(scale(values_of(trials[[slope_of]])))
  remarks <- character()
  for (attempt in kCountAttempts) {
    fit <- function(terms) fit_count_model(trials, terms, attempt[2], attempt[1])
    fits <- c(list(fit(terms)), lapply(tested, function(term) fit(setdiff(terms, term))))
    failures <- unlist(lapply(fits, `[[`, "failure"))
    if (length(failures) == 0) {
      return(list(full = fits[[1]], reduced = stats::setNames(fits[-1], tested),
        distribution = attempt[1], random = attempt[2], remarks = remarks))
    }
    remarks <- c(remarks, sprintf("The %s (%s, %s for each participant) did not converge: %s.",
      kind, attempt[1], if (grepl("slope", attempt[2])) "intercept and slope" else "intercept",
      failures[1]))
  }
  list(failure = failures[1], remarks = c(remarks, sprintf("No %s is reported.", kind)))
}

# One fit: list(beta, covariance, log_likelihood, df, theta, pearson) or list(failure = words).
fit_count_model <- function(trials, terms, random, distribution) {
  formula <- stats::reformulate(c(terms, random, "offset(log(exposure_s))"), "clicks")
  if (distribution == "Poisson") return(fit_poisson(formula, trials))
  if (!requireNamespace("glmmTMB", quietly = TRUE)) {
    return(list(failure = "the package glmmTMB is not installed"))
  }
  fit <- listen_to(glmmTMB::glmmTMB(formula, trials, family = glmmTMB::nbinom2))
  model <- fit$value
  if (is.null(model) || model$fit$convergence != 0 || !isTRUE(model$sdr$pdHess)) {
    words <- first_words(c(fit$complaints, "its Hessian is singular"))
    return(list(failure = gsub("^Model convergence problem; |[.] See vignette.*$", "", words)))
  }
  described_fit(model, glmmTMB::fixef(model)$cond, stats::vcov(model)$cond, stats::sigma(model))
}

fit_poisson <- function(formula, trials) {
  fit <- listen_to(lme4::glmer(formula, trials, family = stats::poisson,
    control = lme4::glmerControl(optimizer = "bobyqa")))
  model <- fit$value
  if (is.null(model)) return(list(failure = first_words(fit$complaints)))
  complaint <- c(model@optinfo$conv$lme4$messages, fit$complaints)
  complaint <- complaint[!grepl("singular", complaint)]  # a variance of 0 is an estimate
  if (length(complaint) > 0) return(list(failure = first_words(complaint)))
  described_fit(model, lme4::fixef(model), as.matrix(stats::vcov(model)), NA)
}

described_fit <- function(model, beta, covariance, theta) {
  if (!all(is.finite(diag(covariance))) || any(diag(covariance) <= 0)) {
    return(list(failure = "its Hessian is singular"))
  }
  likelihood <- stats::logLik(model)
  residuals <- stats::residuals(model, type = "pearson")
  list(beta = beta, covariance = covariance, log_likelihood = as.numeric(likelihood),
    df = attr(likelihood, "df"), theta = theta,
    pearson = sum(residuals^2) / stats::df.residual(model))
}

count_method <- function(models) {
  paste0(models$distribution, " mixed model, log exposure as offset, ", models$random)
}

count_effect_row <- function(models, term, trials) {
  reduced <- models$reduced[[term]]
  chi_squared <- max(0, 2 * (models$full$log_likelihood - reduced$log_likelihood))
  df <- models$full$df - reduced$df
  test_row(kClickFamily, paste0(count_method(models), "; likelihood-ratio test"), term,
    "chi-squared", chi_squared, df, p = stats::pchisq(chi_squared, df, lower.tail = FALSE),
    participants = participant_count(trials), trials = nrow(trials))
}

# How much more the counts vary than Poisson counts would.
dispersion_remark <- function(models) {
  pearson <- sprintf("Pearson's χ² per degree of freedom is %.2f", models$full$pearson)
  if (models$distribution == "Poisson") {
    return(sprintf("The model of clicks is a Poisson one; %s (1 for Poisson counts).", pearson))
  }
  sprintf("The model of clicks is a negative-binomial one: variance μ + μ²/θ, θ = %.2f; %s.",
    models$full$theta, pearson)
}
