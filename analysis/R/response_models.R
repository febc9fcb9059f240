# What is particular to the mixed model of each response.
#
#   ratings  cumulative-link, logit       cumulative_link.R
#   answers  binomial, logit              lme4::glmer
#   clicks   negative binomial with the log of the exposure as offset (`glmmTMB`, nbinom2; its
#            variance is mu + mu^2 / theta; Brooks 2017); Poisson (`lme4`) where that package is
#            missing, or counts vary so little that theta runs away
#
# Every fit is list(beta, covariance, log_likelihood, df, ...) or list(failure = words).
# SPDX-License-Identifier: MIT

kEffectsFamily <- "mixed model, effects"
kOddsFamily <- "mixed model, odds ratios"
kInteractionFamily <- "mixed model, interactions"
kInteractionOddsFamily <- "mixed model, ratios of odds ratios"
kAnswerFamily <- "mixed model of answers, effects"
kAnswerOddsFamily <- "mixed model of answers, odds ratios"
kClickFamily <- "clicks, effects"
kClickRatioFamily <- "clicks, rate ratios"
kClickInteractionFamily <- "clicks, interaction"

# How a response's models are fitted, with which distributions in turn, what their tests are called
# and in which words; `endless(trials, factor)`: why a ratio has no finite estimate, or NULL; `checks`: sentences.
response_model <- function(response) {
  switch(response,
    rating = list(effects = kEffectsFamily, ratios = kOddsFamily,
      interactions = kInteractionFamily, interaction_ratios = kInteractionOddsFamily, kind = "mixed model",
      model = "cumulative-link mixed model", noun = "ratings",
      size = "odds ratio of a higher rating",
      method = function(kind, attempt) {
        sprintf("cumulative-link %s, logit, %s", kind, attempt[["random"]])
      }, distributions = NA, endless = endless_rating, checks = rating_checks,
      fit = function(trials, terms, attempt, like) {
        fit_rating_model(trials, terms, attempt[["random"]], like = like)
      }),
    answer = list(effects = kAnswerFamily, ratios = kAnswerOddsFamily,
      kind = "mixed model of answers", model = "binomial mixed model", noun = "answers",
      size = "odds ratio of a positive answer",
      method = function(kind, attempt) sprintf("binomial %s, logit, %s", kind, attempt[["random"]]),
      distributions = NA, endless = endless_answer, checks = answer_checks,
      fit = function(trials, terms, attempt, like) {
        fit_answer_model(trials, terms, attempt[["random"]])
      }),
    clicks = list(effects = kClickFamily, ratios = kClickRatioFamily,
      interactions = kClickInteractionFamily, interaction_ratios = NA,
      kind = "mixed model of clicks", model = "mixed model of clicks", noun = "clicks",
      size = "rate ratio",
      method = function(kind, attempt) sprintf("%s %s, log exposure as offset, %s",
        attempt[["distribution"]], kind, attempt[["random"]]),
      distributions = c("negative-binomial", "Poisson"),
      endless = endless_count, checks = click_checks,
      fit = function(trials, terms, attempt, like) {
        fit_count_model(trials, terms, attempt[["random"]], attempt[["distribution"]])
      }))
}

# Why the mixed model of a response, of these factors, is not fitted, in a sentence; NULL where it can
# be. `kind`: what it would be called.
why_no_model <- function(trials, factors, response, kind = response_model(response)$kind) {
  if (participant_count(trials) < 3) {
    return(sprintf("The %s needs three participants or more and was not fitted.", kind))
  }
  unlist(lapply(factors, function(factor) {
    endless <- response_model(response)$endless(trials, factor)
    if (!is.null(endless)) sprintf(paste("%s, so the %s has no finite ratio and was not fitted; see",
      "the other tests."), endless, kind)
  }))[1]
}

# What would push a ratio of this factor to infinity, or NULL.
endless_rating <- function(trials, factor) {
  if (separates(trials, factor)) {
    sprintf("The levels of %s separate the ratings completely", factor)
  }
}

endless_answer <- function(trials, factor) {
  share <- tapply(trials$positive, trials[[factor]], mean)
  alike <- names(share)[share %in% c(0, 1)]
  if (length(alike) > 0) {
    sprintf("All answers at %s %s are alike", name_and_unit(factor), and_words(alike))
  }
}

endless_count <- function(trials, factor) {
  clicks <- tapply(trials$clicks, trials[[factor]], sum)
  if (length(clicks) < 2 || anyNA(clicks)) {
    return(sprintf("There are no trials of two kinds of %s", name_and_unit(factor)))
  }
  if (any(clicks == 0)) {
    sprintf("Nobody clicked at %s %s", name_and_unit(factor), and_words(names(clicks)[clicks == 0]))
  }
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

# One fit of ratings. `like`: a fitted model with the same random part that has more terms; its
# spread is the starting place: cold starts miss the optimum when the slope has to stand in for the
# fixed effect that was dropped.
fit_rating_model <- function(trials, factors, random, like = NULL, link = "logit") {
  fixed <- if (length(factors) > 0) stats::reformulate(factors, "rating") else rating ~ 1
  design <- stats::model.matrix(fixed, trials)[, -1, drop = FALSE]
  start <- listen_to(stats::coef(ordinal::clm(fixed, data = trials, link = link)))
  if (is.null(start$value) || anyNA(start$value)) {
    return(list(failure = first_words(c(start$complaints, "its factors cannot be told apart"))))
  }
  effects <- random_effects(trials, random)
  model <- fit_cumulative_link(as.integer(droplevels(trials$rating)), design,
    as.integer(factor(trials$participant)), effects, link, start$value,
    if (is.null(like)) cold_spread(effects) else like$spread)
  # A model that contains another cannot be worse; 1e-3 is above the optimiser's tolerance.
  if (isTRUE(model$log_likelihood > like$log_likelihood + 1e-3)) {
    return(list(failure = "a smaller model fitted better than one that contains it"))
  }
  model
}

# Half a logit of all that deviates for itself; an intercept and a slope do not go together.
cold_spread <- function(effects) {
  vapply(effects$places, function(place) if (all(place[, 1] == place[, 2])) 0.5 else 0, 0)
}

fit_answer_model <- function(trials, terms, random, link = "logit") {
  fit_glmer(stats::reformulate(c(terms, random), "positive"), trials, stats::binomial(link))
}

# One fit of clicks; adds theta of the negative binomial.
fit_count_model <- function(trials, terms, random, distribution) {
  formula <- stats::reformulate(c(terms, random, "offset(log(exposure_s))"), "clicks")
  if (distribution == "Poisson") return(fit_glmer(formula, trials, stats::poisson()))
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

fit_glmer <- function(formula, trials, family) {
  fit <- listen_to(lme4::glmer(formula, trials, family,
    control = lme4::glmerControl(optimizer = "bobyqa")))
  model <- fit$value
  if (is.null(model)) return(list(failure = first_words(fit$complaints)))
  complaints <- c(model@optinfo$conv$lme4$messages, fit$complaints)
  complaints <- complaints[!grepl("singular", complaints)]  # a variance of 0 is an estimate
  if (length(complaints) > 0) return(list(failure = first_words(complaints)))
  described_fit(model, lme4::fixef(model), as.matrix(stats::vcov(model)))
}

# The first line of the first complaint, without the optimiser's code number.
first_words <- function(complaints) {
  sub("^\\([0-9-]+\\) *", "", trimws(sub("\n.*", "", complaints[1])))
}

described_fit <- function(model, beta, covariance, theta = NA) {
  if (!all(is.finite(diag(covariance))) || any(diag(covariance) <= 0)) {
    return(list(failure = "its Hessian is singular"))
  }
  likelihood <- stats::logLik(model)
  residuals <- stats::residuals(model, type = "pearson")
  binomial <- stats::family(model)$family == "binomial"
  list(beta = beta, covariance = covariance, log_likelihood = as.numeric(likelihood),
    df = attr(likelihood, "df"), theta = theta,
    pearson = sum(residuals^2) / stats::df.residual(model), model = if (binomial) model,
    deviations = if (binomial) lme4_deviations(model))
}

lme4_deviations <- function(model) {
  found <- as.data.frame(lme4::VarCorr(model))
  found <- found[is.na(found$var2), ]
  of <- gsub(":", " × ", sub("^participant:", "", found$grp))
  stats::setNames(found$sdcor, ifelse(found$var1 == "slope", "slope",
    ifelse(of == "participant", "intercept", of)))
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
    proportional_odds_words(trials, factor))
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

answer_checks <- function(models, trials, factor) {
  model <- models$full$model
  c(
    sprintf("Pearson's χ² per degree of freedom %.2f", models$full$pearson),
    sprintf("observed and fitted share at a level differ by %.3f at most", max(abs(tapply(
      stats::fitted(model) - trials$positive, trials[[factor]], mean)))),
    if (lme4::isSingular(model)) paste("the random part is at the end of what it can be: a variance",
      "of 0, or a correlation of ±1"))
}

click_checks <- function(models, trials, factor) {
  c(sub("[.]$", "", dispersion_remark(models)),
    sprintf("log likelihood %.1f", models$full$log_likelihood))
}

# How much more the counts vary than Poisson counts would.
dispersion_remark <- function(models) {
  pearson <- sprintf("Pearson's χ² per degree of freedom is %.2f", models$full$pearson)
  if (models$attempt[["distribution"]] == "Poisson") {
    return(sprintf("The model of clicks is a Poisson one; %s (1 for Poisson counts).", pearson))
  }
  sprintf("The model of clicks is a negative-binomial one: variance μ + μ²/θ, θ = %.2f; %s.",
    models$full$theta, pearson)
}
