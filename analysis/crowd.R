#!/usr/bin/env Rscript
# Study 6, crowds: how believable are collisions of 50, 100 and 250 bodies, when the good ones are near
# the gaze and when they are near the eye?
# The scene is the thesis's (Dingliana 2002, sec. 6.4), the question is ours.
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
