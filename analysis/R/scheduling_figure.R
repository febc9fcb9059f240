# The figures of kinds of scheduling, and of what was clicked at.
#
#   contrast: each participant's difference of a pair of kinds, overall and at each number of bodies; its
#             mean with a 95 % t interval
#   kernels:  clicks per second that a collision adds, by the time since it, bad and good ones; means over
#             participants with 95 % t intervals
#   gains:    each participant's gain of bad and of good collisions; their means with 95 % t intervals
# SPDX-License-Identifier: MIT

kEventColours <- c(bad = "#D55E00", good = "#0072B2")
kEventShapes <- c(bad = 17, good = 16)

# The figures of each pair that anybody rated both kinds of: list of list(name, of, pair).
contrasts_drawn <- function(part) {
  pairs <- Filter(function(pair) has_contrast(part$trials, pair), part$pairs)
  unlist(lapply(pairs, function(pair) lapply(c("rating", "clicks"), function(of) {
    list(name = paste(of, pair_words(pair, "-"), sep = "-"), of = of, pair = pair)
  })), recursive = FALSE)
}

contrast_figures <- function(part) {
  better <- function(of) if (of == "rating" && part$scale$rating_best == part$scale$rating_maximum)
    "above" else "below"
  who <- who_words(part$all_simulated)
  several <- participant_count(part$trials) > 1
  lapply(contrasts_drawn(part), function(figure) {
    pair <- figure$pair
    margin <- if (figure$of == "rating") equivalence_margin(part$scale)
    title <- c(rating = "Rating", clicks = "Clicks per trial")[[figure$of]]
    list(name = figure$name,
      plot = contrast_panel(part$trials, figure$of, margin, part$all_simulated, pair) +
        difference_axis(sprintf("%s, %s\n(%s 0: %s is better)", title, pair_words(pair),
          better(figure$of), pair$of)) + column_theme(),
      caption = paste0(title, ", ", pair_words(pair), ", of each ", who, " (grey); black: the mean",
        if (several) " and its 95 % t interval", if (!is.null(margin)) sprintf("; grey band: the equivalence margin of ±%.2f points",
          margin), "."))
  })
}

contrast_panel <- function(trials, of, margin, simulated, pair = kTrackedRandom) {
  differences <- contrast_differences(trials, of, pair)
  places <- colnames(differences)
  each <- long_means(differences, "place")
  each$x <- match(each$place, places) + 0.15 + spread(each$participant) * 0.4
  mean <- t_intervals(differences)
  mean$x <- seq_along(places) - 0.15
  mean <- mean[!is.na(mean$mean), ]
  who <- c(if (all(is.na(mean$low))) "mean" else "mean, 95 % CI", who_words(simulated))
  band <- if (!is.null(margin)) ggplot2::annotate("rect", xmin = -Inf, xmax = Inf, ymin = -margin,
    ymax = margin, fill = "grey92")
  ggplot2::ggplot(mean, ggplot2::aes(x, mean)) + band + zero_line() +
    ggplot2::geom_point(ggplot2::aes(colour = who[2]), each, size = 0.9, stroke = 0) +
    interval_bars(0.6, colour = who[1]) +
    ggplot2::geom_point(ggplot2::aes(colour = who[1]), size = 1.9) +
    ggplot2::scale_colour_manual(NULL, breaks = who, values = stats::setNames(
      c("black", "grey60"), who), guide = ggplot2::guide_legend(override.aes = list(
        size = c(1.9, 0.9)))) +
    ggplot2::scale_x_continuous("Number of bodies", breaks = seq_along(places),
      labels = places, limits = c(0.5, length(places) + 0.5)) +
    figure_theme() +
    ggplot2::theme(axis.title.y = ggplot2::element_text(margin = ggplot2::margin(r = 4)))
}

# 0 is always on it.
difference_axis <- function(title) {
  list(ggplot2::scale_y_continuous(title, labels = minus_signed), ggplot2::expand_limits(y = 0))
}

# The figures of the click regression; none without it. `detection`: of click_detection.
click_figures <- function(detection, simulated) {
  if (is.null(detection$kernels)) return(list())
  gains <- detection$gains[detection$gains$scheduling == "all", ]
  who <- who_words(simulated)
  intervals <- if (nrow(gains) > 1) " with 95 % t intervals"
  list(
    list(name = "kernels", plot = kernel_panel(detection$kernels) + column_theme(),
      caption = paste0("Clicks per second that one collision adds, by the time since it: mean of ",
        count_of(nrow(gains), who), intervals, ".")),
    list(name = "gains", plot = gain_panel(gains, simulated) + column_theme(),
      caption = paste0("Clicks that a collision adds: each ", who, "'s gains (grey), and their means",
        intervals, ".")))
}

kernel_panel <- function(kernels) {
  kernels$x <- (kernels$from_ms + kernels$to_ms) / 2 + ifelse(kernels$collision == "bad", -12, 12)
  ggplot2::ggplot(kernels, ggplot2::aes(x, mean, colour = collision, shape = collision)) + zero_line() +
    ggplot2::geom_line(linewidth = 0.4) + interval_bars(0.6) + ggplot2::geom_point(size = 1.9) +
    series_scales("Collision", kEventColours, kEventShapes) +
    ggplot2::scale_x_continuous("Time since the collision (ms)", breaks = 1000 * kLagEdgesS) +
    ggplot2::scale_y_continuous("Clicks per second added by one collision", labels = minus_signed) +
    figure_theme()
}

gain_panel <- function(gains, simulated) {
  events <- names(kEventColours)
  each <- data.frame(participant = rep(gains$participant, 2), gain = unlist(gains[events]),
    x = rep(1:2, each = nrow(gains)))
  each$x <- each$x + 0.15 + spread(each$participant) * 0.4
  mean <- cbind(t_intervals(gains[events]), event = events, x = 1:2 - 0.15)
  ggplot2::ggplot(mean, ggplot2::aes(x, mean)) + zero_line() +
    ggplot2::geom_line(ggplot2::aes(y = gain, group = participant), each, linewidth = 0.2,
      colour = "grey72") +
    ggplot2::geom_point(ggplot2::aes(y = gain), each, size = 0.9, stroke = 0, colour = "grey60") +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high, colour = event),
      linewidth = 0.6, na.rm = TRUE) +
    ggplot2::geom_point(ggplot2::aes(colour = event, shape = event), size = 1.9) +
    series_scales("Collision", kEventColours, kEventShapes) +
    ggplot2::scale_x_continuous(paste("Collision, for each", who_words(simulated)), breaks = 1:2,
      labels = events, limits = c(0.6, 2.6)) +
    ggplot2::scale_y_continuous("Gain: clicks that a collision adds", labels = minus_signed) +
    figure_theme()
}
