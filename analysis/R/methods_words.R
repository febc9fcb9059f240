# The methods section in words: who, on what, which design, which analysis; versions and references.
# Everything is said from the views, so what nobody recorded is not said.
# SPDX-License-Identifier: MIT

# Sentences of the methods section of a protocol. `parts`: of parts_of_protocol, without refused ones.
methods_sentences <- function(path, protocol, parts) {
  sessions <- rows_of_view(path, "session_provenance", protocol)
  c(people_words(path, protocol), apparatus_words(sessions), device_words(path, sessions),
    unlist(lapply(parts, part_methods)), analysis_words(parts))
}

# Of people, or of simulated participants where they are those who are analysed.
people_words <- function(path, protocol) {
  rows <- rows_of_view(path, "enrolment_summary", protocol)
  if (identical(study_description(protocol)$kind, "distribution")) {
    return(sprintf("Nobody took part: scenes were simulated in %s (protocol '%s').",
      count_of(sum(rows$sessions), "sitting"), protocol))
  }
  all_simulated <- analyses_simulated(path, protocol)
  rows <- rows[rows$simulated == all_simulated, ]
  whole <- query_study(path, "SELECT DISTINCT participant FROM excluded WHERE trial IS NULL")
  out <- sum(rows$participant %in% whole$participant)
  sprintf("%s took part in %s (protocol '%s')%s.", count_of(nrow(rows), who_words(all_simulated)),
    count_of(sum(rows$sessions), "sitting"), protocol, if (out == 0) "" else
      sprintf("; the data of %d were excluded", out))
}

# How bright the screen was, and the mid-grey (128 of 255) that stimuli and pages stand on.
luminance_words <- function(sessions) {
  measured <- sessions[!is.na(sessions$screen_gamma), ]
  if (nrow(measured) == 0) return(NULL)
  black <- measured$screen_black_cd_m2
  white <- measured$screen_white_cd_m2
  ground <- black + (white - black) * (128 / 255)^measured$screen_gamma
  words <- unique(sprintf(
    "from %.3g to %.3g cd/m² (gamma %.3g), that of the ground %.3g cd/m²",
    black, white, measured$screen_gamma, ground))
  unmeasured <- nrow(sessions) - nrow(measured)
  sprintf("The screen's luminance was %s%s.", paste(words, collapse = "; or "),
    if (unmeasured == 0) "" else sprintf("; it was not measured in %s", count_of(unmeasured, "sitting")))
}

# Which sittings ran in a web page, and what no page can know.
page_words <- function(sessions) {
  in_page <- sessions[!is.na(sessions$browser), , drop = FALSE]
  if (nrow(in_page) == 0) return(NULL)
  sprintf(paste("%s ran in a web page (%s) from the same program and gave the same states; a page knows",
    "when a frame begins, not when its light leaves the screen, one to three refreshes later."),
    count_of(nrow(in_page), "sitting"), paste(sort(unique(in_page$browser)), collapse = ", "))
}

# The screens, the refresh, the machines and the program, each said once.
apparatus_words <- function(sessions) {
  if (nrow(sessions) == 0) return("No sitting has begun.")
  each <- function(words) paste(unique(words), collapse = "; or ")
  synced <- sessions$sync_tries > 0 & !is.na(sessions$sync_mean_interval_ms)
  c(
    sprintf("Stimuli were shown by %s on a screen of %s, seen from %s.",
      each(sessions$build), each(sprintf("%.1f × %.1f cm (%d × %d pixels, %.4g Hz)",
        100 * sessions$screen_width_m, 100 * sessions$screen_height_m,
        as.integer(sessions$screen_width_px), as.integer(sessions$screen_height_px),
        sessions$refresh_hz)), each(sprintf("%.4g cm", 100 * sessions$viewing_distance_m))),
    if (any(sessions$screen_measured == 0)) sprintf(
      "Size and distance of the screen were assumed, not measured, in %s.",
      count_of(sum(sessions$screen_measured == 0), "sitting")),
    luminance_words(sessions),
    page_words(sessions),
    sprintf("Machine: %s. Display: %s.", each(sessions$machine), each(sessions$display)),
    if (any(synced)) sprintf(paste("Before a sitting the display's timing was tested: intervals",
      "between flips of %s ms with standard deviations of at most %.3g ms."),
      paste(unique(sprintf("%.2f", range(sessions$sync_mean_interval_ms[synced]))), collapse = " to "),
      max(sessions$sync_sd_interval_ms[synced])),
    if (any(sessions$sync_overridden == 1)) sprintf("The test failed and was overridden in %s.",
      count_of(sum(sessions$sync_overridden), "sitting")))
}

# "delay in ms (0, 100, 300) was varied within participants; keys (f j, j f) was varied between
# participants".
varied_words <- function(part) {
  factors <- unname(part$factors)
  between <- between_factors(part$trials, factors)
  groups <- list(within = setdiff(factors, between), between = between)
  paste(unlist(lapply(names(groups), function(how) {
    each <- vapply(groups[[how]], function(f) {
      sprintf("%s (%s)", name_and_unit(f), levels_words(levels(droplevels(part$trials[[f]])),
        "%d levels from %s to %s"))
    }, "")
    if (length(each) > 0) paste(and_words(unname(each)),
      if (length(each) == 1) "was varied" else "were varied", how, "participants")
  })), collapse = "; ")
}

# The design and the response of one part.
part_methods <- function(part) {
  if (part$response == "distribution") return(NULL)
  trials <- part$trials
  per <- range(table(trials$participant))
  c(
    sprintf("%s: %s, %s of each participant.", title_of_part(part),
      if (length(part$factors) == 0) "no factor varied" else varied_words(part), paste0(paste(unique(per),
        collapse = " to "), " ", answer_noun(part), if (per[2] == 1) "" else "s")),
    switch(part$response,
      rating = c(sprintf("Participants rated from %s.", describe_scale(part$scale)),
        if ("gaps" %in% part$study$shown) paste("Ratings were set against the gap of each trial's first",
          "collision, as measured after the fact, in a cumulative-link mixed model of its own."),
        if ("spin" %in% part$study$shown) paste("So they were against the size of the imposed spin, of",
          "the trials that had one.")),
      mark = sprintf("Participants answered “%s” by a mark on a line from %g to %g.", part$question,
        part$line[1], part$line[2]),
      press = "Participants clicked once in each stimulus, which ended it; its time from onset is analysed.",
      clicks = "Participants clicked during the stimulus whenever they saw what was asked for.",
      threshold = scale_sentence(part),
      scheduling = sprintf("Pairs of kinds compared: %s.", paste(vapply(part$pairs, pair_words, ""),
        collapse = "; ")),
      answer = if (!is.null(part$choices)) sprintf("Participants chose one of %d answers.", part$choices) else
        if (part$kind == "two_interval") "Participants chose one of two intervals." else
          "Participants answered yes or no."))
}

analysis_words <- function(parts) {
  if (length(parts) == 0) return("Nothing was analysed.")
  kinds <- unique(vapply(parts, `[[`, "", "response"))
  people <- unique(unlist(lapply(parts, function(part) as.character(part$trials$participant))))
  tested <- c(gsub("\n", " ", read.dcf(code_file("methods.dcf"))[1, kinds], fixed = TRUE),
    paste0("The unit of every test is the participant",
      if ("clicks" %in% kinds) ", but for a circular shift of clicks", "."),
    paste("Beside each test's own p stands the one corrected after Holm within its family; what is",
      "said to be found rests on the corrected one."),
    "Where one of these could not be made, the results name it and say why.")
  described <- identical(kinds, "distribution")
  c(if (described) tested[1] else if (length(people) > 1) tested else
    if (length(people) == 1)
      "One participant's data are described; no test across participants was made.",
    sprintf("Analyses ran in %s with %s.", R.version.string,
      and_words(package_versions(if (length(people) == 1) character() else kinds))))
}

package_versions <- function(kinds) {
  models <- list(rating = "ordinal", answer = "lme4", threshold = "lme4", clicks = c("glmmTMB", "lme4"),
    scheduling = "ordinal")
  packages <- unique(c(unlist(lapply(setdiff(kinds, "distribution"),
    function(kind) c(models[[kind]], "afex"))), "ggplot2"))
  packages <- packages[vapply(packages, requireNamespace, NA, quietly = TRUE)]
  paste(packages, vapply(packages, function(p) as.character(utils::packageVersion(p)), ""))
}

# What is cited in a report of these parts: references.dcf tells of which analyses each work is,
# and whether (By) of tests alone, which need several participants.
cited_references <- function(parts) {
  kinds <- c("all", vapply(parts, `[[`, "", "response"),
    if (any(vapply(parts, function(part) !is.null(part$study$published), NA))) "published")
  people <- unique(unlist(lapply(parts, function(part) as.character(part$trials$participant))))
  works <- read.dcf(code_file("references.dcf"))
  cited <- vapply(strsplit(works[, "Of"], ", "), function(of) any(of %in% kinds), NA) &
    (length(people) != 1 | is.na(works[, "By"]))
  sort(works[cited, "Reference"])
}
