# The figure of `impetus trade`: what each kind of tree errs against what it costs.
#
#   Rscript trade.R trade.csv      writes trade.svg and trade.pdf beside the table
#
# A curve a kind, its digits the levels, each with the reduction of least error x sqrt(time); behind them
# the frontier, which no kind, level and reduction beats. Errors are against the exact meshes. Time
# is that of all pairs that a step refines. Sizes are a journal's: one column of 89 mm, 7 pt text.
# Colours are Okabe and Ito's (2008). Needs R and ggplot2.
# SPDX-License-Identifier: MIT

kWidthMm <- 89
kHeightMm <- 165
kTextPt <- 7
kBudgetsMs <- c(1, 4, 16, 50)
kColours <- c(octree = "#E69F00", medial = "#0072B2", voxel = "#CC79A7", box = "#D55E00",
  swept = "#56B4E9", heterogeneous = "#000000")
kLeast <- 0.1  # an error below it is drawn as it
# Measure, statistic, title, and what a value is multiplied by.
kPanels <- data.frame(measure = c("normal_error", "gap_seen", "linear_error"),
  statistic = c("median", "p95", "median"),
  title = c("Contact normal off by, median (°)", "95 % of gaps below (minutes of arc)",
    "Velocity off by, median (% of approach)"),
  times = c(1, 1, 100))

refuse <- function(...) {
  message("trade.R: ", ...)
  quit(save = "no", status = 2)
}

read_trade <- function(path) {
  if (!file.exists(path)) refuse(path, ": expected the table of a trade, got no such file")
  rows <- utils::read.csv(path, stringsAsFactors = FALSE, encoding = "UTF-8")
  missing <- setdiff(c("part", "subject", "kind", "level", "reduction", "measure", "reference",
    "statistic", "value"), names(rows))
  if (length(missing) > 0) refuse(path, ": expected the column ", missing[1], ", which is missing")
  rows
}

# Of several pairs of bodies the rows of all together, which come last.
impacts_of <- function(rows) {
  impacts <- rows[rows$part == "impacts", ]
  if (nrow(impacts) == 0) refuse("expected rows of the part impacts, got none")
  impacts[impacts$subject == impacts$subject[nrow(impacts)], ]
}

pairs_of <- function(rows) {
  value <- rows$value[rows$measure == "pairs_refined" & rows$statistic == "p95"]
  if (length(value) == 0 || is.na(value[1])) 1 else max(1, value[1])
}

# Time and error of every kind, level and reduction, for one panel.
options_of <- function(impacts, panel, pairs) {
  time <- impacts[impacts$measure == "pair_time" & impacts$statistic == "mean", ]
  error <- impacts[impacts$measure == panel$measure & impacts$statistic == panel$statistic &
    impacts$reference == "exact", ]
  by <- if (all(error$reduction == "")) c("kind", "level") else c("kind", "level", "reduction")
  both <- merge(time[c("kind", "level", "reduction", "value")], error[c(by, "value")], by = by,
    suffixes = c("_time", "_error"))
  data.frame(kind = both$kind, level = both$level, ms = both$value_time * pairs / 1000,
    error = pmax(both$value_error * panel$times, kLeast), title = panel$title)
}

best_of_each_level <- function(options) {
  options <- options[order(options$kind, options$level, options$error * sqrt(options$ms)), ]
  options[!duplicated(options[c("kind", "level")]), ]
}

# The steps under which nothing lies; drawn on to the right edge.
frontier_of <- function(options, last_ms) {
  options <- options[order(options$ms, options$error), ]
  frontier <- options[options$error < c(Inf, head(cummin(options$error), -1)), ]
  end <- frontier[nrow(frontier), ]
  end$ms <- last_ms
  rbind(frontier, end)
}

each_panel <- function(work) {
  found <- do.call(rbind, lapply(seq_len(nrow(kPanels)), function(i) work(kPanels[i, ])))
  found$title <- factor(found$title, kPanels$title)
  found
}

# 0.001, 1, 50: as people write them.
plain <- function(x) format(x, scientific = FALSE, trim = TRUE, drop0trailing = TRUE)

plain_each <- function(x) vapply(x, function(one) if (is.na(one)) NA_character_ else plain(one), "")

# The least error drawn holds all that is less.
error_labels <- function(x) {
  text <- plain_each(x)
  least <- which(x == kLeast)
  text[least] <- paste0("\u2264 ", text[least])
  text
}

trade_figure <- function(rows) {
  impacts <- impacts_of(rows)
  pairs <- pairs_of(rows)
  options <- each_panel(function(panel) options_of(impacts, panel, pairs))
  curves <- each_panel(function(panel) best_of_each_level(options[options$title == panel$title, ]))
  last_ms <- max(kBudgetsMs, options$ms) * 1.5
  frontier <- each_panel(function(panel) {
    frontier_of(options[options$title == panel$title, ], last_ms)
  })
  mixed <- curves[curves$kind == "heterogeneous", ]
  single <- curves[curves$kind != "heterogeneous", ]
  kinds <- intersect(names(kColours), unique(options$kind))
  budgets <- data.frame(ms = kBudgetsMs, title = factor(kPanels$title[1], kPanels$title))
  ggplot2::ggplot(curves, ggplot2::aes(ms, error)) +
    ggplot2::geom_vline(xintercept = kBudgetsMs, linetype = "22", linewidth = 0.25,
      colour = "grey45") +
    ggplot2::geom_text(ggplot2::aes(ms, Inf, label = paste(ms, "ms")), budgets, angle = 90,
      hjust = 1.1, vjust = -0.35, size = 5.5 / ggplot2::.pt, colour = "grey35") +
    ggplot2::geom_step(data = frontier, linewidth = 2.2, colour = "grey86") +
    # A heterogeneous tree may be another kind's: wider, it shows behind that.
    ggplot2::geom_path(ggplot2::aes(colour = kind), mixed, linewidth = 0.9) +
    ggplot2::geom_point(ggplot2::aes(colour = kind), mixed, size = 2.9, shape = 16) +
    ggplot2::geom_path(ggplot2::aes(colour = kind), single, linewidth = 0.4) +
    ggplot2::geom_point(ggplot2::aes(colour = kind), single, size = 2, shape = 16) +
    ggplot2::geom_text(ggplot2::aes(label = level), size = 4.2 / ggplot2::.pt, colour = "white",
      fontface = "bold") +
    ggplot2::facet_wrap("title", ncol = 1, scales = "free_y") +
    ggplot2::scale_x_log10(paste0("Milliseconds a step, ", plain(signif(pairs, 2)),
      if (pairs == 1) " pair" else " pairs"), labels = plain_each,
      breaks = 10^(-5:3)) +
    ggplot2::scale_y_log10(NULL, labels = error_labels,
      breaks = as.vector(outer(c(1, 2, 5), 10^(-1:4))),
      expand = ggplot2::expansion(mult = c(0.07, 0.12))) +
    ggplot2::scale_colour_manual(NULL, values = kColours[kinds], breaks = kinds) +
    ggplot2::guides(colour = ggplot2::guide_legend(nrow = 2, byrow = TRUE,
      override.aes = list(size = 1.8))) +
    ggplot2::theme_classic(base_size = kTextPt) +
    ggplot2::theme(legend.position = "top", legend.margin = ggplot2::margin(0, 0, 0, 0),
      legend.key.size = ggplot2::unit(3, "mm"), strip.background = ggplot2::element_blank(),
      strip.text = ggplot2::element_text(size = kTextPt, hjust = 0),
      axis.text = ggplot2::element_text(size = 6, colour = "black"),
      panel.grid.major.y = ggplot2::element_line(colour = "grey93", linewidth = 0.25))
}

main <- function(words) {
  if (length(words) != 1 || words[1] %in% c("-h", "--help")) {
    refuse("expected the table to draw; usage: Rscript trade.R trade.csv")
  }
  if (!requireNamespace("ggplot2", quietly = TRUE)) {
    refuse("expected the package ggplot2, which is missing (apt-get install r-cran-ggplot2)")
  }
  figure <- trade_figure(read_trade(words[1]))
  for (device in c("svg", "pdf")) {
    ggplot2::ggsave(paste0("trade.", device), figure, switch(device, svg = grDevices::svg,
      pdf = grDevices::cairo_pdf), dirname(words[1]), width = kWidthMm, height = kHeightMm, units = "mm")
  }
}

if (sys.nframe() == 0) main(commandArgs(trailingOnly = TRUE))
