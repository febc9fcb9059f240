# What a trial with a rating really showed, beside its factors.
#
#   seen_collision ─> gap_arcmin, hidden_share, level_used, meetings ─> table, mixed model of the gap
#                  ─> imposed_spin_rad_s ─> how it is spread over the levels, mixed model of the spin
#
# The gap is that of a trial's first collision as measured by `impetus replay --truth`: an outcome of
# the tree's level, of the bodies' shape and of the viewpoint, which nobody sets. The spin is a change
# of angular velocity, drawn for each body and recorded (thesis sec. 6.2.2, second experiment).
# Each is list(tests, words, table), or NULL where nothing of it is known.
# SPDX-License-Identifier: MIT

kGapFamily <- "mixed model of the gap shown, effect"
kGapOddsFamily <- "mixed model of the gap shown, odds ratio"
kSpinFamily <- "mixed model of the imposed spin, effect"
kSpinOddsFamily <- "mixed model of the imposed spin, odds ratio"

# The part with its three levels of the tree called by its study's names, and part$depths, the sentence
# that says which numbers they were. Fewer levels, or a first that is not 0, keep numbers.
with_depths_named <- function(part) {
  column <- factor_called(part, "level")
  numbers <- if (!is.null(column)) levels(part$trials[[column]])
  names <- part$study$depth_names[[1]]
  if (is.null(names) || length(numbers) != 3 || numbers[1] != "0") return(part)
  levels(part$trials[[column]]) <- names
  part$depths <- sprintf("%s: %s.", part$study$depth_names[[2]], paste(names, numbers, collapse = ", "))
  part
}

# What a part's study asks of its trials beside their factors: list(tests, tables, words), where
# words(tests) are paragraphs about tests that are corrected.
parts_shown <- function(part) {
  parts <- Filter(Negate(is.null), lapply(part$study$shown, function(name) {
    switch(name, gaps = gaps_shown(with_gaps_shown(part)), spin = spin_imposed(with_imposed_spin(part)))
  }))
  list(tests = do.call(all_outcomes, lapply(parts, `[[`, "tests")),
    tables = lapply(parts, `[[`, "table"),
    words = function(tests) lapply(parts, function(shown) shown$words(tests)))
}

# The part with the columns above in its trials; NA where no gap was measured or the bodies never
# met. Later collisions of a trial are only counted.
with_gaps_shown <- function(part) {
  collisions <- rows_of_trials(part, paste(
    "SELECT trial, level AS level_used, CAST(gap_arcmin AS REAL) AS gap_arcmin,",
    "CAST(hidden_share AS REAL) AS hidden_share FROM seen_collision"), "ORDER BY trial, step")
  first <- collisions[!duplicated(collisions$row), ]
  columns <- c("gap_arcmin", "hidden_share", "level_used")
  part$trials[columns] <- first[match(seq_len(nrow(part$trials)), first$row), columns]
  part$trials$meetings <- tabulate(collisions$row, nrow(part$trials))
  part
}

# The gap against the rating; NULL where none has been measured, which the page says of all collisions.
gaps_shown <- function(part) {
  trials <- part$trials
  measured <- trials[!is.na(trials$gap_arcmin), ]
  if (nrow(measured) == 0) return(NULL)
  by <- Filter(Negate(is.null), list(factor_called(part, "level"), factor_called(part, "viewpoint")))
  notes <- shown_notes(trials)
  list(tests = gap_tests(measured), words = function(tests) c(gap_words(tests), notes),
    table = list(name = "gaps", title = "The gap shown: of each trial's first collision",
      rows = shown_table(measured, unlist(by)),
      heads = c(vapply(unlist(by), label_of, "", USE.NAMES = FALSE), "Trials", "Gap as projected (′)",
        "Hidden share", "Level of the tree used", "Mean rating"),
      note = paste(c("Medians over trials.", notes), collapse = " ")))
}

shown_notes <- function(trials) {
  never <- sum(trials$meetings == 0)
  unmeasured <- sum(is.na(trials$gap_arcmin) & trials$meetings > 0)
  again <- sum(trials$meetings > 1)
  c(
    if (unmeasured > 0) sprintf(paste("The gap was not measured in %s, left out here:",
      "`impetus replay STUDY --truth` measures it."), count_of(unmeasured, "trial")),
    if (never > 0) sprintf("The bodies never met in %s, left out here.", count_of(never, "trial")),
    if (again > 0) sprintf("The bodies met more than once in %s: the first collision counts.",
      count_of(again, "trial")))
}

# One row per cell of the factors `by` that has a measured gap: trials, medians, levels of the tree
# used, mean rating.
shown_table <- function(trials, by) {
  cells <- if (length(by) > 0) split(trials, trials[rev(by)], drop = TRUE) else list(trials)
  each_row(cells, function(cell) cbind(cell[1, by, drop = FALSE], data.frame(trials = nrow(cell),
    gap_arcmin = stats::median(cell$gap_arcmin), hidden_share = stats::median(cell$hidden_share),
    level_used = paste(sort(unique(cell$level_used)), collapse = ", "), rating = mean(cell$rating)),
    row.names = NULL))
}

gap_tests <- function(trials) {
  trials$log10_gap <- log10(trials$gap_arcmin + 1)
  measured_effect_tests(trials, "log10_gap", "gap shown", c(kGapFamily, kGapOddsFamily),
    "log₁₀ of the gap plus 1′")
}

gap_words <- function(tests) {
  measured_effect_words(tests, "In a mixed model of the gap as it was shown",
    c(kGapFamily, kGapOddsFamily), "a tenfold gap (plus 1′)")
}

# The mixed model of rating on a number measured in each trial, with a slope of it per participant.
# `name`: what it is a model of; `effect`: what its tests call the number.
measured_effect_tests <- function(trials, column, name, families, effect) {
  kind <- paste("mixed model of the", name)
  if (!is.null(why_no_test(trials)) || participant_count(trials) < 3 ||
      length(unique(trials[[column]])) == 1) {
    return(outcome(remarks = sprintf(
      "The %s needs three participants or more, ratings that vary and values that vary.", kind)))
  }
  trials$rating <- factor(trials$rating, ordered = TRUE)
  say_progress(sprintf("fitting the %s ...", kind))
  tests <- model_tests(fit_models(trials, column, column, kind = kind), trials, column, kind, families)
  if (!is.null(tests$rows)) tests$rows$effect <- sub(column, effect, tests$rows$effect, fixed = TRUE)
  tests
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
with_imposed_spin <- function(part) {
  axes <- sprintf("imposed_spin_%s_rad_s", c("a_x", "a_y", "a_z", "b_x", "b_y", "b_z"))
  part$trials$imposed_spin_rad_s <- NA_real_
  known <- query_study(part$path, "SELECT name FROM pragma_table_info('seen_collision')")$name
  if (!all(axes %in% known)) return(part)  # data of before
  sums <- sprintf("CAST(total(%s) AS REAL) AS %s", axes, axes)
  drawn <- rows_of_trials(part, paste("SELECT trial,", paste(sums, collapse = ", "),
    "FROM seen_collision"), "AND imposed_spin_a_x_rad_s IS NOT NULL GROUP BY trial")
  magnitude <- function(columns) sqrt(rowSums(drawn[columns]^2))
  spin_rad_s <- (magnitude(axes[1:3]) + magnitude(axes[4:6])) / 2
  part$trials$imposed_spin_rad_s <- spin_rad_s[match(seq_len(nrow(part$trials)), drawn$row)]
  part
}

# The size of the imposed spin against the rating; NULL where none was drawn. That it was drawn at some
# levels only is said of every study (shown_tables.R).
spin_imposed <- function(part) {
  drawn <- part$trials[!is.na(part$trials$imposed_spin_rad_s), ]
  if (nrow(drawn) == 0) return(NULL)
  level <- factor_called(part, "level")
  cells <- if (is.null(level)) list(all = drawn) else split(drawn, drawn[[level]], drop = TRUE)
  rows <- each_row(names(cells), function(name) {
    spin <- stats::quantile(cells[[name]]$imposed_spin_rad_s, c(0.5, 0.05, 0.95), names = FALSE)
    data.frame(level = name, trials = nrow(cells[[name]]), median = spin[1], from = spin[2],
      to = spin[3], rating = mean(cells[[name]]$rating))
  })
  list(tests = measured_effect_tests(drawn, "imposed_spin_rad_s", "imposed spin",
      c(kSpinFamily, kSpinOddsFamily), "spin (rad/s)"),
    words = function(tests) measured_effect_words(tests, "Among the trials with random spin",
      c(kSpinFamily, kSpinOddsFamily), "each rad/s of it"),
    table = list(name = "spin", title = "The imposed random spin", rows = rows,
      heads = c(if (is.null(level)) "Trials of" else label_of(level), "Trials with random spin",
        "Median spin (rad/s)", "5th percentile", "95th percentile", "Mean rating")))
}
