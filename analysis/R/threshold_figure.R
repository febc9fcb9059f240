# The figures of a study of thresholds.
#
#   -curves:      one panel per participant: share of positive answers at each level, area by the
#                 number of trials, and the fitted function; the thresholds' 95 % intervals below
#   -thresholds:  by condition: each participant's, and the mean with its 95 % t interval
# SPDX-License-Identifier: MIT

kPanelHeightMm <- 42

# Writes both figures and returns their paths.
write_threshold_figures <- function(study, functions, path) {
  people <- length(unique(functions$rows$participant))
  rows <- ceiling(people / 5)
  c(
    write_figure(function() ggplot2::ggplotGrob(curves_panel(study, functions)), path("-curves"),
      height_mm = 22 + rows * kPanelHeightMm),
    if (any(functions$rows$use)) write_figure(function() {
      ggplot2::ggplotGrob(thresholds_panel(study, functions$rows))
    }, path("-thresholds"))
  )
}

curves_panel <- function(study, functions) {
  label <- function(row, data) cbind(data, participant = row$participant, condition = row$condition)
  points <- do.call(rbind, lapply(functions$curves, function(f) label(f$row, f$data)))
  grid <- seq(min(points$x), max(points$x), length.out = 100)
  fitted <- Filter(function(f) !is.null(f$fit), functions$curves)
  lines <- do.call(rbind, lapply(fitted, function(f) {
    label(f$row, data.frame(x = grid, p = psychometric_p(grid, f$fit)))
  }))
  order_of <- levels(study$trials$condition_of)
  points$condition <- factor(points$condition, order_of)
  if (!is.null(lines)) lines$condition <- factor(lines$condition, order_of)
  colours <- stats::setNames(rep_len(kLevelColours, length(order_of)), order_of)
  ggplot2::ggplot(points, ggplot2::aes(in_unit(study, x), positive / n, colour = condition)) +
    (if (!is.null(lines)) ggplot2::geom_line(ggplot2::aes(y = p), lines, linewidth = 0.4)) +
    ggplot2::geom_point(ggplot2::aes(size = n), shape = 1, stroke = 0.4) +
    ggplot2::scale_size_area("Trials", max_size = 2.5) +
    ggplot2::scale_colour_manual(condition_label(study), values = colours,
      guide = if (length(order_of) > 1) "legend" else "none") +
    threshold_axis(study) +
    ggplot2::scale_y_continuous(positive_label(study), breaks = c(0, 0.5, 1),
      limits = c(0, 1)) +
    ggplot2::facet_wrap("participant", ncol = 5) + rating_theme() +
    ggplot2::theme(strip.background = ggplot2::element_blank())
}

thresholds_panel <- function(study, rows) {
  order_of <- levels(droplevels(study$trials$condition_of))
  rows <- rows[rows$use, ]
  rows$place <- match(rows$condition, order_of)
  mean <- threshold_means(study, rows)
  mean$place <- match(mean$condition, order_of) - 0.15
  rows$x <- rows$place + 0.1 + spread(rows$participant) * 0.3
  ggplot2::ggplot(mean, ggplot2::aes(place, mean)) +
    (if (length(order_of) > 1) ggplot2::geom_line(ggplot2::aes(x, in_unit(study, threshold),
      group = participant), rows, linewidth = 0.2, colour = "grey72")) +
    ggplot2::geom_linerange(ggplot2::aes(x, in_unit(study, threshold), ymin = in_unit(study, low),
      ymax = in_unit(study, high)), rows, linewidth = 0.2, colour = "grey60", na.rm = TRUE) +
    ggplot2::geom_point(ggplot2::aes(x, in_unit(study, threshold)), rows, size = 0.9, stroke = 0,
      colour = "grey60") +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high), linewidth = 0.7, na.rm = TRUE) +
    ggplot2::geom_point(size = 1.9) +
    ggplot2::scale_x_continuous(condition_label(study), breaks = seq_along(order_of),
      labels = if (length(order_of) > 1) order_of, limits = c(0.5, length(order_of) + 0.5)) +
    (if (study$log10) ggplot2::scale_y_log10(threshold_label(study)) else
      ggplot2::scale_y_continuous(threshold_label(study))) + rating_theme()
}

threshold_label <- function(study) {
  name <- label_of(study$axis)
  paste0("Threshold, ", tolower(substr(name, 1, 1)), substring(name, 2))
}

threshold_axis <- function(study) {
  if (study$log10) ggplot2::scale_x_log10(label_of(study$axis)) else
    ggplot2::scale_x_continuous(label_of(study$axis))
}

positive_label <- function(study) {
  if (is.null(study$guess)) "Share answered yes" else "Share answered right"
}

condition_label <- function(study) {
  if (length(study$split) == 0) return("All trials")
  paste(vapply(study$split, label_of, ""), collapse = kConditionSeparator)
}
