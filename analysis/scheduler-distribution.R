#!/usr/bin/env Rscript
# The report of the study that studies/scheduler-distribution.dcf describes.
# SPDX-License-Identifier: MIT

script <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)[1])
source(file.path(dirname(gsub("~+~", " ", script, fixed = TRUE)), "R/command_line.R"))
run_study_command(script)
