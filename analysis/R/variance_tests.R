# Tests of mean ratings: repeated-measures ANOVA, Friedman, and the thesis's pooled ANOVA.
# SPDX-License-Identifier: MIT

kAnovaFamily <- "repeated-measures ANOVA"
kPooledFamily <- "pooled ANOVA, as in the thesis"
kFriedmanFamily <- "Friedman"

# Repeated-measures ANOVA of participants' cell means, Greenhouse–Geisser corrected, with
# generalised eta squared (Olejnik and Algina 2003). Participants with an empty cell are left out,
# and counted. The correction needs more participants than an effect has degrees of freedom; an
# effect without it is labelled so.
repeated_measures_tests <- function(trials, factors) {
  trials[factors] <- lapply(trials[factors], droplevels)
  means <- participant_means(trials, factors)
  complete <- complete_participants(means)
  remarks <- left_out_remark("the repeated-measures ANOVA", nrow(means) - nrow(complete))
  if (nrow(complete) < 2) {
    return(outcome(remarks = paste(
      "Fewer than two participants have a rating in every cell of the design, so there is no",
      "repeated-measures ANOVA."
    )))
  }
  kept <- trials[trials$participant %in% rownames(complete), c("participant", "rating", factors)]
  fit <- listen_to(fit_anova(kept, factors))$value
  if (is.null(fit) || any(!is.finite(fit$F))) {
    return(outcome(remarks = c(remarks, paste(
      "The repeated-measures ANOVA has no variance left within participants to test against, or",
      "too few participants for its interactions, and is not reported."
    ))))
  }
  fit$corrected <- nrow(complete) > fit$whole_df
  if (!all(fit$corrected)) {
    remarks <- c(remarks, sprintf(
      "Greenhouse–Geisser's correction needs more than %d participants for %s: p is uncorrected.",
      nrow(complete), paste(fit$effect[!fit$corrected], collapse = ", ")))
  }
  rows <- do.call(rbind, lapply(seq_len(nrow(fit)), function(i) anova_row(fit[i, ], kept)))
  outcome(rows, remarks)
}

# One row per effect: effect, F, corrected df1 and df2, whole_df, p, ges, and sums of squares.
# `between`: factors of which each participant has one level.
fit_anova <- function(trials, factors, between = NULL) {
  model <- afex::aov_ez("participant", "rating", trials,
    within = unname(factors), between = between, fun_aggregate = mean,
    anova_table = list(es = "ges", correction = "GG"), include_aov = FALSE
  )
  table <- model$anova_table
  squares <- summary(model$Anova)$univariate.tests
  squares <- squares[match(rownames(table), rownames(squares)), , drop = FALSE]
  data.frame(
    effect = rownames(table), df1 = table[["num Df"]], df2 = table[["den Df"]],
    whole_df = squares[, "num Df"], F = table[["F"]], p = table[["Pr(>F)"]],
    ges = table[["ges"]], ss = squares[, "Sum Sq"], ss_error = squares[, "Error SS"]
  )
}

anova_row <- function(effect, trials) {
  partial <- eta_squared_interval(effect$F, effect$df1, effect$df2)
  # Generalised eta squared is SS / (SS + the error of every stratum). The interval's SS follows
  # from the partial one; the errors are held at their estimates.
  error <- effect$ss / effect$ges - effect$ss
  if (!is.finite(error)) error <- effect$ss_error
  limits <- effect$ss_error * partial / (1 - partial)
  method <- paste("ANOVA of participants' cell means,",
    if (effect$corrected) "Greenhouse–Geisser" else "uncorrected")
  test_row(kAnovaFamily, method, effect$effect, "F", effect$F, effect$df1, effect$df2,
    effect$p, "generalised eta squared", effect$ges, limits / (limits + error), 0.90,
    participant_count(trials), nrow(trials))
}

# Single-factor ANOVA over all trials as if they were independent, which they are not: the thesis's
# own analysis of the column `of`, overall and at each level of `by`. For comparison only.
pooled_tests <- function(trials, factor, by = character(), of = "rating", family = kPooledFamily) {
  parts <- list(trials)
  labels <- factor
  if (length(by) == 1) {
    parts <- c(parts, split(trials, droplevels(trials[[by]])))
    labels <- c(factor, paste0(factor, " at ", by, " ", levels(droplevels(trials[[by]]))))
  }
  outcomes <- Map(pooled_test, parts, labels, factor, of, family)
  outcome(
    do.call(rbind, lapply(outcomes, `[[`, "rows")),
    unlist(lapply(outcomes, `[[`, "remarks"), use.names = FALSE)
  )
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
friedman_tests <- function(trials, factors) {
  outcomes <- lapply(factors, function(factor) {
    means <- participant_means(trials, factor)
    complete <- complete_participants(means)
    remarks <- left_out_remark(paste("Friedman's test of", factor), nrow(means) - nrow(complete))
    if (nrow(complete) < 2) return(outcome(remarks = remarks))
    test <- stats::friedman.test(complete)
    if (!is.finite(test$statistic)) {
      return(outcome(remarks = paste0("No Friedman test of ", factor, ": every rank is tied.")))
    }
    outcome(test_row(kFriedmanFamily, "Friedman's rank test of participants' means", factor,
      "chi-squared", test$statistic[[1]], test$parameter[[1]], p = test$p.value,
      size_name = "Kendall's W", size = kendall_w(complete),
      interval = bootstrap_interval(ranks_and_ties(complete), agreement), interval_level = 0.95,
      participants = nrow(complete), trials = nrow(trials)), remarks)
  })
  outcome(do.call(rbind, lapply(outcomes, `[[`, "rows")), unlist(lapply(outcomes, `[[`, "remarks")))
}

# Agreement of the participants' rankings, from 0 to 1: chi-squared / (n (k - 1)), ties corrected.
kendall_w <- function(means) agreement(ranks_and_ties(means))

# One row per participant: the ranks and, last, the correction for ties. A bootstrap draws these rows,
# so that nobody is ranked twice.
ranks_and_ties <- function(means) {
  t(apply(means, 1, function(row) {
    tied <- table(row)
    c(rank(row), sum(tied^3 - tied))
  }))
}

agreement <- function(ranked) {
  n <- nrow(ranked)
  k <- ncol(ranked) - 1
  sums <- colSums(ranked)
  12 * sum((sums[-(k + 1)] - n * (k + 1) / 2)^2) / (n^2 * (k^3 - k) - n * sums[[k + 1]])
}

left_out_remark <- function(test, count) {
  if (count == 0) return(character())
  sprintf("%d participant%s without a rating in every cell %s left out of %s.",
    count, if (count == 1) "" else "s", if (count == 1) "is" else "are", test)
}
