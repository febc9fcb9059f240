#!/usr/bin/env Rscript
# Causality thresholds: how long a freeze at contact is needed for it to be noticed? Ours; the delay
# is the one realised on the display's frames. Its levels were chosen trial by trial by QUEST+, at
# each speed.
#
#   answers ─> a psychometric function per participant and condition ─> thresholds ─> tests, words
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/causality-thresholds-quest.R study.sqlite [more.sqlite ...] --out figures/"

main <- function(words) {
  report_threshold_study(open_threshold_study(words, kUsage, "causality-thresholds-quest",
    "delay", realised_hold = TRUE), "Causality: thresholds of the delay, by QUEST+")
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
or_exit_2("causality-thresholds-quest.R", main(commandArgs(trailingOnly = TRUE)))
