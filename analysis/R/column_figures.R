# The figures of a report.
#
#   by factor:        each participant's mean, thin and grey; the mean and its interval in black
#   by two factors:   means and intervals; colour and shape say the second factor's level
#   thresholds:       each participant's function; each participant's threshold by condition
# SPDX-License-Identifier: MIT

kMostLines <- 7  # levels that colours and shapes tell apart

# What a part's figures show on their vertical axis: list(of, title, axis), where `axis` adds the
# scale to a plot. Clicks are per second: trials may differ in length.
measure_of <- function(part) {
  switch(part$response,
    rating = list(of = "rating", title = "Mean rating",
      axis = axis_of_rating(part$scale, words = TRUE, width = 13)),
    mark = list(of = "mark", title = "Mean mark", axis = list(
      ggplot2::scale_y_continuous("Mean mark"), ggplot2::coord_cartesian(ylim = part$line))),
    press = list(of = "press_s", title = "Mean time of the click (s)", axis = list(
      ggplot2::scale_y_continuous("Mean time of the click (s)"))),
    clicks = list(of = "click_rate", title = "Clicks per second", axis = list(
      ggplot2::scale_y_continuous("Clicks per second", limits = c(0, NA)))),
    list(of = "positive", title = positive_label(part), axis = list(
      ggplot2::scale_y_continuous(positive_label(part), breaks = seq(0, 1, 0.25),
        labels = c("0", ".25", ".5", ".75", "1")), ggplot2::coord_cartesian(ylim = c(0, 1)))))
}

# Every figure of a part: list of list(name, caption, plot, height_mm).
figures_of_part <- function(part, functions = NULL) {
  if (part$response == "threshold") return(threshold_column_figures(part, functions))
  measure <- measure_of(part)
  figure <- function(factors, plot, caption) {
    list(name = figure_name(factors),
      plot = plot + measure$axis + column_theme() + turned_labels(part$trials[[factors[1]]]),
      caption = caption(part, factors, measure))
  }
  single <- lapply(unname(part$factors), function(factor) {
    figure(factor, factor_plot(part$trials, factor, measure$of), factor_figure_caption)
  })
  c(single, lapply(drawn_pairs(part), function(pair) {
    figure(pair, split_plot(part$trials, pair, measure$of, bar = 0.6, point = 1.7, expand = 0.1),
      pair_figure_caption)
  }))
}

# Levels whose names would run into each other stand upright.
turned_labels <- function(factor) {
  if (sum(nchar(levels(factor)) + 1) > 45) ggplot2::theme(
    axis.text.x = ggplot2::element_text(angle = 90, hjust = 1, vjust = 0.5))
}

figure_name <- function(factors) paste0("by-", paste(factors, collapse = "-and-"))

# The pairs of factors that are shown together, each with that of the axis first: numbers before
# words, the one with more levels before the other.
figure_pairs <- function(part) {
  if (!length(part$factors) %in% 2:3) return(list())
  score <- function(f) 100 * is_number(part$trials[[f]]) + nlevels(part$trials[[f]])
  lapply(utils::combn(unname(part$factors), 2, simplify = FALSE), function(pair) {
    pair[order(-vapply(pair, score, 0))]
  })
}

# Those of which colours and shapes tell the levels apart.
drawn_pairs <- function(part) {
  Filter(function(pair) nlevels(droplevels(part$trials[[pair[2]]])) <= kMostLines,
    figure_pairs(part))
}

factor_plot <- function(trials, factor, of) {
  each <- shifted_means(trials, factor, of)
  ggplot2::ggplot(placed_means(trials, factor, of), ggplot2::aes(x, mean)) +
    (if (length(between_factors(trials, factor)) == 0) ggplot2::geom_line(
      ggplot2::aes(group = participant), each, linewidth = 0.25, colour = "grey65")) +
    ggplot2::geom_point(data = each, size = 0.8, stroke = 0, colour = "grey55") +
    line_of_numbers(trials, factor, linewidth = 0.5) + interval_bars(0.9) +
    ggplot2::geom_point(size = 1.9) + level_axis(trials, factor)
}

threshold_column_figures <- function(part, functions) {
  people <- length(unique(functions$rows$participant))
  captions <- threshold_captions(part)
  curves <- list(name = "curves", caption = captions[["curves"]],
    plot = curves_panel(part, functions) + ggplot2::facet_wrap("participant", ncol = 3) +
      column_theme() + ggplot2::theme(legend.box = "vertical", legend.title.align = 0.5,
        panel.spacing.x = grid::unit(3, "mm"), plot.margin = ggplot2::margin(2, 10, 2, 2)) +
      ggplot2::guides(colour = if (length(part$split) > 0) ggplot2::guide_legend(order = 1,
        title.position = "top", ncol = 4) else "none", size = ggplot2::guide_legend(order = 2)),
    height_mm = 34 + 26 * ceiling(people / 3))
  c(list(curves), if (any(functions$rows$use)) list(list(name = "thresholds",
    plot = thresholds_panel(part, functions$rows) + column_theme(),
    caption = captions[["thresholds"]])))
}

column_theme <- function() {
  figure_theme() + ggplot2::theme(
    panel.grid.major.y = ggplot2::element_line(colour = "grey93", linewidth = 0.25))
}

factor_figure_caption <- function(part, factor, measure) {
  shown <- nrow(complete_participants(participant_means(part$trials, factor, measure$of)))
  who <- who_words(part$all_simulated)
  people <- participant_count(part$trials)
  title <- paste(measure$title, "by", name_and_unit(factor))
  if (people == 1) return(sprintf("%s: one %s.", title, who))
  paste0(title, ". Grey: ", count_of(people, who),
    ", shifted sideways a little to keep them apart; black: the mean",
    if (shown > 1) " and its within-participant 95 % interval (Cousineau–Morey)" else
      if (length(between_factors(part$trials, factor)) > 0)
        " and its 95 % interval over the participants of each level (Student's t)", ".",
    mean_base_words(part$trials, factor, measure$of))
}

pair_figure_caption <- function(part, pair, measure) {
  shown <- nrow(complete_participants(participant_means(part$trials, pair, measure$of)))
  paste0(measure$title, " by ", name_and_unit(pair[1]), " and ", name_and_unit(pair[2]), ": means",
    if (shown > 1) " with within-participant 95 % intervals (Cousineau–Morey)" else
      if (length(between_factors(part$trials, pair)) > 0)
        " with 95 % intervals over the participants of each (Student's t)", ".",
    mean_base_words(part$trials, pair, measure$of))
}
