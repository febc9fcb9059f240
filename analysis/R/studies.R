# The studies that are described, as data: studies/NAME.dcf of the protocol NAME. Its report (study_page.R)
# says what is asked and has what its description names beside what every report has; analysis/NAME.R
# is the report of that protocol alone. Field by field:
#
#   Question, Thesis  what is asked; what the thesis found
#   Kind              ratings, thresholds, accuracy, scheduling (scheduling_part.R) or, without
#                     participants, distribution (scheduler_distribution.R)
#   Factors           without units, the one of interest first
#   Interactions      are those of the first factor with each other one tested? (ratings, scheduling)
#
#   ratings: Shown              what else a trial showed: gaps, spin (shown_in_trials.R)
#            Depths, Depths of  what the three levels of a tree are called, and what they are
#   thresholds: Scale           logarithmic, or the factor's own
#               Level           realised freeze: of the display's frames, or that of the plan
#   accuracy: Published         the accuracy that others found, by level: "collide .81, drop .75"
#   scheduling: Kinds           as figures order them, those with the fewest bad collisions near the
#                               gaze first
#               Planned, Beside the pairs compared (planned_contrast.R)
#               Thesis tests    are the thesis's own tests made too?
# SPDX-License-Identifier: MIT

# Of all these studies, in the order in which they stand wherever they are reported.
kSchedulingKinds <- c("all-good", "tracked", "recorded", "random", "all-bad")

# The study of this name as list(protocol, question, kind, factors, ...); NULL where none is described.
study_description <- function(name) {
  file <- file.path(getOption("impetus.analysis"), "studies", paste0(name, ".dcf"))
  if (!file.exists(file)) return(NULL)
  fields <- read.dcf(file)[1, ]
  has <- function(field) field %in% names(fields)
  words <- function(field, sign = ", ") {
    if (has(field)) strsplit(fields[[field]], sign, fixed = TRUE)[[1]]
  }
  said <- function(field) if (has(field)) gsub("[[:space:]]+", " ", fields[[field]])
  pairs <- lapply(Filter(has, c("Planned", "Beside")), function(field) {
    two <- words(field, " - ")
    list(of = two[1], against = two[2], planned = field == "Planned")
  })
  list(protocol = name, question = said("Question"), found = said("Thesis"), kind = fields[["Kind"]],
    factors = words("Factors"), interactions = has("Interactions"), shown = words("Shown"),
    depth_names = if (has("Depths")) list(words("Depths"), fields[["Depths of"]]),
    log10 = has("Scale"), realised_hold = has("Level"), kinds = words("Kinds"), pairs = pairs,
    thesis = has("Thesis tests"), published = unlist(lapply(words("Published"), function(one) {
      two <- strsplit(one, " ", fixed = TRUE)[[1]]
      stats::setNames(as.numeric(two[2]), two[1])
    })))
}

# The part of a report as its study is described: with `study`, the description, where its kind is of
# this response, and levels of a tree by their names.
as_described <- function(part) {
  study <- study_description(part$protocol)
  of <- list(ratings = "rating", accuracy = "answer", scheduling = c("rating", "clicks"))
  if (is.null(study) || !isTRUE(part$response %in% of[[study$kind]])) return(part)
  part$study <- study
  with_depths_named(part)
}

# The column of the factor `name`, with or without a unit, among those that vary; NULL without it.
factor_called <- function(part, name) {
  column <- part$factors[part$factors == name | startsWith(part$factors, paste0(name, "_"))]
  if (length(column) == 1) unname(column)
}

# The interactions that a part's study tests: of its first factor with each other one that varies.
described_interactions <- function(part) {
  columns <- lapply(part$study$factors, function(name) factor_called(part, name))
  if (!isTRUE(part$study$interactions) || is.null(columns[[1]])) return(character())
  sprintf("%s:%s", columns[[1]], unlist(columns[-1]))
}
