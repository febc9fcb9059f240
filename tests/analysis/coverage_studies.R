# Runs studies with planted truths and keeps where the intervals lie:
#
#   Rscript tests/analysis/coverage_studies.R <repo root> [table ...]
#
# Seeds 1, 2, 3 ... Writes tests/analysis/coverage_<table>.csv, one row per seed, of the tables named
# or of all (kCoverageTables, with how many studies each has), and prints the coverages. Seeds that a
# file holds already are not run again, so that an interrupted run goes on. A study takes from .1 s
# (means) to 3 s (odds, ratios).
# SPDX-License-Identifier: MIT

words <- commandArgs(trailingOnly = TRUE)
root <- normalizePath(words[1], mustWork = TRUE)
invisible(Sys.setlocale("LC_ALL", "C.UTF-8"))
for (file in list.files(file.path(root, "analysis/R"), "[.]R$", full.names = TRUE)) source(file)
for (file in c("synthetic_study", "synthetic_gaze_study", "synthetic_clicks",
  "synthetic_thresholds", "null_model", "seed_table", "coverage_model", "coverage_rates")) {
  source(file.path(root, "tests/analysis", paste0(file, ".R")))
}

for (table in if (length(words) > 1) words[-1] else names(kCoverageTables)) {
  complete_table(file.path(root, "tests/analysis", sprintf("coverage_%s.csv", table)),
    kCoverageTables[[table]]$studies, kCoverageTables[[table]]$row_of)
}
writeLines(coverage_lines(coverage_rates(file.path(root, "tests/analysis"))))
