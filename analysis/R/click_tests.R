# How often participants clicked: mixed models, rates with intervals by bootstrap over participants,
# which assume no distribution of counts, and the thesis's totals.
# SPDX-License-Identifier: MIT

kClickPooledFamily <- "clicks, pooled ANOVA, as in the thesis"
kClickBootstrapFamily <- "clicks, bootstrap over participants"

trials_with_exposure <- function(trials) {
  trials[!is.na(trials$exposure_s) & trials$exposure_s > 0, ]
}

# One row per kind of scheduling and number of bodies, and per kind alone ("all"): total clicks (the
# thesis's fig. 6.19), clicks per trial, clicks per second with a 95 % interval, clicks per bad event;
# NULL where no exposure is known.
click_table <- function(trials) {
  trials <- trials_with_exposure(trials)
  if (nrow(trials) == 0) return(NULL)
  cells <- c(split(trials, trials[c("bodies", "scheduling")], drop = TRUE),
    split(trials, droplevels(trials$scheduling)))
  rows <- each_row(cells, function(cell) {
    bodies <- unique(as.character(cell$bodies))
    interval <- bootstrap_of_totals(list(cell), function(totals) totals[[1]])
    data.frame(scheduling = cell$scheduling[1], bodies = if (length(bodies) == 1) bodies else "all",
      participants = participant_count(cell), trials = nrow(cell), clicks = sum(cell$clicks),
      clicks_per_trial = mean(cell$clicks), exposure_s = sum(cell$exposure_s),
      clicks_per_s = rate_of(cell), interval_low = interval[["low"]],
      interval_high = interval[["high"]], bad_events_per_trial = mean(cell$bad_events),
      clicks_per_bad_event = if (!isTRUE(sum(cell$bad_events) > 0)) NA_real_ else
        sum(cell$clicks) / sum(cell$bad_events))
  })
  unique(rows)  # a study of one number of bodies has each row twice
}

# Rate ratios of a pair with their 95 % intervals, overall and at each number of bodies, as
# rows without p.
click_bootstrap <- function(trials, pair = kTrackedRandom) {
  two <- contrast_trials(trials_with_exposure(trials), pair)
  if (participant_count(two) < 2) return(outcome())
  ratio <- function(rates) rates[[1]] / rates[[2]]
  places <- c(kOverall, if (nlevels(two$bodies) > 1) levels(two$bodies))
  do.call(all_outcomes, lapply(places, function(place) {
    here <- if (place == kOverall) two else two[two$bodies == place, ]
    label <- contrast_label(place, pair)
    parts <- split(here, here$scheduling)[c(pair$of, pair$against)]
    if (any(vapply(parts, function(part) sum(part$clicks) == 0, NA))) {
      return(outcome(remarks = sprintf("No bootstrap of %s: a kind has no clicks there.", label)))
    }
    outcome(test_row(family_of(kClickBootstrapFamily, pair),
      "expanded-percentile bootstrap over participants, 2000 draws", label, NA, NA, NA, p = NA,
      size_name = "rate ratio", size = ratio(lapply(parts, rate_of)),
      interval = bootstrap_of_totals(parts, ratio), interval_level = 0.95,
      participants = participant_count(here), trials = nrow(here)))
  }))
}

rate_of <- function(trials) sum(trials$clicks) / sum(trials$exposure_s)

# Percentile interval of statistic(rates), where `parts` are sets of trials and rates their clicks
# per second; participants are drawn, with all their trials of every part.
bootstrap_of_totals <- function(parts, statistic) {
  people <- unique(unlist(lapply(parts, function(part) as.character(part$participant))))
  if (length(people) < 2) return(c(low = NA_real_, high = NA_real_))
  totals <- do.call(cbind, lapply(parts, function(part) {
    who <- factor(as.character(part$participant), people)
    cbind(tapply(part$clicks, who, sum, default = 0), tapply(part$exposure_s, who, sum, default = 0))
  }))
  bootstrap_interval(totals, function(drawn) {
    sums <- colSums(drawn)
    statistic(as.list(sums[c(TRUE, FALSE)] / sums[c(FALSE, TRUE)]))
  })
}
