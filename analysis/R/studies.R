# The studies that have a command of their own, as data: analysis/NAME.R reports on kStudies$NAME.
#
#   kind     ratings (rating_study.R), thresholds (threshold_study.R), scheduling (gaze_study.R) or
#            distribution (scheduler_distribution.R)
#   factors  without units, the one of interest first; title: of the report
#   views    that a file must have beside those of every study
#
#   ratings: interactions  are those of the first factor with each other one tested?
#            shown         what else a trial showed (shown_in_trials.R)
#            depth_names   what the three levels of a tree are called, and what they are levels of
#   thresholds: log10          is the scale logarithmic?
#               realised_hold  is the level the freeze on the display's frames?
#   scheduling: kinds   in the order of figures, those with the fewest bad collisions near the gaze
#                       first
#               pairs   compared (planned_contrast.R), the planned one first
#               thesis  is it the thesis's?
#               Recorded moves as a gaze does, but as somebody else's: tracked differs from it only
#               in where the participant looks.
# SPDX-License-Identifier: MIT

kSchedulingKinds <- c("all-good", "tracked", "random", "all-bad")

kGazeViews <- c("click_trial", "trial_click", "seen_collision", "gaze_sample", "gaze_calibration")

kStudies <- list(
  causality = list(kind = "ratings", title = "Causality: ratings by delay",
    factors = c("delay", "speed", "viewpoint")),
  "causality-thresholds" = list(kind = "thresholds", title = "Causality: thresholds of the delay",
    factors = "delay", realised_hold = TRUE),
  "causality-thresholds-quest" = list(kind = "thresholds",
    title = "Causality: thresholds of the delay, by QUEST+", factors = "delay",
    realised_hold = TRUE),
  gap = list(kind = "ratings", title = "Gap: ratings by level of the sphere tree",
    factors = c("level", "speed", "viewpoint"), interactions = TRUE, shown = "gaps",
    depth_names = list(c("root", "middle", "finest"), "Levels of the sphere tree"),
    views = "seen_collision"),
  "gap-thresholds" = list(kind = "thresholds",
    title = "Gap: thresholds by eccentricity and distractors", factors = "gap", log10 = TRUE),
  response = list(kind = "ratings", title = "Response: ratings by level of the sphere tree",
    factors = c("level", "speed", "viewpoint"), interactions = TRUE, shown = c("gaps", "spin"),
    depth_names = list(c("root", "middle", "finest"), "Levels of the sphere tree"),
    views = "seen_collision"),
  figures = list(kind = "ratings", title = "Figures: ratings by greatest level of detail",
    factors = c("level", "speed", "viewpoint"), interactions = TRUE, shown = "gaps",
    depth_names = list(c("spheres", "parts", "deepest"), "Greatest levels of detail"),
    views = "seen_collision"),
  crowd = list(kind = "ratings", title = "Crowds: ratings by number of bodies",
    factors = c("bodies", "scheduler"), interactions = TRUE, shown = "clicks",
    views = "click_trial"),
  "gaze-contingent" = list(kind = "scheduling",
    title = "Gaze-contingent scheduling: ratings and clicks", factors = c("scheduling", "bodies"),
    kinds = kSchedulingKinds, thesis = TRUE, views = kGazeViews,
    pairs = list(list(of = "tracked", against = "random", planned = TRUE))),
  "gaze-contingent-yoked" = list(kind = "scheduling",
    title = "Gaze-contingent scheduling against another's gaze: ratings and clicks",
    factors = c("scheduling", "bodies"), kinds = c("tracked", "recorded", "random"),
    thesis = FALSE, views = kGazeViews,
    pairs = list(list(of = "tracked", against = "recorded", planned = TRUE),
      list(of = "random", against = "recorded", planned = FALSE))),
  "scheduler-distribution" = list(kind = "distribution",
    title = "Schedulers: which collisions come first", views = "seen_collision")
)

study_of <- function(name) c(kStudies[[name]], protocol = name)

# Reports on the study of this name, from the files that `words` of the command line name.
report_study <- function(name, words) {
  study <- study_of(name)
  switch(study$kind,
    ratings = report_rating_study(open_rating_study(study, words)),
    thresholds = report_threshold_study(open_threshold_study(study, words)),
    scheduling = report_gaze_study(open_gaze_study(study, words)),
    distribution = report_distribution_study(open_distribution_study(study, words)))
}

# What the command line names, as read_arguments gives it, with the packages there.
study_arguments <- function(study, words, packages) {
  arguments <- read_arguments(words, sprintf(
    "Rscript analysis/%s.R study.sqlite [more.sqlite ...] --out figures/", study$protocol))
  need_packages(packages)
  arguments
}
