# Mixed models of ratings, answers and clicks: one way to fit them, to fall back and to test.
#
#   response ~ terms + (1 + slope | participant)     tried first
#   response ~ terms + (1 | participant)             when that does not converge
#
# Each factor is tested in a model of its own, with its own slope, beside all other factors as fixed
# effects: a test of a factor without its slope takes differences between participants for an effect
# of it (Barr 2013). A factor between participants, of which each has one level, has no slope. A slope
# runs over the numbers of a factor, or over 1, 2, 3 where its levels are words: the test of such a
# factor depends on their order, and rejects too often where participants differ in another one. A
# likelihood-ratio test compares two models with the same random part and distribution, so models that
# are compared fall back together. What a response adds is in response_models.R.
# SPDX-License-Identifier: MIT

# The full model and, for each tested term, the model without it, by the first of the response's
# attempts that converges for all: list(full, reduced, attempt, response, remarks), or failure and
# remarks. `slope_of`: the factor whose effect may differ between participants, or none.
fit_models <- function(trials, terms, slope_of, tested = terms, response = "rating",
                       kind = "mixed model") {
  of <- response_model(response)
  attempts <- of$attempts
  columns <- Filter(function(name) is.factor(trials[[name]]),
    unique(c(slope_of, unlist(strsplit(terms, ":", fixed = TRUE)))))
  trials[columns] <- lapply(trials[columns], droplevels)
  if (length(slope_of) == 1) trials$slope <- slope_values(trials[[slope_of]]) else
    attempts <- Filter(function(attempt) !has_slope(attempt[["random"]]), attempts)
  remarks <- character()
  for (attempt in attempts) {
    full <- of$fit(trials, terms, attempt, NULL)
    fits <- c(list(full), if (is.null(full$failure)) lapply(tested, function(term) {
      of$fit(trials, setdiff(terms, term), attempt, full)
    }))
    failure <- unlist(lapply(fits, `[[`, "failure"))[1]
    if (is.null(failure)) {
      return(list(full = full, reduced = stats::setNames(fits[-1], tested), attempt = attempt,
        response = response, remarks = remarks))
    }
    remarks <- c(remarks, sprintf("The %s (%s%s for each participant) did not converge: %s.", kind,
      if (is.na(attempt["distribution"])) "" else paste0(attempt[["distribution"]], ", "),
      random_part(attempt[["random"]]), failure))
  }
  list(failure = failure, remarks = c(remarks, sprintf("No %s is reported.", kind)))
}

has_slope <- function(words) grepl("slope", words)

random_part <- function(words) if (has_slope(words)) "intercept and slope" else "intercept"

# A factor's levels as numbers, words as 1, 2, 3 in their order, numbers as they are; standardised.
slope_values <- function(x) {
  as.numeric(scale(if (is.factor(x)) position_of(levels(x))[x] else x))
}

# The rows of a fitted family: a likelihood-ratio test of each tested term, then its ratios.
# `families`: of the effects and of the ratios, NA for none; `kind`: what the method calls a model.
model_tests <- function(models, trials, tested, kind = "mixed model",
                        families = unlist(response_model(models$response)[c("effects", "ratios")])) {
  if (!is.null(models$failure)) return(outcome(remarks = models$remarks))
  method <- model_method(models, kind)
  effects <- each_row(tested, function(term) {
    reduced <- models$reduced[[term]]
    chi_squared <- max(0, 2 * (models$full$log_likelihood - reduced$log_likelihood))
    df <- models$full$df - reduced$df
    test_row(families[[1]], paste0(method, "; likelihood-ratio test"), term, "chi-squared",
      chi_squared, df, p = stats::pchisq(chi_squared, df, lower.tail = FALSE),
      participants = participant_count(trials), trials = nrow(trials))
  })
  ratios <- if (!is.na(families[[2]])) each_row(tested, ratio_rows, models, trials, families[[2]],
    kind)
  outcome(rbind(effects, ratios), models$remarks)
}

model_method <- function(models, kind = "mixed model") {
  response_model(models$response)$method(kind, models$attempt)
}

# exp(coefficient), with 95 % Wald intervals: at each level of a factor against its first; per unit
# of a number; for an interaction "a:b", how many times larger the ratio of a level of a is at a
# level of b than at b's first.
ratio_rows <- function(term, models, trials, family = response_model(models$response)$ratios,
                       kind = "mixed model") {
  columns <- strsplit(term, ":", fixed = TRUE)[[1]]
  above_first <- lapply(trials[columns], function(x) if (is.factor(x)) levels(x)[-1] else "")
  cells <- expand.grid(above_first, stringsAsFactors = FALSE)
  each_row(seq_len(nrow(cells)), function(i) {
    cell <- unlist(cells[i, , drop = FALSE])
    ratio_row(family, paste0(model_method(models, kind), "; Wald"),
      paste0(term, ": ", against_first(trials, cell)),
      sum_of_coefficients(models$full, paste0(columns, cell, collapse = ":")),
      if (length(columns) > 1) "ratio of odds ratios" else response_model(models$response)$size,
      trials)
  })
}

# "100 against 0", "4 × 85 against 0 × 0", "per unit". `cell`: levels named by their columns.
against_first <- function(trials, cell) {
  if (!is.factor(trials[[names(cell)[1]]])) return("per unit")
  firsts <- vapply(trials[names(cell)], function(x) levels(x)[1], "")
  paste(paste(cell, collapse = " × "), "against", paste(firsts, collapse = " × "))
}

# c(estimate, error) of the sum of the named coefficients.
sum_of_coefficients <- function(model, names) {
  c(estimate = sum(model$beta[names]), error = sqrt(sum(model$covariance[names, names])))
}

# A row for exp(estimate) with its 95 % Wald interval.
ratio_row <- function(family, method, effect, estimate, size_name, trials) {
  z <- estimate[["estimate"]] / estimate[["error"]]
  limits <- estimate[["estimate"]] + c(-1, 1) * stats::qnorm(0.975) * estimate[["error"]]
  test_row(family, method, effect, "z", z, NA, p = 2 * stats::pnorm(-abs(z)),
    size_name = size_name, size = exp(estimate[["estimate"]]), interval = exp(limits),
    interval_level = 0.95, participants = participant_count(trials), trials = nrow(trials))
}

# Likelihood-ratio tests and ratios of each tested factor, as an outcome with `models` (by factor)
# and `trials` as they were fitted. `interactions`: "a:b" of two factors, of ratings, tested beside
# with a slope of the first factor.
factor_tests <- function(trials, factors, response = "rating", tested = factors,
                         interactions = character()) {
  of <- response_model(response)
  if (response == "clicks") trials <- trials_with_exposure(trials)
  trials[factors] <- lapply(trials[factors], droplevels)
  reason <- why_no_model(trials, factors, response)
  if (!is.null(reason)) return(outcome(remarks = reason))
  if (response == "rating") trials$rating <- factor(trials$rating, ordered = TRUE)
  models <- lapply(stats::setNames(nm = tested), function(factor) {
    say_progress(model_step(factor))
    fit_models(trials, factors, within_factors(trials, factor), factor, response,
      paste(of$kind, "for the test of", factor))
  })
  tests <- do.call(all_outcomes, unname(Map(function(fitted, factor) {
    model_tests(fitted, trials, factor)
  }, models, tested)))
  if (length(interactions) > 0) {
    tests <- all_outcomes(tests, interaction_tests(trials, factors,
      utils::head(within_factors(trials, factors), 1), interactions))
  }
  c(tests, list(models = models, trials = trials))
}

# Likelihood-ratio tests of each interaction of ratings, "a:b" of two factors, and ratios of odds
# ratios, as an outcome. `slope_of`: the factor whose effect may differ between participants, or none.
interaction_tests <- function(trials, factors, slope_of, interactions) {
  endless <- Filter(function(interaction) has_one_sided_cell(trials, interaction), interactions)
  if (length(endless) > 0) {
    return(outcome(remarks = sprintf(paste(
      "In a cell of %s there is no rating or only the lowest or the highest, so the mixed model",
      "with interactions has no finite estimate and was not fitted."
    ), paste(gsub(":", " × ", endless), collapse = " and of "))))
  }
  say_progress("fitting the mixed models with interactions ...")
  kind <- "mixed model with interactions"
  models <- fit_models(trials, c(factors, interactions), slope_of, interactions, kind = kind)
  model_tests(models, trials, interactions, kind, c(kInteractionFamily, kInteractionOddsFamily))
}

# Is there a cell of the interaction "a:b" that an estimate would push to infinity?
has_one_sided_cell <- function(trials, interaction) {
  cells <- split(as.integer(trials$rating), trials[strsplit(interaction, ":", fixed = TRUE)[[1]]])
  ends <- range(as.integer(trials$rating))
  any(vapply(cells, function(cell) all(cell == ends[1]) || all(cell == ends[2]), NA))
}

# One row for each factor's model: what its random part came out as, and how well it holds.
model_diagnostics <- function(fitted, response) {
  each_row(names(fitted$models), function(factor) {
    models <- fitted$models[[factor]]
    if (!is.null(models$failure)) {
      return(data.frame(factor = factor, random = "none converged", spread = NA,
        checks = models$failure))
    }
    spread <- models$full$deviations
    data.frame(factor = factor, random = models$attempt[["random"]],
      spread = if (is.null(spread)) NA_character_ else paste(
        ifelse(names(spread) == "slope", "slope", "intercept"), sprintf("%.2f", spread),
        collapse = ", "),
      checks = paste(response_model(response)$checks(models, fitted$trials, factor),
        collapse = "; "))
  })
}
