# analysis/README.md says what every column of every view means.
# SPDX-License-Identifier: MIT
library(testthat)

# The part of the page about a view: from "`view`:" to the next such line or heading.
documented_part <- function(page, view) {
  from <- which(startsWith(page, paste0("`", view, "`:")))
  expect_length(from, 1)
  ends <- which(grepl("^(`[a-z_]+`:|## )", page))
  paste(page[from:(min(ends[ends > from]) - 1)], collapse = "\n")
}

test_that("the page names every view and every column of it", {
  study <- new_study(tempfile(fileext = ".sqlite"))
  on.exit(DBI::dbDisconnect(study))
  page <- readLines(file.path(root, "analysis/README.md"), encoding = "UTF-8")
  views <- DBI::dbGetQuery(study, "SELECT name FROM sqlite_master WHERE type = 'view'")$name
  expect_gt(length(views), 10)
  for (view in views) {
    columns <- DBI::dbGetQuery(study, sprintf("SELECT name FROM pragma_table_info('%s')", view))$name
    named <- vapply(paste0("`", columns, "`"), grepl, NA, documented_part(page, view), fixed = TRUE)
    expect_equal(columns[!named], character(), info = view)
  }
})

source(file.path(root, "tests/analysis/view_columns.R"))

test_that("the tables of columns are those of the schema's comments, and leave none out", {
  page <- readLines(file.path(root, "analysis/README.md"), encoding = "UTF-8")
  made <- view_page(root)
  expect_equal(with_view_page(page, made), page,
    info = "Rscript tests/analysis/view_columns.R . writes them anew")
  study <- new_study(tempfile(fileext = ".sqlite"))
  on.exit(DBI::dbDisconnect(study))
  views <- DBI::dbGetQuery(study, "SELECT name FROM sqlite_master WHERE type = 'view'")$name
  for (view in views) {
    from <- which(made == sprintf("### `%s`", view))
    rows <- made[from:length(made)]
    rows <- rows[seq_len(c(which(startsWith(rows[-1], "### ")), length(rows))[1])]
    named <- sub("^\\| `(\\w+)` .*", "\\1", grep("^\\| `", rows, value = TRUE))
    expect_equal(named, DBI::dbGetQuery(study, sprintf("SELECT name FROM pragma_table_info('%s')",
      view))$name, info = view)
  }
  expect_equal(grep("|  |", made, fixed = TRUE, value = TRUE), character())
})

# The code blocks of a language under the heading of queries.
queries_in <- function(page, language) {
  page <- page[which(page == "## Queries to begin with"):which(page == "## The tests")]
  starts <- which(page == paste0("```", language))
  lapply(starts, function(start) page[(start + 1):(start + min(which(page[-seq_len(start)] == "```")) - 1)])
}

# A result as text, a row to a line, numbers alike whatever language they came from.
as_rows <- function(result) {
  result <- as.data.frame(as.list(do.call(data.frame, unclass(result))))
  vapply(seq_len(nrow(result)), function(i) paste(vapply(result, function(column) {
    number <- suppressWarnings(as.numeric(column[i]))
    if (is.na(number)) as.character(column[i]) else format(round(number, 4), nsmall = 4)
  }, ""), collapse = " | "), "")
}

test_that("the queries of the page give the same rows in SQL, R and Python", {
  trials <- causality_trials(51, participants = 3, repetitions = 1)
  trials$late_timed_frames <- rep_len(c(0, 2, 1), nrow(trials))
  path <- write_study(tempfile(fileext = ".sqlite"), trials, practice = 1)
  add_exclusion(add_exclusion(path, "P03", NA, "asked to"), "P01", 1, "a fly")
  add_collisions(path, data.frame(trial = seq_len(nrow(trials)), step = 1, level = trials$delay_ms /
    100, gap_arcmin = seq_len(nrow(trials)) / 7, hidden_share = 0))
  page <- readLines(file.path(root, "analysis/README.md"), encoding = "UTF-8")
  sql <- queries_in(page, "sql")
  r <- queries_in(page, "r")
  python <- queries_in(page, "python")
  expect_equal(c(length(sql), length(r), length(python)), c(3, 3, 3))
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  on.exit(DBI::dbDisconnect(study))
  expected <- lapply(sql, function(lines) as_rows(DBI::dbGetQuery(study, paste(lines, collapse = "\n"))))
  expect_equal(lengths(expected), c(3, 3, 3))
  for (i in 1:3) {
    scope <- new.env()
    scope$study <- study
    eval(parse(text = r[[i]]), scope)
    expect_equal(as_rows(scope$result), expected[[i]], info = paste("R", i))
  }
  skip_if(Sys.which("python3") == "", "Python is not installed")
  for (i in 1:3) {
    script <- tempfile(fileext = ".py")
    writeLines(c("import sqlite3, sys", "study = sqlite3.connect(sys.argv[1])", python[[i]],
      "for row in result: print('\\t'.join(str(cell) for cell in row))"), script)
    rows <- system2("python3", shQuote(c(script, path)), stdout = TRUE)
    cells <- do.call(rbind, strsplit(rows, "\t", fixed = TRUE))
    expect_equal(as_rows(as.data.frame(cells)), expected[[i]], info = paste("Python", i))
  }
})
