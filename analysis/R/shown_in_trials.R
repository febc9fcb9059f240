# What a trial of a rating study really showed or asked for, beside its factors.
#
#   seen_collision ─> gap_arcmin, hidden_share, level_used, meetings ─> table, mixed model of the gap
#                  ─> imposed_spin_rad_s ─> how it is spread over the levels, mixed model of the spin
#   click_trial ────> clicks, exposure_s ─> table of clicks
#
# The gap is that of a trial's first collision as measured by `impetus replay --truth`: an outcome of
# the tree's level, of the bodies' shape and of the viewpoint, which nobody sets. The spin is a change
# of angular velocity, drawn for each body and recorded (thesis sec. 6.2.2, second experiment).
# Each part of the report is list(tests, words, section), each of which may be NULL.
# SPDX-License-Identifier: MIT

kGapFamily <- "mixed model of the gap shown, effect"
kGapOddsFamily <- "mixed model of the gap shown, odds ratio"
kSpinFamily <- "mixed model of the imposed spin, effect"
kSpinOddsFamily <- "mixed model of the imposed spin, odds ratio"

# The study with its three levels of the tree called by `depths`, and study$depths, the sentence that
# says which numbers `what` were. Fewer levels, or a first that is not 0, keep numbers.
with_depths_named <- function(study, depths = c("root", "middle", "finest"),
                              what = "Levels of the sphere tree") {
  column <- study$factors[["level"]]
  numbers <- levels(study$trials[[column]])
  if (length(numbers) != 3 || numbers[1] != "0") return(study)
  levels(study$trials[[column]]) <- depths
  study$depths <- sprintf("%s: %s.", what, paste(depths, numbers, collapse = ", "))
  study
}

# The part of the report about each of study$shown, as one. What comes later may confound what came
# before, and is said first.
parts_shown <- function(study) {
  parts <- lapply(study$shown, function(name) {
    switch(name, gaps = gaps_shown(with_gaps_shown(study)),
      spin = spin_imposed(with_imposed_spin(study)), clicks = crowd_clicks(study))
  })
  said <- function(name) unlist(lapply(rev(parts), `[[`, name))
  list(tests = do.call(all_outcomes, lapply(parts, `[[`, "tests")), words = said("words"),
    section = said("section"))
}

# The study with the columns above in its trials; NA where no gap was measured or the bodies never
# met. Later collisions of a trial are only counted.
with_gaps_shown <- function(study) {
  collisions <- rows_of_trials(study, paste(
    "SELECT trial, level AS level_used, CAST(gap_arcmin AS REAL) AS gap_arcmin,",
    "CAST(hidden_share AS REAL) AS hidden_share FROM seen_collision"), "ORDER BY trial, step")
  first <- collisions[!duplicated(collisions$row), ]
  columns <- c("gap_arcmin", "hidden_share", "level_used")
  study$trials[columns] <- first[match(seq_len(nrow(study$trials)), first$row), columns]
  study$trials$meetings <- tabulate(collisions$row, nrow(study$trials))
  study
}

gaps_shown <- function(study) {
  trials <- study$trials
  measured <- trials[!is.na(trials$gap_arcmin), ]
  section <- function(lines) c("## What was shown", "", lines, "")
  if (nrow(measured) == 0) {
    sentence <- paste("What was shown is not known yet: no gap has been measured.",
      fill_in_words(trials, "first"))
    return(list(words = sentence, section = section(sentence)))
  }
  tests <- gap_tests(measured)
  notes <- shown_notes(trials)
  table <- shown_table(measured, study$factors[["level"]], study$factors[["viewpoint"]])
  list(tests = tests, words = c(gap_words(combine_outcomes(tests)), notes),
    section = section(c(table_lines(table), "", paste(c("Medians over trials.", notes),
      collapse = " "))))
}

# Which commands measure the gaps of these trials.
fill_in_words <- function(trials, when) {
  commands <- paste0("`impetus replay ", unique(trials$path), " --truth`", collapse = " and ")
  sprintf("Run %s %s.", commands, when)
}

shown_notes <- function(trials) {
  never <- sum(trials$meetings == 0)
  unmeasured <- trials[is.na(trials$gap_arcmin) & trials$meetings > 0, ]
  again <- sum(trials$meetings > 1)
  c(
    if (nrow(unmeasured) > 0) sprintf("The gap was not measured in %s, left out here. %s",
      count_of(nrow(unmeasured), "trial"), fill_in_words(unmeasured, "to have them too")),
    if (never > 0) sprintf("The bodies never met in %s, left out here.", count_of(never, "trial")),
    if (again > 0) sprintf("The bodies met more than once in %s: the first collision counts.",
      count_of(again, "trial")))
}

# One row per cell that has a measured gap: trials, medians, levels of the tree used, mean rating.
shown_table <- function(trials, level, viewpoint) {
  each_row(split(trials, trials[c(viewpoint, level)], drop = TRUE), function(cell) data.frame(
    level = cell[[level]][1], viewpoint = cell[[viewpoint]][1], trials = nrow(cell),
    gap_arcmin = stats::median(cell$gap_arcmin), hidden_share = stats::median(cell$hidden_share),
    level_used = paste(sort(unique(cell$level_used)), collapse = ", "), rating = mean(cell$rating)))
}

# The table of shown_table as Markdown.
table_lines <- function(table) {
  table_as_markdown(table, c(level = "%s", viewpoint = "%s", trials = "%d", gap_arcmin = "%.1f",
    hidden_share = "%.2f", level_used = "%s", rating = "%.2f"), c("level", "viewpoint (°)",
    "trials", "gap as projected (′)", "hidden share", "level of tree used", "mean rating"))
}

gap_tests <- function(trials) {
  trials$log10_gap <- log10(trials$gap_arcmin + 1)
  measured_effect_tests(trials, "log10_gap", "gap shown", c(kGapFamily, kGapOddsFamily))
}

gap_words <- function(tests) {
  measured_effect_words(tests, "In a second mixed model, of the gap as it was shown",
    c(kGapFamily, kGapOddsFamily), "a tenfold gap (plus 1′)")
}

# The mixed model of rating on a number measured in each trial, with a slope of it per participant.
# `name`: what it is a model of.
measured_effect_tests <- function(trials, column, name, families) {
  kind <- paste("mixed model of the", name)
  if (!is.null(why_no_test(trials)) || participant_count(trials) < 3 ||
      length(unique(trials[[column]])) == 1) {
    return(outcome(remarks = sprintf(
      "The %s needs three participants or more, ratings that vary and values that vary.", kind)))
  }
  trials$rating <- factor(trials$rating, ordered = TRUE)
  say_progress(sprintf("fitting the %s ...", kind))
  model_tests(fit_models(trials, column, column, kind = kind), trials, column, kind, families)
}

measured_effect_words <- function(tests, opening, families, unit) {
  row <- tests_of(tests, families[1])
  if (nrow(row) == 0) return(character())
  sprintf("%s, %s: %s; odds ratio of a higher rating for %s, %s.", opening,
    if (row$p_holm < kSignificance) "ratings depended on it" else
      "an effect of it was not detected, which is not evidence of its absence",
    chi_squared_words(row), unit, size_words(tests_of(tests, families[2])))
}

# Adds imposed_spin_rad_s to the trials: the mean magnitude over both bodies, summed as vectors over
# the trial's collisions that had one; NA where none was drawn.
with_imposed_spin <- function(study) {
  axes <- sprintf("imposed_spin_%s_rad_s", c("a_x", "a_y", "a_z", "b_x", "b_y", "b_z"))
  sums <- sprintf("CAST(total(%s) AS REAL) AS %s", axes, axes)
  drawn <- rows_of_trials(study, paste("SELECT trial,", paste(sums, collapse = ", "),
    "FROM seen_collision"), "AND imposed_spin_a_x_rad_s IS NOT NULL GROUP BY trial")
  magnitude <- function(columns) sqrt(rowSums(drawn[columns]^2))
  spin_rad_s <- (magnitude(axes[1:3]) + magnitude(axes[4:6])) / 2
  study$trials$imposed_spin_rad_s <- spin_rad_s[match(seq_len(nrow(study$trials)), drawn$row)]
  study
}

spin_imposed <- function(study) {
  trials <- study$trials
  level <- study$factors[["level"]]
  drawn <- trials[!is.na(trials$imposed_spin_rad_s), ]
  sentence <- confounding_words(trials, level)
  section <- function(lines) c("## Imposed random spin", "", lines, "")
  if (nrow(drawn) == 0) return(list(words = sentence, section = section(sentence)))
  tests <- measured_effect_tests(drawn, "imposed_spin_rad_s", "imposed spin",
    c(kSpinFamily, kSpinOddsFamily))
  rows <- vapply(split(drawn, drawn[[level]], drop = TRUE), function(cell) {
    spin <- stats::quantile(cell$imposed_spin_rad_s, c(0.05, 0.5, 0.95))
    sprintf("%s | %d | %.2f | %.2f to %.2f | %.2f", cell[[level]][1], nrow(cell), spin[2], spin[1],
      spin[3], mean(cell$rating))
  }, "")
  table <- markdown_table(c("level", "trials with random spin", "median spin (rad/s)",
    "5th to 95th percentile", "mean rating"), unname(rows))
  words <- measured_effect_words(combine_outcomes(tests), "Among the trials with random spin",
    c(kSpinFamily, kSpinOddsFamily), "each rad/s of it")
  list(tests = tests, words = c(sentence, words), section = section(c(sentence, "", table)))
}

# Which levels had random spin, and what that means for the effect of level.
confounding_words <- function(trials, level) {
  with_spin <- tapply(!is.na(trials$imposed_spin_rad_s), droplevels(trials[[level]]), mean)
  if (all(with_spin == 0)) {
    return("No random spin was imposed, so level is not confounded with randomness.")
  }
  if (max(with_spin) - min(with_spin) < 1e-9) return(paste(
    "Random spin was imposed in the same share of trials at every level."))
  spread <- paste0(names(with_spin), ": ", sprintf("%.0f %%", 100 * with_spin), collapse = "; ")
  sprintf(paste("CONFOUNDED: random spin was imposed at some levels only (share of trials by level,",
    "%s), so an effect of level cannot be told from one of randomness; a run with random spin",
    "switched off can."), spread)
}

# Clicks in a crowd, by number of bodies and scheduler; empty for a protocol without clicks.
crowd_clicks <- function(study) {
  columns <- unname(study$factors[c("bodies", "scheduler")])
  rows <- rows_of_trials(study,
    "SELECT trial, clicks, CAST(exposure_s AS REAL) AS exposure_s FROM click_trial")
  if (nrow(rows) == 0) return(list())
  rows[columns] <- study$trials[rows$row, columns]
  lines <- vapply(split(rows, rows[rev(columns)], drop = TRUE), function(cell) {
    each <- t_interval(tapply(cell$clicks, as.character(cell$participant), mean))
    sprintf("%s | %s | %d | %.2f | %s | %s", cell[[columns[1]]][1], cell[[columns[2]]][1],
      nrow(cell), each[["mean"]], if (is.na(each[["low"]])) "–" else
        sprintf("%.2f to %.2f", each[["low"]], each[["high"]]), or_dash(rate_of(cell), "%.3f"))
  }, "")
  list(words = sprintf("Participants clicked %s in %s.", count_of(sum(rows$clicks), "time"),
      count_of(nrow(rows), "trial")),
    section = c("## Clicks", "", markdown_table(c("bodies", "scheduler", "trials",
      "clicks per trial", "95 % CI over participants", "clicks per second"), unname(lines)), ""))
}
