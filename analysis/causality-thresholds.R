#!/usr/bin/env Rscript
# Causality thresholds: how long a freeze at contact is needed for it to be noticed? Ours; the delay
# is the one realised on the display's frames.
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
