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

main <- function(words) {
  study <- open_rating_study(words, kUsage, "causality",
    factors = c(delay = "delay", speed = "speed", viewpoint = "viewpoint"))
  report_rating_study(study, "Causality: ratings by delay", "delay", c("speed", "viewpoint"))
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
