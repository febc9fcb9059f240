# A study of thresholds from its views to one psychometric function per participant and condition.
#
#   trial_response ──> trials: x (the level on its scale), positive ──> functions
#   trial_level ─────> condition: every other factor that varies
#
# Invariant: answers that never came are no trials; excluded and catch trials are out (exclusions.R).
# SPDX-License-Identifier: MIT

kBootstrapDraws <- 200
kThresholdKinds <- c("yes_no", "two_interval")
kConditionSeparator <- " × "

# What a script of thresholds says about its study: `factor`, the one on the axis, without unit;
# `log10`: is the scale logarithmic; `realised_hold`: take the freeze on the display's frames for it.
open_threshold_study <- function(words, usage, protocol, factor, log10 = FALSE,
                                 realised_hold = FALSE) {
  arguments <- read_arguments(words, usage)
  need_packages(c("RSQLite", "lme4", "afex", "ggplot2"))
  where <- paste0("kind IN (", paste0("'", kThresholdKinds, "'", collapse = ", "), ")",
    " AND positive IS NOT NULL AND timed_out = 0")
  study <- read_trials(arguments$studies, protocol, "trial_response", "answered main trials",
    where = where)
  names <- unique(study$levels$factor)
  study <- with_factor_columns(study, c(level = factor, stats::setNames(names, names)[
    names != factor & !startsWith(names, paste0(factor, "_"))]))
  study <- keep_people_apart(study)
  prepare_folder(arguments$out)
  study$out <- arguments$out
  study$log10 <- log10
  with_scale_and_condition(study, realised_hold)
}

# Adds x, level and condition to the trials; refuses two kinds of answer and levels that are no
# numbers or, on a logarithmic scale, not above 0.
with_scale_and_condition <- function(study, realised_hold) {
  trials <- study$trials
  files <- paste(study$files, collapse = ", ")
  kinds <- unique(trials$kind)
  if (length(kinds) > 1) {
    refuse(files, ": expected answers of one kind, got ", paste(kinds, collapse = " and "))
  }
  column <- study$factors[["level"]]
  study$axis <- column
  level <- if (realised_hold) trials$realised_hold_ms else
    suppressWarnings(as.numeric(as.character(trials[[column]])))
  if (anyNA(level) || (study$log10 && any(level <= 0))) {
    refuse(files, ": expected numbers ", if (study$log10) "above 0 ", "as levels of ", column,
      ", got ", paste(unique(trials[[column]][is.na(level) | (study$log10 & level <= 0)]),
        collapse = ", "))
  }
  # Freezes of equally many frames differ by less than a microsecond.
  study$trials$x <- if (study$log10) log10(level) else round(level, 3)
  study$guess <- if (kinds == "two_interval") 0.5
  study$kind <- kinds
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
  fitted <- with_seed(1, lapply(unname(cells), one_function, study$guess, draws))
  rows <- do.call(rbind, lapply(fitted, `[[`, "row"))
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
  row[c("threshold", "spread", "guess", "lapse", "deviance")] <-
    fit[c("threshold", "spread", "guess", "lapse", "deviance")]
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
