# Study 5: planted shapes are called by their names, and by no other.
# SPDX-License-Identifier: MIT
library(testthat)

# Collisions at random places; each scheduler's list is planted as the expected shapes say.
planted_collisions <- function(seed, n = 2000) {
  set.seed(seed)
  rows <- lapply(c("size", "velocity", "eccentricity", "gap", "projected-centres",
    "collision-speed"), function(scheduler) {
    depth <- runif(n, 1, 3)
    speed <- rexp(n, depth / 10)
    eccentricity <- runif(n, 0, 20)
    score <- switch(scheduler, size = -depth, velocity = -speed, eccentricity = -eccentricity,
      gap = rnorm(n), "projected-centres" = rnorm(n) - depth,
      "collision-speed" = rnorm(n) - 0.1 * depth)
    data.frame(scheduler = scheduler, distance_m = depth, speed_deg_s = speed,
      eccentricity_deg = eccentricity, high = score > median(score))
  })
  rows <- do.call(rbind, rows)
  rows$scheduler <- factor(rows$scheduler, unique(rows$scheduler))
  rows
}

distribution_file <- function(collisions) {
  schedulers <- levels(collisions$scheduler)
  path <- write_study(tempfile(fileext = ".sqlite"), data.frame(participant = "S01",
    repetition = 1, scheduler = schedulers, rating = 1), protocol = "scheduler-distribution")
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "DELETE FROM rating")
  DBI::dbDisconnect(study)
  add_collisions(path, data.frame(trial = as.integer(collisions$scheduler),
    step = seq_len(nrow(collisions)), level = 0, list = ifelse(collisions$high, 0, 1),
    collisions[names(kPlaces)]))
}

test_that("the best cut is that of trying every cut", {
  set.seed(601)
  for (i in 1:20) {
    x <- sample(1:8, 30, replace = TRUE)
    high <- runif(30) < x / 9
    cuts <- vapply(0:8, function(cut) mean((x <= cut) == high), 0)
    expect_equal(best_cut(x, high), max(cuts, 1 - cuts))
  }
})

test_that("a line's change over the middle nine tenths is the planted one", {
  x <- seq(0, 1, length.out = 1001)
  expect_equal(shape_of(x, 0.2 + 0.5 * x)[["change"]], 0.45)
})

test_that("every planted shape is met, and a wrong one is not", {
  planted <- planted_collisions(602)
  sentences <- shape_sentences(shape_table(planted))
  expect_length(sentences, length(kExpectedShapes))
  expect_true(all(grepl("is met", sentences)))
  # The lists of size and eccentricity changed over: no step in depth, a step where flat was expected.
  planted$scheduler <- factor(c(size = "eccentricity", eccentricity = "size")[
    as.character(planted$scheduler)])
  wrong <- shape_sentences(shape_table(planted[!is.na(planted$scheduler), ]))
  expect_true(all(grepl("is NOT met", wrong)))
  expect_match(wrong[1], "^size: a step over depth was expected and is NOT met \\(the best cut puts")
})

test_that("histograms hold every collision of a bin once, and shares their counts", {
  planted <- planted_collisions(603, n = 300)
  bins <- histogram_table(planted)
  depth <- bins[bins$place == "distance_m" & bins$scheduler == "gap", ]
  gap <- planted[planted$scheduler == "gap", ]
  edges <- c(depth$middle - depth$width / 2, max(depth$middle + depth$width / 2))
  expect_equal(depth$high, as.vector(table(cut(gap$distance_m[gap$high], edges,
    include.lowest = TRUE, right = FALSE))))
  expect_equal(depth$share, ifelse(depth$high + depth$low > 0,
    depth$high / (depth$high + depth$low), NA))
})

test_that("the script's page has the shapes, figures of a page's width and every bin as a file", {
  path <- distribution_file(planted_collisions(604, n = 400))
  out <- new_folder()
  run <- run_script("scheduler-distribution.R", path, "--out", out)
  expect_equal(run$status, 0)
  at <- function(folder, name) file.path(out, folder, paste0("scheduler-distribution-distribution-", name))
  expect_true(all(file.exists(at("figures", c("histograms.svg", "shares.pdf")))))
  expect_match(readLines(at("figures", "histograms.svg"), n = 3), sprintf("width=\"%d", floor(183 / 25.4 * 72)),
    all = FALSE)
  expect_equal(nrow(read.csv(at("tables", "shapes.csv"))), 18)
  expect_equal(nrow(read.csv(at("tables", "bins.csv"))), 18 * kBins)
  page <- paste(readLines(file.path(out, "report.html"), encoding = "UTF-8"), collapse = " ")
  expect_match(page, "High and low priority share 50 : 50 ± 2 % for every scheduler.", fixed = TRUE)
  expect_match(page, "nothing is tested", fixed = TRUE)
  # Without collisions, or in data of before, which did not keep their places, nothing is said of them.
  empty <- write_study(tempfile(fileext = ".sqlite"), data.frame(participant = "S01",
    repetition = 1, scheduler = "size", rating = 1), protocol = "scheduler-distribution")
  expect_null(distribution_results(empty, "scheduler-distribution"))
  expect_null(distribution_results(path, "gap"))
})

test_that("collisions with a face of the view are out and counted, for no list is made for them", {
  planted <- planted_collisions(605, n = 200)
  path <- distribution_file(planted)
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "UPDATE collision SET body_b = 'wall right' WHERE step % 4 = 0")
  DBI::dbDisconnect(study)
  found <- placed_collisions(path, "scheduler-distribution")
  expect_equal(found$walls, nrow(planted) / 4)
  expect_equal(nrow(found$collisions), nrow(planted) * 3 / 4)
  expect_true(paste("Left out: 300 collisions with a face of the view, which no list is made for.")
    %in% distribution_sentences(found))
})

test_that("schedulers stand in the order of the thesis, the projected gap under either name", {
  planted <- planted_collisions(606, n = 50)
  planted$scheduler <- factor(planted$scheduler, c("projected-centres", "collision-speed", "gap",
    "eccentricity", "size", "velocity"))
  found <- placed_collisions(distribution_file(planted), "scheduler-distribution")
  expect_equal(levels(found$collisions$scheduler), c("size", "velocity", "eccentricity", "gap",
    "projected-centres", "collision-speed"))
})

test_that("a shape that geometry rules out is NOT met and the reason stands beside it", {
  row <- data.frame(scheduler = "eccentricity", place = "distance_m", change = -0.24, step = 0.6)
  reason <- Find(function(shape) shape[[1]][1] == "eccentricity", kExpectedShapes)[[4]]
  expect_equal(shape_sentence(row, "flat", reason), paste("eccentricity: a flat share over depth was",
    "expected and is NOT met (the share changes by −0.24 from the 5th to the 95th percentile, ±0.10",
    "is flat). Depth is the distance from the eye: the farthest places are the far face's corners,",
    "and near the eye a body's own size keeps it from the edges."))
  expect_no_match(shape_sentence(transform(row, change = 0.01), "flat", reason), "Depth is")
})
