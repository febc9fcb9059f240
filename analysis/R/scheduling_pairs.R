# The studies of gaze-contingent scheduling: the kinds of each, in order, and the pairs compared.
#
#   gaze-contingent:        tracked − random    (planned)
#   gaze-contingent-yoked:  tracked − recorded  (planned), random − recorded beside it
#
# Recorded moves as a gaze does, but as somebody else's: tracked differs from it only in where the
# participant looks. A pair is list(of, against, planned): a difference is `of` minus `against`.
#
# Invariant: the families of tests of two pairs have different names, so Holm's correction never
# runs over both.
# SPDX-License-Identifier: MIT

scheduling_pair <- function(of, against, planned = TRUE) {
  list(of = of, against = against, planned = planned)
}

kTrackedRandom <- scheduling_pair("tracked", "random")

# Kinds as a figure shows them, those with the fewest bad collisions near the gaze first.
kSchedulingKinds <- c("all-good", "tracked", "random", "all-bad")

kSchedulingStudies <- list(
  "gaze-contingent" = list(kinds = kSchedulingKinds, pairs = list(kTrackedRandom),
    title = "Gaze-contingent scheduling: ratings and clicks", thesis = TRUE),
  "gaze-contingent-yoked" = list(kinds = c("tracked", "recorded", "random"),
    pairs = list(scheduling_pair("tracked", "recorded"),
      scheduling_pair("random", "recorded", planned = FALSE)),
    title = "Gaze-contingent scheduling against another's gaze: ratings and clicks",
    thesis = FALSE)
)

planned_pair <- function(study) study$pairs[[1]]

pair_words <- function(pair, between = " − ") paste0(pair$of, between, pair$against)

# The name of a family of tests for this pair, from its name for tracked and random.
family_of <- function(family, pair) {
  if (pair$planned) {
    return(sub("tracked( [−/] )random", paste0(pair$of, "\\1", pair$against), family))
  }
  named <- grepl("tracked [−/] random", family)
  family <- sub("planned contrast", "contrast", family)
  if (!named) return(paste0(family, ", ", pair_words(pair)))
  sub("tracked( [−/] )random", paste0(pair$of, "\\1", pair$against), family)
}

# Outcomes of `tests(pair)` for every pair of the study, as one.
for_each_pair <- function(study, tests) do.call(all_outcomes, lapply(study$pairs, tests))
