#!/usr/bin/env Rscript
# Tests simulated studies and writes what was found into the ledger of a power analysis. `impetus
# power` runs this, again and again.
#
#   studies.tsv ─> each study's tests, for each number of participants ─> ledger: study, test
#
# SPDX-License-Identifier: MIT

kUsage <- "Rscript power-fits.R power.sqlite studies.tsv, or --check means|mixed versions.txt"

# Refuses unless all packages are there, and writes R's version and those of the packages that test.
check_packages <- function(model, file) {
  need_packages(power_packages(model))
  versions <- vapply(testing_packages(model), function(package) {
    paste(package, utils::packageVersion(package))
  }, "")
  writeLines(paste(c(paste("R", getRversion()), versions), collapse = ", "), file)
}

main <- function(words) {
  if (length(words) == 3 && words[1] == "--check") return(check_packages(words[2], words[3]))
  if (length(words) != 2) refuse("usage: ", kUsage)
  write_power_tests(words[1], words[2])
}

script <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)[1])
source(file.path(dirname(gsub("~+~", " ", script, fixed = TRUE)), "R/command_line.R"))
run_command(script, main)
