# Clicks of any protocol against the collisions before them: the click regression and the windows of
# click_detection.R, where a study has collisions resolved at the coarsest level beside finer ones.
# SPDX-License-Identifier: MIT

# list(tests, matching, words); empty for other responses and without both sorts of collisions.
click_events_of <- function(part) {
  if (part$response != "clicks") return(list())
  study <- with_click_times(with_collisions(with_a_kind(part)))
  if (length(unique(study$collisions$bad)) < 2) {
    return(list(words = paste("All collisions were resolved at one sort of level, coarsest or finer,",
      "so clicks are not set against bad and good ones.")))
  }
  click_detection(study)
}

# What click_detection and read_main_phase need: the columns scheduling (whose kinds have baselines
# of their own: the first factor of words, else all trials alike) and bodies.
with_a_kind <- function(part) {
  trials <- part$trials
  words <- Filter(function(f) !is_number(trials[[f]]), unname(part$factors))
  all <- factor(rep("all", nrow(trials)))
  trials$scheduling <- if (length(words) > 0) trials[[words[1]]] else all
  if (is.null(trials$bodies)) trials$bodies <- all
  part$trials <- trials
  part$pairs <- list()
  part
}
