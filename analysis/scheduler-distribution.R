#!/usr/bin/env Rscript
# Study 5, schedulers: which collisions does each put first? No participants; ten simulated minutes.
#
#   collisions ─> histograms over depth, projected speed and eccentricity ─> figures 6.11 to 6.16
#              └> shapes of the share of high priority ─> expected ones met or not, in words
# (Dingliana 2002, sec. 6.3)
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/scheduler-distribution.R study.sqlite [more.sqlite ...] --out figures/"

main <- function(words) report_distribution_study(open_distribution_study(words, kUsage))

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
or_exit_2("scheduler-distribution.R", main(commandArgs(trailingOnly = TRUE)))
