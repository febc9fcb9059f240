# Figures one column of a journal wide (85 mm), as SVG for the page and as SVG and PDF files.
#
#   by factor:        each participant's mean, thin and grey; the mean and its interval in black
#   by two factors:   means and intervals; colour and shape say the second factor's level
#   thresholds:       each participant's function; each participant's threshold by condition
#
# Text is 7 pt; colours are Okabe and Ito's (2008), and shapes say the same again.
# SPDX-License-Identifier: MIT

kColumnWidthMm <- 85
kColumnHeightMm <- 66
kMostLines <- 7  # levels that colours and shapes tell apart

# What a part's figures show on their vertical axis: list(of, title, axis), where `axis` adds the
# scale to a plot. Clicks are per second: trials may differ in length.
measure_of <- function(part) {
  switch(part$response,
    rating = list(of = "rating", title = "Mean rating",
      axis = axis_of_rating(part$scale, words = TRUE, width = 13)),
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
  single <- lapply(unname(part$factors), function(factor) list(
    name = figure_name(factor), plot = factor_plot(part, factor, measure),
    caption = factor_figure_caption(part, factor, measure)))
  double <- lapply(figure_pairs(part), function(pair) {
    list(name = figure_name(pair), plot = pair_plot(part, pair, measure),
      caption = pair_figure_caption(part, pair, measure))
  })
  c(single, Filter(function(figure) !is.null(figure$plot), double))
}

figure_name <- function(factors) paste0("by-", paste(factors, collapse = "-and-"))

# The pairs of factors that are shown together, each with that of the axis first.
figure_pairs <- function(part) {
  if (!length(part$factors) %in% 2:3) return(list())
  pairs <- utils::combn(unname(part$factors), 2, simplify = FALSE)
  lapply(pairs, function(pair) axis_first(part$trials, pair))
}

# The factor for the axis first: numbers before words, the one with more levels before the other.
axis_first <- function(trials, pair) {
  score <- vapply(pair, function(f) 100 * is_number(trials[[f]]) + nlevels(trials[[f]]), 0)
  pair[order(-score)]
}

factor_plot <- function(part, factor, measure) {
  trials <- part$trials
  means <- participant_means(trials, factor, measure$of)
  each <- long_means(means, factor)
  each <- each[!is.na(each$mean), ]
  each$x <- position_on_axis(trials, factor, rep(colnames(means), each = nrow(means))[!is.na(means)])
  step <- smallest_step(each$x)
  each$x <- each$x + spread(each$participant) * 0.16 * step
  mean <- means_with_intervals(trials, factor, measure$of)
  mean$x <- position_on_axis(trials, factor, mean$cell)
  ggplot2::ggplot(mean, ggplot2::aes(x, mean)) +
    ggplot2::geom_line(ggplot2::aes(group = participant), each, linewidth = 0.25,
      colour = "grey65") +
    ggplot2::geom_point(data = each, size = 0.8, stroke = 0, colour = "grey55") +
    ggplot2::geom_line(linewidth = 0.5) +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high), linewidth = 0.9, na.rm = TRUE) +
    ggplot2::geom_point(size = 1.9) +
    level_axis(trials, factor) + measure$axis + column_theme()
}

# NULL where colours and shapes would not tell the levels apart.
pair_plot <- function(part, pair, measure) {
  trials <- part$trials
  count <- nlevels(droplevels(trials[[pair[2]]]))
  if (count > kMostLines) return(NULL)
  mean <- means_with_intervals(trials, pair, measure$of)
  series <- factor(mean[[pair[2]]], levels(droplevels(trials[[pair[2]]])))
  at <- position_on_axis(trials, pair[1], mean[[pair[1]]])
  # Apart from the factors, of which one may be called anything, such as level.
  shown <- data.frame(series, mean = mean$mean, low = mean$low, high = mean$high,
    x = at + (as.integer(series) - (count + 1) / 2) * 0.09 * smallest_step(at))
  ggplot2::ggplot(shown, ggplot2::aes(x, mean, colour = series, shape = series)) +
    ggplot2::geom_line(linewidth = 0.4) +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high), linewidth = 0.6, na.rm = TRUE,
      show.legend = FALSE) +
    ggplot2::geom_point(size = 1.7) +
    ggplot2::scale_colour_manual(label_of(pair[2]), values = rep_len(kLevelColours, count)) +
    ggplot2::scale_shape_manual(label_of(pair[2]), values = rep_len(kLevelShapes, count)) +
    level_axis(trials, pair[1]) + measure$axis + column_theme()
}

# Numbers stand at their value unless levels would come to lie on each other; words at 1, 2, 3.
position_on_axis <- function(trials, factor, levels) {
  all <- levels(droplevels(trials[[factor]]))
  at <- if (stands_at_values(all)) as.numeric(all) else seq_along(all)
  at[match(levels, all)]
}

stands_at_values <- function(levels) {
  at <- suppressWarnings(as.numeric(levels))
  !anyNA(at) && (length(at) < 2 || smallest_step(at) >= diff(range(at)) / 12)
}

level_axis <- function(trials, factor) {
  levels <- levels(droplevels(trials[[factor]]))
  ggplot2::scale_x_continuous(label_of(factor), breaks = position_on_axis(trials, factor, levels),
    labels = if (stands_at_values(levels)) levels else vapply(levels, function(level) {
      paste(strwrap(level, 12), collapse = "\n")
    }, ""), expand = ggplot2::expansion(mult = 0.1))
}

threshold_column_figures <- function(part, functions) {
  people <- length(unique(functions$rows$participant))
  curves <- list(name = "curves", caption = sprintf(paste(
    "%s by %s, one panel for each %s. Circles: shares, area by the number of trials; lines: fitted",
    "functions."), positive_label(part), name_and_unit(part$axis), who_words(part$all_simulated)),
    plot = curves_panel(part, functions) + ggplot2::facet_wrap("participant", ncol = 3) +
      column_theme() + ggplot2::theme(legend.box = "vertical", legend.title.align = 0.5,
        panel.spacing.x = grid::unit(3, "mm"), plot.margin = ggplot2::margin(2, 10, 2, 2)) +
      ggplot2::guides(colour = if (length(part$split) > 0) ggplot2::guide_legend(order = 1,
        title.position = "top", ncol = 4) else "none", size = ggplot2::guide_legend(order = 2)),
    height_mm = 34 + 26 * ceiling(people / 3))
  if (!any(functions$rows$use)) return(list(curves))
  c(list(curves), list(list(name = "thresholds",
    plot = thresholds_panel(part, functions$rows) + column_theme(),
    caption = sprintf(paste("Thresholds of %s by condition. Grey: each %s with a 95 %% interval by",
      "parametric bootstrap (%d draws); black: the mean and its 95 %% t interval."),
      name_and_unit(part$axis), who_words(part$all_simulated), kBootstrapDraws))))
}

column_theme <- function() {
  rating_theme() + ggplot2::theme(
    strip.background = ggplot2::element_blank(),
    panel.grid.major.y = ggplot2::element_line(colour = "grey93", linewidth = 0.25))
}

factor_figure_caption <- function(part, factor, measure) {
  shown <- nrow(complete_participants(participant_means(part$trials, factor, measure$of)))
  who <- who_words(part$all_simulated)
  if (participant_count(part$trials) == 1) {
    return(sprintf("%s by %s: one %s.", measure$title, name_and_unit(factor), who))
  }
  paste0(measure$title, " by ", name_and_unit(factor), ". Grey: ",
    count_of(participant_count(part$trials), who),
    ", shifted sideways a little to keep them apart; black: the mean",
    if (shown > 1) " and its within-participant 95 % interval (Cousineau–Morey)" else "", ".")
}

pair_figure_caption <- function(part, pair, measure) {
  shown <- nrow(complete_participants(participant_means(part$trials, pair, measure$of)))
  paste0(measure$title, " by ", name_and_unit(pair[1]), " and ", name_and_unit(pair[2]), ": means",
    if (shown > 1) " with within-participant 95 % intervals (Cousineau–Morey)" else "", ".")
}

# Writes <stem>.svg and .pdf of a figure.
write_column_figure <- function(figure, stem) {
  height <- if (is.null(figure$height_mm)) kColumnHeightMm else figure$height_mm
  inch <- function(mm) mm / 25.4
  for (ending in c("svg", "pdf")) {
    device <- if (ending == "svg") grDevices::svg else grDevices::cairo_pdf
    device(paste0(stem, ".", ending), inch(kColumnWidthMm), inch(height))
    print(figure$plot)
    grDevices::dev.off()
  }
  # Cairo counts the pictures of a process: the same figure is to be the same file.
  svg <- paste0(stem, ".svg")
  lines <- readLines(svg, encoding = "UTF-8")
  writeLines(sub("id=\"surface[0-9]+\"", "id=\"surface\"", lines), svg, useBytes = TRUE)
  svg
}
