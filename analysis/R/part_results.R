# The results of one part: its tests, tables, figures and words, whatever its response.
#
#   part ─┬─> tests (families, Holm), diagnostics, sensitivity ─> tables
#         ├─> figures (column_figures.R)
#         └─> paragraphs: one for each factor
# SPDX-License-Identifier: MIT

# list(part, tests, paragraphs, figures, tables): everything that the page shows of a part. `tables`:
# list(title, heads, rows, note) each. `everything`: the part's trials with those excluded.
results_of_part <- function(part, everything = NULL) {
  if (part$response == "threshold") return(threshold_results(part))
  measure <- measure_of(part)
  none <- why_no_test_of(part)
  tested <- is.null(none) && length(part$factors) > 0
  fitted <- if (tested && !is_by_means(part)) {
    factor_tests(part$trials, unname(part$factors), part$response)
  }
  clicked <- clicked_events(part)
  trials <- part$trials
  trials$rating <- trials[[measure$of]]  # what tests of participants' means go by
  means <- if (tested) tests_of_means(trials, unname(part$factors),
    if (is.null(part$scale)) "a trial" else "a rating",
    if (!is.null(part$scale)) equivalence_margin(part$scale))
  tests <- combine_outcomes(outcome(remarks = none), constant_remarks(part$constant), fitted, means,
    clicked$tests)
  list(part = part, tests = tests,
    paragraphs = c(lapply(unname(part$factors), factor_paragraph, part, tests, measure),
      list(anova_interaction_words(tests)), list(clicked$words)),
    figures = figures_of_part(part),
    tables = Filter(Negate(is.null), c(list(diagnostics_table(part, fitted)),
      sensitivity_tables(part, fitted, measure, everything, clicked))))
}

# Why there is no inferential test at all; NULL where there is.
why_no_test_of <- function(part) {
  trials <- part$trials
  if (part$response == "rating") return(why_no_test(trials))
  if (participant_count(trials) < 2) {
    return("One participant: figures and means describe; no inferential test was made.")
  }
  switch(part$response,
    clicks = if (sum(trials$clicks) == 0) "Nobody clicked, so there is nothing to test.",
    mark = if (length(unique(trials$mark)) == 1)
      "Every mark was in the same place: nothing varies, so no test was made.",
    answer = if (length(unique(trials$positive)) == 1)
      "Every answer was alike: nothing varies, so no test was made.")
}

# What was found about one factor.
factor_paragraph <- function(factor, part, tests, measure) {
  with_minus_signs(c(
    means_words(part$trials, factor, measure),
    if (!is_by_means(part)) factor_words(tests, factor, part$response),
    equivalence_words(level_comparisons(tests, kEquivalenceFamily, factor), factor),
    anova_words(tests, factor), friedman_words(tests, factor)))
}

# Clicks against the collisions before them (click_detection.R), where a study has collisions resolved
# at the coarsest level beside finer ones: list(tests, matching, words), empty for other responses.
# Kinds with baselines of their own are those of the first factor of words, else all trials alike.
clicked_events <- function(part) {
  if (part$response != "clicks") return(list())
  words <- Filter(function(f) !is_number(part$trials[[f]]), unname(part$factors))
  part$trials$scheduling <- if (length(words) > 0) part$trials[[words[1]]] else
    factor(rep("all", nrow(part$trials)))
  study <- with_click_times(with_collisions(part))
  if (length(unique(study$collisions$bad)) < 2) {
    return(list(words = paste("All collisions were resolved at one sort of level, coarsest or finer,",
      "so clicks are not set against bad and good ones.")))
  }
  click_detection(study)
}

diagnostics_table <- function(part, fitted) {
  if (is.null(fitted$models)) return(NULL)
  rows <- model_diagnostics(fitted, part$response)
  rows$factor <- vapply(rows$factor, label_of, "")
  list(name = "diagnostics", title = "Diagnostics of the mixed models",
    heads = c("Model for", "Random part", "Standard deviations over participants", "Checks"),
    rows = rows)
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
