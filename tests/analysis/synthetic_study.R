# Study files made up for the tests: the project's own schema, filled by known observers.
#
# That of causality is the cumulative-logit one of the simulated causality participant:
#   eta = -2.2 + 4.5 * Phi((delay - mu_i) / 45 ms) + u_i,  mu_i ~ N(110, 30) ms,  u_i ~ N(0, .6)
#   P(rating <= k) = logistic(cut_k - eta),  cuts (-1, 1.2),  a lapse of .02 rates at random
# Speed and viewpoint do not enter it: their planted effect is none.
#
# That of gap sees a gap, planted by level and viewpoint (kGapsArcmin), less of it at higher speed:
#   eta = -3 + b log10(gap + 1) + u_i,  b = 2.8, 2.3, 1.8 at 50, 100, 150 %,  u_i ~ N(0, .6)
# with the same cuts and lapse.
# SPDX-License-Identifier: MIT

kDelaysMs <- c(0, 100, 300)
kSpeedsDegS <- c(5, 10, 15)
kViewpointsDeg <- c(0, 45, 85)

kTreeLevels <- c(0, 2, 4)
kGapsArcmin <- rbind("0" = c(80, 57, 12), "2" = c(25, 18, 4), "4" = c(3, 2, 0.5))
colnames(kGapsArcmin) <- kViewpointsDeg

# One row per main trial of every participant, in a shuffled order, without ratings yet.
causality_plan <- function(participants = 20, repetitions = 3) {
  shuffled_plan(participants, expand.grid(
    delay_ms = kDelaysMs, speed_deg_s = kSpeedsDegS, viewpoint_deg = kViewpointsDeg,
    repetition = seq_len(repetitions)
  ))
}

shuffled_plan <- function(participants, cells) {
  plans <- lapply(seq_len(participants), function(i) {
    data.frame(participant = sprintf("P%02d", i), cells[sample(nrow(cells)), ])
  })
  do.call(rbind, plans)
}

# The cumulative-logit observer's ratings, 1 to 3, for the rows of a plan.
observed_ratings <- function(plan) {
  person <- factor(plan$participant)
  midpoint_ms <- rnorm(nlevels(person), 110, 30)[person]
  intercept <- rnorm(nlevels(person), 0, 0.6)[person]
  ratings_at(-2.2 + 4.5 * pnorm((plan$delay_ms - midpoint_ms) / 45) + intercept)
}

ratings_at <- function(eta) {
  position <- eta + rlogis(length(eta))
  rating <- 1 + (position > -1) + (position > 1.2)
  lapse <- runif(length(eta)) < 0.02
  ifelse(lapse, sample(1:3, length(eta), replace = TRUE), rating)
}

# The plan with ratings, from a seed.
causality_trials <- function(seed, participants = 20, repetitions = 3) {
  set.seed(seed)
  plan <- causality_plan(participants, repetitions)
  plan$rating <- observed_ratings(plan)
  plan
}

# The gap study's plan with ratings, from a seed; the gaps are planted_gaps(trials).
gap_trials <- function(seed, participants = 20, repetitions = 3) {
  set.seed(seed)
  plan <- shuffled_plan(participants, expand.grid(
    level = kTreeLevels, speed_percent = c(50, 100, 150), viewpoint_deg = kViewpointsDeg,
    repetition = seq_len(repetitions)
  ))
  person <- factor(plan$participant)
  slope <- 2.3 - 0.5 * (plan$speed_percent - 100) / 50
  plan$rating <- ratings_at(-3 + slope * log10(planted_gaps(plan) + 1) +
    rnorm(nlevels(person), 0, 0.6)[person])
  plan
}

planted_gaps <- function(trials) {
  kGapsArcmin[cbind(as.character(trials$level), as.character(trials$viewpoint_deg))]
}

# Effects and odds ratios of factors from one model with a random intercept, as published ones are.
one_model_tests <- function(trials, factors) {
  trials$rating <- factor(trials$rating, ordered = TRUE)
  trials[factors] <- lapply(trials[factors], droplevels)
  model_tests(fit_models(trials, factors, character()), trials, factors)
}

# Writes rated trials to a new study file at `path` and returns the path.
#
# `trials` has participant, repetition, rating and one column per factor; delay_ms, if
# there, is the freeze; rows with rating NA are planned and not yet done.
# Optional columns take their defaults below.
write_study <- function(path, trials, protocol = "causality", practice = 0) {
  defaults <- list(
    simulated = 1, protocol_hash = "hash-1", minimum = 1, maximum = 3, best = 1,
    low_anchor = "very believable", high_anchor = "very unbelievable", device = NA,
    realised_hold_ms = NA, timed_frames = 150, late_timed_frames = 0, sync_overridden = 0,
    catch = 0
  )
  factors <- setdiff(names(trials), c("participant", "repetition", "rating", names(defaults)))
  for (column in setdiff(names(defaults), names(trials))) trials[[column]] <- defaults[[column]]

  study <- new_study(path)
  on.exit(DBI::dbDisconnect(study))
  put <- function(table, rows) DBI::dbAppendTable(study, table, rows)

  people <- unique(trials[c("participant", "simulated")])
  people$id <- seq_len(nrow(people))
  put("participant", data.frame(
    id = people$id, pseudonym = people$participant, simulated = people$simulated
  ))
  hashes <- unique(trials$protocol_hash)
  put("protocol", data.frame(
    id = seq_along(hashes), name = protocol, hash = paste(protocol, hashes),
    protocol_json = "{}", scene_json = "{}"
  ))
  enrolments <- unique(trials[c("participant", "protocol_hash", "sync_overridden")])
  enrolments$id <- seq_len(nrow(enrolments))
  key <- function(rows) paste(rows$participant, rows$protocol_hash)
  unfinished <- key(enrolments) %in% key(trials[is.na(trials$rating), ])
  put("enrolment", data.frame(
    id = enrolments$id, participant_id = match(enrolments$participant, people$participant),
    protocol_id = match(enrolments$protocol_hash, hashes), seed = enrolments$id,
    planned_utc = "2026-01-01T10:00:00Z",
    finished_utc = ifelse(unfinished, NA, "2026-01-01T11:00:00Z")
  ))
  put("session", data.frame(
    id = enrolments$id, enrolment_id = enrolments$id, started_utc = "2026-01-01T10:00:00Z",
    recording_format = 1, build = "test", machine = "test", display = "test", simulated = 1,
    screen_width_m = 0.5, screen_height_m = 0.3, screen_width_px = 1920, screen_height_px = 1080,
    viewing_distance_m = 0.57, screen_measured = 1, refresh_hz = 60, rounding_allowed = 0,
    sync_tries = 1, sync_valid_flips = 120, sync_passed = 1 - enrolments$sync_overridden,
    sync_overridden = enrolments$sync_overridden
  ))

  trials$enrolment <- enrolments$id[match(key(trials), key(enrolments))]
  trials$phase <- rep("main", nrow(trials))
  if (practice > 0) {
    first <- trials[!duplicated(trials$enrolment), ]
    first <- first[rep(seq_len(nrow(first)), each = practice), ]
    first$phase <- "practice"
    first$rating <- first$maximum  # would shift every mean if it were pooled
    trials <- rbind(trials, first)  # last, so that a main trial's number is its row
  }
  trials$id <- seq_len(nrow(trials))
  conditions <- vapply(trials$id, function(i) {
    as.character(jsonlite::toJSON(as.list(trials[i, factors, drop = FALSE]), auto_unbox = TRUE))
  }, "")
  put("trial", data.frame(
    id = trials$id, enrolment_id = trials$enrolment, slot = trials$id, phase = trials$phase,
    repetition = trials$repetition, condition = conditions, seed = trials$id,
    catch = trials$catch
  ))
  done <- trials[!is.na(trials$rating), ]
  hold_ms <- if ("delay_ms" %in% factors) done$delay_ms else rep(0, nrow(done))
  realised_ms <- ifelse(is.na(done$realised_hold_ms), hold_ms, done$realised_hold_ms)
  put("attempt", data.frame(
    id = done$id, trial_id = done$id, session_id = done$enrolment, number = rep(1, nrow(done)),
    outcome = rep("completed", nrow(done)), onset_ns = done$id,
    intended_hold_ms = hold_ms, realised_hold_ms = realised_ms,
    timed_frames = done$timed_frames, late_timed_frames = done$late_timed_frames,
    late_untimed_frames = rep(0, nrow(done)), sync_overridden = done$sync_overridden
  ))
  put("rating", data.frame(
    attempt_id = done$id, rating = done$rating, minimum = done$minimum, maximum = done$maximum,
    best = done$best, low_anchor = done$low_anchor, high_anchor = done$high_anchor,
    device = ifelse(is.na(done$device), ifelse(done$simulated == 1, "simulated", "key"),
      done$device),
    question_shown_ns = done$id, arrived_ns = done$id + 5e8,
    arrival_uncertainty_ns = rep(1e6, nrow(done))
  ))
  path
}

# Adds collisions to the study file at `path`: rows of trial (its number in the order written),
# step, level, and gap_arcmin and hidden_share, NA where `replay --truth` has not been run. Optional
# columns take their defaults below.
add_collisions <- function(path, collisions) {
  extra <- c("distance_m", "speed_deg_s", "eccentricity_deg", "list",
    sprintf("imposed_spin_%s_rad_s", c("a_x", "a_y", "a_z", "b_x", "b_y", "b_z")))
  defaults <- c(list(body_a = "a", body_b = "b", time_s = NA, gaze_eccentricity_deg = NA,
    gap_arcmin = NA, hidden_share = NA), stats::setNames(as.list(rep(NA_real_, length(extra))), extra))
  defaults[c("eccentricity_deg", "list")] <- 0
  for (column in setdiff(names(defaults), names(collisions))) {
    collisions[[column]] <- defaults[[column]]
  }
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  on.exit(DBI::dbDisconnect(study))
  collisions$id <- seq_len(nrow(collisions))
  DBI::dbAppendTable(study, "collision", data.frame(
    id = collisions$id, attempt_id = collisions$trial, step = collisions$step,
    body_a = collisions$body_a, body_b = collisions$body_b, level = collisions$level,
    stopped = "greatest level", point_x_m = 0,
    point_y_m = 0, point_z_m = 0, normal_x = 1, normal_y = 0, normal_z = 0, depth_m = 0,
    approach_m_s = 1, impulse_Ns = 1, imposed_hold_ms = 0, imposed_no_spin = 1,
    time_s = collisions$time_s, gaze_eccentricity_deg = collisions$gaze_eccentricity_deg,
    collisions[extra]
  ))
  measured <- collisions[!is.na(collisions$gap_arcmin), ]
  DBI::dbAppendTable(study, "collision_truth", data.frame(
    collision_id = measured$id, gap_m = measured$gap_arcmin / 1e4, gap_px = measured$gap_arcmin,
    gap_arcmin = measured$gap_arcmin, hidden_share = measured$hidden_share
  ))
  path
}

# Leaves a participant, or one of the participant's trials, out of the analysis of the study at
# `path`; `excluded` 0 takes that back.
add_exclusion <- function(path, participant, trial, reason, excluded = 1) {
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  on.exit(DBI::dbDisconnect(study))
  DBI::dbExecute(study, "INSERT INTO exclusion (participant_id, trial_id, excluded, reason,
    decided_utc) VALUES ((SELECT id FROM participant WHERE pseudonym = ?), ?, ?, ?,
    '2026-02-01T09:00:00Z')", params = list(participant, trial, excluded, reason))
  path
}

# An empty study file at `path`, open for writing. `schema_paths` is set by run.R.
new_study <- function(path) {
  file.copy(empty_study(), path, overwrite = TRUE)
  DBI::dbConnect(RSQLite::SQLite(), path)
}

# A study of no participants; made once, for its statements take a while.
empty_study <- local({
  made <- NULL
  function() {
    if (is.null(made)) {
      path <- tempfile(fileext = ".sqlite")
      study <- DBI::dbConnect(RSQLite::SQLite(), path)
      lines <- sub("--.*$", "", unlist(lapply(schema_paths, readLines)))
      for (statement in strsplit(paste(lines, collapse = "\n"), ";")[[1]]) {
        if (nzchar(trimws(statement))) DBI::dbExecute(study, statement)
      }
      DBI::dbDisconnect(study)
      made <<- path
    }
    made
  }
})
