#!/usr/bin/env Rscript
# Figures: is a collision of two articulated figures less believable where it is handled at a coarse
# level: by spheres about whole parts, or by the parts themselves?
# The thesis built such figures (Dingliana 2002, sec. 4.1.3) and rated none: the question is ours, the
# design that of its gap study. Parts meet many times in a trial; what was shown is the first time.
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
