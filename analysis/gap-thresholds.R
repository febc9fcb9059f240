#!/usr/bin/env Rscript
# Gap thresholds: how large must a gap be to be seen, away from the gaze and among distractors?
# Ours; the factors are O'Sullivan's (1999). The scale is logarithmic.
#
#   answers ─> a psychometric function per participant and condition ─> thresholds ─> tests, words
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/gap-thresholds.R study.sqlite [more.sqlite ...] --out figures/"

main <- function(words) {
  report_threshold_study(open_threshold_study(words, kUsage, "gap-thresholds", "gap",
    log10 = TRUE), "Gap: thresholds by eccentricity and distractors")
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
or_exit_2("gap-thresholds.R", main(commandArgs(trailingOnly = TRUE)))
