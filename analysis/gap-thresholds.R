#!/usr/bin/env Rscript
# Gap thresholds: how large must a gap be to be seen, away from the gaze and among distractors?
# Ours; the factors are O'Sullivan's (1999). The scale is logarithmic.
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
