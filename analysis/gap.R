#!/usr/bin/env Rscript
# Study 2, gap: does a gap at contact, left by a coarse level of the sphere tree, make a collision
# less believable, and do speed and viewpoint hide it?
# The thesis found a strong effect of level, viewpoint to matter at the coarsest level above all,
# and a coarse level to show less at higher speed (Dingliana 2002, sec. 6.2.2, figs. 6.7 to 6.9).
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
