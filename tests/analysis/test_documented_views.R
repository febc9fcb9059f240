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
