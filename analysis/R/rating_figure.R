# The rating figure: mean rating over the levels of one factor, and by each other factor beside it.
#
#   a: every participant, thin and grey, the mean and its interval in black
#   b, c: the same means split by a second factor; colour and shape say the level
#
# Sizes are a journal's: 183 mm wide, 7 pt text. Colours are Okabe and Ito's (2008).
# SPDX-License-Identifier: MIT

kFigureWidthMm <- 183
kFigureHeightMm <- 74
kTextPt <- 7
kLevelColours <- c("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000")
kLevelShapes <- c(16, 17, 15, 18, 3, 4, 8)

# Writes <stem>.png and <stem>.pdf and returns their paths. `main`: the column on the x axis;
# `beside`: columns for the panels beside it, those of a single level left out. `simulated`: no
# participant is a person, and the figure says so.
write_rating_figure <- function(trials, scale, main, beside, simulated, stem) {
  write_figure(function() rating_figure(trials, scale, main, beside, simulated), stem)
}

# Writes <stem>.png and <stem>.pdf of the grob that `figure` returns when a device is open to measure
# text on, and returns their paths.
write_figure <- function(figure, stem, height_mm = kFigureHeightMm) {
  inch <- function(mm) mm / 25.4
  png <- paste0(stem, ".png")
  pdf <- paste0(stem, ".pdf")
  grDevices::png(png, inch(kFigureWidthMm), inch(height_mm), "in", res = 600, type = "cairo")
  grid::grid.draw(figure())
  grDevices::dev.off()
  grDevices::cairo_pdf(pdf, inch(kFigureWidthMm), inch(height_mm))
  grid::grid.draw(figure())
  grDevices::dev.off()
  c(png, pdf)
}

# The panels side by side as one grob. Needs an open device to measure text on.
rating_figure <- function(trials, scale, main, beside, simulated) {
  panels <- list(rating_panel(trials, scale, main, simulated))
  for (factor in varying_factors(trials, beside)) {
    panels <- c(panels, list(split_panel(trials, scale, main, factor)))
  }
  if (length(panels) > 1) {
    panels <- Map(function(panel, letter) panel + ggplot2::labs(tag = letter),
      panels, letters[seq_along(panels)])
  }
  grobs <- lapply(panels, ggplot2::ggplotGrob)
  # The first panel holds the most and gets the most room.
  whole <- grobs[[1]]
  whole$widths[whole$layout$l[whole$layout$name == "panel"]] <- grid::unit(1.3, "null")
  do.call(cbind, c(list(whole), grobs[-1], size = "first"))
}

# Panel a: participants behind, mean and interval before.
rating_panel <- function(trials, scale, main, simulated) {
  each <- long_means(participant_means(trials, main), main)
  each <- each[!is.na(each$mean), ]
  step <- smallest_step(each$x)
  # Participants' means coincide often; a small fixed shift each keeps all of them visible.
  rank <- as.integer(factor(each$participant))
  each$x <- each$x + (rank / (max(rank) + 1) - 0.5) * 0.16 * step
  mean <- means_with_intervals(trials, main)
  who <- c(mean = "mean, 95 % CI", each = if (simulated) "simulated participant" else "participant")
  if (all(is.na(mean$low))) who[["mean"]] <- "mean"
  if (participant_count(trials) == 1) who[["mean"]] <- paste("mean of one", who[["each"]])
  shown <- if (participant_count(trials) == 1) "mean" else c("mean", "each")
  ggplot2::ggplot(mean, ggplot2::aes(x, mean)) +
    ggplot2::geom_line(ggplot2::aes(group = participant, colour = who[["each"]]), each,
      linewidth = 0.25) +
    ggplot2::geom_point(ggplot2::aes(colour = who[["each"]]), each, size = 0.7, stroke = 0) +
    ggplot2::geom_line(ggplot2::aes(colour = who[["mean"]]), linewidth = 0.5) +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high, colour = who[["mean"]]),
      linewidth = 0.8, na.rm = TRUE, show.legend = FALSE) +
    ggplot2::geom_point(ggplot2::aes(colour = who[["mean"]]), size = 1.6) +
    ggplot2::scale_colour_manual(NULL, breaks = unname(who[shown]),
      values = stats::setNames(c("black", "grey72"), who),
      guide = ggplot2::guide_legend(override.aes = list(size = c(1.6, 0.7)[seq_along(shown)],
        linewidth = c(0.5, 0.25)[seq_along(shown)]))) +
    axis_of_factor(trials, main) + axis_of_rating(scale, words = TRUE) + rating_theme()
}

# Panels b and c: one line per level of `by`, nudged apart so that intervals do not hide each other.
split_panel <- function(trials, scale, main, by) {
  mean <- means_with_intervals(trials, c(main, by))
  mean$level <- factor(mean[[by]], levels(droplevels(trials[[by]])))
  count <- nlevels(mean$level)
  mean$x <- mean$x + (as.integer(mean$level) - (count + 1) / 2) * 0.09 * smallest_step(mean$x)
  ggplot2::ggplot(mean, ggplot2::aes(x, mean, colour = level, shape = level)) +
    ggplot2::geom_line(linewidth = 0.4) +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high), linewidth = 0.5, na.rm = TRUE,
      show.legend = FALSE) +
    ggplot2::geom_point(size = 1.4) +
    ggplot2::scale_colour_manual(label_of(by), values = rep_len(kLevelColours, count)) +
    ggplot2::scale_shape_manual(label_of(by), values = rep_len(kLevelShapes, count)) +
    axis_of_factor(trials, main) + axis_of_rating(scale, words = FALSE) + rating_theme()
}

long_means <- function(means, factor) {
  data.frame(
    participant = rep(rownames(means), ncol(means)), mean = as.vector(means),
    x = position_of(rep(colnames(means), each = nrow(means)))
  )
}

smallest_step <- function(x) if (length(unique(x)) > 1) min(diff(sort(unique(x)))) else 1

axis_of_factor <- function(trials, factor) {
  levels <- levels(droplevels(trials[[factor]]))
  ggplot2::scale_x_continuous(label_of(factor), breaks = position_of(levels), labels = levels,
    expand = ggplot2::expansion(mult = 0.08))
}

# The whole scale, always; its ends in the words that participants saw, in lines of `width` letters.
axis_of_rating <- function(scale, words, width = 20) {
  ends <- c(scale$rating_minimum, scale$rating_maximum)
  breaks <- seq(ends[1], ends[2])
  labels <- as.character(breaks)
  if (words) {
    anchors <- vapply(c(scale$low_anchor, scale$high_anchor), function(anchor) {
      paste(strwrap(anchor, width), collapse = "\n")
    }, "")
    at <- c(1, length(labels))
    labels[at] <- trimws(paste0(anchors, "  ", labels[at]))
  }
  list(
    ggplot2::scale_y_continuous(if (words) "Mean rating" else NULL, breaks = breaks,
      labels = labels, expand = ggplot2::expansion(mult = 0.03)),
    ggplot2::coord_cartesian(ylim = ends, clip = "on")
  )
}

# "speed_deg_s" -> "Speed (°/s)"; a name without a known unit keeps its words.
label_of <- function(factor) {
  units <- c(
    deg_per_s = "°/s", deg_s = "°/s", m_per_s = "m/s", m_s = "m/s", deg = "°", ms = "ms",
    percent = "%", hz = "Hz", arcmin = "′", px = "px", m = "m", s = "s"
  )
  unit <- names(units)[endsWith(factor, paste0("_", names(units)))][1]
  name <- if (is.na(unit)) factor else substr(factor, 1, nchar(factor) - nchar(unit) - 1)
  name <- gsub("_", " ", name)
  name <- paste0(toupper(substr(name, 1, 1)), substring(name, 2))
  if (is.na(unit)) name else sprintf("%s (%s)", name, units[[unit]])
}

rating_theme <- function() {
  ggplot2::theme_classic(base_size = kTextPt) + ggplot2::theme(
    axis.text = ggplot2::element_text(size = kTextPt, colour = "black"),
    axis.line = ggplot2::element_line(linewidth = 0.3),
    axis.ticks = ggplot2::element_line(linewidth = 0.3, colour = "black"),
    legend.position = "top", legend.key.size = ggplot2::unit(3, "mm"),
    legend.margin = ggplot2::margin(0, 0, 0, 0), legend.box.spacing = ggplot2::unit(1, "mm"),
    legend.text = ggplot2::element_text(size = kTextPt),
    legend.title = ggplot2::element_text(size = kTextPt),
    plot.tag = ggplot2::element_text(size = kTextPt + 1, face = "bold"),
    plot.margin = ggplot2::margin(2, 6, 2, 2)
  )
}
