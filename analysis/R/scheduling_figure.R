# The figures of a gaze-contingent study, such as the thesis's 6.18 (ratings) and 6.19 (clicks).
#
#   a: kinds of scheduling within each number of bodies; means with within-participant intervals
#      before, participants faint behind
#   b: the planned contrast, such as tracked − random, of each participant; its mean with a 95 % t
#      interval
#   c: a second pair of kinds, where the study has one, on the axis of b
#
# Sizes, type and colours are those of the rating figure.
# SPDX-License-Identifier: MIT

kKindColours <- c(
  "all-good" = "#009E73", tracked = "#0072B2", recorded = "#CC79A7", random = "#D55E00",
  "all-bad" = "#000000"
)
kKindShapes <- c("all-good" = 15, tracked = 16, recorded = 15, random = 17, "all-bad" = 18)
kKindSpacing <- 0.2  # between two kinds, in units of the distance of two groups

# Writes <stem>.png and <stem>.pdf; the panel of a pair is left out when nobody rated both its kinds.
# `of`: the column, rating or clicks; `axes`: list(means, differences): ggplot2 parts for the vertical
# axis of panel a, and a function of a pair that gives those of its panel; `margin`: half width of the
# equivalence band, or NULL.
write_scheduling_figure <- function(trials, of, axes, margin, simulated, stem,
                                    pairs = list(kTrackedRandom)) {
  write_figure(function() {
    kinds <- kinds_panel(trials, of, simulated) + axes$means
    pairs <- Filter(function(pair) has_contrast(trials, pair), pairs)
    if (length(pairs) == 0) return(ggplot2::ggplotGrob(kinds))
    whole <- ggplot2::ggplotGrob(kinds + ggplot2::labs(tag = "a"))
    whole$widths[whole$layout$l[whole$layout$name == "panel"]] <- grid::unit(1.7, "null")
    reach <- unlist(lapply(pairs, function(pair) range(contrast_differences(trials, of, pair),
      na.rm = TRUE)))
    for (i in seq_along(pairs)) {
      panel <- contrast_panel(trials, of, margin, simulated, pairs[[i]]) +
        axes$differences(pairs[[i]]) + ggplot2::expand_limits(y = reach) +
        ggplot2::labs(tag = letters[i + 1])
      if (i > 1) panel <- panel + unseen_legend()
      whole <- cbind(whole, ggplot2::ggplotGrob(panel), size = "first")
    }
    whole
  }, stem)
}

who_words <- function(simulated) if (simulated) "simulated participant" else "participant"

# One legend says it for every pair; its room is kept, so that panels stay of one height.
unseen_legend <- function() {
  list(
    ggplot2::guides(colour = ggplot2::guide_legend(override.aes = list(alpha = 0))),
    ggplot2::theme(legend.text = ggplot2::element_text(colour = "transparent"))
  )
}

kinds_panel <- function(trials, of, simulated) {
  cells <- c("bodies", "scheduling")
  mean <- means_with_intervals(trials, cells, of)
  groups <- levels(droplevels(trials$bodies))
  kinds <- levels(droplevels(trials$scheduling))
  place <- function(rows) {
    rows$kind <- factor(rows$scheduling, kinds)
    shift <- (as.integer(rows$kind) - (length(kinds) + 1) / 2) * kKindSpacing
    rows$x <- match(rows$bodies, groups) + shift
    rows
  }
  mean <- place(mean)
  each <- place(long_cell_means(participant_means(trials, cells, of), cells))
  # The mean at the left of its place, participants at its right: neither hides the other.
  mean$x <- mean$x - 0.2 * kKindSpacing
  each$x <- each$x + (0.25 + 0.5 * spread(each$participant)) * kKindSpacing
  ggplot2::ggplot(mean, ggplot2::aes(x, mean, colour = kind, shape = kind)) +
    ggplot2::geom_point(data = each, size = 0.8, stroke = 0, alpha = 0.45, shape = 16,
      show.legend = FALSE) +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high), linewidth = 0.6, na.rm = TRUE,
      show.legend = FALSE) +
    ggplot2::geom_point(size = 1.9) +
    ggplot2::scale_colour_manual("Scheduling", values = kKindColours) +
    ggplot2::scale_shape_manual("Scheduling", values = kKindShapes) +
    ggplot2::scale_x_continuous("Number of bodies", breaks = seq_along(groups), labels = groups,
      expand = ggplot2::expansion(add = 0.25)) +
    rating_theme()
}

contrast_panel <- function(trials, of, margin, simulated, pair = kTrackedRandom) {
  differences <- contrast_differences(trials, of, pair)
  places <- colnames(differences)
  each <- data.frame(
    participant = rep(rownames(differences), ncol(differences)),
    difference = as.vector(differences), x = rep(seq_along(places), each = nrow(differences))
  )
  each <- each[!is.na(each$difference), ]
  each$x <- each$x + 0.15 + spread(each$participant) * 0.4
  mean <- as.data.frame(t(apply(differences, 2, function(x) t_interval(x[!is.na(x)]))))
  mean$x <- seq_along(places) - 0.15
  mean <- mean[!is.na(mean$mean), ]
  who <- c(if (all(is.na(mean$low))) "mean" else "mean, 95 % CI", who_words(simulated))
  band <- if (!is.null(margin)) {
    ggplot2::annotate("rect", xmin = -Inf, xmax = Inf, ymin = -margin, ymax = margin,
      fill = "grey92")
  }
  ggplot2::ggplot(mean, ggplot2::aes(x, mean)) + band +
    ggplot2::geom_hline(yintercept = 0, linewidth = 0.3, colour = "grey40") +
    ggplot2::geom_point(ggplot2::aes(y = difference, colour = who[2]), each, size = 0.9,
      stroke = 0) +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high, colour = who[1]),
      linewidth = 0.6, na.rm = TRUE, show.legend = FALSE) +
    ggplot2::geom_point(ggplot2::aes(colour = who[1]), size = 1.9) +
    ggplot2::scale_colour_manual(NULL, breaks = who, values = stats::setNames(
      c("black", "grey60"), who), guide = ggplot2::guide_legend(override.aes = list(
        size = c(1.9, 0.9)))) +
    ggplot2::scale_x_continuous("Number of bodies", breaks = seq_along(places),
      labels = places, limits = c(0.5, length(places) + 0.5)) +
    rating_theme() +
    ggplot2::theme(axis.title.y = ggplot2::element_text(margin = ggplot2::margin(r = 4)))
}

# A place between -.5 and .5 for each participant, so that equal values do not hide each other.
spread <- function(participant) {
  rank <- as.integer(factor(participant))
  rank / (max(rank, 0) + 1) - 0.5
}

# participant_means in long form, without empty cells.
long_cell_means <- function(means, factors) {
  rows <- data.frame(participant = rep(rownames(means), ncol(means)), mean = as.vector(means))
  cells <- rep(colnames(means), each = nrow(means))
  rows[factors] <- do.call(rbind, strsplit(cells, " : ", fixed = TRUE))
  rows[!is.na(rows$mean), ]
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
      limits = c(0, NA), breaks = whole_breaks, oob = scales::oob_squish,
      expand = ggplot2::expansion(mult = c(0.02, 0.05)))),
    differences = function(pair) difference_axis(sprintf(
      "Clicks per trial, %s\n(below 0: %s is better)", pair_words(pair), pair$of))
  )
}

whole_breaks <- function(limits) unique(round(pretty(limits)))

# 0 is always on it, and below it stands a minus sign, not a hyphen.
difference_axis <- function(title) {
  list(ggplot2::scale_y_continuous(title, labels = minus_signed), ggplot2::expand_limits(y = 0))
}

minus_signed <- function(x) {
  gsub("-", "−", format(x, trim = TRUE, drop0trailing = TRUE), fixed = TRUE)
}
