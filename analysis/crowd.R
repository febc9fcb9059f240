#!/usr/bin/env Rscript
# Study 6, crowds: how believable are collisions of 50, 100 and 250 bodies, when the good ones are near
# the gaze and when they are near the eye?
#
#   rated main trials ─┬─> mixed models, ANOVA, Friedman, equivalence ─> table, words
#                      └─> participants' means ───────────────────────> figure
#   click_trial, if the protocol asks for clicks ─────────────────────> table of clicks
#
# The scene is the thesis's (Dingliana 2002, sec. 6.4), the question is ours.
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/crowd.R study.sqlite [more.sqlite ...] --out figures/"

main <- function(words) {
  study <- open_rating_study(words, kUsage, "crowd",
    factors = c(bodies = "bodies", scheduler = "scheduler"), views = "click_trial")
  report_rating_study(study, "Crowds: ratings by number of bodies", "bodies", "scheduler",
    interactions = TRUE, shown = crowd_clicks(study))
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
or_exit_2("crowd.R", main(commandArgs(trailingOnly = TRUE)))
