# The planned contrast of a gaze-contingent study, such as tracked − random, overall and at each
# number of bodies, for ratings.
#
#   trials of these two kinds ─┬─> mixed model, odds ratios            primary
#                              └─> participants' differences ─┬─> paired t tests
#                                                             └─> equivalence tests
#
# The model sees the trials of the two kinds alone: its random slope is then the contrast's own, which
# a test of it needs (Barr 2013), and odds have to be proportional between these two only.
# SPDX-License-Identifier: MIT

kContrastFamily <- "planned contrast tracked − random, mixed model"
kContrastMeansFamily <- "planned contrast tracked − random, participants' means"
kOverall <- "overall"

# The trials of a pair; `against` is the first level, so a coefficient is of − against.
contrast_trials <- function(trials, pair = kTrackedRandom) {
  two <- trials[trials$scheduling %in% c(pair$of, pair$against), ]
  two$scheduling <- factor(as.character(two$scheduling), c(pair$against, pair$of))
  two$bodies <- droplevels(two$bodies)
  two
}

# Differences of − against of each participant's means of the column `of`: participants by
# "overall" and each number of bodies. Overall is the mean of the others; NA where a cell is empty.
contrast_differences <- function(trials, of = "rating", pair = kTrackedRandom) {
  two <- contrast_trials(trials, pair)
  bodies <- levels(trials$bodies)
  two$bodies <- factor(as.character(two$bodies), bodies)
  means <- participant_means(two, c("scheduling", "bodies"), of)
  at <- function(kind) means[, paste(kind, bodies, sep = " : "), drop = FALSE]
  differences <- at(pair$of) - at(pair$against)
  differences <- cbind(rowMeans(differences), differences)
  colnames(differences) <- c(kOverall, bodies)
  differences
}

# Has any participant rated both kinds of the pair at one number of bodies?
has_contrast <- function(trials, pair = kTrackedRandom) {
  any(!is.na(contrast_differences(trials, pair = pair)))
}

# "tracked − random, overall", "tracked − random, at 5 bodies"
contrast_label <- function(place, pair = kTrackedRandom) {
  paste0(pair_words(pair), ", ", ifelse(place == kOverall, place, paste("at", place, "bodies")))
}

# Odds ratios of a higher rating in a trial of one kind against the other, as an outcome.
# `without`: words added to the family when some trials are left out.
contrast_model_tests <- function(trials, without = "", pair = kTrackedRandom) {
  two <- contrast_trials(trials, pair)
  reason <- why_no_contrast(two, pair)
  if (!is.null(reason)) return(outcome(remarks = reason))
  two$rating <- factor(two$rating, ordered = TRUE)
  terms <- c("scheduling", varying_factors(two, "bodies"))
  fit <- function(terms, kind) {
    fit_family_or_fall_back(two, terms, "scheduling", tested = character(), kind = kind)
  }
  row <- function(models, coefficients, place) {
    estimate <- sum_of_coefficients(models$full$beta, models$full$covariance, coefficients)
    method <- sprintf("cumulative-link mixed model of %s trials, logit, %s; Wald",
      pair_words(pair, " and "), models$random)
    ratio_row(paste0(family_of(kContrastFamily, pair), without), method,
      contrast_label(place, pair), estimate,
      "odds ratio of a higher rating", two)
  }
  contrast_rows(two, terms, fit, row, has_one_sided_cell(two, "scheduling:bodies"))
}

why_no_contrast <- function(two, pair = kTrackedRandom) {
  none <- why_no_test(two)
  if (!is.null(none)) return(none)
  if (participant_count(two) < 3) {
    return("The mixed model of the planned contrast needs three participants or more.")
  }
  if (nlevels(droplevels(two$scheduling)) < 2) {
    return(sprintf("There is no planned contrast: it needs rated trials of %s and of %s.",
      pair$of, pair$against))
  }
  terms <- c("scheduling", varying_factors(two, "bodies"))
  if (!any(vapply(terms, function(term) separates(two, term), NA))) return(NULL)
  paste("The levels of scheduling or bodies separate the ratings of", pair_words(pair, " and "),
    "trials completely, so the mixed model of the planned contrast was not fitted.")
}

# The contrast from a fitted model, overall and at each number of bodies, whatever the model is.
# `fit(terms, kind)`: models, or their failure and remarks. `row(models, coefficients, place)`: one
# row. `endless`: a cell would push an estimate of the interaction to infinity.
contrast_rows <- function(two, terms, fit, row, endless) {
  alone <- fit(terms, "mixed model of the planned contrast")
  if (!is.null(alone$failure)) return(outcome(remarks = alone$remarks))
  coefficient <- paste0("scheduling", levels(two$scheduling)[2])
  overall <- outcome(row(alone, coefficient, kOverall), alone$remarks)
  if (!"bodies" %in% terms) return(overall)
  if (endless) {
    return(all_outcomes(overall, outcome(remarks = paste(
      "A cell of the planned contrast holds one end of the scale only, so the mixed model gives it",
      "overall alone."))))
  }
  both <- fit(c(terms, "scheduling:bodies"), "mixed model of the contrast by number of bodies")
  if (!is.null(both$failure)) return(all_outcomes(overall, outcome(remarks = both$remarks)))
  bodies <- levels(two$bodies)
  apart <- lapply(bodies, function(place) {
    beside <- if (place != bodies[1]) paste0(coefficient, ":bodies", place)
    row(both, c(coefficient, beside), place)
  })
  all_outcomes(overall, outcome(do.call(rbind, apart), both$remarks))
}

# c(estimate, error) of the sum of the named coefficients.
sum_of_coefficients <- function(beta, covariance, names) {
  c(estimate = sum(beta[names]), error = sqrt(sum(covariance[names, names])))
}

# A row for exp(estimate) with its 95 % Wald interval.
ratio_row <- function(family, method, effect, estimate, size_name, trials) {
  z <- estimate[["estimate"]] / estimate[["error"]]
  limits <- estimate[["estimate"]] + c(-1, 1) * stats::qnorm(0.975) * estimate[["error"]]
  test_row(family, method, effect, "z", z, NA, p = 2 * stats::pnorm(-abs(z)),
    size_name = size_name, size = exp(estimate[["estimate"]]), interval = exp(limits),
    interval_level = 0.95, participants = participant_count(trials), trials = nrow(trials))
}

# Paired t tests and equivalence tests of participants' mean ratings, as an outcome. `margin`: in
# rating points.
contrast_means_tests <- function(trials, margin, pair = kTrackedRandom) {
  differences <- contrast_differences(trials, pair = pair)
  outcomes <- lapply(colnames(differences), function(place) {
    known <- differences[!is.na(differences[, place]), place]
    remark <- left_out_remark(paste("the paired tests of", contrast_label(place, pair)),
      nrow(differences) - length(known))
    all_outcomes(
      outcome(remarks = remark),
      paired_test(known, family_of(kContrastMeansFamily, pair), contrast_label(place, pair),
        "difference in rating points"),
      if (length(known) > 1) equivalence_test(known, contrast_label(place, pair), margin,
        family_of(kEquivalenceFamily, pair))
    )
  })
  do.call(all_outcomes, outcomes)
}

# A paired t test of participants' differences, with their mean's 95 % interval; none for fewer than
# two participants.
paired_test <- function(differences, family, effect, size_name) {
  n <- length(differences)
  if (n < 2) return(outcome())
  if (stats::sd(differences) < 1e-9) {  # means of counts and small numbers: below is rounding
    return(outcome(remarks = sprintf("No t test of %s: the differences do not vary.", effect)))
  }
  interval <- t_interval(differences)
  t <- mean(differences) / (stats::sd(differences) / sqrt(n))
  outcome(test_row(family, "paired t test of participants' means", effect, "t", t, n - 1,
    p = 2 * stats::pt(-abs(t), n - 1), size_name = size_name, size = mean(differences),
    interval = interval[c("low", "high")], interval_level = 0.95, participants = n))
}
