# The results of one part: its tests, tables, figures and words, whatever its response.
#
#   part ─┬─> tests (families, Holm), diagnostics, sensitivity ─> tables
#         ├─> figures (column_figures.R)
#         └─> paragraphs: one for each factor
# SPDX-License-Identifier: MIT

# list(part, tests, paragraphs, figures, tables): everything that the page shows of a part. `tables`:
# list(title, heads, rows, note) each. `everything`: the part's trials with those excluded.
results_of_part <- function(part, everything = NULL) {
  part <- with_click_rate(part)
  if (part$response == "threshold") return(threshold_results(part))
  fitted <- fitted_models(part)
  beside <- click_events_of(part)
  tests <- combine_outcomes(
    outcome(remarks = c(why_no_test_of(part), constant_factor_remarks(part))),
    outcome(fitted$rows, fitted$remarks), tests_of_means(part), beside$tests)
  measure <- measure_of(part)
  list(part = part, tests = tests,
    paragraphs = c(lapply(unname(part$factors), factor_sentences, part = part, tests = tests,
      measure = measure), list(interaction_sentences(tests)), list(beside$words)),
    figures = figures_of_part(part),
    tables = Filter(Negate(is.null), c(
      list(diagnostics_table(part, fitted)), sensitivity_tables(part, fitted, measure, everything,
        beside))))
}

with_click_rate <- function(part) {
  if (part$response != "clicks") return(part)
  part$trials <- trials_with_exposure(part$trials)
  part$trials$click_rate <- part$trials$clicks / part$trials$exposure_s
  part
}

fitted_models <- function(part) {
  if (!is.null(why_no_test_of(part)) || length(part$factors) == 0) return(outcome())
  factors <- unname(part$factors)
  switch(part$response, rating = rating_factor_tests(part$trials, factors),
    clicks = click_factor_tests(part$trials, factors),
    answer = answer_factor_tests(part$trials, factors))
}

# Why there is no inferential test at all; NULL where there is.
why_no_test_of <- function(part) {
  trials <- part$trials
  if (part$response == "rating") return(why_no_test(trials))
  if (participant_count(trials) < 2) {
    return("One participant: figures and means describe; no inferential test was made.")
  }
  if (part$response == "clicks" && sum(trials$clicks) == 0) {
    return("Nobody clicked, so there is nothing to test.")
  }
  if (part$response == "answer" && length(unique(trials$positive)) == 1) {
    return("Every answer was alike: nothing varies, so no test was made.")
  }
  NULL
}

constant_factor_remarks <- function(part) constant_remarks(part$constant)$remarks

# ANOVA, Friedman and, for ratings, equivalence: of participants' means of the response.
tests_of_means <- function(part) {
  if (!is.null(why_no_test_of(part)) || length(part$factors) == 0) return(outcome())
  say_progress(kMeansStep)
  trials <- part$trials
  factors <- unname(part$factors)
  trials$rating <- trials[[measure_of(part)$of]]
  result <- all_outcomes(repeated_measures_tests(trials, factors), friedman_tests(trials, factors))
  if (part$response == "rating") {
    result <- all_outcomes(result, equivalence_tests(trials, factors, equivalence_margin(part$scale)))
  }
  if (part$response != "rating") {
    result$remarks <- gsub("a rating in every cell", "a trial in every cell", result$remarks)
  }
  result
}

# How a response's mixed model names its families of tests, and how words name what it found.
response_families <- function(response) {
  switch(response,
    rating = list(effects = kEffectsFamily, ratios = kOddsFamily, noun = "ratings",
      model = "cumulative-link mixed model", ratio = "Odds ratios of a higher rating"),
    answer = list(effects = kAnswerFamily, ratios = kAnswerOddsFamily, noun = "answers",
      model = "binomial mixed model", ratio = "Odds ratios of a positive answer"),
    clicks = list(effects = kClickFamily, ratios = kClickRatioFamily, noun = "clicks",
      model = "mixed model of clicks", ratio = "Rate ratios"))
}

# What was found about one factor.
factor_sentences <- function(factor, part, tests, measure) {
  words <- response_families(part$response)
  effect <- tests_of(tests, words$effects, factor)
  ratios <- tests_of(tests, words$ratios)
  ratios <- ratios[startsWith(ratios$effect, paste0(factor, ": ")), ]
  friedman <- friedman_words(tests, factor)
  equivalence <- tests_of(tests, kEquivalenceFamily)
  equivalence <- equivalence[startsWith(equivalence$effect, paste0(factor, ": ")), ]
  with_minus_signs(c(
    factor_means_words(part$trials, factor, measure),
    if (nrow(effect) > 0) sprintf("In the %s (random %s for each participant) %s: %s.", words$model,
      if (grepl("slope", effect$method)) "intercept and slope" else "intercept",
      dependence_words(effect, words$noun), chi_squared_words(effect)),
    if (nrow(ratios) > 0) sprintf("%s: %s.", words$ratio, paste(sprintf(
      "%s, %.2f, 95 %% CI [%.2f, %.2f]", sub("^.*?: ", "", ratios$effect, perl = TRUE), ratios$effect_size,
      ratios$interval_low, ratios$interval_high), collapse = "; ")),
    if (nrow(equivalence) > 0) equivalence_words(equivalence, factor),
    anova_sentence(tests, factor), friedman))
}

factor_means_words <- function(trials, factor, measure) {
  rows <- means_with_intervals(trials, factor, measure$of)
  limits <- ifelse(is.na(rows$low), "", sprintf(" [%.2f, %.2f]", rows$low, rows$high))
  sprintf("%s by %s: %s%s.", measure$title, name_and_unit(factor),
    paste0(rows$cell, ": ", sprintf("%.2f", rows$mean), limits, collapse = "; "),
    if (all(is.na(rows$low))) "" else " (within-participant 95 % intervals)")
}

dependence_words <- function(row, noun) {
  name <- plain_name(row$effect)
  if (row$p_holm < kSignificance) return(paste(noun, "depended on", name))
  paste0("no effect of ", name, " on ", noun, " was detected, which is not evidence of its absence")
}

anova_sentence <- function(tests, factor) {
  row <- tests_of(tests, kAnovaFamily, factor)
  if (nrow(row) == 0) return(character())
  sprintf("Repeated-measures ANOVA (%s): %s, generalised η² = %.3f, 90 %% CI [%.3f, %.3f].",
    sub("^.*, ", "", row$method), F_words(row), row$effect_size, row$interval_low, row$interval_high)
}

interaction_sentences <- function(tests) {
  rows <- tests_of(tests, kAnovaFamily)
  rows <- rows[grepl(":", rows$effect, fixed = TRUE), ]
  if (nrow(rows) == 0) return(character())
  names <- vapply(strsplit(rows$effect, ":", fixed = TRUE), function(parts) {
    paste(vapply(parts, plain_name, ""), collapse = " × ")
  }, "")
  found <- rows$p_holm < kSignificance
  c(
    if (any(found)) sprintf("Interactions in the repeated-measures ANOVA: %s.", paste(names[found],
      vapply(which(found), function(i) F_words(rows[i, ]), ""), sep = ", ", collapse = "; ")),
    if (any(!found)) sprintf("Not detected, which is not evidence of absence: %s.",
      paste(names[!found], both_p_words(rows[!found, ]), sep = ", ", collapse = "; "))
  )
}

diagnostics_table <- function(part, fitted) {
  if (is.null(fitted$models)) return(NULL)
  checks <- list(rating = rating_checks, clicks = click_checks, answer = answer_checks)
  rows <- model_diagnostics(fitted, checks[[part$response]])
  rows$factor <- vapply(rows$factor, label_of, "")
  list(name = "diagnostics", title = "Diagnostics of the mixed models",
    heads = c("Model for", "Random part", "Standard deviations over participants", "Checks"),
    rows = rows)
}

sensitivity_tables <- function(part, fitted, measure, everything, beside) {
  if (participant_count(part$trials) < 2 || length(part$factors) == 0) return(list())
  data <- data_sensitivity(part, measure, everything)
  links <- if (!is.null(fitted$models) && part$response != "clicks") link_sensitivity(part, fitted)
  pooled <- pooled_sensitivity(part$trials, unname(part$factors), measure$of)
  list(
    list(name = "sensitivity-data", title = "Sensitivity: which trials are in", heads = kDataHeads,
      rows = data, note = sprintf(paste("The last against the first level of each factor: paired t",
        "tests of participants' means of %s, p uncorrected."), tolower(measure$title))),
    if (!is.null(links)) list(name = "sensitivity-link", title = "Sensitivity: the link",
      heads = kLinkHeads, rows = links, note = paste("The same mixed model under other links;",
        "compare z, for the unit of a coefficient is that of its link; p uncorrected. – did not",
        "converge.")),
    if (!is.null(beside$matching)) list(name = "sensitivity-windows",
      title = "Sensitivity: windows in which a click belongs to a collision",
      heads = gsub("_", " ", names(beside$matching)), rows = beside$matching,
      note = "Descriptive only: at more than one event a second, windows bias d′ downwards."),
    if (!is.null(pooled)) list(name = "sensitivity-pooled", title = "The pooled test over trials",
      heads = kPooledHeads, rows = pooled, note = pooled_warning()))
}

threshold_results <- function(part) {
  say_progress(kFunctionsStep)
  functions <- psychometric_functions(part)
  tests <- threshold_tests(part, functions$rows)
  means <- threshold_means(part, functions$rows)
  rows <- functions$rows[!names(functions$rows) %in% part$split]
  list(part = part, tests = tests, figures = figures_of_part(part, functions),
    paragraphs = list(with_minus_signs(threshold_words(part, functions$rows, means, tests))),
    tables = Filter(Negate(is.null), list(
      list(name = "functions", title = "Each participant's function", rows = rows,
        heads = gsub("_", " ", names(rows)), note = sprintf(paste("Threshold, low, high and spread%s;",
          "low and high: 95 %% interval by parametric bootstrap; use FALSE: no threshold among the",
          "levels shown."), if (part$log10) " in log₁₀" else "")),
      threshold_sensitivity(part))))
}

# Mean thresholds under other choices: no lapses; without late frames; one guess rate of 0.
threshold_sensitivity <- function(part) {
  choices <- list("as reported" = part)
  on_time <- part$trials$late_timed_frames == 0
  if (!all(on_time) && any(on_time)) {
    choices[["without trials with late frames"]] <- c(part[names(part) != "trials"],
      list(trials = part$trials[on_time, ]))
  }
  if (is.null(part$guess)) {
    choices[["guess rate of 0"]] <- c(part[names(part) != "guess"], list(guess = 0))
  }
  rows <- do.call(rbind, lapply(names(choices), function(name) {
    functions <- psychometric_functions(choices[[name]], draws = 0)
    means <- threshold_means(part, functions$rows)
    if (is.null(means)) return(NULL)
    data.frame(condition = means$condition, choice = name, participants = means$participants,
      threshold = means$mean, low = means$low, high = means$high)
  }))
  if (is.null(rows)) return(NULL)
  list(name = "sensitivity", title = "Sensitivity: thresholds under other choices",
    heads = c("Condition", "Choice", "Participants", "Mean threshold", "95 % CI, from", "to"),
    rows = rows[order(rows$condition), ])
}
