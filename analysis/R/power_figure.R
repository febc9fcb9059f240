# Power by number of participants: one panel per factor, a journal's column wide.
# SPDX-License-Identifier: MIT

kPowerColours <- c(planted = "#000000", none = "#D55E00")
kPowerShapes <- c(planted = 16, none = 17)

# list(name, caption, plot, height_mm), as column_figures.R writes it.
power_figure <- function(rates, question) {
  shown <- data.frame(
    factor = vapply(rates$factor, label_of, ""), participants = rates$participants,
    series = factor(ifelse(rates$effect == 1, "planted", "none"), names(kPowerColours)),
    rate = ifelse(rates$effect == 1, rates$rate, rates$alone_rate),
    low = ifelse(rates$effect == 1, rates$low, rates$alone_low),
    high = ifelse(rates$effect == 1, rates$high, rates$alone_high))
  panels <- length(unique(shown$factor))
  labels <- c(planted = "effect as planted", none = "effect set to zero")
  plot <- ggplot2::ggplot(shown, ggplot2::aes(participants, rate, colour = series, shape = series)) +
    ggplot2::geom_hline(yintercept = c(kSignificance, kWantedPower), linewidth = 0.25,
      linetype = "22", colour = "grey55") +
    (if (length(unique(shown$participants)) > 1) ggplot2::geom_line(linewidth = 0.4)) +
    ggplot2::geom_linerange(ggplot2::aes(ymin = low, ymax = high), linewidth = 0.7,
      show.legend = FALSE) +
    ggplot2::geom_point(size = 1.5) +
    ggplot2::scale_colour_manual(NULL, values = kPowerColours, labels = labels, drop = TRUE) +
    ggplot2::scale_shape_manual(NULL, values = kPowerShapes, labels = labels, drop = TRUE) +
    ggplot2::scale_x_continuous("Participants", breaks = sort(unique(shown$participants)),
      expand = ggplot2::expansion(mult = 0.08)) +
    ggplot2::scale_y_continuous("Share of studies that reject", breaks = c(0.05, 0.2, 0.4, 0.6, 0.8, 1),
      labels = c(".05", ".2", ".4", ".6", ".8", "1"), limits = c(0, 1)) +
    ggplot2::facet_wrap("factor", ncol = 2) + column_theme() +
    ggplot2::theme(legend.position = "bottom")
  list(name = "power", plot = plot, caption = power_caption(rates, question),
    height_mm = 20 + 48 * ceiling(panels / 2))
}

power_caption <- function(rates, question) {
  family <- power_family_size(rates)
  paste0("Share of simulated studies of ", question$protocol, " in which the test of a factor",
    " rejects, by number of participants, with its exact 95 % Monte-Carlo interval. Black: ",
    "the effect as planted", if (family > 1) paste0(", p < .05 after Holm over the ", family,
      " factors") else ", p < .05", "; this is the power of factors that have an effect",
    if (any(rates$effect == 0)) paste0(". Orange: the effect set to zero, p < .05",
      if (family > 1) " uncorrected", "; this is the type-I error"), ". Dashed: .05 and .8.")
}
