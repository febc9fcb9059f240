#!/usr/bin/env Rscript
# Study 1, causality: does a freeze at contact make a collision less believable?
#
#   rated main trials ─┬─> mixed model, ANOVA, Friedman, equivalence ─> table, words
#                      └─> participants' means ──────────────────────> figure
#
# The thesis found that ratings worsen with the delay, at each speed too, and no effect of speed
# or viewpoint (Dingliana 2002, sec. 6.2.1 and fig. 6.5). The unit here is the participant; the
# thesis's own pooled test stands beside, labelled.
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/causality.R study.sqlite [more.sqlite ...] --out figures/"
kPackages <- c("RSQLite", "ordinal", "lme4", "afex", "ggplot2")

main <- function(words) {
  arguments <- read_arguments(words, kUsage)
  need_packages(kPackages)
  study <- keep_people_apart(read_studies(arguments$studies, "causality",
    factors = c(delay = "delay", speed = "speed", viewpoint = "viewpoint")))
  prepare_folder(arguments$out)
  trials <- study$trials
  delay <- study$factors[["delay"]]
  others <- unname(study$factors[c("speed", "viewpoint")])

  tests <- rating_tests(trials, delay, others)
  data <- study_sentences(study)
  results <- results_paragraph(trials, study$scale, tests, delay, others)
  caption <- figure_caption(trials, delay, others, study$all_simulated)

  say_progress("drawing the figure (about 5 s) ...")
  path <- function(ending) file.path(arguments$out, paste0("causality", ending))
  figures <- write_rating_figure(trials, study$scale, delay, others, study$all_simulated, path(""))
  write_test_table(tests, path(".csv"))
  write_report(path(".md"), "Causality: ratings by delay", results, data, tests$remarks, caption)
  say(c(figures, path(".csv"), path(".md"), "", paste(data, collapse = " "), "", results,
    tests$remarks))
}

# The folder of this script, as Rscript was called with it ("~+~" is how it writes a space).
own_folder <- function() {
  script <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)[1])
  dirname(gsub("~+~", " ", script, fixed = TRUE))
}

# UTF-8 letters and one order of sorting, whatever the machine is set to.
invisible(suppressWarnings(Sys.setlocale("LC_ALL", "C.UTF-8")))
for (file in list.files(file.path(own_folder(), "R"), "[.]R$", full.names = TRUE)) {
  source(file, encoding = "UTF-8")
}
or_exit_2("causality.R", main(commandArgs(trailingOnly = TRUE)))
