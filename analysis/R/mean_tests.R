# Tests of participants' means: repeated-measures ANOVA, Friedman, the thesis's pooled ANOVA, and
# paired and equivalence tests of differences.
# SPDX-License-Identifier: MIT

kAnovaFamily <- "repeated-measures ANOVA"
kEtaIntervalWords <- paste("The interval is of what generalised eta squared tends to with more",
  "participants (from the noncentral F). The estimate runs high where participants are few, and may lie",
  "above the interval.")
kPooledFamily <- "pooled ANOVA, as in the thesis"
kFriedmanFamily <- "Friedman"
kEquivalenceFamily <- "equivalence"
kEquivalenceMargin <- 0.15  # rating points, of a scale from 1 to 3

# ANOVA, Friedman and, where there is a `margin`, equivalence, of participants' means of `rating`.
tests_of_means <- function(trials, factors, noun, margin) {
  say_progress(kMeansStep)
  all_outcomes(repeated_measures_tests(trials, factors, noun), friedman_tests(trials, factors, noun),
    if (!is.null(margin)) equivalence_tests(trials, factors, margin))
}

# `noun`: what a cell has from everybody who is in, such as "a rating".
left_out_remark <- function(test, count, noun = "a rating") {
  if (count == 0) return(character())
  sprintf("%d participant%s without %s in every cell %s left out of %s.",
    count, if (count == 1) "" else "s", noun, if (count == 1) "is" else "are", test)
}

# Repeated-measures ANOVA of participants' cell means, Greenhouse–Geisser corrected, with
# generalised eta squared (Olejnik and Algina 2003). Participants with an empty cell are left out,
# and counted.
repeated_measures_tests <- function(trials, factors, noun = "a rating") {
  trials[factors] <- lapply(trials[factors], droplevels)
  between <- between_factors(trials, factors)
  within <- setdiff(factors, between)
  means <- means_within(trials, within)
  complete <- complete_participants(means)
  if (nrow(complete) < 2) {
    return(outcome(remarks = sprintf(paste("Fewer than two participants have %s in every cell of the",
      "design, so there is no repeated-measures ANOVA."), noun)))
  }
  remarks <- left_out_remark("the repeated-measures ANOVA", nrow(means) - nrow(complete), noun)
  kept <- trials[trials$participant %in% rownames(complete), c("participant", "rating", factors)]
  fit <- listen_to(fit_anova(kept, within, between))$value
  rounding <- 1e-12 * sum(kept$rating^2)  # in a sum of squares
  if (is.null(fit) || any(!is.finite(fit$F) | fit$ss_error <= rounding)) {
    return(outcome(remarks = c(remarks, paste(
      "The repeated-measures ANOVA has no variance left within participants to test against, or",
      "too few participants for its interactions, and is not reported."))))
  }
  outcome(each_row(seq_len(nrow(fit)), function(i) anova_row(fit[i, ], kept)), remarks)
}

# participant_means of these factors; of no factor, each participant's mean of all.
means_within <- function(trials, within) {
  if (length(within) > 0) return(participant_means(trials, within))
  as.matrix(tapply(trials$rating, as.character(trials$participant), mean))
}

# One row per effect: effect, F, df1 and df2 after Greenhouse and Geisser, p, ges, sums of squares;
# within: does it have a factor within participants? independent: participants beyond the groups'
# means. `between`: factors of which each participant has one level.
fit_anova <- function(trials, factors, between = NULL) {
  model <- afex::aov_ez("participant", "rating", trials,
    within = if (length(factors) > 0) unname(factors), between = between, fun_aggregate = mean,
    anova_table = list(es = "ges", correction = "none"), include_aov = FALSE)
  table <- model$anova_table
  effects <- strsplit(rownames(table), ":", fixed = TRUE)
  # Not afex's own epsilon: that is left out where participants are no more than df.
  epsilon <- epsilon_of_effects(trials, effects, factors, between)
  squares <- squares_of(model, length(factors) > 0)
  squares <- squares[match(rownames(table), rownames(squares)), , drop = FALSE]
  groups <- if (length(between) > 0) nrow(unique(trials[between])) else 1
  df1 <- epsilon * table[["num Df"]]
  df2 <- epsilon * table[["den Df"]]
  data.frame(effect = rownames(table), df1 = df1, df2 = df2, F = table[["F"]],
    p = stats::pf(table[["F"]], df1, df2, lower.tail = FALSE), ges = table[["ges"]],
    ss = squares[, "Sum Sq"], ss_error = squares[, "Error SS"],
    within = vapply(effects, function(of) any(of %in% factors), NA),
    independent = participant_count(trials) - groups)
}

# Greenhouse and Geisser's epsilon of each effect, given as the names of its factors; 1 of those
# between participants. A contrast of an effect is a product of contrasts of its factors, over means
# of the other ones.
epsilon_of_effects <- function(trials, effects, factors, between) {
  if (length(factors) == 0) return(rep(1, length(effects)))
  means <- participant_means(trials, factors)
  first <- trials[match(rownames(means), as.character(trials$participant)), between, drop = FALSE]
  groups <- if (length(between) > 0) interaction(first, drop = TRUE) else rep(1, nrow(means))
  vapply(effects, function(effect) {
    if (!any(effect %in% factors)) return(1)
    parts <- lapply(factors, function(factor) {
      count <- nlevels(trials[[factor]])
      if (factor %in% effect) orthonormal_contrasts(count) else matrix(1, count)
    })
    sphericity(means %*% Reduce(kronecker, parts), groups)
  }, 0)
}

orthonormal_contrasts <- function(levels) qr.Q(qr(stats::contr.helmert(levels)))

# Epsilon after Greenhouse and Geisser (1959), from 1 / df to 1: tr(S)^2 / (df tr(S S)), S the
# covariance of orthonormal contrasts (participants by df) within groups. S needs no inverse, so
# there may be fewer participants than contrasts.
sphericity <- function(contrasts, groups = rep(1, nrow(contrasts))) {
  own <- contrasts - apply(contrasts, 2, stats::ave, groups)
  squares <- crossprod(own)
  sum(diag(squares))^2 / (ncol(contrasts) * sum(squares^2))
}

# Sums of squares of a fit's effects and of their errors, and degrees of freedom.
squares_of <- function(model, is_within) {
  if (is_within) return(summary(model$Anova)$univariate.tests)
  table <- model$Anova
  cbind("num Df" = table[["Df"]], "Sum Sq" = table[["Sum Sq"]],
    "Error SS" = table["Residuals", "Sum Sq"]) |> `rownames<-`(rownames(table))
}

# The interval's sum of squares is that of the population's means, from the noncentrality of F:
# lambda times the error's mean square. Beside it stand the errors as estimated, n mean squares for
# each contrast in place of the `independent` ones that residuals have. Lambda has the factor epsilon
# as df2 has it, so it cancels.
anova_row <- function(effect, trials) {
  n <- participant_count(trials)
  error <- effect$ss / effect$ges - effect$ss  # ges is SS / (SS + the error of every stratum)
  if (!is.finite(error)) error <- effect$ss_error
  ss <- noncentrality_limits(effect$F, effect$df1, effect$df2) * effect$ss_error / effect$df2
  method <- paste("ANOVA of participants' cell means,",
    if (effect$within) "Greenhouse–Geisser" else "between participants")
  test_row(kAnovaFamily, method, effect$effect, "F", effect$F, effect$df1, effect$df2,
    effect$p, "generalised eta squared", effect$ges, ss / (ss + error * n / effect$independent), 0.90,
    n, nrow(trials))
}

# p of the effect that the columns of `means` (participants by levels, no NA) have, corrected after
# Greenhouse and Geisser, at a thousandth of the cost of the whole ANOVA; NA where nothing varies.
# With a complete design it is the main effect of the whole factorial one.
greenhouse_geisser_p <- function(means) {
  n <- nrow(means)
  df <- ncol(means) - 1
  contrasts <- means %*% orthonormal_contrasts(ncol(means))
  error <- sum(apply(contrasts, 2, stats::var))
  if (is.na(error) || error < 1e-12) return(NA_real_)
  epsilon <- sphericity(contrasts)
  stats::pf(n * sum(colMeans(contrasts)^2) / error, df * epsilon, df * (n - 1) * epsilon,
    lower.tail = FALSE)
}

# Single-factor ANOVA over all trials as if they were independent, which they are not: the thesis's
# own analysis of the column `of`, overall and at each level of `by`. For comparison only.
pooled_tests <- function(trials, factor, by = character(), of = "rating", family = kPooledFamily) {
  parts <- stats::setNames(list(trials), factor)
  if (length(by) == 1) {
    apart <- split(trials, droplevels(trials[[by]]))
    parts <- c(parts, stats::setNames(apart, paste0(factor, " at ", by, " ", names(apart))))
  }
  do.call(all_outcomes, unname(Map(pooled_test, parts, names(parts), factor, of, family)))
}

pooled_test <- function(trials, label, factor, of, family) {
  table <- listen_to(stats::anova(stats::lm(stats::reformulate(factor, of), trials)))$value
  residual <- if (is.null(table)) 0 else table[["Sum Sq"]][2]
  # lm leaves rounding errors, not zeros, where the ratings do not vary within levels.
  if (is.na(residual) || residual < 1e-9) {
    return(outcome(remarks = paste0("No pooled ANOVA of ", label, ": no variance within levels.")))
  }
  F <- table[["F value"]][1]
  df <- table[["Df"]]
  outcome(test_row(family, "single-factor ANOVA; treats trials as independent", label, "F",
    F, df[1], df[2], table[["Pr(>F)"]][1], "eta squared", table[["Sum Sq"]][1] /
      sum(table[["Sum Sq"]]), eta_squared_interval(F, df[1], df[2]), 0.90,
    participant_count(trials), nrow(trials)))
}

# Friedman's rank test of participants' means for each factor, with Kendall's W.
friedman_tests <- function(trials, factors, noun = "a rating") {
  between <- outcome(remarks = between_remark("No Friedman test", between_factors(trials, factors)))
  do.call(all_outcomes, c(list(between), lapply(within_factors(trials, factors), function(factor) {
    means <- participant_means(trials, factor)
    complete <- complete_participants(means)
    remarks <- left_out_remark(paste("Friedman's test of", factor), nrow(means) - nrow(complete), noun)
    if (nrow(complete) < 2) return(outcome(remarks = remarks))
    test <- stats::friedman.test(complete)
    if (!is.finite(test$statistic)) {
      return(outcome(remarks = paste0("No Friedman test of ", factor, ": every rank is tied.")))
    }
    outcome(test_row(kFriedmanFamily, "Friedman's rank test of participants' means", factor,
      "chi-squared", test$statistic[[1]], test$parameter[[1]], p = test$p.value,
      size_name = "Kendall's W",  # the agreement of rankings, from 0 to 1
      size = test$statistic[[1]] / (nrow(complete) * (ncol(complete) - 1)),
      participants = nrow(complete),
      trials = sum(trials$participant %in% rownames(complete))), remarks)
  })))
}

# A t test of participants' differences, with their mean's 95 % interval; none for fewer than two
# participants.
paired_test <- function(differences, family, effect, size_name,
                        method = "paired t test of participants' means") {
  if (length(differences) < 2) return(outcome())
  differences <- round(differences, 12)  # less is rounding
  if (stats::sd(differences) < 1e-9) {  # means of counts and small numbers: below is rounding
    return(outcome(remarks = sprintf("No t test of %s: the differences do not vary.", effect)))
  }
  test <- stats::t.test(differences)
  outcome(test_row(family, method, effect, "t",
    test$statistic[[1]], test$parameter[[1]], p = test$p.value, size_name = size_name,
    size = mean(differences), interval = test$conf.int, interval_level = 0.95,
    participants = length(differences)))
}

# The margin of equivalence that is the same share of this scale: ±.30 points from 1 to 5.
equivalence_margin <- function(scale) {
  kEquivalenceMargin * (scale$rating_maximum - scale$rating_minimum) / 2
}

# Are mean ratings at two levels closer than a margin that matters? Every pair of levels of every
# factor, as an outcome. The unit is the participant.
equivalence_tests <- function(trials, factors, margin = kEquivalenceMargin) {
  between <- outcome(remarks = between_remark("No equivalence test",
    between_factors(trials, factors)))
  do.call(all_outcomes, c(list(between), lapply(within_factors(trials, factors), function(factor) {
    means <- participant_means(trials, factor)
    complete <- complete_participants(means)
    pairs <- utils::combn(colnames(complete), 2, simplify = FALSE)
    tests <- do.call(all_outcomes, lapply(pairs, function(pair) {
      equivalence_test(complete[, pair[2]] - complete[, pair[1]],
        sprintf("%s: %s against %s", factor, pair[2], pair[1]), margin)
    }))
    all_outcomes(outcome(remarks = left_out_remark(paste("the equivalence tests of", factor),
      nrow(means) - nrow(complete))), tests)
  })))
}

# One test of participants' differences, in rating points.
equivalence_test <- function(differences, label, margin, family = kEquivalenceFamily) {
  n <- length(differences)
  # Means of small whole numbers: a spread below 1e-9 is rounding.
  if (n < 2 || stats::sd(differences) < 1e-9) {
    return(outcome(remarks = paste0("No equivalence test of ", label, ": ",
      if (n < 2) "fewer than two participants." else "the differences do not vary.")))
  }
  tests <- two_one_sided(mean(differences), stats::sd(differences) / sqrt(n), c(-1, 1) * margin,
    n - 1)
  outcome(test_row(family, sprintf("two one-sided t tests, margin ±%.2f", margin), label, "t",
    tests$statistic, n - 1, p = tests$p, size_name = "difference in rating points",
    size = round(mean(differences), 12), interval = tests$interval, interval_level = 0.90,  # less is rounding
    participants = n))
}

# Two one-sided t tests of an estimate against two margins (Schuirmann 1987; Lakens 2017): p is the
# larger of the two, and p < .05 just when the 90 % interval lies inside the margins. A p > .05 of an
# ordinary test says nothing of the kind.
two_one_sided <- function(estimate, error, margins, df = Inf) {
  t <- (estimate - margins) / error
  p <- c(stats::pt(t[1], df, lower.tail = FALSE), stats::pt(t[2], df))
  list(statistic = if (p[1] > p[2]) t[1] else t[2], p = max(p),
    interval = estimate + c(-1, 1) * stats::qt(0.95, df) * error)
}
