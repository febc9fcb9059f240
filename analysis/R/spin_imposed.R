# The random spin that was imposed on a trial's collisions: a change of angular velocity, drawn for
# each body and recorded (thesis sec. 6.2.2, second experiment).
#
#   seen_collision ─> imposed_spin_rad_s: a column of the trials, NA where none was drawn
#                       ├─> how it was spread over the levels: a confounding, said in words
#                       └─> mixed model of the trials that had it: rating ~ spin
# SPDX-License-Identifier: MIT

kSpinFamily <- "mixed model of the imposed spin, effect"
kSpinOddsFamily <- "mixed model of the imposed spin, odds ratio"

# Adds imposed_spin_rad_s to the trials: the mean magnitude over both bodies, summed as vectors over
# the trial's collisions that had one.
with_imposed_spin <- function(study) {
  drawn <- do.call(rbind, lapply(unique(study$trials$path), read_imposed_spin, study$protocol))
  key <- function(rows) paste(rows$path, rows$trial)
  study$trials$imposed_spin_rad_s <- drawn$spin_rad_s[match(key(study$trials), key(drawn))]
  study
}

read_imposed_spin <- function(path, protocol) {
  study <- open_study(path, c(kViews, "seen_collision"))
  on.exit(DBI::dbDisconnect(study))
  axes <- sprintf("imposed_spin_%s_rad_s", c("a_x", "a_y", "a_z", "b_x", "b_y", "b_z"))
  sums <- sprintf("CAST(total(%s) AS REAL) AS %s", axes, axes)
  rows <- DBI::dbGetQuery(study, paste("SELECT trial,", paste(sums, collapse = ", "),
    "FROM seen_collision WHERE protocol = ? AND phase = 'main'",
    "AND imposed_spin_a_x_rad_s IS NOT NULL GROUP BY trial"), params = list(protocol))
  magnitude <- function(columns) sqrt(rowSums(rows[columns]^2))
  data.frame(trial = rows$trial, path = rep(path, nrow(rows)),
    spin_rad_s = (magnitude(axes[1:3]) + magnitude(axes[4:6])) / 2)
}

# The part of the report about spin: list(tests, words, section).
spin_imposed <- function(study) {
  trials <- study$trials
  level <- study$factors[["level"]]
  drawn <- trials[!is.na(trials$imposed_spin_rad_s), ]
  sentence <- confounding_words(trials, level)
  if (nrow(drawn) == 0) return(list(words = sentence, section = spin_section(sentence)))
  tests <- spin_tests(drawn)
  rows <- vapply(split(drawn, drawn[[level]], drop = TRUE), function(cell) {
    spin <- stats::quantile(cell$imposed_spin_rad_s, c(0.05, 0.5, 0.95))
    sprintf("%s | %d | %.2f | %.2f to %.2f | %.2f", cell[[level]][1], nrow(cell), spin[2], spin[1],
      spin[3], mean(cell$rating))
  }, "")
  table <- markdown_table(c("level", "trials with random spin", "median spin (rad/s)",
    "5th to 95th percentile", "mean rating"), unname(rows))
  list(tests = tests, words = c(sentence, spin_words(combine_outcomes(tests))),
    section = spin_section(c(sentence, "", table)))
}

spin_section <- function(lines) c("## Imposed random spin", "", lines, "")

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

# The mixed model of rating on the imposed spin in rad/s, in the trials that had one.
spin_tests <- function(trials) {
  if (!is.null(why_no_test(trials)) || participant_count(trials) < 3 ||
      stats::sd(trials$imposed_spin_rad_s) == 0) {
    return(outcome(remarks = paste("The mixed model of the imposed spin needs three participants",
      "or more, ratings that vary and a spin that varies.")))
  }
  trials$rating <- factor(trials$rating, ordered = TRUE)
  say_progress("fitting the mixed model of the imposed spin ...")
  kind <- "mixed model of the imposed spin"
  models <- fit_family_or_fall_back(trials, "imposed_spin_rad_s", "imposed_spin_rad_s", kind = kind)
  mixed_model_outcome(models, trials, "imposed_spin_rad_s", kind,
    families = c(kSpinFamily, kSpinOddsFamily))
}

spin_words <- function(tests) {
  row <- tests_of(tests, kSpinFamily)
  odds <- tests_of(tests, kSpinOddsFamily)
  if (nrow(row) == 0) return(character())
  sprintf(paste("Among the trials with random spin, %s: %s; odds ratio of a higher rating for each",
    "rad/s of it, %.2f, 95 %% CI [%.2f, %.2f]."), if (row$p_holm < kSignificance)
    "ratings depended on its size" else
    "an effect of its size was not detected, which is not evidence of its absence",
    chi_squared_words(row), odds$effect_size, odds$interval_low, odds$interval_high)
}
