# A power analysis as one page of HTML, its figure and its table: how often the tests of simulated
# studies reject.
#
#   ledger: study, test ─> one row per (effect, participants, factor): rejected, rate, its interval
#                       ─> power.html, power.svg, power.pdf, power.csv
#
# The interval is the Monte-Carlo one: exact (Clopper and Pearson 1934), for a limited number of
# studies. Rejected: p < .05 after Holm within the factors that are tested (a report's family has the
# ANOVA's interactions too); `alone`: p < .05 as it is, which is what a test's own type-I error is about.
# A study whose test could not be made did not reject.
# SPDX-License-Identifier: MIT

kWantedPower <- 0.8

# Every test of every study. One whose participants left nothing to test has rows without p.
kAllTestsSql <- "
  WITH tested AS (SELECT DISTINCT factor FROM test)
  SELECT effect, number, participants, factor, p, coalesce(method, '') AS method,
    coalesce(remark, 'no answers are left to test') AS remark
  FROM study CROSS JOIN tested LEFT JOIN test USING (effect, number, participants, factor)
  ORDER BY effect DESC, number, participants, factor"

power_rates <- function(ledger) {
  tests <- DBI::dbGetQuery(ledger, kAllTestsSql)
  if (nrow(tests) == 0) {
    refuse("expected tests of studies in the ledger, got none: no study is done yet, or nobody's answers",
      " are left to test in any")
  }
  study <- paste(tests$effect, tests$number, tests$participants)
  tests$p_holm <- stats::ave(tests$p, study, FUN = function(p) stats::p.adjust(p, "holm"))
  cells <- split(tests, list(tests$participants, tests$effect, tests$factor), drop = TRUE)
  rates <- each_row(cells, function(cell) {
    alone <- stats::setNames(rejection_share(cell$p), c("alone", "alone_rate", "alone_low",
      "alone_high"))
    data.frame(cell[1, c("factor", "effect", "participants")], studies = nrow(cell),
      untested = sum(is.na(cell$p)), rejection_share(cell$p_holm), alone, row.names = NULL)
  })
  rates[order(-rates$effect, rates$factor, rates$participants), ]
}

# How many p are below .05, with the exact 95 % interval of the rate.
rejection_share <- function(p) {
  rejected <- sum(p < kSignificance, na.rm = TRUE)
  interval <- stats::binom.test(rejected, length(p))$conf.int
  data.frame(rejected = rejected, rate = rejected / length(p), low = interval[1],
    high = interval[2])
}

# The families of a factor tested alone need no correction.
power_family_size <- function(rates) length(unique(rates$factor))

# ".987 [.978, .993]"
rate_words <- function(rate, low, high) {
  digits <- function(x) ifelse(x == 1, "1", sub("^0", "", sprintf("%.3f", x)))
  sprintf("%s [%s, %s]", digits(rate), digits(low), digits(high))
}

kPowerColours <- c(planted = "#000000", none = "#D55E00")
kPowerShapes <- c(planted = 16, none = 17)

# list(name, caption, plot, height_mm), as column_figures.R writes it.
power_figure <- function(rates, question) {
  planted <- rates$effect == 1
  shown <- data.frame(
    factor = vapply(rates$factor, label_of, ""), participants = rates$participants,
    series = factor(ifelse(planted, "planted", "none"), names(kPowerColours)),
    rate = ifelse(planted, rates$rate, rates$alone_rate),
    low = ifelse(planted, rates$low, rates$alone_low),
    high = ifelse(planted, rates$high, rates$alone_high))
  labels <- c(planted = "effect as planted", none = "effect set to zero")
  plot <- ggplot2::ggplot(shown, ggplot2::aes(participants, rate, colour = series, shape = series)) +
    ggplot2::geom_hline(yintercept = c(kSignificance, kWantedPower), linewidth = 0.25,
      linetype = "22", colour = "grey55") +
    (if (length(unique(shown$participants)) > 1) ggplot2::geom_line(linewidth = 0.4)) +
    interval_bars(0.7) + ggplot2::geom_point(size = 1.5) +
    series_scales(NULL, kPowerColours, kPowerShapes, labels = labels, drop = TRUE) +
    ggplot2::scale_x_continuous("Participants", breaks = sort(unique(shown$participants)),
      expand = ggplot2::expansion(mult = 0.08)) +
    ggplot2::scale_y_continuous("Share of studies that reject", breaks = c(0.05, 0.2, 0.4, 0.6, 0.8, 1),
      labels = c(".05", ".2", ".4", ".6", ".8", "1"), limits = c(0, 1)) +
    ggplot2::facet_wrap("factor", ncol = 2) + column_theme() +
    ggplot2::theme(legend.position = "bottom")
  list(name = "power", plot = plot, caption = power_caption(rates, question),
    height_mm = 20 + 48 * ceiling(length(unique(shown$factor)) / 2))
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

write_power_page <- function(path, folder) {
  ledger <- withr::local_db_connection(open_ledger(path))
  question <- power_question(ledger)
  rates <- power_rates(ledger)
  figure <- power_figure(rates, question)
  svg <- write_figure(figure, file.path(folder, "power"))
  write_table(rates, file.path(folder, "power.csv"))
  writeLines(enc2utf8(power_page(ledger, question, rates, figure, svg)),
    file.path(folder, "power.html"), useBytes = TRUE)
  say(power_lines(rates))
}

# What the command says at its end: a line for each factor.
power_lines <- function(rates) {
  for_each_planted(rates, function(mine) {
    paste0(mine$factor[1], ": ", paste(sprintf("%d participants %s", mine$participants,
      rate_words(mine$rate, mine$low, mine$high)), collapse = "; "))
  })
}

# `words` of the rates of each factor with the effect as planted.
for_each_planted <- function(rates, words) {
  planted <- rates[rates$effect == 1, ]
  vapply(unname(split(planted, planted$factor)), words, "")
}

power_page <- function(ledger, question, rates, figure, svg) {
  html_page(paste("Power of", question$protocol), c(
    paste0("<p class=\"simulated\">SIMULATED: everything here follows from an observer model and its",
      " assumptions, listed below. People may differ from it.</p>"),
    html_paragraphs(c(paste(power_answers(rates), collapse = " "), type_one_words(rates))),
    html_figure(svg, "power", figure$caption),
    "<h2>Rates</h2>", html_table(rates_shown(rates), kRatesHeads), untested_lines(ledger),
    "<h2>Method, in words</h2>", html_paragraphs(power_method(ledger, question, rates)),
    "<h2>What was assumed of participants</h2>", html_table(assumptions_of(ledger, "observer"),
      c("Parameter", "Value", "Unit", "Source")),
    null_lines(ledger, question),
    "<h2>How to repeat</h2>", html_paragraphs(power_repeat_words(ledger))))
}

# For each factor the least number whose power is .8 beyond Monte-Carlo error, or that none is.
power_answers <- function(rates) {
  for_each_planted(rates, function(mine) {
    factor <- name_and_unit(mine$factor[1])
    enough <- mine[mine$low >= kWantedPower, ]
    if (nrow(enough) == 0) {
      best <- mine[nrow(mine), ]
      return(sprintf(paste("The test of %s reaches a power of .8 at none of these numbers beyond",
        "Monte-Carlo error; with %d participants it rejects in %s of the studies."),
        factor, best$participants, rate_words(best$rate, best$low, best$high)))
    }
    sprintf(paste("Of these numbers of participants, %d is the least at which the test of %s has a",
      "power of .8 beyond Monte-Carlo error: %s."), enough$participants[1], factor,
      rate_words(enough$rate[1], enough$low[1], enough$high[1]))
  })
}

type_one_words <- function(rates) {
  none <- rates[rates$effect == 0, ]
  if (nrow(none) == 0) return("The type-I error was not simulated.")
  off <- none[none$alone_low > kSignificance | none$alone_high < kSignificance, ]
  of_all <- sprintf("With the effect set to zero, p was below .05 in %s of %s tests;",
    format(sum(none$alone), big.mark = ","), format(sum(none$studies), big.mark = ","))
  if (nrow(off) == 0) {
    return(paste(of_all, "the interval of the type-I error holds .05 for each factor and number of",
      "participants."))
  }
  paste(of_all, sprintf("the interval of the type-I error does not hold .05 for %s.",
    paste(sprintf("%s with %d participants (%s)", vapply(off$factor, name_and_unit, ""),
      off$participants, rate_words(off$alone_rate, off$alone_low, off$alone_high)),
      collapse = "; ")),
    "Of many such intervals one in twenty misses by chance.")
}

kRatesHeads <- c("Factor", "Effect", "Participants", "Studies", "Rejects after Holm [95 %]",
  "p < .05 alone [95 %]")

rates_shown <- function(rates) {
  data.frame(factor = vapply(rates$factor, label_of, ""),
    effect = ifelse(rates$effect == 1, "as planted", "set to zero"),
    participants = rates$participants, studies = rates$studies,
    holm = rate_words(rates$rate, rates$low, rates$high),
    alone = rate_words(rates$alone_rate, rates$alone_low, rates$alone_high))
}

# Why tests were not made, as often as they were not.
untested_lines <- function(ledger) {
  rows <- DBI::dbGetQuery(ledger, paste("SELECT factor, participants, remark, count(*) AS studies",
    "FROM (", kAllTestsSql, ") WHERE p IS NULL GROUP BY factor, participants, remark",
    "ORDER BY 1, 2, 4 DESC"))
  if (nrow(rows) == 0) return(NULL)
  c("<h4>Tests that could not be made; they count as not rejecting</h4>",
    html_table(rows, c("Factor", "Participants", "Why", "Studies")))
}

power_method <- function(ledger, question, rates) {
  builds <- DBI::dbGetQuery(ledger, "SELECT DISTINCT build FROM study")$build
  methods <- DBI::dbGetQuery(ledger, "SELECT DISTINCT method FROM test WHERE p IS NOT NULL")$method
  counts <- unique(range(rates$studies[rates$effect == 1]))
  paste0(
    "Power was estimated by simulation: ", paste(counts, collapse = " to "), " whole studies of the",
    " protocol ", question$protocol, " (hash ", substr(question$protocol_hash, 1, 16), ") with each of ",
    and_words(as.character(sort(unique(rates$participants)))), " participants were run through the",
    " platform itself: every session's plan, its trials' physics and the observer's answers to what",
    " was shown. Studies of fewer participants are the first of those of more, so the points of",
    " a curve depend on each other. Each study was tested as a report of it does: ", paste(methods,
      collapse = "; or "), ", of ", switch(question$response, rating = "ratings",
      clicks = "clicks per second", "answers"),
    if (length(question$compared) > 0) sprintf(", in trials of %s %s and %s alone",
      plain_name(question$compared[1]), question$compared[2], question$compared[3]), ". ",
    if (power_family_size(rates) > 1) "Tests were corrected after Holm over the factors tested. ",
    if (question$model == "means") paste("A report of a study corrects p of all main effects and",
      "interactions of the ANOVA together: with interactions it rejects no more often than here. "),
    "Intervals are exact binomial ones over studies. Simulated by ", paste(builds, collapse = "; "),
    ".")
}

# The parameters of an observer, as its file gives them.
assumptions_of <- function(ledger, column) {
  DBI::dbGetQuery(ledger, sprintf(paste("SELECT key AS parameter,",
    "json_extract(each.value, '$.value') AS value, json_extract(each.value, '$.unit') AS unit,",
    "json_extract(each.value, '$.source') AS source",
    "FROM question, json_each(%s, '$.parameters') AS each"), column))
}

# What the observer of the studies without an effect has otherwise.
null_lines <- function(ledger, question) {
  if (question$null_observer == "") return(NULL)
  planted <- assumptions_of(ledger, "observer")
  none <- assumptions_of(ledger, "null_observer")
  same <- paste(none$parameter, none$value) %in% paste(planted$parameter, planted$value)
  changed <- none[!same, ]
  html_paragraphs(if (nrow(changed) == 0) "Without the effect: the same participant." else
    sprintf("Without the effect: %s; the rest as above.", paste(sprintf("%s %s", changed$parameter,
      format_number(changed$value)), collapse = ", ")))
}

power_repeat_words <- function(ledger) {
  seed <- DBI::dbGetQuery(ledger, paste("SELECT seed, participants FROM study WHERE effect = 1",
    "ORDER BY number, participants LIMIT 1"))
  c(sprintf(paste("`power.sqlite` holds every simulated study's seed and the p of each test. Any one",
    "of them is simulated again, to be looked at or replayed, by `impetus run PROTOCOL --observer FILE",
    "--participants %d --seed %s --db study.sqlite`."), seed$participants[1],
    format(seed$seed[1], scientific = FALSE)),
    paste("The same `impetus power` command goes on where this one ended, with more studies or",
      "more numbers of participants if it is given them."))
}
