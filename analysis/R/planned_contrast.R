# The pairs of kinds that a gaze-contingent study compares, such as tracked − random, overall and at
# each number of bodies, for ratings and clicks.
#
#   trials of these two kinds ─┬─> mixed model, odds or rate ratios      primary
#                              └─> participants' differences ─┬─> paired t tests
#                                                             └─> equivalence tests
#
# The model sees the trials of the two kinds alone: what participants differ in is then the contrast,
# which a test of it needs (Barr 2013), and odds have to be proportional between these two only. A pair
# is list(of, against, planned): a difference is `of` minus `against`.
#
# Invariant: the families of tests of two pairs have different names, so Holm's correction never
# runs over both.
# SPDX-License-Identifier: MIT

kContrastFamily <- "planned contrast tracked − random, mixed model"
kContrastMeansFamily <- "planned contrast tracked − random, participants' means"
kClickContrastFamily <- "clicks, planned contrast tracked / random"
kClickEquivalenceFamily <- "clicks, equivalence of rates"
kRateMargin <- c(0.8, 1.25)
kOverall <- "overall"
kTrackedRandom <- list(of = "tracked", against = "random", planned = TRUE)

planned_pair <- function(study) study$pairs[[1]]

pair_words <- function(pair, between = " − ") paste0(pair$of, between, pair$against)

# The name of a family of tests for this pair, from its name for tracked and random.
family_of <- function(family, pair) {
  named <- sub("tracked( [−/] )random", paste0(pair$of, "\\1", pair$against), family)
  if (pair$planned) return(named)
  paste0(sub("planned contrast", "contrast", named),
    if (!grepl("tracked [−/] random", family)) paste0(", ", pair_words(pair)))
}

# Outcomes of `tests(pair)` for every pair of the study, as one.
for_each_pair <- function(study, tests) do.call(all_outcomes, lapply(study$pairs, tests))

# The trials of a pair; `against` is the first level, so a coefficient is of − against.
contrast_trials <- function(trials, pair = kTrackedRandom) {
  two <- trials[trials$scheduling %in% c(pair$of, pair$against), ]
  two$scheduling <- factor(as.character(two$scheduling), c(pair$against, pair$of))
  two$bodies <- droplevels(two$bodies)
  two
}

# Differences of − against of each participant's means of the column `of`: participants by
# "overall" and, where there are several, each number of bodies. Overall is the mean of the others; NA where a cell is empty.
contrast_differences <- function(trials, of = "rating", pair = kTrackedRandom) {
  two <- contrast_trials(trials, pair)
  bodies <- levels(trials$bodies)
  two$bodies <- factor(as.character(two$bodies), bodies)
  means <- participant_means(two, c("scheduling", "bodies"), of)
  at <- function(kind) means[, paste(kind, bodies, sep = " : "), drop = FALSE]
  differences <- at(pair$of) - at(pair$against)
  differences <- cbind(rowMeans(differences), differences)
  colnames(differences) <- c(kOverall, bodies)
  if (length(bodies) > 1) differences else differences[, kOverall, drop = FALSE]
}

# Has any participant rated both kinds of the pair at one number of bodies?
has_contrast <- function(trials, pair = kTrackedRandom) {
  any(!is.na(contrast_differences(trials, pair = pair)))
}

# "tracked − random, overall", "tracked − random, at 5 bodies"
contrast_label <- function(place, pair = kTrackedRandom) {
  paste0(pair_words(pair), ", ", ifelse(place == kOverall, place, paste("at", place, "bodies")))
}

# Odds ratios of a higher rating, or rate ratios of clicks with their equivalence tests, in a trial of
# one kind against the other, as an outcome. `without`: words added to the family when some trials
# are left out.
contrast_model_tests <- function(trials, without = "", pair = kTrackedRandom,
                                 response = "rating") {
  is_rating <- response == "rating"
  two <- contrast_trials(if (is_rating) trials else trials_with_exposure(trials), pair)
  reason <- why_no_contrast(two, response, pair, without)
  if (!is.null(reason)) return(outcome(remarks = reason))
  if (is_rating) two$rating <- factor(two$rating, ordered = TRUE)
  family <- family_of(if (is_rating) kContrastFamily else kClickContrastFamily, pair)
  kind <- paste("mixed model of", pair_words(pair, " and "), "trials")
  row <- function(models, coefficients, place) {
    estimate <- sum_of_coefficients(models$full, coefficients)
    label <- contrast_label(place, pair)
    rbind(ratio_row(paste0(family, without), paste0(model_method(models, kind), "; Wald"), label,
      estimate, response_model(response)$size, two),
      if (!is_rating && without == "") rate_equivalence_row(estimate, label, two, pair))
  }
  contrast_rows(two, response, row)
}

# The contrast from mixed models of the response, overall and at each number of bodies.
# `row(models, coefficients, place)`: its rows at one place.
contrast_rows <- function(two, response, row) {
  fit <- function(terms, differing, kind) {
    fit_models(two, terms, differing, character(), response,
      paste0(kind, if (response == "clicks") " of clicks"))
  }
  terms <- c("scheduling", varying_factors(two, "bodies"))
  alone <- fit(terms, "scheduling", "mixed model of the planned contrast")
  if (!is.null(alone$failure)) return(outcome(remarks = alone$remarks))
  coefficient <- paste0("scheduling", levels(two$scheduling)[2])
  overall <- outcome(row(alone, coefficient, kOverall), alone$remarks)
  if (!"bodies" %in% terms) return(overall)
  # Would an estimate of the interaction be pushed to infinity?
  if (has_endless_cell(two, "scheduling:bodies", response)) {
    return(all_outcomes(overall, outcome(remarks = paste(
      "A cell of the planned contrast holds one end of the scale only, so the mixed model gives it",
      "overall alone."))))
  }
  both <- fit(c(terms, "scheduling:bodies"), "scheduling:bodies",
    "mixed model of the contrast by number of bodies")
  if (!is.null(both$failure)) return(all_outcomes(overall, outcome(remarks = both$remarks)))
  bodies <- levels(two$bodies)
  apart <- each_row(bodies, function(place) {
    row(both, c(coefficient, if (place != bodies[1]) paste0(coefficient, ":bodies", place)), place)
  })
  all_outcomes(overall, outcome(apart, both$remarks))
}

why_no_contrast <- function(two, response, pair, without) {
  if (nlevels(droplevels(two$scheduling)) < 2) {
    return(sprintf("There is no contrast of %s of %s%s: it needs trials of both%s.",
      response_model(response)$noun, pair_words(pair, " against "), without,
      if (response == "clicks") " of which it is known how long one could click" else ""))
  }
  none <- if (response == "rating") why_no_test(two)
  if (!is.null(none)) return(none)
  why_no_model(two, c("scheduling", if (response == "rating") varying_factors(two, "bodies")),
    response, paste(response_model(response)$kind, "of the planned contrast"))
}

# Two one-sided z tests of the log ratio against ratios of .8 and 1.25, with a 90 % interval.
rate_equivalence_row <- function(estimate, label, trials, pair) {
  tests <- two_one_sided(estimate[["estimate"]], estimate[["error"]], log(kRateMargin))
  test_row(family_of(kClickEquivalenceFamily, pair),
    sprintf("two one-sided z tests, margin %.2f to %.2f", kRateMargin[1], kRateMargin[2]), label,
    "z", tests$statistic, NA, p = tests$p, size_name = "rate ratio",
    size = exp(estimate[["estimate"]]), interval = exp(tests$interval), interval_level = 0.90,
    participants = participant_count(trials), trials = nrow(trials))
}

# Paired t tests and equivalence tests of participants' mean ratings, as an outcome. `margin`: in
# rating points.
contrast_means_tests <- function(trials, margin, pair = kTrackedRandom) {
  differences <- contrast_differences(trials, pair = pair)
  do.call(all_outcomes, lapply(colnames(differences), function(place) {
    known <- differences[!is.na(differences[, place]), place]
    label <- contrast_label(place, pair)
    all_outcomes(outcome(remarks = left_out_remark(paste("the paired tests of", label),
        nrow(differences) - length(known))),
      paired_test(known, family_of(kContrastMeansFamily, pair), label,
        "difference in rating points"),
      if (length(known) > 1) equivalence_test(known, label, margin,
        family_of(kEquivalenceFamily, pair)))
  }))
}
