# The figures of a gaze-contingent study: ratings and clicks (thesis 6.18 and 6.19), and what was
# clicked at.
#
#   a: kinds of scheduling within each number of bodies; means with within-participant intervals
#      before, participants faint behind
#   b: the planned contrast, such as tracked − random, of each participant; its mean with a 95 % t
#      interval
#   c: a second pair of kinds, where the study has one, on the axis of b
#
#   kernels: a: clicks per second that a collision adds, by the time since it, bad and good ones;
#               means over participants with 95 % t intervals
#            b: each participant's gain of bad and of good collisions; their means with 95 % t intervals
# SPDX-License-Identifier: MIT

kKindColours <- c(
  "all-good" = "#009E73", tracked = "#0072B2", recorded = "#CC79A7", random = "#D55E00",
  "all-bad" = "#000000"
)
kKindShapes <- c("all-good" = 15, tracked = 16, recorded = 15, random = 17, "all-bad" = 18)
kKindSpacing <- 0.2  # between two kinds, in units of the distance of two groups
kEventColours <- c(bad = "#D55E00", good = "#0072B2")
kEventShapes <- c(bad = 17, good = 16)

# Writes both figures and returns their paths.
write_scheduling_figures <- function(study) {
  draw <- function(of, axes, margin, ending) {
    write_figure(function() scheduling_figure(study, of, axes, margin), output_path(study, ending))
  }
  c(draw("rating", rating_axes(study$scale), equivalence_margin(study$scale), "-ratings"),
    draw("clicks", click_axes(), NULL, "-clicks"))
}

# As one grob; the panel of a pair is left out when nobody rated both its kinds. `of`: the column,
# rating or clicks; `axes`: list(means, differences): ggplot2 parts for the vertical axis of panel a,
# and a function of a pair that gives those of its panel; `margin`: half width of the equivalence
# band, or NULL.
scheduling_figure <- function(study, of, axes, margin) {
  trials <- study$trials
  pairs <- Filter(function(pair) has_contrast(trials, pair), study$pairs)
  reach <- unlist(lapply(pairs, function(pair) {
    range(contrast_differences(trials, of, pair), na.rm = TRUE)
  }))
  beside <- lapply(pairs, function(pair) {
    contrast_panel(trials, of, margin, study$all_simulated, pair) + axes$differences(pair) +
      ggplot2::expand_limits(y = reach) + (if (!identical(pair, pairs[[1]])) unseen_legend())
  })
  panels_beside(c(list(kinds_panel(trials, of) + axes$means), beside), first = 1.7)
}

# One legend says it for every pair; its room is kept, so that panels stay of one height.
unseen_legend <- function() {
  list(
    ggplot2::guides(colour = ggplot2::guide_legend(override.aes = list(alpha = 0))),
    ggplot2::theme(legend.text = ggplot2::element_text(colour = "transparent")))
}

kinds_panel <- function(trials, of) {
  cells <- c("bodies", "scheduling")
  groups <- levels(droplevels(trials$bodies))
  kinds <- levels(droplevels(trials$scheduling))
  place <- function(rows) {
    rows$kind <- factor(rows$scheduling, kinds)
    rows$x <- match(rows$bodies, groups) +
      (as.integer(rows$kind) - (length(kinds) + 1) / 2) * kKindSpacing
    rows
  }
  mean <- place(means_with_intervals(trials, cells, of))
  each <- place(long_means(participant_means(trials, cells, of), cells))
  # The mean at the left of its place, participants at its right: neither hides the other.
  mean$x <- mean$x - 0.2 * kKindSpacing
  each$x <- each$x + (0.25 + 0.5 * spread(each$participant)) * kKindSpacing
  ggplot2::ggplot(mean, ggplot2::aes(x, mean, colour = kind, shape = kind)) +
    ggplot2::geom_point(data = each, size = 0.8, stroke = 0, alpha = 0.45, shape = 16,
      show.legend = FALSE) +
    interval_bars(0.6) + ggplot2::geom_point(size = 1.9) +
    series_scales("Scheduling", kKindColours, kKindShapes) +
    ggplot2::scale_x_continuous("Number of bodies", breaks = seq_along(groups), labels = groups,
      expand = ggplot2::expansion(add = 0.25)) +
    figure_theme()
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

# Ratings: the whole scale with both its ends in words, and which side of 0 is better.
rating_axes <- function(scale) {
  better <- if (scale$rating_best == scale$rating_maximum) "above" else "below"
  list(means = axis_of_rating(scale, words = TRUE), differences = function(pair) {
    difference_axis(sprintf("Rating, %s\n(%s 0: %s is better)", pair_words(pair), better, pair$of))
  })
}

# Whole numbers of clicks; an interval that would reach below 0 ends there.
click_axes <- function() {
  list(
    means = list(ggplot2::scale_y_continuous("Clicks per trial (\"a bad collision\")",
      limits = c(0, NA), breaks = function(limits) unique(round(pretty(limits))),
      oob = scales::oob_squish, expand = ggplot2::expansion(mult = c(0.02, 0.05)))),
    differences = function(pair) difference_axis(sprintf(
      "Clicks per trial, %s\n(below 0: %s is better)", pair_words(pair), pair$of)))
}

# 0 is always on it.
difference_axis <- function(title) {
  list(ggplot2::scale_y_continuous(title, labels = minus_signed), ggplot2::expand_limits(y = 0))
}

scheduling_captions <- function(study) {
  cells <- participant_means(study$trials, c("scheduling", "bodies"))
  shown <- nrow(complete_participants(cells))
  who <- who_words(study$all_simulated)
  pairs <- Filter(function(pair) has_contrast(study$trials, pair), study$pairs)
  panels <- paste0(letters[seq_along(pairs) + 1], ": ", vapply(pairs, pair_words, ""))
  caption <- function(title, figure, what, more) {
    paste0(title, if (study$thesis) sprintf(" (thesis fig. %s)", figure), ". a: mean ", what,
      " by kind of scheduling, ", count_of(max(shown, 1), who), "; ",
      if (shown > 1) "bars: within-participant 95 % confidence intervals (Cousineau–Morey); ",
      "faint points: ", who, "s.", if (length(pairs) > 0) paste0(" ", paste(panels,
        collapse = ", "), " of each; black, the mean and its 95 % t interval", more, "."))
  }
  c(caption("Ratings", "6.18", "rating", sprintf("; grey band, the equivalence margin of ±%.2f points",
      equivalence_margin(study$scale))), "",
    caption("Clicks", "6.19", "number of clicks per trial", ""))
}

# The figure of the click regression. `detection`: of click_detection.
kernel_figure <- function(detection, simulated) {
  gains <- detection$gains[detection$gains$scheduling == "all", ]
  panels_beside(list(kernel_panel(detection$kernels), gain_panel(gains, simulated)), first = 1.7)
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

kernel_caption <- function(detection, simulated) {
  people <- sum(detection$gains$scheduling == "all")
  paste0("What was clicked at. a: clicks per second that one collision adds, by the time since it, ",
    "mean of ", count_of(people, who_words(simulated)), if (people > 1) "; bars: 95 % t intervals",
    ". b: each ", who_words(simulated), "'s gains (grey), their means",
    if (people > 1) " and 95 % t intervals", ".")
}
