# Mixed models of answers that are one of two: yes or no, the right interval or the wrong one.
#
#   positive ~ all factors + (1 + this factor | participant), binomial, logit    (lme4::glmer)
#
# As factor_models.R: each factor in a model with its own slope, an intercept alone where that does
# not converge. Beside it the same tests of participants' shares as ratings get of means.
# SPDX-License-Identifier: MIT

kAnswerFamily <- "mixed model of answers, effects"
kAnswerOddsFamily <- "mixed model of answers, odds ratios"

answer_factor_tests <- function(trials, factors, tested = factors) {
  reason <- why_no_answer_model(trials, factors)
  if (!is.null(reason)) return(outcome(remarks = reason))
  fit_each_factor(trials, tested, function(factor) {
    models <- fit_answer_family(trials, factors, factor)
    if (!is.null(models$failure)) {
      return(list(models = models, tests = outcome(remarks = models$remarks)))
    }
    list(models = models, tests = outcome(answer_rows(models, trials, factor), models$remarks))
  })
}

why_no_answer_model <- function(trials, factors) {
  if (participant_count(trials) < 3) {
    return("The mixed model of answers needs three participants or more and was not fitted.")
  }
  for (factor in factors) {
    share <- tapply(trials$positive, droplevels(trials[[factor]]), mean)
    alike <- names(share)[share %in% c(0, 1)]
    if (length(alike) == 0) next
    return(sprintf(paste("All answers at %s %s are alike, so the mixed model has no finite odds",
      "ratio and was not fitted; see the other tests."), name_and_unit(factor), and_words(alike)))
  }
  NULL
}

# list(full, reduced (by `tested`), random, remarks), or failure and remarks.
fit_answer_family <- function(trials, terms, tested, link = "logit") {
  trials$slope <- as.numeric(scale(values_of(trials[[tested]])))
  remarks <- character()
  for (random in c("(1 + slope | participant)", "(1 | participant)")) {
    full <- fit_answer_model(trials, c(terms, random), link)
    reduced <- fit_answer_model(trials, c(setdiff(terms, tested), random), link)
    failure <- c(full$failure, reduced$failure)
    if (length(failure) == 0) {
      return(list(full = full$model, reduced = stats::setNames(list(reduced$model), tested),
        random = random, remarks = remarks))
    }
    remarks <- c(remarks, sprintf("The mixed model of answers for the test of %s with %s did not converge: %s.",
      tested, random, failure[1]))
  }
  list(failure = failure[1], remarks = remarks)
}

fit_answer_model <- function(trials, terms, link) {
  fit <- listen_to(lme4::glmer(stats::reformulate(terms, "positive"), trials,
    stats::binomial(link), control = lme4::glmerControl(optimizer = "bobyqa")))
  if (is.null(fit$value)) return(list(failure = first_words(fit$complaints)))
  poor <- c(fit$value@optinfo$conv$lme4$messages, fit$complaints)
  poor <- poor[!grepl("singular", poor)]  # a variance of 0 is an estimate
  if (length(poor) > 0) return(list(failure = first_words(poor)))
  list(model = fit$value)
}

answer_rows <- function(models, trials, factor) {
  method <- paste0("binomial mixed model, logit, ", models$random)
  reduced <- models$reduced[[factor]]
  chi_squared <- max(0, 2 * as.numeric(stats::logLik(models$full) - stats::logLik(reduced)))
  df <- length(lme4::fixef(models$full)) - length(lme4::fixef(reduced))
  effect <- test_row(kAnswerFamily, paste0(method, "; likelihood-ratio test"), factor,
    "chi-squared", chi_squared, df, p = stats::pchisq(chi_squared, df, lower.tail = FALSE),
    participants = participant_count(trials), trials = nrow(trials))
  levels <- levels(droplevels(trials[[factor]]))
  odds <- lapply(levels[-1], function(level) {
    estimate <- sum_of_coefficients(lme4::fixef(models$full), as.matrix(stats::vcov(models$full)),
      paste0(factor, level))
    ratio_row(kAnswerOddsFamily, paste0(method, "; Wald"), paste0(factor, ": ", level, " against ",
      levels[1]), estimate, "odds ratio of a positive answer", trials)
  })
  do.call(rbind, c(list(effect), odds))
}

answer_checks <- function(models, trials, factor) {
  model <- models$full
  residuals <- stats::residuals(model, type = "pearson")
  c(
    sprintf("Pearson's χ² per degree of freedom %.2f", sum(residuals^2) / stats::df.residual(model)),
    sprintf("observed and fitted share at a level differ by %.3f at most", max(abs(tapply(
      stats::fitted(model) - trials$positive, droplevels(trials[[factor]]), mean)))),
    if (lme4::isSingular(model)) "a variance of the random part is estimated as 0"
  )
}
