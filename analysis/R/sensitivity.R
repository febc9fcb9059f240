# Does the result hang on a choice? The same comparison under other choices, all of them shown.
#
#   data:    without late frames, without late gaze, finished participants only, nobody left out
#   link:    the mixed model's logit against probit and complementary log-log
#   windows: clicks matched to collisions within other times (click_matching.R)
#   test:    the thesis's pooled one, over trials
#
# The comparison of a factor is its last level against its first, in participants' means: a
# difference with its 95 % t interval, whatever the response is.
# SPDX-License-Identifier: MIT

# How often the pooled test rejected in 2,000 studies without an effect in which participants
# differed in their slopes (.7 logit): tests/analysis/null_studies.csv.
kPooledNullRate <- 0.4505

# Which trials each choice of data keeps: a named list of data frames. `everything`: the trials with
# those that are excluded.
data_choices <- function(part, everything = NULL) {
  trials <- part$trials
  finished <- part$enrolments$participant[!is.na(part$enrolments$finished_utc)]
  choices <- list("as reported" = trials)
  keep <- function(name, rows) {
    if (sum(rows) < nrow(trials) && any(rows)) choices[[name]] <<- trials[rows, ]
  }
  keep("without trials with late frames", trials$late_timed_frames == 0)
  if (!is.null(trials$gaze_late)) keep("without trials with late gaze", trials$gaze_late %in% 0)
  if (!is.null(trials$gaze_lost_share)) {
    keep("without trials with gaze lost for a quarter or more",
      !(trials$gaze_lost_share %in% NA) & trials$gaze_lost_share < 0.25 |
        all(is.na(trials$gaze_lost_share)))
  }
  keep("without trials of an overridden sync test", trials$sync_overridden == 0)
  keep("participants who have finished", trials$participant %in% finished)
  if (!is.null(everything) && nrow(everything) > nrow(trials)) {
    choices[["with what was excluded"]] <- everything
  }
  choices
}

# One row per factor and choice of data.
data_sensitivity <- function(part, measure, everything = NULL) {
  choices <- data_choices(part, everything)
  rows <- lapply(unname(part$factors), function(factor) {
    ends <- levels(part$trials[[factor]])[c(1, nlevels(part$trials[[factor]]))]
    do.call(rbind, lapply(names(choices), function(name) {
      means <- participant_means(choices[[name]], factor, measure$of)
      difference <- if (all(ends %in% colnames(means))) means[, ends[2]] - means[, ends[1]] else NA
      difference <- difference[!is.na(difference)]
      difference_row(difference, sprintf("%s: %s − %s", label_of(factor), ends[2], ends[1]), name,
        nrow(choices[[name]]))
    }))
  })
  do.call(rbind, rows)
}

difference_row <- function(difference, comparison, choice, trials) {
  n <- length(difference)
  interval <- if (n > 0) t_interval(difference) else c(mean = NA, low = NA, high = NA)
  varies <- n > 1 && stats::sd(difference) > 1e-9
  t <- if (varies) interval[["mean"]] / (stats::sd(difference) / sqrt(n)) else NA
  data.frame(comparison = comparison, choice = choice, participants = n, trials = trials,
    difference = interval[["mean"]], low = interval[["low"]], high = interval[["high"]],
    p = if (varies) 2 * stats::pt(-abs(t), n - 1) else NA)
}

kDataHeads <- c("Comparison", "Choice", "Participants", "Trials", "Difference", "95 % CI, from", "to",
  "p")

# The last against the first level of each factor under other links, by the model as it was fitted:
# coefficients are in units of the link and cannot be compared across links, z can.
link_sensitivity <- function(part, fitted) {
  rows <- lapply(names(fitted$models), function(factor) {
    models <- fitted$models[[factor]]
    if (!is.null(models$failure)) return(NULL)
    trials <- fitted$trials
    trials$slope <- as.numeric(scale(values_of(trials[[factor]])))
    last <- utils::tail(levels(droplevels(trials[[factor]])), 1)
    do.call(rbind, lapply(c("logit", kOtherLinks), function(link) {
      if (link %in% kOtherLinks) say_progress(link_step(factor, link))
      estimate <- link_estimate(part, trials, unname(part$factors), models, link,
        paste0(factor, last))
      data.frame(comparison = sprintf("%s: %s against %s", label_of(factor), last,
        levels(droplevels(trials[[factor]]))[1]), link = link, coefficient = estimate[1],
        error = estimate[2], z = estimate[1] / estimate[2],
        p = 2 * stats::pnorm(-abs(estimate[1] / estimate[2])))
    }))
  })
  do.call(rbind, rows)
}

# c(coefficient, standard error); NA where the model does not converge.
link_estimate <- function(part, trials, factors, models, link, coefficient) {
  if (part$response == "rating") {
    fit <- if (link == "logit") list(model = models$full) else
      fit_rating_model(trials, factors, models$random, link = link)
    if (!is.null(fit$failure)) return(c(NA, NA))
    return(c(fit$model$beta[[coefficient]], sqrt(diag(fit$model$covariance))[[coefficient]]))
  }
  fit <- if (link == "logit") list(model = models$full) else
    fit_answer_model(trials, c(factors, models$random), link)
  if (!is.null(fit$failure)) return(c(NA, NA))
  c(lme4::fixef(fit$model)[[coefficient]],
    sqrt(diag(as.matrix(stats::vcov(fit$model))))[[coefficient]])
}

kOtherLinks <- c("probit", "cloglog")

kLinkHeads <- c("Comparison", "Link", "Coefficient", "Standard error", "z", "p")

# The thesis's test over trials, for comparison alone.
pooled_sensitivity <- function(trials, factors, of) {
  rows <- lapply(factors, function(factor) pooled_tests(trials, factor, of = of)$rows)
  rows <- do.call(rbind, rows)
  if (is.null(rows)) return(NULL)
  data.frame(factor = vapply(rows$effect, label_of, ""), F = rows$statistic, df1 = rows$df1,
    df2 = rows$df2, p = rows$p, row.names = NULL)
}

kPooledHeads <- c("Factor", "F", "df", "df of the error", "p")

pooled_warning <- function() {
  sprintf(paste("A pooled test treats trials as independent, which they are not: where participants",
    "differ in their slopes (standard deviation .7 logit) it rejected in %.0f %% of 2,000 simulated",
    "studies without any effect, instead of 5 %%. It is given for comparison with older work, and",
    "is no evidence; p uncorrected."), 100 * kPooledNullRate)
}
