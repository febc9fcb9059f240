# What was really shown: who took part, how well timed, which levels and gaps, where the gaze was.
# Measured values, beside what was asked for.
# SPDX-License-Identifier: MIT

# One row per participant of a protocol; `out`: codes wholly left out.
participants_table <- function(path, protocol) {
  rows <- rows_of_view(path, "enrolment_summary", protocol)
  whole <- query_study(path, "SELECT participant, reason FROM excluded WHERE trial IS NULL")
  state <- ifelse(!is.na(rows$finished_utc), "finished",
    ifelse(rows$completed_trials > 0, "in progress", "enrolled"))
  at <- match(rows$participant, whole$participant)
  data.frame(participant = rows$participant, who = ifelse(rows$simulated == 1, "simulated", "person"),
    planned = rows$planned_trials, completed = rows$completed_trials, sittings = rows$sessions,
    state = state, late = ifelse(rows$timed_frames > 0,
      sprintf("%.2f %%", 100 * rows$late_timed_frames / rows$timed_frames), NA),
    left_out = ifelse(is.na(at), "", whole$reason[at]))
}

kParticipantHeads <- c("Participant", "Who", "Main trials planned", "completed", "Sittings", "State",
  "Late frames", "Left out, why")

# Sentences about timing, freezes, collisions and gaze of the main trials of a protocol.
shown_sentences <- function(path, protocol) {
  rows <- rows_of_view(path, "rated_trial", protocol)
  c(
    frame_sentences(rows_of_view(path, "enrolment_summary", protocol)),
    hold_sentence(rows), gaze_shown_sentences(rows), collision_sentences(path, protocol),
    pop_sentence(query_study(path, paste("SELECT count(DISTINCT trial) AS trials, sum(pops) AS pops,",
      "max(largest_pop_deg) AS largest FROM popped_step WHERE protocol = ? AND phase = 'main'"),
      protocol)))
}

frame_sentences <- function(rows) {
  timed <- sum(rows$timed_frames, na.rm = TRUE)
  late <- sum(rows$late_timed_frames, na.rm = TRUE)
  if (timed == 0) return("No timed frame was recorded.")
  sprintf("%s frames were timed, practice included; %s.", format(timed, big.mark = ","),
    if (late == 0) "none was late" else sprintf("%s (%.3f %%) came late",
      format(late, big.mark = ","), 100 * late / timed))
}

# The freeze at contact, for studies that impose one.
hold_sentence <- function(rows) {
  rows <- rows[rows$phase == "main", ]
  if (nrow(rows) == 0 || all(rows$intended_hold_ms == 0)) return(character())
  each <- split(rows, rows$intended_hold_ms)
  words <- vapply(each, function(cell) {
    ends <- unique(range(cell$realised_hold_ms))
    sprintf("%s ms was %s ms (%s)", format(cell$intended_hold_ms[1]),
      paste(sprintf("%.2f", ends), collapse = " to "), count_of(nrow(cell), "trial"))
  }, "")
  paste0("Freeze at contact as realised on the display's frames: ", paste(words, collapse = "; "), ".")
}

gaze_shown_sentences <- function(rows) {
  rows <- rows[rows$phase == "main", ]
  lost <- rows$gaze_lost_share[!is.na(rows$gaze_lost_share)]
  if (nrow(rows) == 0) return(character())
  c(gaze_sentences(rows, "the tables of sensitivity show the comparisons without them"),
    if (length(lost) > 0) sprintf(paste("The gaze was lost for %.1f %% of the stimulus on average",
      "(at most %.1f %% of a trial)."), 100 * mean(lost), 100 * max(lost)))
}

collision_sentences <- function(path, protocol) {
  rows <- query_study(path, paste("SELECT count(*) AS n, count(gap_arcmin) AS measured,",
    "count(DISTINCT trial) AS trials FROM seen_collision WHERE protocol = ? AND phase = 'main'"),
    protocol)
  if (rows$n == 0) return("No collision was recorded in the main trials.")
  c(
    sprintf("%s in %s.", count_of(rows$n, "collision"), count_of(rows$trials, "main trial")),
    if (rows$measured == 0) paste("No gap has been measured: `impetus replay STUDY --truth` does it,",
      "before the report is made.") else if (rows$measured < rows$n)
      sprintf("The gap was measured in %s of them.", format(rows$measured, big.mark = ",")))
}

pop_sentence <- function(row) {
  if (is.na(row$pops) || row$pops == 0) return(character())
  sprintf("Detail fell from one step to the next %s in %s; the largest jump was %.2f°.",
    count_of(row$pops, "time"), count_of(row$trials, "trial"), row$largest)
}

# Collisions of the main trials by the level that was reached: why refinement stopped, and gaps.
levels_reached <- function(path, protocol) {
  rows <- query_study(path, paste("SELECT level, stopped, CAST(gap_arcmin AS REAL) AS gap_arcmin,",
    "CAST(hidden_share AS REAL) AS hidden_share FROM seen_collision",
    "WHERE protocol = ? AND phase = 'main'"), protocol)
  if (nrow(rows) == 0) return(NULL)
  gaps_by(rows, rows$level, function(cell) data.frame(stopped = paste(vapply(names(table(
    cell$stopped)), function(why) sprintf("%s: %.0f %%", why, 100 * mean(cell$stopped == why)), ""),
    collapse = ", ")))
}

kLevelHeads <- c("Level reached", "Collisions", "Share", "Gap, median (′)", "Gap, 95 % below (′)",
  "Hidden share, median", "Refinement ended at")

# The same by each level of each factor of the design: what a condition really looked like.
levels_by_factor <- function(path, protocol) {
  rows <- query_study(path, paste("SELECT factor, CAST(trial_level.level AS TEXT) AS of,",
    "seen_collision.level AS reached, stopped, CAST(gap_arcmin AS REAL) AS gap_arcmin,",
    "CAST(hidden_share AS REAL) AS hidden_share FROM seen_collision JOIN trial_level USING (trial)",
    "WHERE protocol = ? AND phase = 'main'"), protocol)
  if (nrow(rows) == 0) return(NULL)
  each_row(split(rows, rows$factor), function(mine) {
    levels <- unique(mine$of)
    number <- suppressWarnings(as.numeric(levels))
    levels <- if (anyNA(number)) sort(levels) else levels[order(number)]
    if (length(levels) < 2 || length(levels) > 12) return(NULL)
    table <- gaps_by(mine, factor(mine$of, levels), function(cell) data.frame(
      reached = paste(range(cell$reached)[c(TRUE, diff(range(cell$reached)) > 0)], collapse = " to ")))
    cbind(factor = label_of(mine$factor[1]), table)
  })
}

kFactorLevelHeads <- c("Factor", "Level", "Collisions", "Share", "Gap, median (′)",
  "Gap, 95 % below (′)", "Hidden share, median", "Levels of the tree reached")

# The same by how far from the gaze they began, where it was followed: which levels were looked at.
levels_looked_at <- function(path, protocol) {
  rows <- query_study(path, paste("SELECT gaze_eccentricity_deg AS away_deg, level AS reached,",
    "CAST(gap_arcmin AS REAL) AS gap_arcmin, CAST(hidden_share AS REAL) AS hidden_share",
    "FROM seen_collision WHERE protocol = ? AND phase = 'main'",
    "AND gaze_eccentricity_deg IS NOT NULL"), protocol)
  if (nrow(rows) == 0) return(NULL)
  away <- cut(rows$away_deg, c(0, 2, 5, 10, Inf), include.lowest = TRUE,
    labels = c("within 2°", "2° to 5°", "5° to 10°", "beyond 10°"))
  gaps_by(rows, away, function(cell) data.frame(reached = mean(cell$reached)))
}

kLookedAtHeads <- c("From the gaze", "Collisions", "Share", "Gap, median (′)",
  "Gap, 95 % below (′)", "Hidden share, median", "Level reached, mean")

gaps_by <- function(rows, by, more) {
  cells <- split(rows, by, drop = TRUE)
  table <- each_row(cells, function(cell) data.frame(collisions = nrow(cell),
    share = sprintf("%.1f %%", 100 * nrow(cell) / nrow(rows)),
    median = stats::median(cell$gap_arcmin, na.rm = TRUE),
    p95 = stats::quantile(cell$gap_arcmin, 0.95, na.rm = TRUE, names = FALSE),
    hidden = stats::median(cell$hidden_share, na.rm = TRUE), more(cell)))
  cbind(level = names(cells), table, row.names = NULL)
}
