# What the analysis rests on, in sentences: people, exclusions, timing, protocols.
# SPDX-License-Identifier: MIT

# A vector of sentences, each about one thing a reader must know before the results.
study_sentences <- function(study) {
  c(
    simulated_sentence(study), participants_sentence(study), exclusions_sentence(study),
    catch_sentence(study), hashes_sentence(study), late_frames_sentence(study$trials), sync_sentence(study$trials),
    if (!is.null(study$scale)) delay_sentence(study$trials, study$factors), study$depths
  )
}

# "1 rating", "2 ratings"
count_of <- function(count, noun) {
  paste0(format(count, big.mark = ",", trim = TRUE), " ", noun, if (count == 1) "" else "s")
}

simulated_sentence <- function(study) {
  if (!study$all_simulated) return(character())
  paste(
    "SIMULATED: every participant is simulated; these results describe an observer model,",
    "not people."
  )
}

participants_sentence <- function(study) {
  per <- table(study$trials$participant)
  left_out <- c(study$excluded$participant, wholly_excluded(study))
  enrolled <- study$enrolments[!study$enrolments$participant %in% left_out, ]
  unfinished <- enrolled$completed_trials < enrolled$planned_trials | is.na(enrolled$finished_utc)
  started <- enrolled$participant %in% names(per)
  sentence <- sprintf("%s, %s in the main phase (%s each).",
    count_of(length(per), "participant"), count_of(sum(per), answer_noun(study)),
    paste(unique(range(per)), collapse = " to "))
  incomplete <- length(unique(enrolled$participant[unfinished & started]))
  if (incomplete > 0) {
    sentence <- paste(sentence, sprintf(
      "The study is in progress: %s included with the %ss given so far.",
      if (incomplete == 1) "1 participant has not finished and is" else
        paste(incomplete, "participants have not finished and are"), answer_noun(study)
    ))
  }
  waiting <- length(setdiff(enrolled$participant, names(per)))
  if (waiting > 0) {
    sentence <- paste0(sentence, " ", count_of(waiting, "more participant"), " enrolled, without ",
      answer_noun(study), "s.")
  }
  sentence
}

exclusions_sentence <- function(study) {
  decided <- study$exclusions
  left_out <- data.frame(
    participant = c(study$excluded$participant, decided$participant),
    trials = c(study$excluded$trials, decided$trials),
    reason = c(study$excluded$reason, decided$reason)
  )
  if (nrow(left_out) == 0) return(sprintf("No %s was excluded.", answer_noun(study)))
  sprintf("Left out: %s of %s (%s).", count_of(sum(left_out$trials), answer_noun(study)),
    count_of(people_in(left_out), "participant"), paste(as_typed(unique(left_out$reason)), collapse = "; "))
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

late_frames_sentence <- function(trials) {
  late <- sum(trials$late_timed_frames)
  if (late == 0) return("No timed frame was late.")
  sprintf("Late timed frames: %s of %s, in %s.", format(late, big.mark = ","),
    format(sum(trials$timed_frames), big.mark = ","),
    count_of(sum(trials$late_timed_frames > 0), "trial"))
}

sync_sentence <- function(trials) {
  overridden <- trials$sync_overridden == 1
  if (!any(overridden)) return("The sync test was not overridden.")
  sprintf("The sync test was overridden for %s (%s), which are included.",
    count_of(participant_count(trials[overridden, ]), "participant"),
    count_of(sum(overridden), "trial"))
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
