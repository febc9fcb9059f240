# What a trial really showed: the gap at its first collision, measured by `impetus replay --truth`.
#
#   seen_collision ─> gap_arcmin, hidden_share, level_used, meetings: columns of the trials
#                       ├─> table of medians by level × viewpoint
#                       └─> mixed model: rating ~ log10(gap_arcmin + 1)
#
# The gap is an outcome of the tree's level, of the bodies' shape and of the viewpoint; nobody sets
# it. NA where it was not measured or the bodies never met.
# SPDX-License-Identifier: MIT

kGapFamily <- "mixed model of the gap shown, effect"
kGapOddsFamily <- "mixed model of the gap shown, odds ratio"

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

# The study with the columns above in its trials. Later collisions of a trial are only counted.
with_gaps_shown <- function(study) {
  collisions <- do.call(rbind, lapply(unique(study$trials$path), read_collisions, study$protocol))
  key <- function(rows) paste(rows$path, rows$trial)
  first <- collisions[!duplicated(key(collisions)), ]
  columns <- c("gap_arcmin", "hidden_share", "level_used")
  study$trials[columns] <- first[match(key(study$trials), key(first)), columns]
  study$trials$meetings <- as.integer(table(factor(key(collisions), key(study$trials))))
  study
}

read_collisions <- function(path, protocol) {
  study <- open_study(path, c(kViews, "seen_collision"))
  on.exit(DBI::dbDisconnect(study))
  rows <- DBI::dbGetQuery(study, paste(
    "SELECT trial, level AS level_used, CAST(gap_arcmin AS REAL) AS gap_arcmin,",
    "CAST(hidden_share AS REAL) AS hidden_share FROM seen_collision",
    "WHERE protocol = ? AND phase = 'main' ORDER BY trial, step"
  ), params = list(protocol))
  rows$path <- rep(path, nrow(rows))
  rows
}

# The part of the report about what was shown: list(tests, words, section).
gaps_shown <- function(study) {
  trials <- study$trials
  measured <- trials[!is.na(trials$gap_arcmin), ]
  if (nrow(measured) == 0) {
    sentence <- paste("What was shown is not known yet: no gap has been measured.",
      fill_in_words(trials, "first"))
    return(list(words = sentence, section = shown_section(sentence)))
  }
  tests <- gap_tests(measured)
  notes <- shown_notes(trials)
  table <- shown_table(measured, study$factors[["level"]], study$factors[["viewpoint"]])
  list(tests = tests, words = c(gap_words(combine_outcomes(tests)), notes),
    section = shown_section(c(table_lines(table), "", paste(c("Medians over trials.", notes),
      collapse = " "))))
}

shown_section <- function(lines) c("## What was shown", "", lines, "")

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
      count_of(again, "trial"))
  )
}

# One row per cell that has a measured gap: trials, medians, levels of the tree used, mean rating.
shown_table <- function(trials, level, viewpoint) {
  cells <- split(trials, trials[c(viewpoint, level)], drop = TRUE)
  rows <- lapply(cells, function(cell) data.frame(
    level = cell[[level]][1], viewpoint = cell[[viewpoint]][1], trials = nrow(cell),
    gap_arcmin = stats::median(cell$gap_arcmin), hidden_share = stats::median(cell$hidden_share),
    level_used = paste(sort(unique(cell$level_used)), collapse = ", "), rating = mean(cell$rating)
  ))
  do.call(rbind, unname(rows))
}

# The table of shown_table as Markdown.
table_lines <- function(table) {
  heads <- c("level", "viewpoint (°)", "trials", "gap as projected (′)", "hidden share",
    "level of tree used", "mean rating")
  markdown_table(heads, sprintf("%s | %s | %d | %.1f | %.2f | %s | %.2f", table$level,
    table$viewpoint, table$trials, table$gap_arcmin, table$hidden_share, table$level_used,
    table$rating))
}

# The mixed model of rating on log10(gap in minutes of arc + 1), a slope of it per participant.
gap_tests <- function(trials) {
  if (!is.null(why_no_test(trials)) || participant_count(trials) < 3) {
    return(outcome(remarks =
      "The mixed model of the gap shown needs three participants or more whose ratings vary."))
  }
  trials$log10_gap <- log10(trials$gap_arcmin + 1)
  if (length(unique(trials$log10_gap)) == 1) {
    return(outcome(remarks = "Every gap shown was the same: there is no model of it."))
  }
  trials$rating <- factor(trials$rating, ordered = TRUE)
  say_progress("fitting the mixed model of the gap shown ...")
  kind <- "mixed model of the gap shown"
  models <- fit_family_or_fall_back(trials, "log10_gap", "log10_gap", kind = kind)
  mixed_model_outcome(models, trials, "log10_gap", kind, families = c(kGapFamily, kGapOddsFamily))
}

gap_words <- function(tests) {
  row <- tests_of(tests, kGapFamily)
  odds <- tests_of(tests, kGapOddsFamily)
  if (nrow(row) == 0) return(character())
  sprintf(paste(
    "In a second mixed model, of the gap as it was shown, %s: %s; odds ratio of a higher rating",
    "for a tenfold gap (plus 1′), %.2f, 95 %% CI [%.2f, %.2f]."
  ), if (row$p_holm < kSignificance) "ratings depended on it" else
    "an effect was not detected, which is not evidence of its absence",
    chi_squared_words(row), odds$effect_size, odds$interval_low, odds$interval_high)
}
