#!/usr/bin/env Rscript
# Study 5, schedulers: which collisions does each put first? No participants; ten simulated minutes.
# (Dingliana 2002, sec. 6.3)
# SPDX-License-Identifier: MIT

words <- gsub("~+~", " ", commandArgs(), fixed = TRUE)  # as Rscript writes a space
script <- sub("^--file=", "", grep("^--file=", words, value = TRUE)[1])
source(file.path(dirname(script), "R/command_line.R"))
run_study_command(script)
