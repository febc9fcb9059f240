#!/usr/bin/env Rscript
# Gaze-contingent scheduling, yoked: do collisions look better when the good ones are where the eye is
# (tracked) than when they follow somebody else's recorded gaze? Recorded moves as a gaze does, which
# random jumps do not; ours, the control that the thesis's random region is not.
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
