#!/usr/bin/env Rscript
# Study 4, gaze-contingent scheduling: do collisions look better when the good ones are where the
# eye is (tracked) than when as many are somewhere else (random)?
# The thesis found tracked better than random at every number of bodies, nowhere significantly
# (Dingliana 2002, sec. 6.3.1, figs. 6.18 and 6.19).
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
