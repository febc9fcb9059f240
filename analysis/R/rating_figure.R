# The figure of a rating study: mean rating over the levels of one factor, and by each other factor
# beside it.
#
#   a: every participant, thin and grey, the mean and its interval in black
#   b, c: the same means split by a second factor; colour and shape say the level
# SPDX-License-Identifier: MIT

# The panels side by side as one grob. Needs an open device to measure text on. `main`: the column on
# the x axis; `beside`: columns for the panels beside it, those of a single level left out.
# `simulated`: no participant is a person, and the figure says so.
rating_figure <- function(trials, scale, main, beside, simulated) {
  split <- lapply(varying_factors(trials, beside), function(factor) {
    split_plot(trials, c(main, factor), "rating", bar = 0.5, point = 1.4, expand = 0.08) +
      axis_of_rating(scale, words = FALSE) + figure_theme()
  })
  panels_beside(c(list(rating_panel(trials, scale, main, simulated)), split), first = 1.3)
}

# Panel a: participants behind, mean and interval before.
rating_panel <- function(trials, scale, main, simulated) {
  mean <- placed_means(trials, main)
  each <- shifted_means(trials, main)
  alone <- participant_count(trials) == 1
  who <- c(mean = if (alone) paste("mean of one", who_words(simulated)) else
    if (all(is.na(mean$low))) "mean" else "mean, 95 % CI", each = who_words(simulated))
  shown <- if (alone) "mean" else c("mean", "each")
  ggplot2::ggplot(mean, ggplot2::aes(x, mean)) +
    ggplot2::geom_line(ggplot2::aes(group = participant, colour = who[["each"]]), each,
      linewidth = 0.25) +
    ggplot2::geom_point(ggplot2::aes(colour = who[["each"]]), each, size = 0.7, stroke = 0) +
    ggplot2::geom_line(ggplot2::aes(colour = who[["mean"]]), linewidth = 0.5) +
    interval_bars(0.8, colour = who[["mean"]]) +
    ggplot2::geom_point(ggplot2::aes(colour = who[["mean"]]), size = 1.6) +
    ggplot2::scale_colour_manual(NULL, breaks = unname(who[shown]),
      values = stats::setNames(c("black", "grey72"), who),
      guide = ggplot2::guide_legend(override.aes = list(size = c(1.6, 0.7)[seq_along(shown)],
        linewidth = c(0.5, 0.25)[seq_along(shown)]))) +
    level_axis(trials, main, 0.08) + axis_of_rating(scale, words = TRUE) + figure_theme()
}
