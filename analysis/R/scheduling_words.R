# The planned contrast, the clicks and the exposure in words, by the rules of report_words.R.
# SPDX-License-Identifier: MIT

# "overall", "at 5 bodies" of a contrast's label.
place_of <- function(effect) sub("^.*, ", "", effect)

# "overall 1.92, 95 % CI [1.20, 3.05], p = .012, Holm-corrected p = .048; at 5 bodies ..."
estimates_words <- function(rows, format = "%.2f") {
  paste0(place_of(rows$effect), " ", gsub("-", "−", size_words(rows, format), fixed = TRUE),
    ifelse(is.na(rows$p_holm), "", paste0(", ", both_p_words(rows))), collapse = "; ")
}

# What the primary tests of a contrast allow to be said. `better`, `worse`: "rated better" ...;
# `good`: per row, is the pair's first kind the better one?
verdict_words <- function(rows, good, better, worse, pair = kTrackedRandom) {
  found <- !is.na(rows$p_holm) & rows$p_holm < kSignificance
  said <- function(chosen, words) {
    if (any(chosen)) sprintf("%s was %s than %s %s.", sentence_case(pair$of), words,
      pair$against, and_words(place_of(rows$effect[chosen])))
  }
  paste(c(
    said(found & good, better), said(found & !good, worse), if (any(!found)) sprintf(
      "A difference was not detected %s, which is not evidence of its absence.",
      and_words(place_of(rows$effect[!found])))
  ), collapse = " ")
}

# Which of the equivalence tests showed it; `margin`: the margin in words.
equivalence_verdict <- function(rows, margin) {
  if (nrow(rows) == 0) return(character())
  shown <- rows$p_holm < kSignificance
  said <- function(chosen, was) if (any(chosen)) sprintf("Equivalence within %s %s shown %s.",
    margin, was, and_words(place_of(rows$effect[chosen])))
  paste(c(said(shown, "was"), said(!shown, "was not")), collapse = " ")
}

# The contrast of ratings: model, means, equivalence, the thesis's test.
rating_contrast_words <- function(tests, scale, pair = kTrackedRandom) {
  up_is_good <- scale$rating_best == scale$rating_maximum
  rows <- tests_of(tests, family_of(kContrastFamily, pair))
  means <- tests_of(tests, family_of(kContrastMeansFamily, pair))
  c(
    if (nrow(rows) > 0) c(
      sprintf(paste("%s, %s (cumulative-link mixed model of these two kinds, %s; Holm over %s):",
        "odds ratio of a higher rating %s."),
        if (pair$planned) "Planned contrast" else "Beside it", pair_words(pair, " against "),
        contrast_random_words(rows), count_of(nrow(rows), "test"), estimates_words(rows)),
      verdict_words(rows, (rows$effect_size > 1) == up_is_good, "rated better", "rated worse",
        pair)),
    if (nrow(means) > 0) sprintf("%s (%s, paired t tests of participants' means): %s.",
      if (nrow(rows) > 0) "The same in rating points" else
        paste(if (pair$planned) "Planned contrast" else "Beside it, contrast", "in rating points"),
      pair_words(pair), estimates_words(means, "%+.2f")),
    equivalence_verdict(tests_of(tests, family_of(kEquivalenceFamily, pair)),
      sprintf("±%.2f points", equivalence_margin(scale))),
    if (pair$planned) thesis_words(tests, kPooledFamily))
}

# What participants differ in, overall and, where that is another model, at each number of bodies.
contrast_random_words <- function(rows) {
  parts <- unique(vapply(rows$method, random_part, ""))
  paste0(random_words(rows$method[1]),
    if (length(parts) > 1) sprintf(" (at each number of bodies %s)", parts[2]))
}

# The thesis quoted 1 − p of this test as "significance": > 70 %, > 55 % and > 80 % for ratings.
thesis_words <- function(tests, family) {
  rows <- tests_of(tests, family)
  if (nrow(rows) == 0) return(character())
  place <- ifelse(grepl(" at bodies ", rows$effect),
    paste("at", sub("^.* at bodies ", "", rows$effect), "bodies"), kOverall)
  sprintf(paste(
    "As in the thesis, a single-factor ANOVA of tracked against random (treats trials as",
    "independent; uncorrected p): %s."
  ), paste0(place, ", F(", rows$df1, ", ", rows$df2, ") = ", sprintf("%.1f", rows$statistic), ", ",
    p_words(rows$p), collapse = "; "))
}

click_rate_words <- function(trials) {
  known <- trials_with_exposure(trials)
  if (nrow(known) == 0) return("No trial's exposure is known, so there is no rate of clicks.")
  cells <- split(known, droplevels(known$scheduling))
  sprintf("Clicks per 10 s by scheduling (and in all): %s.", paste0(names(cells), ": ",
    sprintf("%.2f (%.0f)", 10 * vapply(cells, rate_of, 0),
      vapply(cells, function(cell) sum(cell$clicks), 0)), collapse = "; "))
}

click_contrast_words <- function(tests, pair = kTrackedRandom) {
  rows <- tests_of(tests, family_of(kClickContrastFamily, pair))
  bootstrap <- tests_of(tests, family_of(kClickBootstrapFamily, pair))
  c(
    if (nrow(rows) > 0) c(
      sprintf("%s of clicks (%s of %s trials, %s; Holm over %s): rate ratio %s %s.",
        if (pair$planned) "Planned contrast" else "Beside it, contrast",
        sub(" mixed model.*$", " mixed model", rows$method[1]), pair_words(pair, " and "),
        contrast_random_words(rows), count_of(nrow(rows), "test"), pair_words(pair, " / "),
        estimates_words(rows)),
      verdict_words(rows, rows$effect_size < 1, "clicked at less often", "clicked at more often",
        pair)),
    if (nrow(bootstrap) > 0) sprintf("Rate ratio of clicks %s by bootstrap over participants: %s.",
      pair_words(pair, " / "), estimates_words(bootstrap)),
    equivalence_verdict(tests_of(tests, family_of(kClickEquivalenceFamily, pair)),
      sprintf("a ratio of %.2f to %.2f", kRateMargin[1], kRateMargin[2])),
    if (pair$planned) thesis_words(tests, kClickPooledFamily))
}

# Did the manipulation work, and did the two kinds differ in more than it?
exposure_words <- function(tests, pair = kTrackedRandom) {
  rows <- tests_of(tests, family_of(kExposureFamily, pair))
  if (nrow(rows) == 0) return(character())
  found <- rows$p_holm < kSignificance
  c(
    if (pair$of == "tracked") manipulation_words(tests, pair), if (any(found)) sprintf(paste(
      "%s differed in exposure too (%s; paired t tests over",
      "participants, Holm over %d): %s. A difference between their ratings or clicks may come from",
      "this as much as from where the good collisions were."),
      sentence_case(pair_words(pair, " and ")), pair_words(pair), nrow(rows),
      differences_words(rows[found, ])) else
      sprintf("Of %d measures of exposure none was found to differ between %s.",
        nrow(rows), pair_words(pair, " and ")),
    if (any(!found)) sprintf(paste("A difference was not detected, which is not evidence of its",
      "absence, in: %s."), differences_words(rows[!found, ])))
}

manipulation_words <- function(tests, pair = kTrackedRandom) {
  row <- tests_of(tests, family_of(kManipulationFamily, pair))
  if (nrow(row) == 0) return("The distance of bad collisions from the gaze is not known.")
  words <- differences_words(row)
  if (row$p_holm < kSignificance && row$effect_size > 0) {
    return(sprintf("Tracking kept bad collisions away from the gaze (%s): %s.",
      pair_words(pair), words))
  }
  sprintf(paste("That tracking kept bad collisions farther from the gaze than %s places did was",
    "not detected: %s."), pair$against, words)
}

differences_words <- function(rows) {
  signed <- function(x) gsub("-", "−", formatC(x, digits = 3, format = "fg", flag = "+#"))
  paste0(rows$effect, " ", signed(rows$effect_size), ", 95 % CI [", signed(rows$interval_low), ", ",
    signed(rows$interval_high), "], ", both_p_words(rows), collapse = "; ")
}

# The primary contrasts again without the trials marked late; nothing when there are none.
sensitivity_words <- function(tests, late, without, pair = kTrackedRandom) {
  if (late == 0) return(character())
  ratings <- tests_of(tests, paste0(family_of(kContrastFamily, pair), without))
  clicks <- tests_of(tests, paste0(family_of(kClickContrastFamily, pair), without))
  what <- c(
    if (nrow(ratings) > 0) sprintf("odds ratio of a higher rating %s", estimates_words(ratings)),
    if (nrow(clicks) > 0) sprintf("for clicks, rate ratio %s", estimates_words(clicks)))
  sprintf("Sensitivity: without the %s marked late, %s: %s.", count_of(late, "trial"),
    pair_words(pair, " against "), if (length(what) == 0) "too few trials are left" else
      paste(what, collapse = "; "))
}
