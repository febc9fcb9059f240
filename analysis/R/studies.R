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

# Reports on the study of this name, from the files that `words` of the command line name. Refuses
# before anything is written.
report_study <- function(name, words) {
  study <- study_description(name)
  # What reads the study, what tests, writes and says everything, and packages beside those of all.
  kind <- switch(study$kind,
    ratings = list(open_rating_study, report_rating_study, c("ordinal", "lme4", "afex")),
    thresholds = list(open_threshold_study, report_threshold_study, c("lme4", "afex")),
    accuracy = list(open_accuracy_study, report_accuracy_study, "afex"),
    scheduling = list(open_gaze_study, report_gaze_study, c("ordinal", "lme4", "afex")),
    distribution = list(open_distribution_study, report_distribution_study))
  arguments <- read_arguments(words, sprintf(
    "Rscript analysis/%s.R study.sqlite [more.sqlite ...] --out figures/", name))
  need_packages(c("RSQLite", unlist(kind[-(1:2)]), "ggplot2"))
  opened <- kind[[1]](study, arguments$studies)
  prepare_folder(arguments$out)
  kind[[2]](c(opened, out = arguments$out))
}
