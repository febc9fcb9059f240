#!/usr/bin/env Rscript
# The page of a power analysis from its ledger: power and type-I error with Monte-Carlo intervals.
# `impetus power` runs this at its end; on a ledger that is still being filled it shows what there is.
#
#   power.sqlite ─> OUT/power.html, power.svg, power.pdf, power.csv
#
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/power.R power/power.sqlite --out power/"

main <- function(words) {
  arguments <- read_arguments(words, kUsage)
  need_packages(power_packages("means"))
  if (length(arguments$studies) > 1) refuse("expected one ledger; usage: ", kUsage)
  if (!file.exists(arguments$studies)) {
    refuse(arguments$studies, ": expected a ledger, found no such file")
  }
  prepare_folder(arguments$out)
  write_power_page(arguments$studies, arguments$out)
}

script <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)[1])
source(file.path(dirname(gsub("~+~", " ", script, fixed = TRUE)), "R/command_line.R"))
run_command(script, main)
