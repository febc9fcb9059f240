#!/usr/bin/env Rscript
# Gaze-contingent scheduling, yoked: do collisions look better when the good ones are where the eye is
# (tracked) than when they follow somebody else's recorded gaze? Recorded moves as a gaze does, which
# random jumps do not; ours, the control that the thesis's random region is not.
#
#   rated main trials ─┬─> mixed models, tracked − recorded (planned), random − recorded ─> table, words
#   clicks ────────────┤
#                      └─> participants' means ─────────────────────────> two figures
#   collisions ────────────> what was shown: are the pairs fair ones?
#   gaze samples, steps ───> how good the gaze was, how late the display
# SPDX-License-Identifier: MIT

kUsage <- "Rscript analysis/gaze-contingent-yoked.R study.sqlite [more.sqlite ...] --out figures/"

main <- function(words) {
  report_gaze_study(open_gaze_study(words, kUsage, "gaze-contingent-yoked"))
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
or_exit_2("gaze-contingent-yoked.R", main(commandArgs(trailingOnly = TRUE)))
