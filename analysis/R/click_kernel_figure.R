# The figure of the click regression.
#
#   a: clicks per second that an event adds, by the time since it, bad and good events; means over
#      participants with 95 % t intervals
#   b: each participant's gain of bad and of good events; their means with 95 % t intervals
# SPDX-License-Identifier: MIT

kEventColours <- c(bad = "#D55E00", good = "#0072B2")
kEventShapes <- c(bad = 17, good = 16)

# Writes <stem>.png and .pdf and returns their paths. `detection`: of click_detection.
write_kernel_figure <- function(detection, simulated, stem) {
  write_figure(function() {
    kernels <- ggplot2::ggplotGrob(kernel_panel(detection$kernels) + ggplot2::labs(tag = "a"))
    gains <- detection$gains[detection$gains$scheduling == "all", ]
    gains <- ggplot2::ggplotGrob(gain_panel(gains, simulated) + ggplot2::labs(tag = "b"))
    kernels$widths[kernels$layout$l[kernels$layout$name == "panel"]] <- grid::unit(1.7, "null")
    cbind(kernels, gains, size = "first")
  }, stem)
}

kernel_panel <- function(kernels) {
  kernels$x <- (kernels$from_ms + kernels$to_ms) / 2 + ifelse(kernels$event == "bad", -12, 12)
  ggplot2::ggplot(kernels, ggplot2::aes(x, mean, colour = event, shape = event)) +
    ggplot2::geom_hline(yintercept = 0, linewidth = 0.3, colour = "grey40") +
    ggplot2::geom_line(linewidth = 0.4) +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high), linewidth = 0.6, na.rm = TRUE,
      show.legend = FALSE) +
    ggplot2::geom_point(size = 1.9) +
    ggplot2::scale_colour_manual("Event", values = kEventColours) +
    ggplot2::scale_shape_manual("Event", values = kEventShapes) +
    ggplot2::scale_x_continuous("Time since the event (ms)", breaks = 1000 * kLagEdgesS) +
    ggplot2::scale_y_continuous("Clicks per second added by one event", labels = minus_signed) +
    rating_theme()
}

gain_panel <- function(gains, simulated) {
  events <- names(kEventColours)
  each <- data.frame(participant = rep(gains$participant, 2), gain = unlist(gains[events]),
    x = rep(1:2, each = nrow(gains)))
  each$x <- each$x + 0.15 + spread(each$participant) * 0.4
  mean <- as.data.frame(t(vapply(gains[events], t_interval, numeric(3))))
  mean$event <- events
  mean$x <- 1:2 - 0.15
  ggplot2::ggplot(mean, ggplot2::aes(x, mean)) +
    ggplot2::geom_hline(yintercept = 0, linewidth = 0.3, colour = "grey40") +
    ggplot2::geom_line(ggplot2::aes(y = gain, group = participant), each, linewidth = 0.2,
      colour = "grey72") +
    ggplot2::geom_point(ggplot2::aes(y = gain), each, size = 0.9, stroke = 0, colour = "grey60") +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high, colour = event),
      linewidth = 0.6, na.rm = TRUE) +
    ggplot2::geom_point(ggplot2::aes(colour = event, shape = event), size = 1.9) +
    ggplot2::scale_colour_manual("Event", values = kEventColours) +
    ggplot2::scale_shape_manual("Event", values = kEventShapes) +
    ggplot2::scale_x_continuous(paste("Event, for each", who_words(simulated)), breaks = 1:2,
      labels = events, limits = c(0.6, 2.6)) +
    ggplot2::scale_y_continuous("Gain: clicks that an event adds", labels = minus_signed) +
    rating_theme()
}

kernel_caption <- function(detection, simulated) {
  people <- sum(detection$gains$scheduling == "all")
  paste0("What was clicked at. a: clicks per second that one event adds, by the time since it, mean ",
    "of ", count_of(people, who_words(simulated)), if (people > 1) "; bars: 95 % t intervals",
    ". b: each ", who_words(simulated), "'s gains (grey), their means",
    if (people > 1) " and 95 % t intervals", ".")
}
