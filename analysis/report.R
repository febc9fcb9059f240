#!/usr/bin/env Rscript
# The report of any study: one page with figures, models, their words and the methods section, and
# beside it the data and the code to repeat it. `impetus report` runs this.
#
#   study.sqlite ─> OUT/data/*.csv ─> OUT/report.html, OUT/figures/, OUT/tables/
#
# In place of a study file it takes the data/ of an earlier report.
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/report.R study.sqlite --out report/"

main <- function(words) report_page(read_arguments(words, kUsage))

script <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)[1])
source(file.path(dirname(gsub("~+~", " ", script, fixed = TRUE)), "R/command_line.R"))
run_command(script, main)
