# A study of right answers from its views to figure, table and words.
#
#   trial_response ──> participants' shares of right answers at each level of one factor
#                      ─┬─> <protocol>-accuracy.csv     mean and interval, beside what was published
#                       ├─> <protocol>.csv              tests of the levels against each other
#                       └─> <protocol>.png, .pdf, .md
#
# Invariant: the unit is the participant; answers that never came are no trials.
# SPDX-License-Identifier: MIT

kAccuracyAxis <- "Share of right answers"

# Reads what the command line names; refuses before anything is written.
open_accuracy_study <- function(study, words) {
  arguments <- study_arguments(study, words, c("RSQLite", "afex", "ggplot2"))
  read <- read_trials(arguments$studies, study$protocol, "trial_response",
    "main trials that were answered right or wrong",
    where = paste(answered_where(kThresholdKinds), "AND correct IS NOT NULL"))
  read <- keep_people_apart(with_factor_columns(read, study$factors))
  prepare_folder(arguments$out)
  c(read, out = arguments$out, study[c("title", "published")])
}

# Tests, writes and says everything.
report_accuracy_study <- function(study) {
  factor <- study$factors[[1]]
  trials <- study$trials
  trials$rating <- trials$correct  # what tests of participants' means go by
  rows <- accuracy_rows(trials, factor, study$published)
  tests <- combine_outcomes(if (nlevels(droplevels(trials[[factor]])) > 1)
    repeated_measures_tests(trials, factor, "an answer"))
  figures <- write_figure(function() ggplot2::ggplotGrob(accuracy_figure(trials, factor)),
    output_path(study, ""))
  write_outputs(study, tests, paste(c(accuracy_words(rows, factor), anova_words(tests, factor)),
    collapse = " "), study_sentences(study), accuracy_caption(trials, factor, study), NULL, figures,
    tables = list(accuracy = rows))
}

# By level: the mean over participants of their shares of right answers, Student's 95 % interval, how
# many participants, and what was published. As in the figure, of those who have every level, if any.
accuracy_rows <- function(trials, factor, published) {
  means <- participant_means(trials, factor, "correct")
  complete <- complete_participants(means)
  if (nrow(complete) > 0) means <- complete
  rows <- t_intervals(means)
  data.frame(level = rows$cell, accuracy = rows$mean, low = rows$low, high = rows$high,
    participants = colSums(!is.na(means)),
    published = as.numeric(published[match(rows$cell, names(published))]))
}

accuracy_words <- function(rows, factor) {
  two <- function(x) sub("^0", "", sprintf("%.2f", x))
  interval <- ifelse(is.na(rows$low), "", sprintf(" [%s, %s]", two(rows$low), two(rows$high)))
  beside <- ifelse(is.na(rows$published), "", sprintf(" (published: %s)", two(rows$published)))
  sprintf("%s by %s: %s (Student's 95 %% intervals over participants).", kAccuracyAxis,
    name_and_unit(factor), paste0(rows$level, ": ", two(rows$accuracy), interval, beside,
      collapse = "; "))
}

accuracy_figure <- function(trials, factor) {
  factor_plot(trials, factor, "correct") + ggplot2::scale_y_continuous(kAccuracyAxis) +
    ggplot2::coord_cartesian(ylim = c(0, 1)) + column_theme()
}

accuracy_caption <- function(trials, factor, study) {
  factor_figure_caption(list(trials = trials, all_simulated = study$all_simulated), factor,
    list(of = "correct", title = kAccuracyAxis))
}
