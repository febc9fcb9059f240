# A study of thresholds from its trials to figures, tables and words.
#
#   functions ─┬─> <protocol>-functions.csv, -curves.png      each participant
#              ├─> <protocol>-thresholds.png, .md             means by condition
#              └─> <protocol>.csv                             tests, hierarchical model
# SPDX-License-Identifier: MIT

report_threshold_study <- function(study, title) {
  say_progress(kFunctionsStep)
  functions <- psychometric_functions(study)
  tests <- threshold_tests(study, functions$rows)
  means <- threshold_means(study, functions$rows)
  data <- c(study_sentences(study), scale_sentence(study))
  results <- paste(threshold_words(study, functions$rows, means, tests), collapse = " ")
  say_progress("drawing the figures ...")
  path <- function(ending) file.path(study$out, paste0(study$protocol, ending))
  figures <- write_threshold_figures(study, functions, path)
  write_test_table(tests, path(".csv"))
  write_table(functions$rows, path("-functions.csv"))
  write_report(path(".md"), title, results, data, tests$remarks, threshold_captions(study),
    threshold_section(study, means), left_out_section(study))
  say(c(figures, path(".csv"), path("-functions.csv"), path(".md"), "",
    paste(data, collapse = " "), "", results, tests$remarks))
}

scale_sentence <- function(study) {
  kind <- if (is.null(study$guess)) "yes or no (guess rate fitted, 0 to .5)" else
    "a choice of two intervals (guess rate 1/2)"
  method <- if (all(is.na(study$trials$track))) "levels fixed before" else
    "levels chosen trial by trial; trials as shown are analysed, never means of reversals"
  sprintf("Answers were %s; %s. Cumulative normal %s, lapse rate fitted within 0 to %.2f.", kind,
    method, if (study$log10) paste("in log₁₀ of", name_and_unit(study$axis)) else
      paste("in", name_and_unit(study$axis)), kLargestLapse)
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
    sprintf("Mean threshold%s, %s%s: %s (95 %% t intervals over participants%s).",
      if (study$log10) " (geometric)" else "", name_and_unit(study$axis),
      if (length(study$split) > 0) paste(", by", condition_label(study)) else "", each,
      sprintf("; %s", count_of(used, "function"))),
    vapply(seq_len(nrow(anova)), function(i) sprintf(
      "%s: %s, generalised η² = %.3f.", gsub(":", " × ", anova$effect[i]), F_words(anova[i, ]),
      anova$effect_size[i]), ""),
    if (nrow(model) > 0) sprintf("Hierarchical model: %s.", paste(sprintf(
      "%s, %.3g, 95 %% CI [%.3g, %.3g]", model$effect, model$effect_size, model$interval_low,
      model$interval_high), collapse = "; "))
  )
}

threshold_section <- function(study, means) {
  if (is.null(means)) return(NULL)
  c("## Thresholds", "",
    markdown_table(c(condition_label(study), "participants",
      paste("mean threshold,", name_and_unit(study$axis)), "95 % CI"),
      sprintf("%s | %d | %.3g | %s", means$condition, means$participants, means$mean,
        ifelse(is.na(means$low), "–", sprintf("%.3g to %.3g", means$low, means$high)))), "",
    paste0("Each participant's functions, with bootstrap intervals and goodness of fit: ",
      study$protocol, "-functions.csv."), "")
}

threshold_captions <- function(study) {
  c(
    sprintf(paste("Curves. %s by %s, one panel for each %s; circles by area: number of trials;",
      "lines: fitted functions."), positive_label(study), name_and_unit(study$axis),
      who_words(study$all_simulated)), "",
    sprintf(paste("Thresholds. Grey: each %s, with a 95 %% interval by parametric bootstrap (%d",
      "draws); black: the mean and its 95 %% t interval."), who_words(study$all_simulated),
      kBootstrapDraws)
  )
}
