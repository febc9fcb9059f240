#!/usr/bin/env Rscript
# The report of any study: one page with figures, models, their words and the methods section, and
# beside it the data and the code to repeat it. `impetus report` runs this.
#
#   study.sqlite ─> OUT/data/*.csv ─> OUT/report.html, OUT/figures/, OUT/tables/
#
# In place of a study file it takes the data/ of an earlier report.
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/report.R study.sqlite --out report/"

main <- function(words) {
  arguments <- read_arguments(words, kUsage)
  need_packages(kReportPackages)
  if (length(arguments$studies) > 1) refuse("expected one study file; usage: ", kUsage)
  prepare_folder(arguments$out)
  data <- file.path(arguments$out, "data")
  prepare_folder(data)
  if (dir.exists(arguments$studies)) {
    copy_report_data(arguments$studies, data)
  } else {
    write_report_data(arguments$studies, data)
  }
  need_packages(packages_for_data(data))
  write_study_report(arguments$out)
  end_progress()
  say_progress("wrote report.html, figures/ and tables/")
}

script <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)[1])
source(file.path(dirname(gsub("~+~", " ", script, fixed = TRUE)), "R/command_line.R"))
run_command(script, main)
