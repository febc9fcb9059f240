# What a participant was exposed to: how many collisions, how many of them bad, how visible, how far
# from the gaze. Tracked is meant to differ from the other kind in one of these, how far bad collisions
# are from the gaze; if the two differ in others too, the contrast of their ratings is no fair one.
#
#   collisions of one participant and kind ─> exposure_of() ─> mean over participants: the table
#                                                         └─> the study's pairs, paired t tests
#
# Bad: resolved at the bounding sphere. Events: collisions of one sort (bad or good) closer than
# the protocol's merge_within_ms are one. Visible gap: the gap as projected without its hidden share,
# of collisions between bodies and of those with walls apart, for they are of different sizes.
# SPDX-License-Identifier: MIT

kExposureFamily <- "exposure, tracked − random"
kManipulationFamily <- "manipulation check, tracked − random"
kManipulated <- "bad_eccentricity_deg"

# Columns of the exposure table, in their order, with the words for each.
kExposureMeasures <- c(
  body_per_trial = "collisions between bodies per trial",
  body_bad_share = "share of bad ones between bodies",
  wall_per_trial = "collisions with walls per trial",
  wall_bad_share = "share of bad ones with walls",
  bad_events_per_trial = "bad events per trial",
  good_events_per_trial = "good events per trial",
  body_bad_gap_arcmin = "visible gap of bad ones between bodies, median (′)",
  wall_bad_gap_arcmin = "visible gap of bad ones with walls, median (′)",
  eccentricity_deg = "eccentricity of collisions from the gaze, median (°)",
  bad_eccentricity_deg = "eccentricity of bad collisions from the gaze, median (°)",
  covered_share = "share of the enclosure inside the region"
)

# The trials with bad_events and good_events, how many click_events() of a sort each has. NA where the
# time of one of its sort is not known.
with_events <- function(study) {
  events <- click_events(study)
  timeless <- study$collisions[is.na(study$collisions$time_s), ]
  count <- function(bad) {
    counts <- tabulate(events$row[events$bad == bad], nrow(study$trials))
    replace(counts, timeless$row[timeless$bad == bad], NA)
  }
  study$trials$bad_events <- count(TRUE)
  study$trials$good_events <- count(FALSE)
  study
}

mean_known <- function(x) if (all(is.na(x))) NA_real_ else mean(x, na.rm = TRUE)

# The measures of one participant's trials of one kind, as a one-row data frame; NA: not known.
exposure_of <- function(trials, collisions) {
  bad <- collisions[collisions$bad, ]
  share_bad <- function(some) if (nrow(some) > 0) mean(some$bad) else NA_real_
  middle <- function(x) stats::median(as.numeric(x), na.rm = TRUE)
  data.frame(trials = nrow(trials), body_per_trial = sum(!collisions$wall) / nrow(trials),
    body_bad_share = share_bad(collisions[!collisions$wall, ]),
    wall_per_trial = sum(collisions$wall) / nrow(trials),
    wall_bad_share = share_bad(collisions[collisions$wall, ]),
    bad_events_per_trial = mean(trials$bad_events),
    good_events_per_trial = mean(trials$good_events),
    body_bad_gap_arcmin = middle(bad$visible_gap_arcmin[!bad$wall]),
    wall_bad_gap_arcmin = middle(bad$visible_gap_arcmin[bad$wall]),
    eccentricity_deg = middle(collisions$gaze_eccentricity_deg),
    bad_eccentricity_deg = middle(bad$gaze_eccentricity_deg),
    covered_share = mean_known(trials$region_covered_share))
}

# exposure_of every participant, kind of scheduling and number of bodies that has a trial.
exposure_by_participant <- function(study) {
  columns <- c("participant", "scheduling", "bodies")
  each_row(split(seq_len(nrow(study$trials)), study$trials[columns], drop = TRUE), function(rows) {
    cbind(study$trials[rows[1], columns],
      exposure_of(study$trials[rows, ], study$collisions[study$collisions$row %in% rows, ]))
  })
}

# One row per kind and number of bodies: trials, and each measure's mean over the participants who
# have it.
exposure_table <- function(each) {
  each_row(split(each, each[c("bodies", "scheduling")], drop = TRUE), function(cell) {
    data.frame(scheduling = cell$scheduling[1], bodies = cell$bodies[1],
      participants = nrow(cell), trials = sum(cell$trials),
      lapply(cell[names(kExposureMeasures)], mean_known))
  })
}

# Paired t tests over participants of every measure for a pair of kinds, as an outcome. A participant's
# value for a kind is the mean over the numbers of bodies, and is missing where one of them is.
exposure_tests <- function(each, pair = kTrackedRandom) {
  do.call(all_outcomes, lapply(names(kExposureMeasures), function(measure) {
    differences <- contrast_differences(each, measure, pair)[, kOverall]
    family <- if (measure == kManipulated && pair$of == "tracked") kManipulationFamily else
      kExposureFamily
    paired_test(differences[!is.na(differences)], family_of(family, pair),
      kExposureMeasures[[measure]], kExposureMeasures[[measure]])
  }))
}

# What is not known of the exposure, and how to fill it in.
exposure_sentences <- function(study) {
  collisions <- study$collisions
  bad <- collisions[collisions$bad, ]
  unmeasured <- bad[is.na(bad$visible_gap_arcmin), ]
  unseen <- sum(is.na(study$trials$exposure_s))
  c(
    if (nrow(unmeasured) > 0) sprintf(paste("The gap was not measured in %s of %s:",
      "`impetus replay STUDY --truth` measures it."), format(nrow(unmeasured), big.mark = ","),
      count_of(nrow(bad), "bad collision")),
    if (all(is.na(study$trials$merge_within_ms)))
      "The protocol names no merge_within_ms, so every collision is an event of its own.",
    if (unseen > 0) sprintf("No frame was recorded of %s, left out of the rates of clicks.",
      count_of(unseen, "trial")))
}
