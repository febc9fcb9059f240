# The steps of a report that take time, in their order: what its progress counts.
#
#   a part: models of each factor ─> means ─> other links ─> figures       ratings, answers, clicks
#           functions ─> hierarchical model ─> figures                     thresholds
#
# A step's weight is about how many seconds it takes for 50 participants; weights grow with the trials.
# SPDX-License-Identifier: MIT

kMeansStep <- "testing the participants' means ..."
kFunctionsStep <- "fitting psychometric functions ..."
kHierarchicalStep <- "fitting the hierarchical model of all answers ..."
kClickRegressionStep <- "regressing the click rate on the events before ..."
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
  links <- if (part$response != "clicks") unlist(lapply(factors, link_step, kOtherLinks))
  seconds <- 0.3 + c(rating = 1, answer = 5, clicks = 10)[[part$response]] * share
  c(
    stats::setNames(rep(2 * seconds, length(factors)), vapply(factors, model_step, "")),
    if (part$response == "clicks") stats::setNames(10 * share, kClickRegressionStep),
    stats::setNames(2, kMeansStep), stats::setNames(rep(seconds, length(links)), links))
}

steps_of_figures <- function(part) {
  names <- if (part$response == "threshold") c("curves", "thresholds") else
    vapply(c(as.list(unname(part$factors)), figure_pairs(part)), figure_name, "")
  stats::setNames(rep(1, length(names)), vapply(names, figure_step, "", part = part))
}
