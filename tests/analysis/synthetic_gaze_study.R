# Gaze-contingent studies made up for the tests: the project's own schema, filled by a known observer.
#
#   rating: eta = quality[kind] + u_i, u_i ~ N(0, .6), 5 is best
#           P(rating <= k) = logistic(cut_k - eta), cuts (-2, -.7, .7, 2)
#   clicks: Poisson with mean rate[kind] * g_i * h * 10 s; log g_i ~ N(0, .3) for each participant,
#           h gamma with shape 4 and mean 1 for each trial: negative binomial, theta = 4
#
# Number of bodies does not enter either.
# SPDX-License-Identifier: MIT

kThesisKinds <- c("all-good", "tracked", "random", "all-bad")
kPlantedQuality <- c("all-good" = 2.2, tracked = 1.0, recorded = -0.2, random = -0.2,
  "all-bad" = -1.8)
kPlantedClicksPerS <- c("all-good" = 0.06, tracked = 0.20, recorded = 0.32, random = 0.32,
  "all-bad" = 0.50)
kPlantedTheta <- 4

# One row per main trial with ratings and clicks, from a seed. `difference` false: random is tracked.
gaze_trials <- function(seed, participants = 10, repetitions = 3, difference = TRUE,
                        kinds = kThesisKinds) {
  set.seed(seed)
  plan <- shuffled_plan(participants, expand.grid(
    scheduling = kinds, bodies = c(5, 10, 15),
    repetition = seq_len(repetitions), stringsAsFactors = FALSE
  ))
  kind <- if (difference) plan$scheduling else sub("random", "tracked", plan$scheduling)
  person <- factor(plan$participant)
  eta <- kPlantedQuality[kind] + rnorm(nlevels(person), 0, 0.6)[person]
  plan$rating <- 1 + rowSums(outer(eta + rlogis(nrow(plan)), c(-2, -0.7, 0.7, 2), ">"))
  rate <- kPlantedClicksPerS[kind] * exp(rnorm(nlevels(person), 0, 0.3))[person]
  plan$clicks <- rpois(nrow(plan), 10 * rate *
    rgamma(nrow(plan), shape = kPlantedTheta, rate = kPlantedTheta))
  plan
}

kFivePoints <- data.frame(rating_minimum = 1L, rating_maximum = 5L, rating_best = 5L,
  low_anchor = "not believable", high_anchor = "very believable")

# The trials as scheduling_part gives them, without a file.
as_read <- function(trials) {
  trials$scheduling <- factor(trials$scheduling, kThesisKinds)
  trials$bodies <- factor(trials$bodies)
  trials
}

# Writes a study file of these trials, each of 10 s. Columns of `trials` beside the design:
# clicks, and those of attempts that only this study has, with defaults here.
write_gaze_study <- function(path, trials, merge_within_ms = 100, protocol = "gaze-contingent",
                             ...) {
  attempt <- list(gaze_source = "simulated eye", gaze_latency_p95_ms = 45, gaze_late = 0,
    region_covered_share = 0.3)
  for (column in setdiff(names(attempt), names(trials))) trials[[column]] <- attempt[[column]]
  scale <- data.frame(minimum = 1, maximum = 5, best = 5, low_anchor = "not believable",
    high_anchor = "very believable")
  scale <- scale[setdiff(names(scale), names(trials))]
  design <- cbind(trials[setdiff(names(trials), c(names(attempt), "clicks"))], scale)
  write_study(path, design, protocol = protocol, ...)
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  on.exit(DBI::dbDisconnect(study))
  execute <- function(statement, ...) DBI::dbExecute(study, statement, params = list(...))
  execute("UPDATE protocol SET protocol_json = json_object('clicks',
    json_object('merge_within_ms', ?))", merge_within_ms)
  trials$trial <- seq_len(nrow(trials))
  done <- trials[!is.na(trials$rating), ]
  execute("UPDATE attempt SET gaze_source = ?, gaze_latency_p95_ms = ?, gaze_late = ?,
    region_covered_share = ? WHERE trial_id = ?", done$gaze_source, done$gaze_latency_p95_ms,
    done$gaze_late, done$region_covered_share, done$trial)
  DBI::dbAppendTable(study, "frame", data.frame(
    attempt_id = done$trial, frame = 600, phase = "stimulus", shown_time_s = 10,
    scheduled_ns = 1e10, submitted_ns = 1e10, flipped_ns = 1e10, missed_slots = 0
  ))
  clicked <- done[done$clicks > 0, ]
  each <- sequence(clicked$clicks)
  DBI::dbAppendTable(study, "click", data.frame(
    attempt_id = rep(clicked$trial, clicked$clicks), number = each,
    device = rep("simulated", length(each)), arrived_ns = each * 1e8,
    arrival_uncertainty_ns = rep(1e6, length(each))
  ))
  path
}

# The study at `path` as the page has it: a file made of a report's data.
as_reported <- function(path) {
  folder <- tempfile()
  dir.create(folder)
  write_report_data(path, folder)
  study_of_report_data(folder)
}

# The part of a study's page that compares its kinds of scheduling.
read_scheduling <- function(path, name = "gaze-contingent") {
  scheduling_part(as_reported(path), study_description(name))
}

# What the page says of the gaze and of its calibration: a table each, by name.
gaze_tables <- function(path, name = "gaze-contingent") {
  tables <- gaze_shown(as_reported(path), name)$tables
  stats::setNames(lapply(tables, `[[`, "rows"), vapply(tables, `[[`, "", "name"))
}

# Adds a second stimulus to each trial of the study at `path`, whose onset is at `onset_ns`: its first
# and last frame, and which of the two was chosen.
add_second_stimulus <- function(path, onset_ns) {
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  on.exit(DBI::dbDisconnect(study))
  for (place in 0:1) {
    DBI::dbExecute(study, "INSERT INTO frame (attempt_id, frame, phase, shown_time_s, scheduled_ns,
      submitted_ns, flipped_ns, missed_slots, interval) SELECT id, 601 + ?1, 'stimulus', ?1 * 10, ?2,
      ?2, ?2 + ?1 * 10000000000, 0, 2 FROM attempt", params = list(place, onset_ns))
  }
  DBI::dbExecute(study, "INSERT INTO response (attempt_id, number, kind, question, answer, detail,
    device, question_shown_ns, arrived_ns, arrival_uncertainty_ns) SELECT id, 1, 'two_interval',
    'Which?', 'first', '{}', 'simulated', 0, 1, 0 FROM attempt")
  path
}

# Adds gaze samples: rows of trial, sample, taken_ns, and loss, NA where there is a place; interval, 1
# where it is left out.
add_gaze <- function(path, samples) {
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  on.exit(DBI::dbDisconnect(study))
  place <- ifelse(is.na(samples$loss), 0, NA)
  DBI::dbAppendTable(study, "gaze", data.frame(attempt_id = samples$trial,
    sample = samples$sample, taken_ns = samples$taken_ns, x_m = place, y_m = place,
    loss = samples$loss, interval = if (is.null(samples$interval)) 1 else samples$interval))
  path
}

# Adds calibrations: rows of session_id, kind, number and whatever other columns are not the same for
# all.
add_calibrations <- function(path, rows) {
  columns <- list(before_slot = 1, gaze_source = "simulated eye", accuracy_deg = 0.5,
    worst_accuracy_deg = 0.6, precision_rms_deg = 0.05, lost_share = 0, sampling_hz = 250,
    accuracy_limit_deg = 1, passed = 1, began_ns = 0)
  for (column in setdiff(names(columns), names(rows))) rows[[column]] <- columns[[column]]
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  on.exit(DBI::dbDisconnect(study))
  DBI::dbAppendTable(study, "calibration", rows)
  path
}

# Collisions at random for every trial of `trials`, as add_collisions takes them: three between
# bodies per body and 10 s, a third as many with walls, bad by kind, and farther from the gaze when
# tracked has made them so.
random_collisions <- function(trials, truth = TRUE) {
  trials$trial <- seq_len(nrow(trials))
  trials <- trials[!is.na(trials$rating), ]
  rows <- trials[rep(seq_len(nrow(trials)), rpois(nrow(trials), 4 * trials$bodies)), ]
  n <- nrow(rows)
  bad_share <- c("all-good" = 0, tracked = 0.7, recorded = 0.75, random = 0.8,
    "all-bad" = 1)
  bad <- runif(n) < bad_share[rows$scheduling]
  tracked <- rows$scheduling == "tracked"
  eccentricity_deg <- ifelse(tracked & bad, 5, 0) + rexp(n, 1 / 6)
  data.frame(trial = rows$trial, step = seq_len(n), level = ifelse(bad, 0, 4),
    body_b = ifelse(runif(n) < 0.25, "wall +y", "b"), time_s = runif(n, 0, 10),
    gaze_eccentricity_deg = eccentricity_deg,
    gap_arcmin = if (truth) ifelse(bad, rexp(n, 1 / 30), 0.5) else NA, hidden_share = 0.25)
}

kVaried <- "slope|participant:"  # random parts with more than an intercept

# `expression` with models of an intercept alone, which is what was planted: those with more take
# ten times as long and are tested in test_rating_models.R and test_cumulative_link.R.
without_slopes <- function(expression) {
  real <- fit_rating_model
  on.exit(assign("fit_rating_model", real, globalenv()))
  assign("fit_rating_model", function(trials, factors, random, ...) {
    if (grepl(kVaried, random)) list(failure = "left out") else real(trials, factors, random, ...)
  }, globalenv())
  expression
}

# `expression` with some attempts of the count models made to fail; those that fail match `failing`.
with_failing <- function(failing, expression) {
  real <- fit_count_model
  on.exit(assign("fit_count_model", real, globalenv()))
  assign("fit_count_model", function(trials, terms, random, distribution) {
    if (grepl(failing, paste(distribution, random))) return(list(failure = "planted"))
    real(trials, terms, random, distribution)
  }, globalenv())
  expression
}
