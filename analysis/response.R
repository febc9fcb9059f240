#!/usr/bin/env Rscript
# Study 3, response: does a collision that is resolved at a coarse level, and so turns the bodies
# wrongly, look less believable?
# The thesis found an effect of viewpoint, faster collisions rated worse, accurate ones worse than
# randomised ones at high speed, and none of level, which the random spin masked (Dingliana 2002,
# sec. 6.2.2, figs. 6.7 to 6.9).
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
