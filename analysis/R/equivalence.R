# Equivalence: are mean ratings at two levels closer than a margin that matters?
#
# Two one-sided t tests on the participants' differences (Schuirmann 1987; Lakens 2017): p is the
# larger of the two, and p < .05 just when the 90 % interval lies inside the margin. A p > .05 of an
# ordinary test says nothing of the kind.
# SPDX-License-Identifier: MIT

kEquivalenceFamily <- "equivalence"
kEquivalenceMargin <- 0.15  # rating points, of a scale from 1 to 3

# The margin that is the same share of this scale: ±.30 points from 1 to 5.
equivalence_margin <- function(scale) {
  kEquivalenceMargin * (scale$rating_maximum - scale$rating_minimum) / 2
}

# Every pair of levels of every factor, as an outcome. The unit is the participant.
equivalence_tests <- function(trials, factors, margin = kEquivalenceMargin) {
  outcomes <- lapply(factors, function(factor) {
    means <- participant_means(trials, factor)
    complete <- complete_participants(means)
    remarks <- left_out_remark(paste("the equivalence tests of", factor),
      nrow(means) - nrow(complete))
    pairs <- utils::combn(colnames(complete), 2, simplify = FALSE)
    tests <- lapply(pairs, function(pair) {
      equivalence_test(complete[, pair[2]] - complete[, pair[1]],
        sprintf("%s: %s against %s", factor, pair[2], pair[1]), margin)
    })
    outcome(do.call(rbind, lapply(tests, `[[`, "rows")),
      c(remarks, unlist(lapply(tests, `[[`, "remarks"))))
  })
  outcome(do.call(rbind, lapply(outcomes, `[[`, "rows")), unlist(lapply(outcomes, `[[`, "remarks")))
}

# One test of participants' differences, in rating points.
equivalence_test <- function(differences, label, margin, family = kEquivalenceFamily) {
  n <- length(differences)
  # Means of small whole numbers: a spread below 1e-9 is rounding.
  if (n < 2 || stats::sd(differences) < 1e-9) {
    return(outcome(remarks = paste0("No equivalence test of ", label, ": ",
      if (n < 2) "fewer than two participants." else "the differences do not vary.")))
  }
  error <- stats::sd(differences) / sqrt(n)
  above_lower <- (mean(differences) + margin) / error
  below_upper <- (mean(differences) - margin) / error
  p_lower <- stats::pt(above_lower, n - 1, lower.tail = FALSE)
  p_upper <- stats::pt(below_upper, n - 1)
  interval <- t_interval(differences, 0.90)
  method <- sprintf("two one-sided t tests, margin ±%.2f", margin)
  outcome(test_row(family, method, label, "t",
    if (p_lower > p_upper) above_lower else below_upper, n - 1, p = max(p_lower, p_upper),
    size_name = "difference in rating points", size = mean(differences),
    interval = interval[c("low", "high")], interval_level = 0.90, participants = n))
}
