# Every test of a rating study: which families there are, and when no test is made.
#
#   primary  mixed model, effects            beside it  repeated-measures ANOVA
#            mixed model, odds ratios                   Friedman
#            equivalence                                pooled ANOVA, as in the thesis
#
# All but the last are those of the study's report, made alike, so that both print the same numbers.
# SPDX-License-Identifier: MIT

# Tests of `main`, the ordered factor of interest, and of the `others`, all columns of `trials`;
# `interactions`: those of main with each other one are tested in a mixed model too. `margin`: of equivalence, in rating points.
# With one participant, or ratings that never vary, there is no test and a remark says so.
rating_tests <- function(trials, main, others, interactions = FALSE,
                         margin = kEquivalenceMargin) {
  none <- why_no_test(trials)
  if (!is.null(none)) return(combine_outcomes(outcome(remarks = none)))
  factors <- varying_factors(trials, c(main, others))
  constant <- setdiff(c(main, others), factors)
  others <- intersect(others, factors)
  main <- intersect(main, factors)
  if (length(factors) == 0) return(combine_outcomes(constant_remarks(constant)))
  pairs <- if (interactions && length(main) == 1) sprintf("%s:%s", main, others)
  models <- rating_factor_tests(trials, factors, interactions = pairs)
  say_progress(kMeansStep)
  combine_outcomes(
    constant_remarks(constant), models, repeated_measures_tests(trials, factors),
    friedman_tests(trials, factors), equivalence_tests(trials, factors, margin),
    if (length(main) > 0) pooled_tests(trials, main, by = utils::head(others, 1))
  )
}

why_no_test <- function(trials) {
  if (participant_count(trials) < 2) {
    return("One participant: the figure and the means describe; no inferential test was made.")
  }
  if (length(unique(trials$rating)) > 1) return(NULL)
  sprintf("Every rating was %d: nothing varies, so no test was made.", as.integer(trials$rating[1]))
}

constant_remarks <- function(factors) {
  if (length(factors) == 0) return(outcome())
  outcome(remarks = sprintf("%s has one level in these trials and is not tested.", factors))
}
