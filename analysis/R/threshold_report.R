# A study of thresholds from its trials to figures, tables and words.
#
#   functions ─┬─> <protocol>-functions.csv, -curves.png      each participant
#              ├─> <protocol>-thresholds.png, .md             means by condition
#              └─> <protocol>.csv                             tests, hierarchical model
# SPDX-License-Identifier: MIT

report_threshold_study <- function(study) {
  say_progress(kFunctionsStep)
  functions <- psychometric_functions(study)
  tests <- threshold_tests(study, functions$rows)
  means <- threshold_means(study, functions$rows)
  results <- paste(threshold_words(study, functions$rows, means, tests), collapse = " ")
  say_progress("drawing the figures ...")
  captions <- threshold_captions(study)
  write_outputs(study, tests, results, c(study_sentences(study), scale_sentence(study)),
    c(paste("Curves.", captions[["curves"]]), "", captions[["thresholds"]]),
    threshold_section(study, means), write_threshold_figures(study, functions),
    list(functions = functions$rows))
}

scale_sentence <- function(study) {
  kind <- if (is.null(study$guess)) "yes or no (guess rate fitted, 0 to .5)" else
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
    sprintf("Mean threshold%s, %s%s: %s (95 %% t intervals over participants; %s).",
      if (study$log10) " (geometric)" else "", name_and_unit(study$axis),
      if (length(study$split) > 0) paste(", by", condition_label(study)) else "", each,
      count_of(used, "function")),
    vapply(seq_len(nrow(anova)), function(i) sprintf(
      "%s: %s, generalised η² = %.3f.", gsub(":", " × ", anova$effect[i]), F_words(anova[i, ]),
      anova$effect_size[i]), ""),
    if (nrow(model) > 0) sprintf("Hierarchical model: %s.", paste(model$effect,
      size_words(model, "%.3g"), sep = ", ", collapse = "; "))
  )
}

threshold_section <- function(study, means) {
  if (is.null(means)) return(NULL)
  means$interval <- ifelse(is.na(means$low), NA, sprintf("%.3g to %.3g", means$low, means$high))
  c("## Thresholds", "",
    markdown_of(means, c(condition = "%s", participants = "%d", mean = "%.3g", interval = "%s"),
      c(condition_label(study), "participants",
        paste("mean threshold,", name_and_unit(study$axis)), "95 % CI")), "",
    paste0("Each participant's functions, with bootstrap intervals and goodness of fit: ",
      study$protocol, "-functions.csv."), "")
}
