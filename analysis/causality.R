#!/usr/bin/env Rscript
# Study 1, causality: does a freeze at contact make a collision less believable?
# The thesis found that ratings worsen with the delay, at each speed too, and no effect of speed
# or viewpoint (Dingliana 2002, sec. 6.2.1 and fig. 6.5). The unit here is the participant; the
# thesis's own pooled test stands beside, labelled.
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
