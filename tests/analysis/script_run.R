# The scripts as they are called.
# SPDX-License-Identifier: MIT

# Runs a script of analysis/ from another folder; list(status, stdout, stderr).
# `root` is set by run.R.
run_script <- function(script, ..., environment = character()) {
  error_file <- tempfile()
  from <- setwd(tempdir())
  on.exit(setwd(from))
  output <- suppressWarnings(system2(file.path(R.home("bin"), "Rscript"),
    shQuote(c(file.path(root, "analysis", script), ...)), stdout = TRUE, stderr = error_file,
    env = environment))
  status <- attr(output, "status")
  list(status = if (is.null(status)) 0L else status, stdout = as.vector(output),
    stderr = readLines(error_file))
}

# A new folder for output; its name has a space on purpose.
new_folder <- function() tempfile("figures of ")
