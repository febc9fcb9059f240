#!/usr/bin/env Rscript
# Figures: is a collision of two articulated figures less believable where it is handled at a coarse
# level: by spheres about whole parts, or by the parts themselves?
#
#   rated main trials ─┬─> mixed models, ANOVA, Friedman, equivalence ─> table, words
#                      ├─> participants' means ───────────────────────> figure
#   seen collisions ───┴─> what was shown: table, mixed model of the gap
#
# The thesis built such figures (Dingliana 2002, sec. 4.1.3) and rated none: the question is ours, the
# design that of its gap study. Parts meet many times in a trial; what was shown is the first time.
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/figures.R study.sqlite [more.sqlite ...] --out figures/"

main <- function(words) {
  study <- open_rating_study(words, kUsage, "figures",
    factors = c(level = "level", speed = "speed", viewpoint = "viewpoint"))
  study <- with_gaps_shown(with_depths_named(study, c("spheres", "parts", "deepest"),
    "Greatest levels of detail"))
  report_rating_study(study, "Figures: ratings by greatest level of detail", "level",
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
or_exit_2("figures.R", main(commandArgs(trailingOnly = TRUE)))
