# The study of schedulers, in which nobody takes part: which collisions does each put first?
#
#   seen_collision, trial_level ─> collisions ─┬─> histograms, shares: two figures
#                                              └─> shapes, met or not: words and a table
#
#   change  share at the 95th minus share at the 5th percentile, of a straight line through all
#           collisions: how much the share of high priority rises (+) or falls (−)
#   step    the share of collisions that the best single cut puts right: 1 for a perfect step, about
#           the larger list's share for none
#
# Every collision is a data point of one simulated run, not a participant, and neighbours in time are
# alike: numbers describe, and no p is given.
# SPDX-License-Identifier: MIT

kPriorityColours <- c(high = "#D55E00", low = "#56B4E9")

# What the page shows of a study of schedulers (part_results.R); NULL of others, and without collisions.
distribution_results <- function(path, protocol) {
  if (!identical(study_description(protocol)$kind, "distribution")) return(NULL)
  found <- placed_collisions(path, protocol)
  if (NROW(found$collisions) == 0) return(NULL)
  shapes <- shape_table(found$collisions)
  bins <- histogram_table(found$collisions)
  figure <- function(name, plot, caption) {
    list(name = name, plot = plot, caption = caption, width_mm = kPageWidthMm,
      height_mm = 20 + 24 * nlevels(found$collisions$scheduler))
  }
  list(part = list(protocol = protocol, response = "distribution"),
    tests = combine_outcomes(outcome(remarks = paste("Every collision is a data point of one",
      "simulated run: numbers describe, nothing is tested."))),
    paragraphs = c(list(distribution_sentences(found)), as.list(shape_sentences(shapes))),
    figures = list(
      figure("histograms", histogram_panel(bins), paste("Collisions of high (list 0) and low priority",
        "by place (thesis figs. 6.11 to 6.16).")),
      figure("shares", share_panel(bins),
        "Share of high priority in each bin, with 95 % Wilson intervals.")),
    tables = list(
      list(name = "shapes", title = "Shapes", rows = transform(shapes, place = kPlaces[place]),
        heads = c("Scheduler", "Over", "Collisions", "Share of high priority", "Change of the share",
          "Put right by the best cut")),
      list(name = "bins", rows = bins)))
}

# list(collisions, walls, unknown): the collisions of the trials that are analysed, with their
# scheduler; list 0 is that of high priority. Collisions with a wall are out and counted: the thesis has
# none, and thresholds are solved on pairs of bodies.
placed_collisions <- function(path, protocol) {
  fields <- query_study(path, "SELECT name FROM pragma_table_info('seen_collision')")$name
  if (!all(c(names(kPlaces), "list") %in% fields)) return(list())  # data of before
  places <- sprintf("CAST(%s AS REAL) AS %s", names(kPlaces), names(kPlaces))
  rows <- analysed_rows(path, protocol, query_study(path, paste("SELECT participant, trial, body_a,",
    "body_b,", paste(places, collapse = ", "), ", list = 0 AS high,",
    "CAST(trial_level.level AS TEXT) AS scheduler FROM seen_collision",
    "JOIN trial_level USING (trial) WHERE protocol = ? AND phase = 'main'",
    "AND trial_level.factor = 'scheduler'"), protocol))
  wall <- is_wall(rows$body_a) | is_wall(rows$body_b)
  known <- stats::complete.cases(rows[names(kPlaces)])
  rows$high <- rows$high == 1
  seen <- unique(rows$scheduler)
  order_of <- c(unlist(lapply(kExpectedShapes, `[[`, 1)), "distance")
  rows$scheduler <- factor(rows$scheduler, unique(c(intersect(order_of, seen), seen)))
  list(collisions = droplevels(rows[!wall & known, ]), walls = sum(wall), unknown = sum(!known & !wall))
}

distribution_sentences <- function(study) {
  counts <- table(study$collisions$scheduler)
  high <- tapply(study$collisions$high, study$collisions$scheduler, mean)
  unequal <- names(high)[abs(high - 0.5) > 0.02]
  c(
    sprintf("Collisions: %s.", paste0(names(counts), " ", format(as.integer(counts), big.mark = ",",
      trim = TRUE), collapse = "; ")),
    if (length(unequal) > 0) sprintf("The lists do not share 50 : 50 ± 2 %% for %s.",
      paste0(unequal, sprintf(" (%.1f %% high)", 100 * high[unequal]), collapse = ", ")) else
      "High and low priority share 50 : 50 ± 2 % for every scheduler.",
    if (study$walls > 0) sprintf("Left out: %s with a face of the view, which no list is made for.",
      count_of(study$walls, "collision")),
    if (study$unknown > 0) sprintf("Without a recorded distance, speed or eccentricity, left out: %s.",
      count_of(study$unknown, "collision")))
}

histogram_panel <- function(bins) {
  long <- rbind(cbind(bins, priority = "low", count = bins$low),
    cbind(bins, priority = "high", count = bins$high))
  long$priority <- factor(long$priority, c("low", "high"))
  long$place <- factor(kPlaces[long$place], kPlaces)
  long$base <- ifelse(long$priority == "high", 0, long$high)
  ggplot2::ggplot(long, ggplot2::aes(xmin = middle - width / 2, xmax = middle + width / 2,
    ymin = base, ymax = base + count, fill = priority)) +
    ggplot2::geom_rect() +
    ggplot2::scale_fill_manual("Priority", values = kPriorityColours) +
    ggplot2::facet_grid(scheduler ~ place, scales = "free") +
    ggplot2::labs(x = NULL, y = "Collisions") + distribution_theme()
}

share_panel <- function(bins) {
  bins$place <- factor(kPlaces[bins$place], kPlaces)
  bins <- bins[!is.na(bins$share), ]
  ggplot2::ggplot(bins, ggplot2::aes(middle, share)) +
    ggplot2::geom_hline(yintercept = 0.5, linewidth = 0.3, colour = "grey60") +
    ggplot2::geom_linerange(ggplot2::aes(ymin = share_low, ymax = share_high), linewidth = 0.4) +
    ggplot2::geom_line(linewidth = 0.3) + ggplot2::geom_point(size = 0.8) +
    ggplot2::scale_y_continuous("Share of high priority", breaks = c(0, 0.5, 1), limits = c(0, 1)) +
    ggplot2::facet_grid(scheduler ~ place, scales = "free_x") + ggplot2::labs(x = NULL) +
    distribution_theme()
}

distribution_theme <- function() {
  figure_theme() + ggplot2::theme(strip.text = ggplot2::element_text(size = kTextPt),
    panel.spacing = ggplot2::unit(2, "mm"))
}

kPlaces <- c(distance_m = "depth (m)", speed_deg_s = "projected speed (°/s)",
  eccentricity_deg = "eccentricity (°)")
kBins <- 20
# What counts as a shape, our choice.
kFlatChange <- 0.10
kWeakChange <- 0.25
kStepShare <- 0.95

# What experiments predict (thesis sec. 6.3): scheduler with its other names, place, shape; and why,
# from geometry alone, it need not be met.
kExpectedShapes <- list(
  list("size", "distance_m", "step"),
  list(c("velocity", "speed"), "speed_deg_s", "step"),
  list(c("velocity", "speed"), "distance_m", "rises"),
  list("eccentricity", "distance_m", "flat", paste(" Depth is the distance from the eye: the farthest",
    "places are the far face's corners, and near the eye a body's own size keeps it from the edges.")),
  list(c("gap", "centres"), "distance_m", "flat"),
  list(c("gap", "centres"), "eccentricity_deg", "flat"),
  list(c("projected-gap", "projected-centres"), "distance_m", "falls"),
  list("collision-speed", "distance_m", "weak",
    " A relative speed falls with distance as every projected speed does."),
  list("collision-speed", "speed_deg_s", "weak",
    " The relative speed of two bodies is at most twice their mean speed."),
  list("collision-speed", "eccentricity_deg", "weak"))

# c(change, step) of logical `high` over numbers `x`; NA for fewer than two values.
shape_of <- function(x, high) {
  if (length(unique(x)) < 2) return(c(change = NA_real_, step = NA_real_))
  ends <- stats::quantile(x, c(0.05, 0.95), names = FALSE)
  slope <- stats::cov(x, high) / stats::var(x)
  c(change = slope * diff(ends), step = best_cut(x, high))
}

# The share that the best cut puts right, with high on either side of it. Equal values stay together.
best_cut <- function(x, high) {
  order_of <- order(x)
  below <- cumsum(high[order_of])
  n <- length(x)
  ends <- which(c(diff(x[order_of]) > 0, TRUE))
  high_below <- below[ends] + (n - ends) - (below[n] - below[ends])
  max(high_below, n - high_below) / n
}

# One row per scheduler and place: collisions, share of high priority, change, step.
shape_table <- function(collisions) {
  each_row(split(collisions, collisions$scheduler, drop = TRUE), function(some) {
    each_row(names(kPlaces), function(place) {
      data.frame(scheduler = some$scheduler[1], place = place, collisions = nrow(some),
        high_share = mean(some$high), t(shape_of(some[[place]], some$high)))
    })
  })
}

# One row per scheduler, place and bin: counts of high and low, the share of high with its 95 %
# Wilson interval. Bins are the same for every scheduler: from 0 or the least to the 99.5th percentile.
histogram_table <- function(collisions) {
  edges <- lapply(collisions[names(kPlaces)], function(x) {
    seq(min(x), stats::quantile(x, 0.995, names = FALSE), length.out = kBins + 1)
  })
  each_row(split(collisions, collisions$scheduler, drop = TRUE), function(some) {
    each_row(names(kPlaces), function(place) {
      bin <- findInterval(some[[place]], edges[[place]], rightmost.closed = TRUE)
      inside <- bin >= 1 & bin <= kBins
      high <- tabulate(bin[inside & some$high], kBins)
      low <- tabulate(bin[inside & !some$high], kBins)
      middle <- (utils::head(edges[[place]], -1) + edges[[place]][-1]) / 2
      data.frame(scheduler = some$scheduler[1], place = place, middle = middle,
        width = diff(edges[[place]]), high = high, low = low, wilson_share(high, high + low))
    })
  })
}

# share, share_low, share_high of `count` of `n` (Wilson 1927); NA for n = 0.
wilson_share <- function(count, n) {
  z <- stats::qnorm(0.975)
  share <- ifelse(n > 0, count / n, NA)
  middle <- (share + z^2 / (2 * n)) / (1 + z^2 / n)
  half <- z * sqrt(share * (1 - share) / n + z^2 / (4 * n^2)) / (1 + z^2 / n)
  data.frame(share = share, share_low = pmax(middle - half, 0), share_high = pmin(middle + half, 1))
}

# A sentence for each expected shape whose scheduler is there: is it met, by which number?
shape_sentences <- function(shapes) {
  unlist(lapply(kExpectedShapes, function(expected) {
    rows <- shapes[shapes$scheduler %in% expected[[1]] & shapes$place == expected[[2]], ]
    lapply(split(rows, seq_len(nrow(rows))), shape_sentence, expected[[3]], unlist(expected[-(1:3)]))
  }), use.names = FALSE)
}

shape_sentence <- function(row, shape, reason) {
  met <- switch(shape,
    step = row$step >= kStepShare, rises = row$change > kFlatChange,
    falls = row$change < -kFlatChange, flat = abs(row$change) <= kFlatChange,
    weak = abs(row$change) <= kWeakChange)
  expected <- c(step = "a step", rises = "a share that rises", falls = "a share that falls",
    flat = "a flat share", weak = "a weak change")[[shape]]
  number <- if (shape == "step") {
    sprintf("the best cut puts %.1f %% of collisions right, %.0f %% or more is a step",
      100 * row$step, 100 * kStepShare)
  } else {
    limit <- if (shape == "weak") kWeakChange else kFlatChange
    sprintf("the share changes by %s from the 5th to the 95th percentile, ±%.2f is %s",
      sub("-", "−", sprintf("%+.2f", row$change)), limit, if (shape == "weak") "weak" else "flat")
  }
  sprintf("%s: %s over %s was expected and is %s (%s).%s", row$scheduler, expected,
    sub(" \\(.*", "", kPlaces[[row$place]]), if (isTRUE(met)) "met" else "NOT met", number,
    if (isTRUE(met) || is.null(reason)) "" else reason)
}
