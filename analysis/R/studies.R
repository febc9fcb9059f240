# The studies that have a command of their own, as data: analysis/NAME.R reports on the study that
# analysis/studies/NAME.dcf describes, field by field:
#
#   Title, Question, Thesis  of the report; what is asked; what the thesis found
#   Kind     ratings (rating_study.R), thresholds (threshold_study.R), accuracy (accuracy_study.R),
#            scheduling (gaze_study.R) or distribution (scheduler_distribution.R)
#   Factors  without units, the one of interest first
#   Views    that a file must have beside those of every study
#
#   ratings: Interactions       are those of the first factor with each other one tested?
#            Shown              what else a trial showed: gaps, spin, clicks (shown_in_trials.R)
#            Depths, Depths of  what the three levels of a tree are called, and what they are
#   thresholds: Scale           logarithmic, or the factor's own
#               Level           realised freeze: of the display's frames, or that of the plan
#   accuracy: Published         the accuracy that others found, by level: "collide .81, drop .75"
#   scheduling: Kinds           as figures order them, those with the fewest bad collisions near the
#                               gaze first
#               Planned, Beside the pairs compared (planned_contrast.R)
#               Thesis tests    are the thesis's own tests made too?
# SPDX-License-Identifier: MIT

kSchedulingKinds <- c("all-good", "tracked", "random", "all-bad")

# The study of this name as list(protocol, title, kind, factors, views, ...).
study_description <- function(name) {
  fields <- read.dcf(file.path(getOption("impetus.analysis"), "studies", paste0(name, ".dcf")))[1, ]
  has <- function(field) field %in% names(fields)
  words <- function(field, sign = ", ") {
    if (has(field)) strsplit(fields[[field]], sign, fixed = TRUE)[[1]]
  }
  pairs <- lapply(Filter(has, c("Planned", "Beside")), function(field) {
    two <- words(field, " - ")
    list(of = two[1], against = two[2], planned = field == "Planned")
  })
  list(protocol = name, title = fields[["Title"]], kind = fields[["Kind"]],
    factors = words("Factors"), views = words("Views"), shown = words("Shown"),
    interactions = has("Interactions"),
    depth_names = if (has("Depths")) list(words("Depths"), fields[["Depths of"]]),
    log10 = has("Scale"), realised_hold = has("Level"), kinds = words("Kinds"), pairs = pairs,
    thesis = has("Thesis tests"), published = unlist(lapply(words("Published"), function(one) {
      two <- strsplit(one, " ", fixed = TRUE)[[1]]
      stats::setNames(as.numeric(two[2]), two[1])
    })))
}

# Reports on the study of this name, from the files that `words` of the command line name.
report_study <- function(name, words) {
  study <- study_description(name)
  switch(study$kind,
    ratings = report_rating_study(open_rating_study(study, words)),
    thresholds = report_threshold_study(open_threshold_study(study, words)),
    accuracy = report_accuracy_study(open_accuracy_study(study, words)),
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
