#!/usr/bin/env Rscript
# Study 2, gap: does a gap at contact, left by a coarse level of the sphere tree, make a collision
# less believable, and do speed and viewpoint hide it?
#
#   rated main trials ─┬─> mixed models, ANOVA, Friedman, equivalence ─> table, words
#                      ├─> participants' means ───────────────────────> figure
#   seen collisions ───┴─> what was shown: table, mixed model of the gap
#
# The thesis found a strong effect of level, viewpoint to matter at the coarsest level above all,
# and a coarse level to show less at higher speed (Dingliana 2002, sec. 6.2.2, figs. 6.7 to 6.9).
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/gap.R study.sqlite [more.sqlite ...] --out figures/"

main <- function(words) {
  study <- open_rating_study(words, kUsage, "gap",
    factors = c(level = "level", speed = "speed", viewpoint = "viewpoint"))
  study <- with_gaps_shown(with_depths_named(study))
  report_rating_study(study, "Gap: ratings by level of the sphere tree", "level",
    c("speed", "viewpoint"), interactions = TRUE, shown = gaps_shown(study))
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
or_exit_2("gap.R", main(commandArgs(trailingOnly = TRUE)))
