# How often the intervals that the analysis prints hold a planted truth. The tables beside were made
# by coverage_studies.R, whose seeds are 1, 2, 3 ...; what they say is reported as found, here and in
# analysis/README.md.
# SPDX-License-Identifier: MIT
library(testthat)

for (file in c("null_model.R", "coverage_model.R", "coverage_rates.R")) {
  source(file.path(root, "tests/analysis", file))
}
folder <- file.path(root, "tests/analysis")
coverage_table <- function(name) read.csv(file.path(folder, sprintf("coverage_%s.csv", name)))
tables <- sub("^coverage_(.*)[.]csv$", "\\1", list.files(folder, "^coverage_.*[.]csv$"))

# The rates of a table's columns, in their order.
rates_of <- function(table, columns) {
  rates <- coverage_rates(folder)
  rates <- rates[rates$table == table, ]
  rates[match(columns, rates$column), ]
}

test_that("the quick ANOVA's row is the analysis's own", {
  for (seed in 1:2) {
    set.seed(seed)
    means <- normal_means(slope_sd = 0.3)$means
    trials <- data.frame(participant = rownames(means)[row(means)], rating = as.vector(means),
      delay_ms = factor(kDelaysMs[col(means)]))
    columns <- c("statistic", "df1", "df2", "effect_size", "interval_low", "interval_high")
    expect_equal(quick_anova_row(means)[columns],
      repeated_measures_tests(trials, "delay_ms")$rows[columns], tolerance = 1e-6)
  }
})

test_that("the integrated truths are those of many participants", {
  set.seed(1)
  eta <- rnorm(2e5, 0.4, 0.9)
  rating <- 1 + rowSums(outer(eta + rlogis(2e5), kFivePointCuts, ">"))
  expect_lt(abs(mean(rating) - mean_rating(0.4, 0.9, kFivePointCuts)), 4 * sd(rating) / sqrt(2e5))
  # Of 20,000 participants the estimate's own standard error is below .005.
  for (slope_sd in c(0, 0.3)) {
    row <- quick_anova_row(normal_means(slope_sd, participants = 2e4)$means)
    expect_lt(abs(row$effect_size - generalised_truth(slope_sd)), 0.015)
  }
})

test_that("the committed tables are those of their seeds", {
  again <- function(name, seeds) for (seed in seeds) {
    expect_equal(unlist(kCoverageTables[[name]]$row_of(seed)),
      unlist(coverage_table(name)[seed, ]), tolerance = 1e-5, info = paste(name, seed))
  }
  expect_equal(setdiff(tables, names(kCoverageTables)), character())
  for (name in tables) {
    rows <- coverage_table(name)
    expect_equal(rows$seed, seq_len(nrow(rows)), info = name)
  }
  again("means", c(1, 77, nrow(coverage_table("means"))))
  again("bootstrap", 2)
  again("gains", 3)
})

test_that("the README has the coverages of these tables", {
  lines <- coverage_lines(coverage_rates(folder))
  message(paste(lines, collapse = "\n"))
  readme <- readLines(file.path(root, "analysis/README.md"), encoding = "UTF-8")
  expect_equal(setdiff(lines, readme), character())
})

test_that("t intervals over participants, and bars of compound symmetry, hold .93 to .97", {
  rates <- rates_of("means", c("mean", "contrast", "bar_own", "bar_difference"))
  expect_true(all(rates$rate >= 0.93 & rates$rate <= 0.97), info = coverage_lines(rates))
  equivalence <- rates_of("means", "equivalence")$rate
  expect_true(equivalence >= 0.88 && equivalence <= 0.92)  # of .90
})

test_that("intervals of eta squared, of nominal .90, hold .87 to .93", {
  rates <- rates_of("means", c("eta_between", "eta_even", "eta_sloped"))
  expect_true(all(rates$rate >= 0.87 & rates$rate <= 0.93), info = coverage_lines(rates))
})

test_that("bars are for comparisons that differ equally between participants, and for no others", {
  rates <- rates_of("means", c("bar_population", "bar_sloped_100", "bar_sloped_300"))
  expect_lt(rates$rate_high[1], 0.93)
  expect_gt(rates$rate_low[2], 0.97)
  # Wide enough by chance: the errors of a trial's rating are a large share of each mean.
  expect_true(rates$rate[3] >= 0.90 && rates$rate[3] <= 0.97)
})

# Fewer studies say less: what they show is not outside .93 to .97.
expect_no_contradiction <- function(rates) {
  expect_true(all(rates$rate_low <= 0.97 & rates$rate_high >= 0.93), info = coverage_lines(rates))
}

test_that("the bootstrap over participants holds .93 to .97", {
  rates <- coverage_rates(folder)
  rates <- rates[rates$table == "bootstrap", ]
  expect_equal(rates$studies, c(400, 400))
  expect_true(all(rates$rate >= 0.93 & rates$rate <= 0.97), info = coverage_lines(rates))
})

test_that("odds ratios, rate ratios, thresholds and gains do not contradict .93 to .97", {
  for (table in c("ratios", "functions", "threshold_means")) {
    rates <- coverage_rates(folder)
    rates <- rates[rates$table == table, ]
    expect_gte(min(rates$studies), 100)
    expect_no_contradiction(rates)
  }
  expect_gte(min(coverage_rates(folder)$studies[coverage_rates(folder)$table == "odds"]), 100)
  expect_no_contradiction(rates_of("odds", c("100", "300")))
  expect_no_contradiction(rates_of("gains", c("bad", "difference")))
})

test_that("the costly rows come out again (slow)", {
  skip_if_not(run_slow, "--slow not given")
  for (name in intersect(c("odds", "ratios", "functions", "threshold_means"), tables)) {
    row <- kCoverageTables[[name]]$row_of(1)
    numbers <- names(row)[vapply(row, is.numeric, NA)]
    expect_equal(unlist(row[numbers]), unlist(coverage_table(name)[1, numbers]),
      tolerance = 0.01, info = name)  # an optimiser's end
  }
  means <- coverage_table("means")
  expect_equal(do.call(rbind, lapply(means$seed, coverage_means_row)), means)
})
