# A rating study from its files to figure, table and words.
#
#   rated main trials ─┬─> rating_tests ──────────> <protocol>.csv, .md
#                      └─> participants' means ───> <protocol>.png, .pdf
#
#   primary  mixed model, effects            beside it  repeated-measures ANOVA
#            mixed model, odds ratios                   Friedman
#            equivalence                                pooled ANOVA, as in the thesis
#
#   figure   a: mean rating over the levels of one factor: every participant, thin and grey, the mean
#               and its interval in black
#            b, c: the same means split by a second factor; colour and shape say the level
#
# All families but the last are those of the report (part_results.R), made alike, so that both print
# the same numbers.
# SPDX-License-Identifier: MIT

open_rating_study <- function(study, paths) {
  read <- keep_people_apart(read_studies(paths, study$protocol, study$factors, study$views))
  c(read, study[setdiff(names(study), names(read))])
}

report_rating_study <- function(study) {
  if (!is.null(study$depth_names)) {
    study <- do.call(with_depths_named, c(list(study), study$depth_names))
  }
  trials <- study$trials
  main <- study$factors[[1]]
  others <- unname(study$factors[-1])
  shown <- parts_shown(study)
  tests <- combine_outcomes(rating_tests(trials, main, others, isTRUE(study$interactions),
    equivalence_margin(study$scale)), shown$tests)
  results <- paste(c(results_sentences(trials, study$scale, tests, main, others), shown$words),
    collapse = " ")
  say_progress("drawing the figure ...")
  figures <- write_figure(function() rating_figure(trials, study$scale, main, others,
    study$all_simulated), output_path(study, ""))
  write_outputs(study, tests, results, study_sentences(study),
    figure_caption(trials, main, others, study$all_simulated), shown$section, figures)
}

output_path <- function(study, ending) file.path(study$out, paste0(study$protocol, ending))

# Writes the tests, the further `tables` (named by what their files end in) and the report as
# Markdown, and says where all is and what was found. `data`: sentences on what is behind the results;
# `sections`: lines of Markdown after the results; `beside`: paragraphs that stand in them and are said
# too; `left_out`: the part about exclusions.
write_outputs <- function(study, tests, results, data, caption, sections, figures,
                          tables = list(), beside = NULL, left_out = left_out_section(study)) {
  tables <- c(list(tests$rows), stats::setNames(tables, sprintf("-%s", names(tables))))
  files <- c(output_path(study, paste0(names(tables), ".csv")), output_path(study, ".md"))
  Map(write_table, tables, utils::head(files, -1))
  bullets <- function(lines) if (length(lines) > 0) paste("-", lines) else "- none"
  text <- c(
    paste("#", study$title), "", results, "", sections, "## Data", "", bullets(data), "",
    "## Left out, and other trials to know of", "", left_out, "",
    "## Remarks on the tests", "", bullets(tests$remarks), "", "## Figure", "", caption)
  writeLines(enc2utf8(text), output_path(study, ".md"), useBytes = TRUE)
  say(c(figures, files, "", paste(data, collapse = " "), "", results, beside, tests$remarks))
}

# Tests of `main`, the ordered factor of interest, and of the `others`, all columns of `trials`;
# `interactions`: those of main with each other one are tested in a mixed model too. `margin`: of
# equivalence, in rating points; NULL: neither equivalence nor the thesis's test. With one
# participant, or ratings that never vary, there is no test and a remark says so.
rating_tests <- function(trials, main, others, interactions = FALSE,
                         margin = kEquivalenceMargin) {
  none <- why_no_test(trials)
  if (!is.null(none)) return(combine_outcomes(outcome(remarks = none)))
  factors <- varying_factors(trials, c(main, others))
  constant <- constant_remarks(setdiff(c(main, others), factors))
  others <- intersect(others, factors)
  main <- intersect(main, factors)
  if (length(factors) == 0) return(combine_outcomes(constant))
  pairs <- if (interactions && length(main) == 1) sprintf("%s:%s", main, others)
  models <- factor_tests(trials, factors, interactions = pairs)
  combine_outcomes(constant, models, tests_of_means(trials, factors, "a rating", margin),
    if (!is.null(margin) && length(main) > 0)
      pooled_tests(trials, main, by = utils::head(others, 1)))
}

why_no_test <- function(trials) {
  if (participant_count(trials) < 2) {
    return("One participant: the figure and the means describe; no inferential test was made.")
  }
  if (length(unique(trials$rating)) > 1) return(NULL)
  sprintf("Every rating was %d: nothing varies, so no test was made.", as.integer(trials$rating[1]))
}

constant_remarks <- function(factors) {
  if (length(factors) == 0) return(outcome())
  outcome(remarks = sprintf("%s has one level in these trials and is not tested.", factors))
}

# The paragraph. `main`: the factor of interest; `others`: those tested for equivalence too.
results_sentences <- function(trials, scale, tests, main, others) {
  c(
    scale_words(scale), means_words(trials, main), factor_words(tests, main, scale = scale),
    unlist(lapply(others, function(factor) other_factor_words(tests, factor))),
    interaction_words(tests), anova_words(tests, main), anova_interaction_words(tests),
    friedman_words(tests, main), pooled_words(tests, main))
}

# The panels side by side as one grob. Needs an open device to measure text on. `main`: the column on
# the x axis; `beside`: columns for the panels beside it, those of a single level left out.
# `simulated`: no participant is a person, and the figure says so.
rating_figure <- function(trials, scale, main, beside, simulated) {
  split <- lapply(varying_factors(trials, beside), function(factor) {
    split_plot(trials, c(main, factor), "rating", bar = 0.5, point = 1.4, expand = 0.08) +
      axis_of_rating(scale, words = FALSE) + figure_theme()
  })
  panels_beside(c(list(rating_panel(trials, scale, main, simulated)), split), first = 1.3)
}

# Panel a: participants behind, mean and interval before.
rating_panel <- function(trials, scale, main, simulated) {
  mean <- placed_means(trials, main)
  each <- shifted_means(trials, main)
  alone <- participant_count(trials) == 1
  who <- c(mean = if (alone) paste("mean of one", who_words(simulated)) else
    if (all(is.na(mean$low))) "mean" else "mean, 95 % CI", each = who_words(simulated))
  shown <- if (alone) "mean" else c("mean", "each")
  ggplot2::ggplot(mean, ggplot2::aes(x, mean)) +
    ggplot2::geom_line(ggplot2::aes(group = participant, colour = who[["each"]]), each,
      linewidth = 0.25) +
    ggplot2::geom_point(ggplot2::aes(colour = who[["each"]]), each, size = 0.7, stroke = 0) +
    ggplot2::geom_line(ggplot2::aes(colour = who[["mean"]]), linewidth = 0.5) +
    interval_bars(0.8, colour = who[["mean"]]) +
    ggplot2::geom_point(ggplot2::aes(colour = who[["mean"]]), size = 1.6) +
    ggplot2::scale_colour_manual(NULL, breaks = unname(who[shown]),
      values = stats::setNames(c("black", "grey72"), who),
      guide = ggplot2::guide_legend(override.aes = list(size = c(1.6, 0.7)[seq_along(shown)],
        linewidth = c(0.5, 0.25)[seq_along(shown)]))) +
    level_axis(trials, main, 0.08) + axis_of_rating(scale, words = TRUE) + figure_theme()
}
