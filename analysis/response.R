#!/usr/bin/env Rscript
# Study 3, response: does a collision that is resolved at a coarse level, and so turns the bodies
# wrongly, look less believable?
#
#   rated main trials ─┬─> mixed models, ANOVA, Friedman, equivalence ─> table, words
#                      ├─> participants' means ───────────────────────> figure
#   seen collisions ───┼─> gaps shown: table, mixed model
#                      └─> random spin imposed: confounding, mixed model
#
# The thesis found an effect of viewpoint, faster collisions rated worse, accurate ones worse than
# randomised ones at high speed, and none of level, which the random spin masked (Dingliana 2002,
# sec. 6.2.2, figs. 6.7 to 6.9).
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/response.R study.sqlite [more.sqlite ...] --out figures/"

main <- function(words) {
  study <- open_rating_study(words, kUsage, "response",
    factors = c(level = "level", speed = "speed", viewpoint = "viewpoint"))
  study <- with_imposed_spin(with_gaps_shown(with_depths_named(study)))
  gaps <- gaps_shown(study)
  spin <- spin_imposed(study)
  report_rating_study(study, "Response: ratings by level of the sphere tree", "level",
    c("speed", "viewpoint"), interactions = TRUE, shown = list(
      tests = all_outcomes(gaps$tests, spin$tests), words = c(spin$words, gaps$words),
      section = c(spin$section, gaps$section)))
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
or_exit_2("response.R", main(commandArgs(trailingOnly = TRUE)))
