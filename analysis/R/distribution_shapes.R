# How the collisions of high priority lie over depth, projected speed and eccentricity, for each
# scheduler: counts by bin, the share of high priority, and numbers for the shape of that share.
#
#   change  share at the 95th minus share at the 5th percentile, of a straight line through all
#           collisions: how much the share rises (+) or falls (−)
#   step    the share of collisions that the best single cut puts right: 1 for a perfect step, about
#           the larger list's share for none
#
# Every collision is a data point of one simulated run, not a participant, and neighbours in time are
# alike: numbers describe, and no p is given.
# SPDX-License-Identifier: MIT

kPlaces <- c(distance_m = "depth (m)", speed_deg_s = "projected speed (°/s)",
  eccentricity_deg = "eccentricity (°)")
kBins <- 20
# What counts as a shape, our choice.
kFlatChange <- 0.10
kWeakChange <- 0.25
kStepShare <- 0.95

# What experiments predict (thesis sec. 6.3): scheduler, its other names, place, shape.
kExpectedShapes <- list(
  list(c("size"), "distance_m", "step"),
  list(c("velocity", "speed"), "speed_deg_s", "step"),
  list(c("velocity", "speed"), "distance_m", "rises"),
  list(c("eccentricity"), "distance_m", "flat"),
  list(c("gap", "centres"), "distance_m", "flat"),
  list(c("gap", "centres"), "eccentricity_deg", "flat"),
  list(c("projected-gap", "projected-centres"), "distance_m", "falls"),
  list(c("collision-speed"), "distance_m", "weak"),
  list(c("collision-speed"), "speed_deg_s", "weak"),
  list(c("collision-speed"), "eccentricity_deg", "weak")
)

# Why a shape need not be met, from geometry alone: scheduler, place, words.
kShapeReasons <- list(
  list("eccentricity", "distance_m", paste("Depth is the distance from the eye: the farthest places",
    "are the far face's corners, and near the eye a body's own size keeps it from the edges")),
  list("collision-speed", "distance_m", paste("A relative speed falls with distance as every",
    "projected speed does")),
  list("collision-speed", "speed_deg_s", paste("The relative speed of two bodies is at most twice",
    "their mean speed"))
)

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
    row <- shapes[shapes$scheduler %in% expected[[1]] & shapes$place == expected[[2]], ]
    if (nrow(row) == 0) return(NULL)
    vapply(seq_len(nrow(row)), function(i) shape_sentence(row[i, ], expected[[3]]), "")
  }))
}

shape_sentence <- function(row, shape) {
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
    if (isTRUE(met)) "" else shape_reason(row))
}

# " ... ." where geometry says why the shape is not met, otherwise "".
shape_reason <- function(row) {
  mine <- Filter(function(reason) reason[[1]] == row$scheduler && reason[[2]] == row$place,
    kShapeReasons)
  if (length(mine) > 0) paste0(" ", mine[[1]][[3]], ".") else ""
}
