# A rating study from its files to figure, table and words: what the scripts have in common.
#
#   rated main trials ─┬─> rating_tests ──────────> <protocol>.csv, .md
#                      └─> participants' means ───> <protocol>.png, .pdf
# SPDX-License-Identifier: MIT

kPackages <- c("RSQLite", "ordinal", "lme4", "afex", "ggplot2")

# Reads what the command line names; refuses before anything is written. Adds `out`, the folder.
# `views`: those that the script needs beyond the ones of every rating study.
open_rating_study <- function(words, usage, protocol, factors, views = character()) {
  arguments <- read_arguments(words, usage)
  need_packages(kPackages)
  study <- keep_people_apart(read_studies(arguments$studies, protocol, factors, views))
  prepare_folder(arguments$out)
  c(study, out = arguments$out)
}

# Tests, writes and says everything. `main`, `others`: names in study$factors. `interactions`: see
# rating_tests. `shown`: list(tests, words, section) of a further part, each of which may be NULL.
report_rating_study <- function(study, title, main, others, interactions = FALSE, shown = list()) {
  trials <- study$trials
  main <- study$factors[[main]]
  others <- unname(study$factors[others])
  tests <- combine_outcomes(rating_tests(trials, main, others, interactions,
    equivalence_margin(study$scale)), shown$tests)
  data <- study_sentences(study)
  results <- paste(c(results_paragraph(trials, study$scale, tests, main, others), shown$words),
    collapse = " ")
  caption <- figure_caption(trials, main, others, study$all_simulated)

  say_progress("drawing the figure ...")
  path <- function(ending) file.path(study$out, paste0(study$protocol, ending))
  figures <- write_rating_figure(trials, study$scale, main, others, study$all_simulated, path(""))
  write_test_table(tests, path(".csv"))
  write_report(path(".md"), title, results, data, tests$remarks, caption, shown$section,
    left_out_section(study))
  say(c(figures, path(".csv"), path(".md"), "", paste(data, collapse = " "), "", results,
    tests$remarks))
}
