#!/usr/bin/env Rscript
# Draws from the posterior of an observer's parameters. `impetus fit --posterior` runs this and
# answers its questions, a line each:
#
#   in      n; the mode, n numbers; the covariance, a line of n for each parameter
#   out     density x1 … xn      in   its logarithm, or -Inf
#   out     progress SHARE
#   out     parameter LOW MEDIAN HIGH SD RHAT ENOUGH        of each
#   out     draw CHAIN x1 … xn                              all of them, at the end
#
# SPDX-License-Identifier: MIT

kUsage <- "Rscript sample-posterior.R [--check], run by impetus fit --posterior"

tell_line <- function(...) {
  writeLines(paste(c(...), collapse = " "))
  flush(stdout())
}

exactly <- function(x) sprintf("%.17g", x)

sample_for_program <- function(program) {
  numbers <- function() as.numeric(strsplit(readLines(program, 1), " ")[[1]])
  size <- numbers()
  mode <- numbers()
  covariance <- matrix(unlist(lapply(seq_len(size), function(row) numbers())), size)
  density <- function(x) {
    tell_line("density", exactly(x))
    numbers()
  }
  sampled <- sample_posterior(density, mode, covariance,
    function(share) tell_line("progress", share))
  drawn <- do.call(rbind, sampled$chains)
  for (i in seq_len(size)) {
    tell_line("parameter", exactly(c(stats::quantile(drawn[, i], c(0.025, 0.5, 0.975), names = FALSE),
      stats::sd(drawn[, i]), sampled$rhat[i], sampled$enough[i])))
  }
  for (chain in seq_along(sampled$chains)) {
    columns <- lapply(seq_len(size), function(i) exactly(sampled$chains[[chain]][, i]))
    writeLines(do.call(paste, c("draw", chain, columns)))
  }
}

main <- function(words) {
  need_packages(c("mcmc", "coda"))
  if (identical(words, "--check")) return(invisible())
  if (length(words) > 0) refuse("usage: ", kUsage)
  set.seed(1)
  program <- file("stdin", "r", blocking = TRUE)
  on.exit(close(program))
  sample_for_program(program)
}

script <- sub("^--file=", "", grep("^--file=", commandArgs(), value = TRUE)[1])
source(file.path(dirname(gsub("~+~", " ", script, fixed = TRUE)), "R/command_line.R"))
run_command(script, main)
