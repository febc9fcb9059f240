# Tables of made-up studies, one row per seed, that an interrupted run adds to.
# SPDX-License-Identifier: MIT

# Adds the rows of seeds 1 to `count` that the file lacks, one by one; all rows.
complete_table <- function(path, count, row_of) {
  done <- if (file.exists(path)) read.csv(path)$seed
  for (seed in setdiff(seq_len(count), done)) {
    row <- row_of(seed)
    row[] <- lapply(row, function(x) if (is.numeric(x)) signif(x, 6) else x)
    write.table(row, path, sep = ",", append = file.exists(path), col.names = !file.exists(path),
      row.names = FALSE)
  }
  read.csv(path)
}
