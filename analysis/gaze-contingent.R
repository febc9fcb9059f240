#!/usr/bin/env Rscript
# Study 4, gaze-contingent scheduling: do collisions look better when the good ones are where the
# eye is (tracked) than when as many are somewhere else (random)?
#
#   rated main trials ─┬─> mixed models, planned contrast, equivalence ─> table, words
#   clicks ────────────┤
#                      └─> participants' means ─────────────────────────> two figures
#   collisions ────────────> what was shown: is the contrast a fair one?
#   gaze samples, steps ───> how good the gaze was, how late the display
#
# The thesis found tracked better than random at every number of bodies, nowhere significantly
# (Dingliana 2002, sec. 6.3.1, figs. 6.18 and 6.19).
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/gaze-contingent.R study.sqlite [more.sqlite ...] --out figures/"

main <- function(words) report_gaze_study(open_gaze_study(words, kUsage))

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
or_exit_2("gaze-contingent.R", main(commandArgs(trailingOnly = TRUE)))
