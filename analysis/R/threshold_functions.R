# Thresholds of a part: each participant's psychometric function, and what they say in words.
#
#   trial_response ──> trials: x (the level on its scale), positive ─┬─> functions ─┬─> figures, tables
#   trial_level ─────> condition: every other factor that varies ────┘              └─> threshold_tests.R
#
# Invariant: answers that never came are no trials; excluded and catch trials are out
# (trials_analysed.R).
# SPDX-License-Identifier: MIT

kBootstrapDraws <- 200
kThresholdKinds <- c("yes_no", "two_interval")
kConditionSeparator <- " × "

# The rows of trial_response that are answers of these kinds.
answered_where <- function(kinds) {
  sprintf("kind IN (%s) AND positive IS NOT NULL AND timed_out = 0",
    paste0("'", kinds, "'", collapse = ", "))
}

# Adds x, level and condition to the trials; refuses levels that are no numbers or, on a logarithmic
# scale, not above 0.
with_scale_and_condition <- function(study, realised_hold) {
  trials <- study$trials
  column <- study$factors[["level"]]
  study$axis <- column
  level <- if (realised_hold) trials$realised_hold_ms else
    suppressWarnings(as.numeric(as.character(trials[[column]])))
  if (anyNA(level) || (study$log10 && any(level <= 0))) {
    refuse(study$file, ": expected numbers ", if (study$log10) "above 0 ", "as levels of ", column,
      ", got ", paste(unique(trials[[column]][is.na(level) | (study$log10 & level <= 0)]),
        collapse = ", "))
  }
  # Freezes of equally many frames differ by less than a microsecond.
  study$trials$x <- if (study$log10) log10(level) else round(level, 3)
  study$guess <- if (study$kind == "two_interval") 0.5
  study$split <- varying_factors(trials, setdiff(study$factors, column))
  study$trials$condition_of <- condition_names(study$trials, study$split)
  study
}

# "0 × 8": the levels of the factors in `split`, in their order; "all" without any.
condition_names <- function(trials, split) {
  if (length(split) == 0) return(factor(rep("all", nrow(trials))))
  interaction(trials[split], sep = kConditionSeparator, lex.order = TRUE, drop = TRUE)
}

# Fits every participant and condition: list(rows, curves). `rows`: one per function, threshold and
# spread in the scale's unit, 95 % intervals and p of the deviance by parametric bootstrap, seeded;
# `use`: does the threshold lie among the levels shown? `curves`: fit and data of each row.
psychometric_functions <- function(study, draws = kBootstrapDraws) {
  cells <- split(study$trials, list(study$trials$condition_of,
    as.character(study$trials$participant)), drop = TRUE, sep = "\r")
  fitted <- withr::with_seed(1, lapply(unname(cells), one_function, study$guess, draws))
  rows <- each_row(fitted, `[[`, "row")
  for (factor in study$split) {
    rows[[factor]] <- droplevels(study$trials[[factor]])[match(rows$condition,
      study$trials$condition_of)]
  }
  list(rows = rows, curves = fitted)
}

one_function <- function(trials, guess, draws) {
  data <- by_level(trials$x, trials$positive)
  fit <- fit_psychometric(data, guess)
  row <- data.frame(participant = as.character(trials$participant[1]),
    condition = as.character(trials$condition_of[1]), trials = nrow(trials),
    levels = nrow(data), threshold = NA_real_, low = NA_real_, high = NA_real_,
    spread = NA_real_, guess = NA_real_, lapse = NA_real_, deviance = NA_real_,
    deviance_p = NA_real_, use = FALSE)
  if (is.null(fit)) return(list(row = row, data = data))
  row[names(fit)] <- fit
  row$use <- fit$threshold >= min(data$x) && fit$threshold <= max(data$x)
  if (draws > 0) {
    again <- bootstrap_psychometric(data, fit, guess, draws)
    limits <- stats::quantile(again[, 1], c(0.025, 0.975), na.rm = TRUE, names = FALSE)
    row[c("low", "high")] <- as.list(limits)
    row$deviance_p <- (1 + sum(again[, 3] >= fit$deviance, na.rm = TRUE)) /
      (1 + sum(!is.na(again[, 3])))
  }
  list(row = row, data = data, fit = fit)
}

# A threshold in the unit of the factor, from the scale that it was fitted on.
in_unit <- function(study, x) if (study$log10) 10^x else x

scale_sentence <- function(study) {
  kind <- if (is.null(study$guess)) "yes or no (guess rate fitted, prior Beta(1, 10))" else
    "a choice of two intervals (guess rate 1/2)"
  method <- if (all(is.na(study$trials$track))) "levels fixed before" else
    "levels chosen trial by trial; trials as shown are analysed, never means of reversals"
  sprintf("Answers were %s; %s. Cumulative normal in %s%s, lapse rate fitted within 0 to %.2f.",
    kind, method, if (study$log10) "log₁₀ of " else "", name_and_unit(study$axis), kLargestLapse)
}

threshold_words <- function(study, rows, means, tests) {
  used <- sum(rows$use)
  if (used == 0) return("No participant has a threshold yet.")
  limits <- ifelse(is.na(means$low), "", sprintf(" [%.3g, %.3g]", means$low, means$high))
  each <- paste0(if (length(study$split) > 0) paste0(means$condition, ": "),
    sprintf("%.3g", means$mean), limits, collapse = "; ")
  anova <- tests_of(tests, kThresholdAnovaFamily)
  model <- tests_of(tests, kThresholdFamily)
  c(
    sprintf("Mean threshold%s, %s%s: %s (%s%s).",
      if (study$log10) " (geometric)" else "", name_and_unit(study$axis),
      if (length(study$split) > 0) paste(", by", condition_label(study)) else "", each,
      if (any(!is.na(means$low))) "95 % t intervals over participants; " else "",
      count_of(used, "function")),
    vapply(seq_len(nrow(anova)), function(i) sprintf(
      "%s: %s, generalised η² = %.3f.", sentence_case(effect_words(gsub(":", " × ", anova$effect[i]))),
      F_words(anova[i, ]),
      anova$effect_size[i]), ""),
    if (nrow(model) > 0) sprintf("Hierarchical model: %s.", paste(model$effect,
      size_words(model, "%.3g"), sep = ", ", collapse = "; ")))
}
