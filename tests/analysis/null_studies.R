# Runs null studies and keeps their p values:
#
#   Rscript tests/analysis/null_studies.R <repo root> [--means 2000] [--mixed 200] [--words 200]
#
# Seeds 1, 2, 3 ... Writes tests/analysis/null_studies.csv (ANOVA on participants' means, pooled
# ANOVA), null_studies_mixed.csv (mixed model) and null_studies_words.csv (mixed models of a factor of
# words and of its interaction), one row per seed, and prints the rates. Seeds that the files hold
# already are not run again, so that an interrupted run goes on. A mixed model takes a second, one of
# an interaction some ten.
# SPDX-License-Identifier: MIT

words <- commandArgs(trailingOnly = TRUE)
root <- normalizePath(words[1], mustWork = TRUE)
count_after <- function(flag, default) {
  at <- match(flag, words)
  if (is.na(at)) default else as.integer(words[at + 1])
}
invisible(Sys.setlocale("LC_ALL", "C.UTF-8"))
for (file in list.files(file.path(root, "analysis/R"), "[.]R$", full.names = TRUE)) source(file)
source(file.path(root, "tests/analysis/synthetic_study.R"))
source(file.path(root, "tests/analysis/null_model.R"))
source(file.path(root, "tests/analysis/seed_table.R"))

folder <- file.path(root, "tests/analysis")
means <- complete_table(file.path(folder, "null_studies.csv"), count_after("--means", 2000),
  null_means_row)
mixed <- complete_table(file.path(folder, "null_studies_mixed.csv"), count_after("--mixed", 200),
  null_mixed_row)
of_words <- complete_table(file.path(folder, "null_studies_words.csv"), count_after("--words", 200),
  null_words_row)
rates <- rbind("ANOVA on means" = rejection_rate(means$anova_p),
  "pooled ANOVA" = rejection_rate(means$pooled_p), "mixed model" = rejection_rate(mixed$mixed_p),
  "mixed model of words" = rejection_rate(of_words$kind_p),
  "its interaction" = rejection_rate(of_words$cells_p))
print(rates)
print(table(mixed$random))
print(table(of_words$kind_random, of_words$cells_random))
