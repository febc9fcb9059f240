# Cumulative-link mixed models of ratings: the primary analysis.
#
#   rating ~ factors + (1 + slope | participant)     tried first
#   rating ~ factors + (1 | participant)             when that does not converge
#   rating ~ factors + interactions + (...)          for the interactions alone
#
# A factor is tested in the model without interactions, with a slope of its own (factor_models.R), an
# interaction in the model with all. A likelihood-ratio test compares two models with the same random
# part, so models that are compared fall back together. (Christensen 2018; the fit itself is
# cumulative_link.R)
# SPDX-License-Identifier: MIT

kEffectsFamily <- "mixed model, effects"
kOddsFamily <- "mixed model, odds ratios"
kInteractionFamily <- "mixed model, interactions"
kInteractionOddsFamily <- "mixed model, ratios of odds ratios"

# Why no cumulative-link mixed model is fitted, in a sentence; NULL where one can be.
why_no_mixed_model <- function(trials, factors) {
  if (participant_count(trials) < 3) {
    return("The mixed model needs three participants or more and was not fitted.")
  }
  separated <- factors[vapply(factors, function(f) separates(trials, f), logical(1))]
  if (length(separated) == 0) return(NULL)
  paste0(
    "The levels of ", paste(separated, collapse = " and "), " separate the ratings completely, ",
    "so the mixed model has no finite odds ratio and was not fitted; see the other tests."
  )
}

# Likelihood-ratio tests of each interaction, "a:b" of two factors, and ratios of odds ratios, as an
# outcome. `slope_of`: the factor whose effect may differ between participants, or none.
interaction_tests <- function(trials, factors, slope_of, interactions) {
  endless <- interactions[vapply(interactions, function(i) has_one_sided_cell(trials, i), NA)]
  if (length(endless) > 0) {
    return(outcome(remarks = sprintf(paste(
      "In a cell of %s there is no rating or only the lowest or the highest, so the mixed model",
      "with interactions has no finite estimate and was not fitted."
    ), paste(gsub(":", " × ", endless), collapse = " and of "))))
  }
  say_progress("fitting the mixed models with interactions ...")
  kind <- "mixed model with interactions"
  models <- fit_family_or_fall_back(trials, c(factors, interactions), slope_of, interactions, kind)
  mixed_model_outcome(models, trials, interactions, kind,
    families = c(kInteractionFamily, kInteractionOddsFamily))
}

# Is there a cell of the interaction "a:b" that an estimate would push to infinity?
has_one_sided_cell <- function(trials, interaction) {
  cells <- split(as.integer(trials$rating), trials[strsplit(interaction, ":", fixed = TRUE)[[1]]])
  ends <- range(as.integer(trials$rating))
  any(vapply(cells, function(cell) all(cell == ends[1]) || all(cell == ends[2]), NA))
}

# fit_family with a slope for each participant, or, when that does not converge, with an intercept
# alone; `remarks` says what was given up.
fit_family_or_fall_back <- function(trials, terms, slope_of, tested = terms, kind = "mixed model") {
  remarks <- character()
  if (length(slope_of) == 1) {
    trials$slope <- as.numeric(scale(values_of(trials[[slope_of]])))
    models <- fit_family(trials, terms, "(1 + slope | participant)", tested)
    if (is.null(models$failure)) return(models)
    remarks <- sprintf(paste(
      "The %s with a slope of %s for each participant did not converge (%s); the one reported has",
      "a random intercept only."
    ), kind, slope_of, models$failure)
  }
  models <- fit_family(trials, terms, "(1 | participant)", tested)
  if (!is.null(models$failure)) {
    remarks <- c(remarks, sprintf(
      "The %s with a random intercept did not converge (%s), so no %s is reported.",
      kind, models$failure, kind))
  }
  c(models, list(remarks = remarks))
}

# A factor's levels as numbers, words as 1, 2, 3 in their order; numbers as they are.
values_of <- function(x) if (is.factor(x)) position_of(levels(x))[x] else x

# Do two levels of the factor share no more than a boundary? Then a coefficient has no finite
# estimate: pushing the two apart raises the likelihood for ever.
separates <- function(trials, factor) {
  lowest <- sort(tapply(trials$rating, droplevels(trials[[factor]]), min))
  highest <- tapply(trials$rating, droplevels(trials[[factor]]), max)[names(lowest)]
  apart <- outer(highest, lowest, `<=`)
  diag(apart) <- FALSE
  any(apart)
}

# The full model and, for each tested term, the model without it; or list(failure = words).
fit_family <- function(trials, terms, random, tested = terms) {
  full <- fit_rating_model(trials, terms, random)
  if (!is.null(full$failure)) return(full)
  reduced <- lapply(tested, function(dropped) {
    fit_rating_model(trials, setdiff(terms, dropped), random, like = full$model)
  })
  names(reduced) <- tested
  for (dropped in tested) {
    model <- reduced[[dropped]]
    if (!is.null(model$failure)) return(list(failure = model$failure))
    # A model that contains another cannot be worse; 1e-3 is above the optimiser's tolerance.
    if (model$model$log_likelihood > full$model$log_likelihood + 1e-3) {
      return(list(failure = "a smaller model fitted better than one that contains it"))
    }
  }
  list(full = full$model, reduced = lapply(reduced, `[[`, "model"), random = random)
}

# One fit: list(model) or list(failure = words). `like`: a fitted model with the same random part,
# whose spread is the starting place; cold starts miss the optimum when the slope has to stand in
# for the fixed effect that was dropped.
fit_rating_model <- function(trials, factors, random, like = NULL, link = "logit") {
  fixed <- if (length(factors) > 0) stats::reformulate(factors, "rating") else rating ~ 1
  design <- stats::model.matrix(fixed, trials)[, -1, drop = FALSE]
  start <- listen_to(stats::coef(ordinal::clm(fixed, data = trials, link = link)))
  if (is.null(start$value) || anyNA(start$value)) {
    return(list(failure = first_words(c(start$complaints, "its factors cannot be told apart"))))
  }
  model <- fit_cumulative_link(as.integer(droplevels(trials$rating)), design,
    as.integer(factor(trials$participant)), if (grepl("slope", random)) trials$slope, link,
    start$value, if (is.null(like)) kColdSpread else like$spread)
  if (!is.null(model$failure)) return(model)
  list(model = model)
}

kColdSpread <- c(0.5, 0, 0.5)  # logits: of the intercept, of both together, of the slope

# The first line of the first complaint, without the optimiser's code number.
first_words <- function(complaints) {
  sub("^\\([0-9-]+\\) *", "", trimws(sub("\n.*", "", complaints[1])))
}

# Rows for the tested terms of a fitted family. `families`: of their effects, of their odds ratios.
mixed_model_outcome <- function(models, trials, tested, kind = "mixed model",
                                families = c(kEffectsFamily, kOddsFamily)) {
  if (!is.null(models$failure)) return(outcome(remarks = models$remarks))
  method <- sprintf("cumulative-link %s, logit, %s", kind, models$random)
  effects <- lapply(tested, function(dropped) {
    reduced <- models$reduced[[dropped]]
    chi_squared <- max(0, 2 * (models$full$log_likelihood - reduced$log_likelihood))
    df <- length(models$full$beta) - length(reduced$beta)
    test_row(families[1], paste0(method, "; likelihood-ratio test"), dropped, "chi-squared",
      chi_squared, df, p = stats::pchisq(chi_squared, df, lower.tail = FALSE),
      participants = participant_count(trials), trials = nrow(trials))
  })
  odds <- lapply(tested, function(term) odds_ratios(models$full, trials, term, method, families[2]))
  outcome(do.call(rbind, c(effects, odds)), models$remarks)
}

# Odds of a higher rating, with 95 % Wald intervals: at each level of a factor against its first;
# per unit of a number; for an interaction "a:b", how many times larger the odds ratio of a level of
# a is at a level of b than at b's first.
odds_ratios <- function(model, trials, term, method, family) {
  columns <- strsplit(term, ":", fixed = TRUE)[[1]]
  size <- if (length(columns) > 1) "ratio of odds ratios" else "odds ratio of a higher rating"
  errors <- sqrt(diag(model$covariance))
  cells <- expand.grid(lapply(trials[columns], levels_above_first), stringsAsFactors = FALSE)
  rows <- lapply(seq_len(nrow(cells)), function(i) {
    cell <- unlist(cells[i, , drop = FALSE])
    coefficient <- paste0(columns, cell, collapse = ":")
    beta <- model$beta[[coefficient]]
    z <- beta / errors[[coefficient]]
    test_row(family, paste0(method, "; Wald"), paste0(term, ": ", against_first(trials, cell)), "z",
      z, NA, p = 2 * stats::pnorm(-abs(z)), size_name = size, size = exp(beta),
      interval = exp(beta + c(-1, 1) * stats::qnorm(0.975) * errors[[coefficient]]),
      interval_level = 0.95, participants = participant_count(trials), trials = nrow(trials))
  })
  do.call(rbind, rows)
}

# What a coefficient's name adds to the column: a level, or nothing for a number.
levels_above_first <- function(x) if (is.factor(x)) levels(x)[-1] else ""

# "100 against 0", "4 × 85 against 0 × 0", "per unit". `cell`: levels named by their columns.
against_first <- function(trials, cell) {
  if (!is.factor(trials[[names(cell)[1]]])) return("per unit")
  firsts <- vapply(trials[names(cell)], function(x) levels(x)[1], "")
  paste(paste(cell, collapse = " × "), "against", paste(firsts, collapse = " × "))
}
