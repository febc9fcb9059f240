# The figure of a trade: its curves and its frontier, from rows whose answer is known.
# SPDX-License-Identifier: MIT
library(testthat)

trade_functions <- function() {
  functions <- new.env()
  sys.source(file.path(root, "analysis/trade.R"), functions)
  functions
}

# Two kinds, two levels, two reductions; 10 pairs a step. Times in microseconds a pair.
trade_rows <- function() {
  row <- function(kind, level, reduction, measure, statistic, reference, value) {
    data.frame(part = "impacts", subject = "a x a", kind = kind, level = level,
      reduction = reduction, scheduler = "", traversal = "", budget = NA, measure = measure,
      unit = "", reference = reference, statistic = statistic, n = 10, value = value, low = NA,
      high = NA, by_clock = FALSE)
  }
  times <- list(box = c(1, 4), octree = c(0.5, 2))
  normals <- list(box = c(20, 0), octree = c(30, 10))
  rows <- do.call(rbind, lapply(names(times), function(kind) {
    do.call(rbind, lapply(1:2, function(i) rbind(
      row(kind, i - 1, "", "gap_seen", "p95", "exact", 100 / i),
      do.call(rbind, lapply(c("average", "groups"), function(reduction) {
        dearer <- if (reduction == "groups") 2 else 1
        rbind(row(kind, i - 1, reduction, "pair_time", "mean", "", times[[kind]][i] * dearer),
          row(kind, i - 1, reduction, "normal_error", "median", "exact", normals[[kind]][i]),
          row(kind, i - 1, reduction, "normal_error", "median", "finest", 0),
          row(kind, i - 1, reduction, "linear_error", "median", "exact", 0.5 / i))
      })))))
  }))
  pairs <- rows[1, ]
  pairs[c("part", "kind", "level", "measure", "statistic", "value")] <-
    list("scene", "", NA, "pairs_refined", "p95", 10)
  rbind(pairs, rows)
}

test_that("a curve has each level once, with the reduction that errs least and then the quickest", {
  trade <- trade_functions()
  rows <- trade_rows()
  options <- trade$options_of(trade$impacts_of(rows), trade$kPanels[1, ], trade$pairs_of(rows))
  expect_equal(nrow(options), 8)
  best <- trade$best_of_each_level(options)
  expect_equal(best$kind, c("box", "box", "octree", "octree"))
  expect_equal(best$ms, c(1, 4, 0.5, 2) * 10 / 1000)
  expect_equal(best$error, c(20, 0.1, 30, 10))  # nothing is drawn as the least that matters
})

test_that("the frontier has what nothing beats, and goes on to the right", {
  trade <- trade_functions()
  options <- data.frame(ms = c(1, 2, 3, 4), error = c(5, 6, 2, 2), title = "x")
  frontier <- trade$frontier_of(options, 100)
  expect_equal(frontier$ms, c(1, 3, 100))
  expect_equal(frontier$error, c(5, 2, 2))
})

test_that("the script writes both files beside the table, and refuses what is no table", {
  folder <- new_folder()
  dir.create(folder)
  table <- file.path(folder, "trade.csv")
  utils::write.csv(trade_rows(), table, row.names = FALSE, na = "")
  expect_equal(run_script("trade.R", table)$status, 0)
  expect_true(all(file.exists(file.path(folder, c("trade.svg", "trade.pdf")))))
  none <- run_script("trade.R", file.path(folder, "none.csv"))
  expect_equal(none$status, 2)
  expect_match(none$stderr[1], "none.csv: expected the table of a trade, got no such file")
})
