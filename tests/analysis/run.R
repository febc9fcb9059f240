# Runs every test of analysis/: Rscript tests/analysis/run.R <repo root> [--slow]
# Exits 1 when a test fails. --slow adds the whole scripts on 20 participants (some minutes).
# SPDX-License-Identifier: MIT

words <- commandArgs(trailingOnly = TRUE)
root <- normalizePath(setdiff(words, "--slow")[1], mustWork = TRUE)
run_slow <- "--slow" %in% words
schema_paths <- file.path(root, "experiments/store", c("schema.sql", "views.sql"))

invisible(Sys.setlocale("LC_ALL", "C.UTF-8"))
options(impetus.analysis = file.path(root, "analysis"))  # where studies are described
for (file in list.files(file.path(root, "analysis/R"), "[.]R$", full.names = TRUE)) source(file)
source(file.path(root, "tests/analysis/synthetic_study.R"))
source(file.path(root, "tests/analysis/synthetic_gaze_study.R"))
source(file.path(root, "tests/analysis/synthetic_clicks.R"))
source(file.path(root, "tests/analysis/synthetic_thresholds.R"))
source(file.path(root, "tests/analysis/script_run.R"))

save_time()

results <- testthat::test_dir(file.path(root, "tests/analysis"),
  reporter = testthat::ProgressReporter$new(show_praise = FALSE, update_interval = Inf),
  env = globalenv(), stop_on_failure = FALSE, load_helpers = FALSE)
counts <- as.data.frame(results)
if (nrow(counts) == 0 || any(counts$failed > 0) || any(counts$error)) quit(status = 1)
