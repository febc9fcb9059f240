# Mixed models of ratings, answers and clicks: one way to fit them, to fall back and to test.
#
#   what is tested                 effects that participants differ in, beside their intercepts
#   a factor of numbers, or of     its slope
#     two levels
#   a factor of words              each level:  (1 | participant:a)
#   an interaction of a and b      each level and each cell:  (1 | participant:a) +
#                                  (1 | participant:b) + (1 | participant:a:b)
#   a factor between participants  none: each has one level of it
#
# Each factor and each interaction is tested in a model of its own, with these, beside all other
# factors as fixed effects: a test without them takes differences between participants for an effect
# (Barr 2013). Where that does not converge, (1 | participant:a:b) alone of an interaction, and then
# (1 | participant) alone is tried. A likelihood-ratio test compares two models with the same random
# part and distribution, so models that are compared fall back together. What a response adds is in
# response_models.R.
# SPDX-License-Identifier: MIT

# The full model and, for each tested term, the model without it, by the first of the response's
# attempts that converges for all: list(full, reduced, attempt, response, remarks), or failure and
# remarks. `differing`: the factor or the interaction "a:b" whose effect may differ between
# participants, or none.
fit_models <- function(trials, terms, differing, tested = terms, response = "rating",
                       kind = "mixed model") {
  of <- response_model(response)
  columns <- Filter(function(name) is.factor(trials[[name]]),
    unique(unlist(strsplit(c(differing, terms), ":", fixed = TRUE))))
  trials[columns] <- lapply(trials[columns], droplevels)
  random <- random_parts(trials, differing)
  if (has_slope(random[1])) trials$slope <- slope_values(trials[[differing]])
  remarks <- character()
  # Every random part with the first distribution, then with the next.
  attempts <- expand.grid(random = random, distribution = of$distributions, stringsAsFactors = FALSE)
  for (i in seq_len(nrow(attempts))) {
    attempt <- unlist(attempts[i, ])
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

# The random parts to be tried for a test of `differing`, the fullest first.
random_parts <- function(trials, differing) {
  columns <- Filter(function(column) {
    !is.factor(trials[[column]]) || length(between_factors(trials, column)) == 0
  }, as.character(unlist(strsplit(differing, ":", fixed = TRUE))))
  in_words <- function(terms) paste(sprintf("(1 | %s)", terms), collapse = " + ")
  within <- paste0("participant:", columns)
  c(if (length(columns) == 2) c(
      in_words(c("participant", within, paste0(within[1], ":", columns[2]))),
      in_words(c("participant", paste0(within[1], ":", columns[2])))),
    if (length(columns) == 1) if (length(differing) == 1 && has_many_words(trials[[columns]]))
      in_words(c("participant", within)) else "(1 + slope | participant)",
    "(1 | participant)")
}

# Are there three levels or more, which are no numbers?
has_many_words <- function(x) {
  is.factor(x) && nlevels(x) > 2 && anyNA(suppressWarnings(as.numeric(levels(x))))
}

has_slope <- function(words) grepl("slope", words)

# "intercept and slope": what a random part says that participants differ in.
random_part <- function(words) {
  if (has_slope(words)) return("intercept and slope")
  sizes <- lengths(random_terms(words))
  and_words(c("intercept", if (any(sizes == 1)) "levels", if (any(sizes == 2)) "cells"))
}

# A factor's numbers, or 1 and 2 for two words; standardised.
slope_values <- function(x) {
  if (!is.factor(x)) return(as.numeric(scale(x)))
  number <- suppressWarnings(as.numeric(levels(x)))
  as.numeric(scale((if (anyNA(number)) seq_along(number) else number)[x]))
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
# and `trials` as they were fitted. `interactions`: "a:b" of two factors, of ratings or clicks, tested beside.
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
    fit_models(trials, factors, factor, factor, response,
      paste(of$kind, "for the test of", factor))
  })
  tests <- do.call(all_outcomes, unname(Map(function(fitted, factor) {
    model_tests(fitted, trials, factor)
  }, models, tested)))
  if (length(interactions) > 0) {
    tests <- all_outcomes(tests, interaction_tests(trials, factors, interactions, response))
  }
  c(tests, list(models = models, trials = trials))
}

# Likelihood-ratio tests of each interaction, "a:b" of two factors, among all of them, and of ratings
# ratios of odds ratios, as an outcome.
interaction_tests <- function(trials, factors, interactions, response = "rating") {
  of <- response_model(response)
  endless <- Filter(function(interaction) has_endless_cell(trials, interaction, response), interactions)
  if (length(endless) > 0) {
    return(outcome(remarks = sprintf(paste(
      "In a cell of %s there is no %s, so the %s with interactions has no finite estimate and was not",
      "fitted."), paste(gsub(":", " × ", endless), collapse = " and of "),
      if (response == "clicks") "click" else "rating or only the lowest or the highest", of$kind)))
  }
  # In this order R calls the coefficients of an interaction as it is called here.
  factors <- unique(c(unlist(strsplit(interactions, ":", fixed = TRUE)), factors))
  do.call(all_outcomes, lapply(interactions, function(interaction) {
    say_progress(model_step(gsub(":", " × ", interaction)))
    kind <- paste(of$kind, "with interactions")
    models <- fit_models(trials, c(factors, interactions), interaction, interaction, response,
      paste(kind, "for the test of", gsub(":", " × ", interaction)))
    model_tests(models, trials, interaction, kind, c(of$interactions, of$interaction_ratios))
  }))
}

# Is there a cell of the interaction "a:b" that an estimate would push to infinity?
has_endless_cell <- function(trials, interaction, response = "rating") {
  of <- droplevels(trials[strsplit(interaction, ":", fixed = TRUE)[[1]]])
  if (response == "clicks") return(any(vapply(split(trials$clicks, of), sum, 0) == 0))
  cells <- split(as.integer(trials$rating), of)
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
        names(spread), sprintf("%.2f", spread), collapse = ", "),
      checks = paste(response_model(response)$checks(models, fitted$trials, factor),
        collapse = "; "))
  })
}
