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
or_exit_2("power-fits.R", invisible(main(commandArgs(trailingOnly = TRUE))))
