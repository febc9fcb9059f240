# What all figures have in common: sizes, colours, axes, and the files they become.
#
# A figure is 85 mm wide, a journal's column, or 183 mm, its page (SVG and PDF). Text is 7 pt; colours are Okabe and Ito's (2008), and shapes say the same
# again.
# SPDX-License-Identifier: MIT

kPageWidthMm <- 183
kColumnWidthMm <- 85
kColumnHeightMm <- 66
kTextPt <- 7
kLevelColours <- c("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000")
kLevelShapes <- c(16, 17, 15, 18, 3, 4, 8)

inches <- function(mm) mm / 25.4

# Writes <stem>.svg and .pdf of a report's figure and returns the path of the first.
write_figure <- function(figure, stem) {
  width <- inches(c(figure$width_mm, kColumnWidthMm)[1])
  height <- inches(c(figure$height_mm, kColumnHeightMm)[1])
  svg <- paste0(stem, ".svg")
  grDevices::svg(svg, width, height)
  made <- ggplot2::ggplotGrob(figure$plot)
  grid::grid.draw(made)
  grDevices::dev.off()
  grDevices::cairo_pdf(paste0(stem, ".pdf"), width, height)
  grid::grid.draw(made)
  grDevices::dev.off()
  # Cairo counts the pictures of a process: the same figure is to be the same file.
  lines <- readLines(svg, encoding = "UTF-8")
  writeLines(sub("id=\"surface[0-9]+\"", "id=\"surface\"", lines), svg, useBytes = TRUE)
  svg
}

# "speed_deg_s" -> "Speed (°/s)"; a name without a known unit keeps its words. A study's own label,
# where design_words() found one, comes first.
label_of <- function(factor) {
  own <- getOption("impetus.labels")[factor]
  if (!is.null(own) && !is.na(own)) return(unname(own))
  units <- c(
    deg_per_s = "°/s", deg_s = "°/s", m_per_s = "m/s", m_s = "m/s", deg = "°", ms = "ms",
    percent = "%", hz = "Hz", arcmin = "′", px = "px", m = "m", s = "s")
  unit <- names(units)[endsWith(factor, paste0("_", names(units)))][1]
  name <- if (is.na(unit)) factor else substr(factor, 1, nchar(factor) - nchar(unit) - 1)
  name <- sentence_case(gsub("_", " ", name))
  if (is.na(unit)) name else sprintf("%s (%s)", name, units[[unit]])
}

smallest_step <- function(x) if (length(unique(x)) > 1) min(diff(sort(unique(x)))) else 1

# A place between -.5 and .5 for each participant, so that equal values do not hide each other.
spread <- function(participant) {
  rank <- as.integer(factor(participant))
  rank / (max(rank, 0) + 1) - 0.5
}

# Participants' means of the column `of` at each level of a factor, x shifted a little.
shifted_means <- function(trials, factor, of = "rating") {
  each <- long_means(participant_means(trials, factor, of), factor)
  each$x <- position_on_axis(trials, factor, each[[factor]])
  each$x <- each$x + spread(each$participant) * 0.16 * smallest_step(each$x)
  each
}

# Means over participants of the column `of` at each level of a factor, at their place.
placed_means <- function(trials, factor, of = "rating") {
  mean <- means_with_intervals(trials, factor, of)
  mean$x <- position_on_axis(trials, factor, mean$cell)
  mean
}

# One line per level of the pair's second factor, nudged apart so that intervals do not hide each
# other. `bar`, `point`: sizes.
split_plot <- function(trials, pair, of, bar, point, expand) {
  mean <- means_with_intervals(trials, pair, of)
  series <- factor(mean[[pair[2]]], levels(droplevels(trials[[pair[2]]])))
  at <- position_on_axis(trials, pair[1], mean[[pair[1]]])
  count <- nlevels(series)
  # Apart from the factors, of which one may be called anything, such as level.
  shown <- data.frame(series, mean = mean$mean, low = mean$low, high = mean$high,
    x = at + (as.integer(series) - (count + 1) / 2) * 0.09 * smallest_step(at))
  ggplot2::ggplot(shown, ggplot2::aes(x, mean, colour = series, shape = series)) +
    line_of_numbers(trials, pair[1], linewidth = 0.4) + interval_bars(bar) +
    ggplot2::geom_point(size = point) +
    series_scales(wrapped(label_of(pair[2]), 25), rep_len(kLevelColours, count), rep_len(kLevelShapes, count)) +
    level_axis(trials, pair[1], expand)
}

# Lines between levels that are numbers; between words there is nothing.
line_of_numbers <- function(trials, factor, ...) {
  if (is_number(trials[[factor]])) ggplot2::geom_line(...)
}

# The bars of the intervals low to high; they stand in no legend.
interval_bars <- function(width, ...) {
  ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high, ...), linewidth = width,
    na.rm = TRUE, show.legend = FALSE)
}

# Colours and shapes that say the same, under one title.
series_scales <- function(title, colours, shapes, ...) {
  list(ggplot2::scale_colour_manual(title, values = colours, ...),
    ggplot2::scale_shape_manual(title, values = shapes, ...))
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

level_axis <- function(trials, factor, expand = 0.1) {
  levels <- levels(droplevels(trials[[factor]]))
  ggplot2::scale_x_continuous(wrapped(label_of(factor), 50), breaks = position_on_axis(trials, factor, levels),
    labels = if (stands_at_values(levels)) levels else wrapped(levels, 12),
    expand = ggplot2::expansion(mult = expand))
}

# Words in lines of `width` letters.
wrapped <- function(words, width) {
  unname(vapply(words, function(one) paste(strwrap(one, width), collapse = "\n"), ""))
}

# The whole scale, always; its ends in the words that participants saw, in lines of `width` letters.
axis_of_rating <- function(scale, words, width = 20) {
  ends <- c(scale$rating_minimum, scale$rating_maximum)
  breaks <- seq(ends[1], ends[2])
  labels <- as.character(breaks)
  if (words) {
    at <- c(1, length(labels))
    anchors <- wrapped(c(scale$low_anchor, scale$high_anchor), width)
    labels[at] <- trimws(paste0(anchors, "  ", labels[at]))
  }
  list(
    ggplot2::scale_y_continuous(if (words) "Mean rating" else NULL, breaks = breaks,
      labels = labels, expand = ggplot2::expansion(mult = 0.03)),
    ggplot2::coord_cartesian(ylim = ends, clip = "on"))
}

# Below 0 stands a minus sign, not a hyphen.
minus_signed <- function(x) {
  gsub("-", "−", format(x, trim = TRUE, drop0trailing = TRUE), fixed = TRUE)
}

zero_line <- function() {
  ggplot2::geom_hline(yintercept = 0, linewidth = 0.3, colour = "grey40")
}

figure_theme <- function() {
  ggplot2::theme_classic(base_size = kTextPt) + ggplot2::theme(
    axis.text = ggplot2::element_text(size = kTextPt, colour = "black"),
    axis.line = ggplot2::element_line(linewidth = 0.3),
    axis.ticks = ggplot2::element_line(linewidth = 0.3, colour = "black"),
    legend.position = "top", legend.key.size = ggplot2::unit(3, "mm"),
    legend.margin = ggplot2::margin(0, 0, 0, 0), legend.box.spacing = ggplot2::unit(1, "mm"),
    legend.text = ggplot2::element_text(size = kTextPt),
    legend.title = ggplot2::element_text(size = kTextPt),
    strip.background = ggplot2::element_blank(),
    plot.tag = ggplot2::element_text(size = kTextPt + 1, face = "bold"),
    plot.margin = ggplot2::margin(2, 6, 2, 2))
}
