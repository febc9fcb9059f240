# The figures of a study of thresholds.
#
#   curves:      one panel per participant: share of positive answers at each level, area by the
#                number of trials, and the fitted function
#   thresholds:  by condition: each participant's, and the mean with its 95 % t interval
# SPDX-License-Identifier: MIT

threshold_captions <- function(study) {
  who <- who_words(study$all_simulated)
  c(
    curves = sprintf(paste("%s by %s, one panel for each %s. Circles: shares, area by the number of",
      "trials; lines: fitted functions."), positive_label(study), name_and_unit(study$axis), who),
    thresholds = sprintf(paste("Thresholds of %s by condition. Grey: each %s with a 95 %% interval",
      "by parametric bootstrap (%d draws); black: the mean%s."),
      name_and_unit(study$axis), who, kBootstrapDraws,
      if (participant_count(study$trials) > 1) " and its 95 % t interval" else ""))
}

curves_panel <- function(study, functions) {
  conditions <- levels(study$trials$condition_of)
  label <- function(row, data) cbind(data, participant = row$participant,
    condition = factor(row$condition, conditions))
  points <- each_row(functions$curves, function(f) label(f$row, f$data))
  grid <- seq(min(points$x), max(points$x), length.out = 100)
  lines <- each_row(functions$curves, function(f) if (!is.null(f$fit)) {
    label(f$row, data.frame(x = grid, p = psychometric_p(grid, f$fit)))
  })
  colours <- stats::setNames(rep_len(kLevelColours, length(conditions)), conditions)
  ggplot2::ggplot(points, ggplot2::aes(in_unit(study, x), positive / n, colour = condition)) +
    (if (!is.null(lines)) ggplot2::geom_line(ggplot2::aes(y = p), lines, linewidth = 0.4)) +
    ggplot2::geom_point(ggplot2::aes(size = n), shape = 1, stroke = 0.4) +
    ggplot2::scale_size_area("Trials", max_size = 2.5) +
    ggplot2::scale_colour_manual(condition_label(study), values = colours,
      guide = if (length(conditions) > 1) "legend" else "none") +
    (if (study$log10) ggplot2::scale_x_log10 else ggplot2::scale_x_continuous)(
      label_of(study$axis)) +
    ggplot2::scale_y_continuous(positive_label(study), breaks = c(0, 0.5, 1), limits = c(0, 1)) +
    ggplot2::facet_wrap("participant", ncol = 5) + figure_theme()
}

thresholds_panel <- function(study, rows) {
  conditions <- levels(droplevels(study$trials$condition_of))
  several <- length(conditions) > 1
  rows <- rows[rows$use, ]
  mean <- threshold_means(study, rows)
  mean$place <- match(mean$condition, conditions) - 0.15
  rows$place <- match(rows$condition, conditions) + 0.1 + spread(rows$participant) * 0.3
  rows[c("mean", "low", "high")] <- in_unit(study, rows[c("threshold", "low", "high")])
  ggplot2::ggplot(mean, ggplot2::aes(place, mean)) +
    (if (several) ggplot2::geom_line(ggplot2::aes(group = participant), rows, linewidth = 0.2,
      colour = "grey72")) +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high), rows, linewidth = 0.2,
      colour = "grey60", na.rm = TRUE) +
    ggplot2::geom_point(data = rows, size = 0.9, stroke = 0, colour = "grey60") +
    interval_bars(0.7) + ggplot2::geom_point(size = 1.9) +
    ggplot2::scale_x_continuous(condition_label(study), breaks = seq_along(conditions),
      labels = if (several) conditions, limits = c(0.5, length(conditions) + 0.5)) +
    (if (study$log10) ggplot2::scale_y_log10 else ggplot2::scale_y_continuous)(
      paste("Threshold,", name_and_unit(study$axis))) +
    figure_theme()
}

positive_label <- function(study) {
  if (!is.null(study$option)) return(sprintf("Share answered “%s”", study$option))
  is_of_right <- !is.null(study$guess) || isTRUE(study$kind %in% c("two_interval", "right", "right choice"))
  if (is_of_right) "Share answered right" else "Share answered yes"
}

condition_label <- function(study) {
  if (length(study$split) == 0) return("All trials")
  paste(vapply(study$split, label_of, ""), collapse = kConditionSeparator)
}
