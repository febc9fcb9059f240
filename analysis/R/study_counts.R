# What the analysis rests on, in sentences: people, exclusions, timing, protocols.
# SPDX-License-Identifier: MIT

# A vector of sentences, each about one thing a reader must know before the results.
study_sentences <- function(study) {
  c(
    if (study$all_simulated) paste("SIMULATED: every participant is simulated; these results",
      "describe an observer model, not people."),
    participants_sentence(study), exclusions_sentence(study), catch_sentence(study),
    hashes_sentence(study), timing_sentences(study$trials),
    if (!is.null(study$scale)) delay_sentence(study$trials, study$factors), study$depths
  )
}

participants_sentence <- function(study) {
  noun <- answer_noun(study)
  per <- table(study$trials$participant)
  left_out <- c(study$excluded$participant,
    study$exclusions$participant[is.na(study$exclusions$trial)])
  enrolled <- study$enrolments[!study$enrolments$participant %in% left_out, ]
  unfinished <- enrolled$completed_trials < enrolled$planned_trials | is.na(enrolled$finished_utc)
  incomplete <- people_in(enrolled[unfinished & enrolled$participant %in% names(per), ])
  waiting <- length(setdiff(enrolled$participant, names(per)))
  paste0(
    sprintf("%s, %s in the main phase (%s each).", count_of(length(per), "participant"),
      count_of(sum(per), noun), paste(unique(range(per)), collapse = " to ")),
    if (incomplete > 0) sprintf(" The study is in progress: %s included with the %ss given so far.",
      if (incomplete == 1) "1 participant has not finished and is" else
        paste(incomplete, "participants have not finished and are"), noun),
    if (waiting > 0) sprintf(" %s enrolled, without %ss.", count_of(waiting, "more participant"),
      noun))
}

exclusions_sentence <- function(study) {
  columns <- c("participant", "trials", "reason")
  left_out <- rbind(study$excluded[columns], study$exclusions[columns])
  if (nrow(left_out) == 0) return(sprintf("No %s was excluded.", answer_noun(study)))
  sprintf("Left out: %s of %s (%s).", count_of(sum(left_out$trials), answer_noun(study)),
    count_of(people_in(left_out), "participant"),
    paste(as_typed(unique(left_out$reason)), collapse = "; "))
}

catch_sentence <- function(study) {
  if (nrow(study$catch) == 0) return(character())
  sprintf("%s are reported apart and are in no test.", count_of(nrow(study$catch), "catch trial"))
}

# What a participant gives in a trial of this study: a rating or an answer.
answer_noun <- function(study) if (is.null(study$scale)) "answer" else "rating"

hashes_sentence <- function(study) {
  if (length(study$hashes) == 1) return(character())
  sprintf("%d versions of protocol '%s' (different hashes) are pooled here.",
    length(study$hashes), study$protocol)
}

# Late frames and overridden tests of the display.
timing_sentences <- function(trials) {
  late <- sum(trials$late_timed_frames)
  overridden <- trials[trials$sync_overridden == 1, ]
  c(
    if (late == 0) "No timed frame was late." else sprintf("Late timed frames: %s of %s, in %s.",
      format(late, big.mark = ","), format(sum(trials$timed_frames), big.mark = ","),
      count_of(sum(trials$late_timed_frames > 0), "trial")),
    if (nrow(overridden) == 0) "The sync test was not overridden." else
      sprintf("The sync test was overridden for %s (%s), which are included.",
        count_of(participant_count(overridden), "participant"), count_of(nrow(overridden), "trial"))
  )
}

# Only for studies with a factor delay: did the display show what was asked?
delay_sentence <- function(trials, factors) {
  if (!"delay" %in% names(factors)) return(character())
  intended_ms <- as.numeric(as.character(trials[[factors[["delay"]]]]))
  off_ms <- abs(trials$realised_hold_ms - intended_ms)
  # A frame is no shorter than 2 ms; less than .05 ms is the rounding of 1/60 s.
  if (all(off_ms < 0.05)) return("Every freeze lasted as many frames as its intended delay.")
  sprintf(paste(
    "The analysis uses the intended delay; the freeze realised on the display's frames differs",
    "from it in %s, by up to %.1f ms."
  ), count_of(sum(off_ms >= 0.05), "trial"), max(off_ms))
}
