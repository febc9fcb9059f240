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

# How often the pooled test rejected in 2,000 studies of 20 participants with 81 ratings each, without
# an effect, in which participants differed in their slopes (.7 logit): tests/analysis/null_studies.csv.
kPooledNullRate <- 0.4505

# The tables of a part's sensitivity. `fitted`: its mixed models; `everything`: the trials with those
# that are excluded; `clicked`: of clicked_events.
sensitivity_tables <- function(part, fitted, measure, everything, clicked) {
  if (participant_count(part$trials) < 2 || length(part$factors) == 0) return(list())
  links <- if (!is.null(fitted$models) && part$response != "clicks") link_sensitivity(part, fitted)
  pooled <- each_row(unname(part$factors), function(factor) {
    pooled_rows(part, factor, measure)
  })
  list(
    list(name = "sensitivity-data", title = "Sensitivity: which trials are in",
      heads = c("Comparison", "Choice", "Participants", "Trials", "Difference", "95 % CI, from", "to",
        "p"), rows = data_sensitivity(part, measure, everything),
      note = sprintf(paste("The last against the first level of each factor: paired t tests of",
        "participants' means of %s, p uncorrected."), tolower(measure$title))),
    if (!is.null(links)) list(name = "sensitivity-link", title = "Sensitivity: the link",
      heads = c("Comparison", "Link", "Coefficient", "Standard error", "z", "p"), rows = links,
      note = paste("The same mixed model under other links; compare z, for the unit of a",
        "coefficient is that of its link; p uncorrected. – did not converge.")),
    if (!is.null(clicked$matching)) list(name = "sensitivity-windows",
      title = "Sensitivity: windows in which a click belongs to a collision",
      heads = gsub("_", " ", names(clicked$matching)), rows = clicked$matching,
      note = "Descriptive only: at more than one event a second, windows bias d′ downwards."),
    if (!is.null(pooled)) list(name = "sensitivity-pooled", title = "The pooled test over trials",
      heads = c("Factor", "F", "df", "df of the error", "p"),
      rows = data.frame(factor = pooled$effect, F = pooled$statistic,
        df1 = pooled$df1, df2 = pooled$df2, p = pooled$p, row.names = NULL),
      note = sprintf(paste("A pooled test treats trials as independent, which they are not: of",
        "ratings, 81 of each of 20 participants who differ in their slopes (standard deviation .7",
        "logit), it rejected in %.0f %% of 2,000 simulated studies without any effect, instead of",
        "5 %%. For other numbers and other answers the rate differs, and is not known. It is given",
        "for comparison with older work, and is no evidence; p uncorrected."), 100 * kPooledNullRate)))
}

# The pooled tests of a factor, by its label; of the one that a described study is about also at each
# level of its second, as the thesis has them.
pooled_rows <- function(part, factor, measure) {
  by <- if (identical(factor, factor_called(part, part$study$factors[1])))
    factor_called(part, part$study$factors[2])
  rows <- pooled_tests(part$trials, factor, as.character(by), measure$of)$rows
  if (is.null(rows)) return(NULL)
  at <- substring(rows$effect, nchar(paste(factor, "at", by)) + 2)
  rows$effect <- paste0(label_of(factor), ifelse(at == "", "", sprintf(" at %s: %s",
    name_and_unit(by), at)))
  rows
}

# Which trials each choice of data keeps: a named list of data frames.
data_choices <- function(part, everything = NULL) {
  trials <- part$trials
  finished <- part$enrolments$participant[!is.na(part$enrolments$finished_utc)]
  kept <- list(
    "without trials with late frames" = trials$late_timed_frames == 0,
    "without trials with late gaze" = trials$gaze_late %in% 0,
    "without trials with gaze lost for a quarter or more" =
      trials$gaze_lost_share < 0.25 | all(is.na(trials$gaze_lost_share)),
    "without trials of an overridden sync test" = trials$sync_overridden == 0,
    "participants who have finished" = trials$participant %in% finished)
  # What the response does not know, or what keeps all or nothing, is no choice.
  kept <- Filter(function(rows) any(rows %in% TRUE) && !all(rows %in% TRUE), kept)
  c(list("as reported" = trials), lapply(kept, function(rows) trials[rows %in% TRUE, ]),
    if (NROW(everything) > nrow(trials)) list("with what was excluded" = everything))
}

# One row per factor and choice of data.
data_sensitivity <- function(part, measure, everything = NULL) {
  choices <- data_choices(part, everything)
  # A factor between participants has no differences within them.
  each_row(within_factors(part$trials, unname(part$factors)), function(factor) {
    ends <- levels(part$trials[[factor]])[c(1, nlevels(part$trials[[factor]]))]
    each_row(names(choices), function(name) {
      means <- participant_means(choices[[name]], factor, measure$of)
      difference <- if (all(ends %in% colnames(means))) means[, ends[2]] - means[, ends[1]] else NA
      kept <- rownames(means)[!is.na(difference)]
      difference <- difference[!is.na(difference)]
      interval <- t_interval(difference)
      varies <- length(difference) > 1 && stats::sd(difference) > 1e-9
      data.frame(comparison = sprintf("%s: %s − %s", label_of(factor), ends[2], ends[1]),
        choice = name, participants = length(difference),
        trials = sum(choices[[name]]$participant %in% kept),
        difference = if (length(difference) > 0) round(interval[["mean"]], 12) else NA,
        low = interval[["low"]], high = interval[["high"]],
        p = if (varies) stats::t.test(difference)$p.value else NA)
    })
  })
}

kOtherLinks <- c("probit", "cloglog")

# The last against the first level of each factor under other links, by the model as it was fitted:
# coefficients are in units of the link and cannot be compared across links, z can.
link_sensitivity <- function(part, fitted) {
  factors <- unname(part$factors)
  each_row(names(fitted$models), function(factor) {
    models <- fitted$models[[factor]]
    if (!is.null(models$failure)) return(NULL)
    trials <- fitted$trials
    trials$slope <- slope_values(trials[[factor]])
    last <- utils::tail(levels(trials[[factor]]), 1)
    fit <- if (part$response == "rating") fit_rating_model else fit_answer_model
    each_row(c("logit", kOtherLinks), function(link) {
      if (link %in% kOtherLinks) say_progress(link_step(factor, link))
      model <- if (link == "logit") models$full else
        fit(trials, factors, models$attempt[["random"]], link = link)
      # NA where the model does not converge.
      estimate <- if (is.null(model$failure)) sum_of_coefficients(model, paste0(factor, last)) else
        c(estimate = NA, error = NA)
      z <- estimate[["estimate"]] / estimate[["error"]]
      data.frame(comparison = sprintf("%s: %s against %s", label_of(factor), last,
        levels(trials[[factor]])[1]), link = link, coefficient = estimate[["estimate"]],
        error = estimate[["error"]], z = z, p = 2 * stats::pnorm(-abs(z)))
    })
  })
}

# Mean thresholds under other choices: no lapses; without late frames; one guess rate of 0.
threshold_sensitivity <- function(part) {
  choices <- list("as reported" = part)
  on_time <- part$trials$late_timed_frames == 0
  if (!all(on_time) && any(on_time)) {
    choices[["without trials with late frames"]] <- replace(part, "trials",
      list(part$trials[on_time, ]))
  }
  if (is.null(part$guess)) choices[["guess rate of 0"]] <- replace(part, "guess", 0)
  rows <- each_row(names(choices), function(name) {
    functions <- psychometric_functions(choices[[name]], draws = 0)
    means <- threshold_means(part, functions$rows)
    if (is.null(means)) return(NULL)
    data.frame(condition = means$condition, choice = name, participants = means$participants,
      threshold = means$mean, low = means$low, high = means$high)
  })
  if (is.null(rows)) return(NULL)
  list(name = "sensitivity", title = "Sensitivity: thresholds under other choices",
    heads = c("Condition", "Choice", "Participants", "Mean threshold", "95 % CI, from", "to"),
    rows = rows[order(match(rows$condition, levels(part$trials$condition_of))), ])
}
