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

open_accuracy_study <- function(study, paths) {
  read <- read_trials(paths, study$protocol, "trial_response",
    "main trials that were answered right or wrong",
    where = paste(answered_where(kThresholdKinds), "AND correct IS NOT NULL"))
  c(keep_people_apart(with_factor_columns(read, study$factors)), study[c("title", "published")])
}

report_accuracy_study <- function(study) {
  factor <- study$factors[[1]]
  trials <- study$trials
  trials$rating <- trials$correct  # what tests of participants' means go by
  rows <- accuracy_rows(trials, factor, study$published)
  tests <- combine_outcomes(if (nlevels(droplevels(trials[[factor]])) > 1)
    repeated_measures_tests(trials, factor, "an answer"))
  figure <- factor_plot(trials, factor, "correct") + ggplot2::scale_y_continuous(kAccuracyAxis) +
    ggplot2::coord_cartesian(ylim = c(0, 1)) + column_theme()
  caption <- factor_figure_caption(study, factor, list(of = "correct", title = kAccuracyAxis))
  write_outputs(study, tests, paste(c(accuracy_words(rows, factor), anova_words(tests, factor)),
    collapse = " "), study_sentences(study), caption, NULL,
    write_figure(function() ggplot2::ggplotGrob(figure), output_path(study, "")),
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
