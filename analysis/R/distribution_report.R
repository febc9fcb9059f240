# The study of schedulers without participants: collisions to figures, tables and words.
#
#   seen_collision, trial_level ─> collisions ─┬─> histograms, shares: two figures, .csv
#                                              └─> shapes, met or not: .md, -shapes.csv
# SPDX-License-Identifier: MIT

kPriorityColours <- c(high = "#D55E00", low = "#56B4E9")

open_distribution_study <- function(study, words) {
  arguments <- study_arguments(study, words, c("RSQLite", "ggplot2"))
  parts <- lapply(arguments$studies, read_distribution, study$protocol)
  together <- function(part) each_row(parts, `[[`, part)
  collisions <- together("collisions")
  if (is.null(collisions)) {
    refuse(paste(basename(arguments$studies), collapse = ", "), ": expected collisions of '",
      study$protocol, "' with their distance, got none yet")
  }
  prepare_folder(arguments$out)
  seen <- unique(collisions$scheduler)
  order_of <- c(unlist(lapply(kExpectedShapes, `[[`, 1)), "distance")
  collisions$scheduler <- factor(collisions$scheduler, unique(c(intersect(order_of, seen), seen)))
  c(study, list(collisions = collisions, out = arguments$out, walls = sum(together("walls")),
    unknown = sum(together("unknown")), left_out = sum(together("left_out")),
    exclusions = together("exclusions")))
}

# list(collisions, walls, unknown, left_out, exclusions) of one file; list 0 is that of high priority.
# Collisions with a wall are out and counted: the thesis has none, and thresholds are solved on pairs
# of bodies.
read_distribution <- function(path, protocol) {
  study <- open_study(path, c(kViews, "seen_collision"))
  on.exit(DBI::dbDisconnect(study))
  enrolments <- DBI::dbGetQuery(study, "SELECT * FROM enrolment_summary WHERE protocol = ?",
    params = list(protocol))
  if (nrow(enrolments) == 0) refuse_protocol(study, path, protocol)
  places <- sprintf("CAST(%s AS REAL) AS %s", names(kPlaces), names(kPlaces))
  rows <- DBI::dbGetQuery(study, paste("SELECT participant, trial, body_a, body_b,",
    paste(places, collapse = ", "), ", list = 0 AS high,",
    "CAST(trial_level.level AS TEXT) AS scheduler FROM seen_collision",
    "JOIN trial_level USING (trial) WHERE protocol = ? AND phase = 'main'",
    "AND trial_level.factor = 'scheduler'"), params = list(protocol))
  mark <- function(x) if (nrow(x) > 0) cbind(x, file = basename(path), path = path) else NULL
  if (nrow(rows) == 0) return(list(walls = 0, unknown = 0, left_out = 0))
  exclusions <- read_remarkable(study, protocol, enrolments, mark)$exclusions
  rows <- mark(rows)
  wall <- is_wall(rows$body_a) | is_wall(rows$body_b)
  rows <- rows[!wall, setdiff(names(rows), c("body_a", "body_b"))]
  out <- is_excluded(rows, exclusions)
  known <- stats::complete.cases(rows[names(kPlaces)])
  rows$high <- rows$high == 1
  kept <- rows[known & !out, ]
  list(collisions = if (isTRUE(nrow(kept) > 0)) kept, walls = sum(wall), unknown = sum(!known & !out),
    left_out = sum(out), exclusions = exclusions)
}

report_distribution_study <- function(study) {
  shapes <- shape_table(study$collisions)
  bins <- histogram_table(study$collisions)
  say_progress("drawing the figures ...")
  draw <- function(panel, ending) {
    write_figure(function() ggplot2::ggplotGrob(panel(bins)), path_of(study, ending),
      20 + 24 * nlevels(study$collisions$scheduler))
  }
  figures <- c(draw(histogram_panel, "-histograms"), draw(share_panel, "-shares"))
  write_outputs(study, outcome(bins, paste("Every collision is a data point of one simulated run:",
    "numbers describe, nothing is tested.")), paste("-", shape_sentences(shapes)),
    distribution_sentences(study), c(paste("Histograms: collisions of high (list 0) and low",
      "priority by place (thesis figs. 6.11 to 6.16)."), "",
      "Shares: share of high priority in each bin, with 95 % Wilson intervals."),
    shape_section(shapes), figures, list(shapes = shapes), left_out = distribution_exclusions(study))
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
      count_of(study$unknown, "collision"))
  )
}

distribution_exclusions <- function(study) {
  excluded <- study$exclusions
  if (is.null(excluded)) return("Nobody and no trial is left out.")
  c(sprintf("Left out: %s.", count_of(study$left_out, "collision")), "",
    markdown_table(c("participant", "trial", "reason", "decided"), sprintf("%s | %s | %s | %s",
      as_typed(excluded$participant), ifelse(is.na(excluded$trial), "all", excluded$trial),
      as_typed(excluded$reason), excluded$decided_utc)))
}

shape_section <- function(shapes) {
  shapes$place <- kPlaces[shapes$place]
  c("## Shapes", "", markdown_of(shapes, c(scheduler = "%s", place = "%s", collisions = "%d",
    high_share = "%.3f", change = "%+.3f", step = "%.3f"), c("scheduler", "over", "collisions",
    "share of high priority", "change of the share", "put right by the best cut")), "")
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
