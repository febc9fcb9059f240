# What a protocol asked of its participants, found in the views alone: any protocol, any factors.
#
#   rated_trial ─────────────────────────────> a part "rating"      ordinal
#   trial_response: yes_no, two_interval ─┬──> "answer"             binary, of levels that the plan set
#                                         ├──> the same of whether yes or no was right, where no
#                                         │    single factor says which of the two is
#                                         └──> "threshold"          a level chosen trial by trial, or
#                                                                   four numbers or more
#   trial_response: choice ──────────────────> "answer"             binary, each option against the rest,
#                                                                   and whether it was right
#   trial_response: slider ──────────────────> "mark"               a number on a line, by question
#   click_trial ─────────────────────────┬───> "clicks"             counts in a time
#                                        └───> "press"              when the first came, where it ended
#                                                                   the stimulus
#   a study of kinds of scheduling ──────────> "scheduling"         their pairs (scheduling_part.R)
#
# A part is a study as read_trials gives it, with `response`, `factors` (every factor of the design
# that varies, in columns of `trials`) and `noun`. Where a part cannot be read its `why` says it.
# SPDX-License-Identifier: MIT

kFewestThresholdLevels <- 4
kFewestFunctionTrials <- 40  # of a participant in a condition, of levels that the plan set
# Columns that models make themselves.
kTakenColumns <- c("slope", "x", "condition_of", "centred", "log10_gap", "cell",
  "mean", "low", "high", "positive")

# Every part of a protocol that has answers in the main phase, and list(why) of those refused.
parts_of_protocol <- function(path, protocol) {
  answers <- rows_of_view(path, "trial_response", protocol)
  kinds <- unique(answers$kind[answers$phase == "main" & answers$kind %in% kThresholdKinds])
  ratings <- rows_of_view(path, "rated_trial", protocol)
  clicks <- rows_of_view(path, "click_trial", protocol)
  study <- study_description(protocol)
  parts <- c(
    if (any(ratings$phase == "main")) list(read_part(rating_part(path, protocol))),
    unlist(lapply(kinds, answer_parts, path = path, protocol = protocol), recursive = FALSE),
    choice_parts(path, protocol, answers),
    lapply(mark_questions(answers), function(question) {
      read_part(mark_part(path, protocol, question))
    }),
    if (any(clicks$phase == "main")) {
      ends <- !is.null(clicks$first_ends) && all(clicks$first_ends == 1)  # data of before say nothing
      list(read_part(if (ends) press_part(path, protocol) else
        click_part(path, protocol)))
    },
    if (identical(study$kind, "scheduling") && any(ratings$phase == "main"))
      list(read_part(scheduling_part(path, study))))
  lapply(Filter(Negate(is.null), parts), as_described)
}

# A refusal becomes list(why), for the page to say.
read_part <- function(part) {
  tryCatch(part, refusal = function(condition) list(why = conditionMessage(condition)))
}

# The main trials of one response as a part; `more(part)` adds what only this response has.
read_response <- function(response, path, protocol, view, what, more, where = "1") {
  part <- more(read_trials(path, protocol, view, what, where = where))
  part$response <- response
  with_factors_that_vary(keep_people_apart(with_every_factor(part)))
}

rating_part <- function(path, protocol) {
  read_response("rating", path, protocol, "rated_trial", "rated main trials",
    function(part) c(part, list(scale = one_scale(part))))
}

# The questions that were answered by a mark on a line in the main phase.
mark_questions <- function(answers) {
  unique(answers$question[answers$phase == "main" & answers$kind == "slider" & answers$answer != ""])
}

# Marks of one question: each has a line of its own.
mark_part <- function(path, protocol, question) {
  where <- sprintf("kind = 'slider' AND answer <> '' AND question = '%s'",
    gsub("'", "''", question, fixed = TRUE))
  read_response("mark", path, protocol, "trial_response", "main trials with a mark", function(part) {
    part$trials$mark <- as.numeric(part$trials$answer)
    part$line <- vapply(c("minimum", "maximum"), function(end) {
      as.numeric(sub(sprintf(".*\"%s\": *(-?[0-9.]+).*", end), "\\1", part$trials$detail[1]))
    }, 0)
    part$question <- question
    part$kind <- paste("mark", match(question, mark_questions(rows_of_view(path, "trial_response",
      protocol))))
    part
  }, where)
}

# Answers of one kind: whether they were right, where that is a question of its own; they themselves
# by condition, where the plan set it; and thresholds, where there are levels for them.
answer_parts <- function(path, protocol, kind) {
  part <- read_part(answer_part(path, protocol, kind))
  if (!is.null(part$why)) return(list(part))
  thresholds <- if (!is.null(threshold_factor(part))) read_part(why_no_function(threshold_part(part)))
  c(right_parts(part), if (is.null(thresholds) || !is_tracked(part)) list(part), list(thresholds))
}

answer_part <- function(path, protocol, kind) {
  read_response("answer", path, protocol, "trial_response", "answered main trials",
    function(part) c(part, list(kind = kind)), answered_where(kind))
}

# The part of whether answers were right; none where nothing is right, or where the answers by one
# factor tell it already.
right_parts <- function(part) {
  trials <- part$trials
  if (part$kind != "yes_no" || anyNA(trials$correct) || is_tracked(part)) return(list())
  yes_is_right <- trials$positive == trials$correct
  decides <- vapply(c(unname(part$factors), part$constant), function(f) {
    all(tapply(yes_is_right, droplevels(trials[[f]]), function(x) length(unique(x))) == 1)
  }, NA)
  if (any(decides)) return(list())
  part$trials$positive <- trials$correct
  part$kind <- "right"
  list(part)
}

# Choices among several options: whether they were right, where that is known, and each option that
# was ever chosen against the rest.
choice_parts <- function(path, protocol, answers) {
  chosen <- answers$answer[answers$phase == "main" & answers$kind == "choice" & answers$timed_out == 0]
  if (length(chosen) == 0) return(list())
  read <- read_part(read_response("answer", path, protocol, "trial_response", "answered main trials",
    function(part) {
      part$choices <- as.integer(sub(".*\"options\": *([0-9]+).*", "\\1", part$trials$detail[1]))
      part
    }, "kind = 'choice' AND timed_out = 0"))
  if (!is.null(read$why)) return(list(read))
  right <- if (!anyNA(read$trials$correct)) list(counting(read, "right choice", read$trials$correct))
  c(right, lapply(sort(unique(chosen)), function(option) {
    part <- counting(read, paste("choice", option), as.integer(read$trials$answer == option))
    part$option <- option
    part
  }))
}

# The part where such answers count.
counting <- function(part, kind, positive) {
  part$kind <- kind
  part$trials$positive <- positive
  part
}

# Were levels chosen trial by trial?
is_tracked <- function(part) any(!is.na(part$trials$track))

# Answers as thresholds of the factor that threshold_factor() finds.
threshold_part <- function(part) {
  axis <- threshold_factor(part)
  part$response <- "threshold"
  part$factors <- c(level = axis, stats::setNames(nm = setdiff(part$factors, axis)))
  levels <- as.numeric(as.character(part$trials[[axis]]))
  study <- study_description(part$protocol)
  if (identical(study$kind, "thresholds")) part$study <- study
  part$log10 <- if (!is.null(part$study)) study$log10 else
    all(levels > 0) && max(levels) >= 10 * min(levels)
  with_scale_and_condition(part, realised_hold = if (!is.null(part$study)) study$realised_hold else
    is_realised_hold(part$trials, axis, levels))
}

# The part itself or, where a usual participant has too few trials in a condition for a function,
# list(why). Whoever describes a study of thresholds wants what there is.
why_no_function <- function(part) {
  if (is_tracked(part) || !is.null(part$study)) return(part)
  each <- table(part$trials$participant, part$trials$condition_of)
  usual <- stats::median(each[each > 0])
  if (usual >= kFewestFunctionTrials) return(part)
  list(why = sprintf(paste("No participant has a threshold yet. A threshold of %s needs %d trials or",
    "more of each participant in each condition of the other factors; there are %g."),
    name_and_unit(part$axis), kFewestFunctionTrials, usual))
}

# The factor whose levels make a threshold: the one that tracks choose, or numbers of four levels or
# more (the factor with the most); NULL where there is none.
threshold_factor <- function(part) {
  trials <- part$trials
  numbers <- part$factors[vapply(part$factors, function(f) is_number(trials[[f]]), NA)]
  tracked <- trials[!is.na(trials$track), ]
  if (nrow(tracked) > 0) {
    within <- vapply(numbers, function(f) {
      each <- tapply(as.character(tracked[[f]]), paste(tracked$participant, tracked$track),
        function(x) length(unique(x)))
      mean(each > 1)
    }, 0)
    if (any(within > 0)) return(unname(numbers[which.max(within)]))
  }
  counts <- vapply(numbers, function(f) nlevels(droplevels(trials[[f]])), 0L)
  if (length(counts) == 0 || max(counts) < kFewestThresholdLevels) return(NULL)
  unname(numbers[which.max(counts)])
}

is_number <- function(factor) !anyNA(suppressWarnings(as.numeric(levels(droplevels(factor)))))

# Is this factor the freeze, whose realised value is recorded? Whole frames are no more than 20 ms off.
is_realised_hold <- function(trials, axis, levels) {
  hold <- trials$realised_hold_ms
  endsWith(axis, "_ms") && !anyNA(hold) && any(hold > 0) && all(abs(hold - levels) < 20)
}

# Trials with clicks, of which the rate is that of the exposure.
click_part <- function(path, protocol) {
  read_response("clicks", path, protocol, "clicked_trial", "main trials with clicks", function(part) {
    part$trials <- trials_with_exposure(part$trials)
    if (nrow(part$trials) == 0) {
      refuse(part$file, ": expected frames of the trials with clicks, got none, so how long one",
        " could click is not known and clicks are not analysed")
    }
    part$trials$click_rate <- part$trials$clicks / part$trials$exposure_s
    part
  })
}

# Trials that a click ended, and when it came; part$unclicked: those that ended without one.
press_part <- function(path, protocol) {
  part <- keep_people_apart(with_every_factor(read_trials(path, protocol, "clicked_trial",
    "main trials with a click")))
  part$trials$press_s <- part$trials$first_click_s
  clicked <- !is.na(part$trials$press_s)
  if (!any(clicked)) {
    refuse_without_answers(part$file, ": expected main trials with a click of '", protocol,
      "', got none yet")
  }
  part$unclicked <- part$trials[!clicked, ]
  part$trials <- part$trials[clicked, ]
  part$response <- "press"
  with_factors_that_vary(part)
}

# Is this response analysed by participants' means alone?
is_by_means <- function(part) part$response %in% c("mark", "press")

# A column for each factor of any main trial, under its own name or, where that is taken,
# factor_NAME: R factors with their levels in rising order.
with_every_factor <- function(part) {
  mine <- part$levels[part$levels$trial %in% part$trials$trial, ]
  names <- unique(mine$factor)
  names <- c(intersect(names(getOption("impetus.levels")), names),
    setdiff(names, names(getOption("impetus.levels"))))
  if (length(names) == 0) refuse(part$file, ": expected a design with factors, got none")
  taken <- names %in% c(names(part$trials), kTakenColumns)
  part$factors <- stats::setNames(ifelse(taken, paste0("factor_", names), names), names)
  for (name in names) {
    column <- part$factors[[name]]
    part$trials[[column]] <- factor_of_trials(part$trials, mine, column, name, part$file)
  }
  part
}

# part$factors: the columns of those that vary, named by themselves; part$constant: of the others.
with_factors_that_vary <- function(part) {
  columns <- unname(part$factors)
  part$trials[columns] <- lapply(part$trials[columns], droplevels)
  vary <- varying_factors(part$trials, columns)
  part$constant <- setdiff(columns, vary)
  part$factors <- stats::setNames(nm = vary)
  part
}

# The title of a part's section.
title_of_part <- function(part) {
  switch(part$response, rating = "Ratings", clicks = "Clicks", scheduling = "Kinds of scheduling",
    distribution = "Which collisions come first",
    mark = sprintf("Marks: %s", part$question), press = "Times of the click",
    threshold = sprintf("Thresholds of %s", name_and_unit(part$axis)),
    answer = if (!is.null(part$option)) sprintf("Choices of “%s”", part$option) else
      switch(part$kind, two_interval = "Choices of an interval", right = "Right answers",
        "right choice" = "Right choices", "Answers yes or no"))
}
