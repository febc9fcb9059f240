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

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
