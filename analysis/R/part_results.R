# The results of one part: its tests, tables, figures and words, whatever its response.
#
#   part ─┬─> tests (families, Holm), diagnostics, sensitivity ─> tables
#         ├─> figures (column_figures.R)
#         ├─> paragraphs: one for each factor
#         └─> of a study that is described (studies.R): interactions, what was shown (shown_in_trials.R),
#             what was published
# SPDX-License-Identifier: MIT

# list(part, tests, paragraphs, figures, tables): everything that the page shows of a part. `tables`:
# list(title, heads, rows, note) each. `everything`: the part's trials with those excluded.
results_of_part <- function(part, everything = NULL) {
  if (part$response == "threshold") return(threshold_results(part))
  if (part$response == "scheduling") return(scheduling_results(part))
  measure <- measure_of(part)
  none <- why_no_test_of(part)
  tested <- is.null(none) && length(part$factors) > 0
  fitted <- if (tested && !is_by_means(part)) {
    factor_tests(part$trials, unname(part$factors), part$response,
      interactions = described_interactions(part))
  }
  clicked <- clicked_events(part)
  trials <- part$trials
  trials$rating <- trials[[measure$of]]  # what tests of participants' means go by
  means <- if (tested) tests_of_means(trials, unname(part$factors),
    if (is.null(part$scale)) "a trial" else "a rating",
    if (!is.null(part$scale)) equivalence_margin(part$scale))
  shown <- parts_shown(part)
  published <- published_accuracy(part)
  tests <- combine_outcomes(outcome(remarks = none), constant_remarks(part$constant), fitted, means,
    clicked$tests, shown$tests)
  list(part = part, tests = tests,
    paragraphs = c(lapply(unname(part$factors), factor_paragraph, part, tests, measure),
      list(interaction_words(tests, part$response)), list(anova_interaction_words(tests)), list(clicked$words),
      shown$words(tests), list(published$words)),
    figures = c(figures_of_part(part), click_figures(clicked, part$all_simulated)),
    tables = Filter(Negate(is.null), c(shown$tables, list(published$table), click_tables(clicked),
      list(diagnostics_table(part, fitted)),
      sensitivity_tables(part, fitted, measure, everything, clicked))))
}

why_no_test <- function(trials) {
  if (participant_count(trials) < 2) {
    return("One participant: the figure and the means describe; no inferential test was made.")
  }
  if (length(unique(trials$rating)) > 1) return(NULL)
  sprintf("Every rating was %d: nothing varies, so no test was made.", as.integer(trials$rating[1]))
}

constant_remarks <- function(factors) {
  if (length(factors) == 0) return(outcome())
  outcome(remarks = sprintf("%s has one level in these trials and is not tested.",
    sentence_case(vapply(factors, plain_name, ""))))
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
# at the coarsest level beside finer ones: list(tests, gains, kernels, matching, words), empty for other
# responses.
# Kinds with baselines of their own are those of the first factor of words, else all trials alike.
clicked_events <- function(part) {
  if (part$response != "clicks") return(list())
  words <- Filter(function(f) !is_number(part$trials[[f]]), unname(part$factors))
  part$trials$scheduling <- if (length(words) > 0) part$trials[[words[1]]] else
    factor(rep("all", nrow(part$trials)))
  part$pairs <- part$study$pairs
  study <- with_click_times(with_collisions(part))
  if (length(unique(study$collisions$bad)) < 2) {
    return(list(words = paste("All collisions were resolved at one sort of level, coarsest or finer,",
      "so clicks are not set against bad and good ones.")))
  }
  click_detection(study)
}

# Right answers beside what others found at the same levels, where the study's description says:
# list(words, table), empty elsewhere. By level: the mean over participants of their shares, Student's
# 95 % interval, how many participants; as in the figure, of those who have every level, if any.
published_accuracy <- function(part) {
  factor <- factor_called(part, part$study$factors[1])
  if (!identical(part$kind, "right") || is.null(part$study$published) || is.null(factor)) return(list())
  means <- participant_means(part$trials, factor, "positive")
  complete <- complete_participants(means)
  if (nrow(complete) > 0) means <- complete
  each <- t_intervals(means)
  rows <- data.frame(level = each$cell, accuracy = each$mean, low = each$low, high = each$high,
    participants = colSums(!is.na(means)),
    published = as.numeric(part$study$published[match(each$cell, names(part$study$published))]))
  two <- function(x) sub("^0", "", sprintf("%.2f", x))
  known <- rows[!is.na(rows$published), ]
  if (nrow(known) == 0) return(list())
  list(
    words = sprintf("Share of right answers beside what was published: %s.", paste0(known$level, ": ",
      two(known$accuracy), " (published: ", two(known$published), ")", collapse = "; ")),
    table = list(name = "accuracy", title = "Right answers, and what was published", rows = rows,
      heads = c(label_of(factor), "Share of right answers", "95 % CI, from", "to", "Participants",
        "Published")))
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
      if (!is.null(means)) list(name = "means", title = "Thresholds",
        rows = means[c("condition", "participants", "mean", "low", "high")],
        heads = c(condition_label(part), "Participants", paste("Mean,", name_and_unit(part$axis)),
          "95 % CI, from", "to")),
      list(name = "functions", title = "Each participant's function", rows = rows,
        heads = c("Participant", condition_label(part), "Trials", "Levels", "Threshold",
          "95 % CI, from", "to", "Spread", "Guess rate", "Lapse rate", "Deviance", "p of it",
          "In the tests"),
        note = sprintf(paste("Threshold, interval and spread%s; intervals and p by parametric bootstrap;",
          "in no test: a threshold beyond the levels shown."),
          if (part$log10) " in log₁₀" else "")),
      threshold_sensitivity(part))))
}
