# How far a piece of work has come, on stderr: on a terminal one line that changes, else a line for
# each step.
#
#   expect_steps(c("fitting ..." = 3, "drawing ..." = 1))     the steps to come, and how long each takes
#   say_progress("fitting ...")                               one of them begins
#   end_progress()                                            the terminal's line is emptied
#
# A step that turns out not to be needed is passed over and counts as done. Without steps to come,
# progress is words alone. Of a report the steps that take time are, for ratings, answers and clicks,
# models of each factor, means, other links and figures; for thresholds, functions, the hierarchical
# model and figures. A step's weight is about how many seconds it takes for 50 participants; weights
# grow with the trials.
# SPDX-License-Identifier: MIT

work <- new.env()
work$steps <- numeric()

# `steps`: how long each takes against the others, named by the words with which it begins.
expect_steps <- function(steps) {
  work$steps <- steps
  work$at <- 0
  work$began <- Sys.time()
}

# One step begins; `...`: its words.
say_progress <- function(...) {
  words <- paste0(...)
  at <- work$at + match(words, names(work$steps)[seq_along(work$steps) > work$at])
  if (length(at) == 1 && !is.na(at)) {
    work$at <- at
    words <- paste(words, step_words(work$steps, at, as.numeric(Sys.time() - work$began,
      units = "secs")))
  }
  if (length(work$steps) > 0 && isatty(stderr())) cat("\r", words, "\033[K", sep = "", file = stderr())
  else message(words)
}

end_progress <- function() {
  if (length(work$steps) > 0 && isatty(stderr())) cat("\r\033[K", file = stderr())
  work$steps <- numeric()
}

# "(3 of 14; 12 s so far, about 40 s left)": what is left, from how long the steps before took, as
# soon as they are a tenth of all.
step_words <- function(steps, at, seconds) {
  before <- sum(utils::head(steps, at - 1))
  left <- seconds * (sum(steps) - before) / before
  sprintf("(%d of %d; %s so far%s)", as.integer(at), length(steps), time_words(seconds),
    if (before >= sum(steps) / 10) sprintf(", about %s left", time_words(left)) else "")
}

# "12 s", "4 min"
time_words <- function(seconds) {
  if (seconds < 90) sprintf("%.0f s", seconds) else sprintf("%.0f min", seconds / 60)
}

kMeansStep <- "testing the participants' means ..."
kFunctionsStep <- "fitting psychometric functions ..."
kContrastStep <- "fitting the mixed models of pairs of kinds ..."
kHierarchicalStep <- "fitting the hierarchical model of all answers ..."
kClickRegressionStep <- "regressing the click rate on the collisions before ..."
model_step <- function(factor) sprintf("fitting the mixed model for %s ...", factor)
link_step <- function(factor, link) sprintf("fitting %s with the link %s ...", factor, link)
figure_step <- function(part, name) sprintf("drawing %s %s ...", tolower(title_of_part(part)), name)

# The steps of a protocol whose parts these are: their weights, named by their words.
steps_of_parts <- function(parts) {
  parts <- Filter(function(part) is.null(part$why), parts)
  c(unlist(lapply(parts, steps_of_results)), unlist(lapply(parts, steps_of_figures)))
}

steps_of_results <- function(part) {
  factors <- unname(part$factors)
  share <- nrow(part$trials) / 4000
  if (part$response == "threshold") {
    return(c(stats::setNames(10 * share, kFunctionsStep), stats::setNames(20 * share, kHierarchicalStep)))
  }
  if (part$response == "scheduling") return(stats::setNames(10 * share, kContrastStep))
  if (is_by_means(part)) return(stats::setNames(2, kMeansStep))
  links <- if (part$response != "clicks") unlist(lapply(factors, link_step, kOtherLinks))
  terms <- c(factors, gsub(":", " × ", described_interactions(part)))
  seconds <- 0.3 + c(rating = 1, answer = 5, clicks = 10)[[part$response]] * share
  c(
    stats::setNames(rep(2 * seconds, length(terms)), vapply(terms, model_step, "")),
    if (part$response == "clicks") stats::setNames(10 * share, kClickRegressionStep),
    stats::setNames(2, kMeansStep), stats::setNames(rep(seconds, length(links)), links))
}

steps_of_figures <- function(part) {
  names <- if (part$response == "threshold") c("curves", "thresholds") else
    if (part$response == "scheduling") vapply(contrasts_drawn(part), `[[`, "", "name") else
    vapply(c(as.list(unname(part$factors)), figure_pairs(part)), figure_name, "")
  stats::setNames(rep(1, length(names)), vapply(names, figure_step, "", part = part))
}
