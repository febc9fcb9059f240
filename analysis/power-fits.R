#!/usr/bin/env Rscript
# Tests simulated studies and writes what was found into the ledger of a power analysis. `impetus
# power` runs this, again and again.
#
#   studies.tsv ─> each study's tests, for each number of participants ─> ledger: study, test
#
# SPDX-License-Identifier: MIT

kUsage <- "Rscript power-fits.R power.sqlite studies.tsv, or --check means|mixed"

main <- function(words) {
  if (length(words) != 2) refuse("usage: ", kUsage)
  if (words[1] == "--check") return(need_packages(power_packages(words[2])))
  write_power_tests(words[1], words[2])
}

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_command(script, main)
