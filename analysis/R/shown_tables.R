# What was really shown: who took part, how well timed, which levels and gaps, where the gaze was.
# Measured values, beside what was asked for.
# SPDX-License-Identifier: MIT

# Who is analysed of a protocol, as keep_people_apart() has it: nobody who is left out whole, and
# simulated participants only where there is no person.
analysed_enrolments <- function(path, protocol) {
  rows <- enrolments_not_left_out(path, protocol)
  rows[analyses_simulated(path, protocol) | rows$simulated == 0, ]
}

# Are those who are analysed simulated? Those who enrolled are, where nobody is left to analyse.
analyses_simulated <- function(path, protocol) {
  left <- enrolments_not_left_out(path, protocol)
  of_whom <- Filter(function(rows) nrow(rows) > 0, list(left[left$completed_trials > 0, ], left,
    rows_of_view(path, "enrolment_summary", protocol)))[[1]]
  all(of_whom$simulated == 1)
}

enrolments_not_left_out <- function(path, protocol) {
  rows <- rows_of_view(path, "enrolment_summary", protocol)
  whole <- query_study(path, "SELECT participant FROM excluded WHERE trial IS NULL")$participant
  rows[!rows$participant %in% whole, ]
}

# The view that tells of every completed trial; in data of before, of rated ones alone.
shown_view <- function(path) {
  views <- query_study(path, "SELECT name FROM sqlite_master WHERE type = 'view'")$name
  if ("shown_trial" %in% views) "shown_trial" else "rated_trial"
}

# Those of `rows` (participant, trial) whose trials are analysed: no catch trials, none left out.
analysed_rows <- function(path, protocol, rows) {
  catch <- query_study(path, paste("SELECT trial FROM", shown_view(path), "WHERE catch = 1",
    "UNION SELECT trial FROM trial_response WHERE catch = 1"))$trial
  out <- query_study(path, "SELECT trial FROM excluded WHERE trial IS NOT NULL")$trial
  people <- analysed_enrolments(path, protocol)$participant
  rows[rows$participant %in% people & !rows$trial %in% c(catch, out), ]
}

# The collisions of the trials that are analysed, for the tables and sentences below.
analysed_collisions <- function(path, protocol) {
  known <- query_study(path, "SELECT name FROM pragma_table_info('seen_collision')")$name
  spin <- intersect("imposed_spin_a_x_rad_s", known)  # data of before have none
  analysed_rows(path, protocol, query_study(path, paste("SELECT participant, trial, level, stopped,",
    "CAST(gap_arcmin AS REAL) AS gap_arcmin, CAST(hidden_share AS REAL) AS hidden_share,",
    "CAST(gaze_eccentricity_deg AS REAL) AS away_deg,", if (length(spin) > 0) paste(spin, "IS NOT NULL")
    else "0", "AS spun FROM seen_collision WHERE protocol = ? AND phase = 'main'"), protocol))
}

# Each trial's level of each factor: trial, factor, of.
levels_of_trials <- function(path) {
  query_study(path, "SELECT trial, factor, CAST(level AS TEXT) AS of FROM trial_level")
}

# One row per participant of a protocol.
participants_table <- function(path, protocol) {
  rows <- rows_of_view(path, "enrolment_summary", protocol)
  whole <- query_study(path, "SELECT participant, reason FROM excluded WHERE trial IS NULL")
  single <- query_study(path, paste("SELECT participant FROM excluded WHERE trial IN (SELECT trial FROM",
    "(SELECT protocol, phase, trial FROM rated_trial UNION SELECT protocol, phase, trial FROM",
    "trial_response UNION SELECT protocol, phase, trial FROM click_trial)",
    "WHERE protocol = ? AND phase = 'main')"), protocol)
  trials <- as.vector(table(factor(single$participant, rows$participant)))
  state <- ifelse(!is.na(rows$finished_utc), "finished",
    ifelse(rows$completed_trials > 0, "in progress", "enrolled"))
  why <- ifelse(trials == 0, "", sprintf("%d trial%s", trials, ifelse(trials == 1, "", "s")))
  why[!rows$participant %in% analysed_enrolments(path, protocol)$participant] <- kAmongPeople
  at <- match(rows$participant, whole$participant)
  why[!is.na(at)] <- whole$reason[at[!is.na(at)]]
  data.frame(participant = rows$participant, who = ifelse(rows$simulated == 1, "simulated", "person"),
    planned = rows$planned_trials, completed = rows$completed_trials, sittings = rows$sessions,
    state = state, late = ifelse(rows$timed_frames > 0,
      sprintf("%.2f %%", 100 * rows$late_timed_frames / rows$timed_frames), NA),
    left_out = why)
}

kParticipantHeads <- c("Participant", "Who", "Main trials planned", "completed", "Sittings", "State",
  "Late frames", "Left out, why")

# Sentences about timing, freezes, collisions and gaze of the trials of a protocol that are analysed.
shown_sentences <- function(path, protocol, collisions) {
  rows <- analysed_rows(path, protocol, rows_of_view(path, shown_view(path), protocol))
  popped <- analysed_rows(path, protocol, query_study(path, paste("SELECT participant, trial, pops,",
    "largest_pop_deg FROM popped_step WHERE protocol = ? AND phase = 'main'"), protocol))
  c(
    frame_sentences(analysed_enrolments(path, protocol)),
    hold_sentence(rows), gaze_shown_sentences(rows), collision_sentences(collisions),
    if (nrow(collisions) > 0 && nrow(query_study(path, paste("SELECT 1 FROM trial_response",
      "WHERE protocol = ? AND kind = 'two_interval' LIMIT 1"), protocol)) > 0)
      "Of a trial's two stimuli these are of the one that had the condition's levels.",
    spin_sentences(collisions, levels_of_trials(path)), pop_sentence(popped))
}

# Factors of which some levels were shown with random spin and others without.
spin_sentences <- function(rows, levels) {
  if (sum(rows$spun) == 0) return(character())
  levels <- levels[levels$trial %in% rows$trial, ]
  levels$spun <- levels$trial %in% rows$trial[rows$spun == 1]
  unlist(lapply(split(levels, levels$factor), function(mine) {
    share <- tapply(mine$spun, factor(mine$of, in_order(unique(mine$of))), mean)
    if (max(share) - min(share) < 1e-9) return(character())
    sprintf(paste("CONFOUNDED: random spin was imposed at some levels of %s only (share of trials: %s),",
      "so an effect of it cannot be told from one of randomness."), plain_name(mine$factor[1]),
      paste0(names(share), ": ", sprintf("%.0f %%", 100 * share), collapse = "; "))
  }), use.names = FALSE)
}

frame_sentences <- function(rows) {
  timed <- sum(rows$timed_frames, na.rm = TRUE)
  late <- sum(rows$late_timed_frames, na.rm = TRUE)
  if (timed == 0) return("No timed frame was recorded of those who are analysed.")
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
  c(gaze_sentences(rows),
    if (length(lost) > 0) sprintf(paste("The gaze was lost for %.1f %% of the stimulus on average",
      "(at most %.1f %% of a trial)."), 100 * mean(lost), 100 * max(lost)))
}

collision_sentences <- function(rows) {
  if (nrow(rows) == 0) return("No collision was recorded in the main trials that are analysed.")
  measured <- sum(!is.na(rows$gap_arcmin))
  c(
    sprintf("%s in %s.", count_of(nrow(rows), "collision"),
      count_of(length(unique(rows$trial)), "main trial")),
    if (measured == 0) paste("No gap has been measured: `impetus replay STUDY --truth` does it,",
      "before the report is made.") else if (measured < nrow(rows))
      sprintf("The gap was measured in %s of them.", format(measured, big.mark = ",")))
}

pop_sentence <- function(rows) {
  if (sum(rows$pops) == 0) return(character())
  sprintf("Detail fell from one step to the next %s in %s; the largest jump was %.2f°.",
    count_of(sum(rows$pops), "time"), count_of(length(unique(rows$trial)), "trial"),
    max(rows$largest_pop_deg, na.rm = TRUE))
}

# Collisions of the main trials by the level that was reached: why refinement stopped, and gaps.
levels_reached <- function(rows) {
  if (nrow(rows) == 0) return(NULL)
  gaps_by(rows, rows$level, function(cell) data.frame(stopped = paste(vapply(names(table(
    cell$stopped)), function(why) sprintf("%s: %.0f %%", why, 100 * mean(cell$stopped == why)), ""),
    collapse = ", ")))
}

# The same by each level of each factor of the design: what a condition really looked like.
levels_by_factor <- function(rows, levels) {
  if (nrow(rows) == 0) return(NULL)
  own <- getOption("impetus.levels")
  in_design <- factor(levels$factor, unique(c(names(own), levels$factor)))
  each_row(split(levels, in_design, drop = TRUE), function(of_trials) {
    mine <- rows[rows$trial %in% of_trials$trial, ]
    mine$of <- of_trials$of[match(mine$trial, of_trials$trial)]
    levels <- unique(mine$of)
    in_protocol <- own[[of_trials$factor[1]]]
    levels <- if (all(levels %in% in_protocol)) intersect(in_protocol, levels) else in_order(levels)
    if (length(levels) < 2 || length(levels) > 12) return(NULL)
    table <- gaps_by(mine, factor(mine$of, levels), function(cell) data.frame(
      reached = paste(range(cell$level)[c(TRUE, diff(range(cell$level)) > 0)], collapse = " to ")))
    cbind(factor = label_of(of_trials$factor[1]), table)
  })
}

# Numbers by their value, words by their letters.
in_order <- function(levels) {
  number <- suppressWarnings(as.numeric(levels))
  if (anyNA(number)) sort(levels) else levels[order(number)]
}

# The same by how far from the gaze they began, where it was followed: which levels were looked at.
levels_looked_at <- function(rows) {
  rows <- rows[!is.na(rows$away_deg), ]
  if (nrow(rows) == 0) return(NULL)
  away <- cut(rows$away_deg, c(0, 2, 5, 10, Inf), include.lowest = TRUE,
    labels = c("within 2°", "2° to 5°", "5° to 10°", "beyond 10°"))
  gaps_by(rows, away, function(cell) data.frame(reached = mean(cell$level)))
}

# What these three tables have in common; before it stands what they are by, after it `more`.
kGapHeads <- c("Collisions", "Share", "Gap, median (′)", "Gap, 95 % below (′)",
  "Hidden share, median")

gaps_by <- function(rows, by, more) {
  cells <- split(rows, by, drop = TRUE)
  table <- each_row(cells, function(cell) data.frame(collisions = nrow(cell),
    share = sprintf("%.1f %%", 100 * nrow(cell) / nrow(rows)),
    median = stats::median(cell$gap_arcmin, na.rm = TRUE),
    p95 = stats::quantile(cell$gap_arcmin, 0.95, na.rm = TRUE, names = FALSE),
    hidden = stats::median(cell$hidden_share, na.rm = TRUE), more(cell)))
  cbind(level = names(cells), table, row.names = NULL)
}
