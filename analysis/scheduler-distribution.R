#!/usr/bin/env Rscript
# Study 5, schedulers: which collisions does each put first? No participants; ten simulated minutes.
#
#   collisions ─> histograms over depth, projected speed and eccentricity ─> figures 6.11 to 6.16
#              └> shapes of the share of high priority ─> expected ones met or not, in words
# (Dingliana 2002, sec. 6.3)
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
