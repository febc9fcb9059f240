# The report of any study: what it is made of, what it says, and that it never falls over.
# SPDX-License-Identifier: MIT
library(testthat)

# Makes the report of the study at `path` in a new folder; list(folder, page), the page as one text.
made_report <- function(path) {
  folder <- new_folder()
  dir.create(file.path(folder, "data"), recursive = TRUE)
  suppressMessages({
    write_report_data(path, file.path(folder, "data"))
    write_study_report(folder)
  })
  page <- paste(readLines(file.path(folder, "report.html"), encoding = "UTF-8"), collapse = "\n")
  expect_sound_page(page)
  list(folder = folder, page = page)
}

# Whole, self-contained and finite.
expect_sound_page <- function(page) {
  for (tag in c("table", "figure", "svg", "p", "ul", "li", "h2", "h3", "h4", "td")) {
    count <- function(pattern) lengths(regmatches(page, gregexpr(pattern, page)))
    expect_equal(count(sprintf("<%s[ >]", tag)), count(sprintf("</%s>", tag)), info = tag)
  }
  ids <- regmatches(page, gregexpr(" id=\"[^\"]*\"", page))[[1]]
  expect_false(any(duplicated(ids)))
  expect_false(grepl("<script|<link|<img|src=|@import|href=\"[^#]", page))
  words <- gsub("<svg.*?</svg>", "", page)
  expect_false(grepl("\\b(NaN|Inf|NULL|NA)\\b", words))
}

expect_says <- function(report, ...) {
  for (words in c(...)) expect_match(report$page, words, fixed = TRUE, all = FALSE)
}

# Delay and, where asked for, speed; one viewpoint, so that its models take seconds.
few_trials <- function(seed, participants, speeds = 5) {
  trials <- causality_trials(seed, participants, repetitions = 2)
  trials[trials$viewpoint_deg == 0 & trials$speed_deg_s %in% speeds, ]
}

# Two kinds of scheduling at one number of bodies.
few_gaze_trials <- function(seed, participants) {
  trials <- gaze_trials(seed, participants)
  trials[trials$scheduling %in% c("tracked", "all-bad") & trials$bodies == 5, ]
}

small_study <- function(trials, ...) write_study(tempfile("study", fileext = ".sqlite"), trials, ...)

data_folder_of <- function(path) {
  folder <- tempfile()
  dir.create(folder)
  write_report_data(path, folder)
}

test_that("words stay words, whatever they hold", {
  expect_equal(html_text("<b a=\"1\" c='2'>&amp;\n"),
    "&lt;b a=&quot;1&quot; c=&#39;2&#39;&gt;&amp;amp; ")
  hostile <- "<script>|`x`*[y](z)\\&lt;"
  shown <- html_paragraphs(as_typed(hostile))
  expect_false(grepl("<", gsub("^<p>|</p>$", "", shown)))
  # What a browser makes of it is what was typed, in a sentence and in a cell.
  back <- function(html) {
    gsub("&amp;", "&", gsub("&lt;", "<", gsub("&gt;", ">", gsub("</?(p|td)>", "", html))), fixed = TRUE)
  }
  expect_equal(back(shown), hostile)
  cells <- html_of_lines(markdown_table(c("a", "b"), paste(as_typed(hostile), "| 1")))
  expect_true(hostile %in% back(cells))
  expect_equal(html_paragraphs("p < .001 and `impetus run` & more"),
    "<p>p &lt; .001 and <code>impetus run</code> &amp; more</p>")
})

test_that("an effect's factors are called by their labels, each once, or by their names as words are", {
  withr::local_options(impetus.labels = c(speed_percent = "Speed at a level (x.y)", level = "Level of the tree"),
    impetus.levels = list(level = c("0", "4"), speed_percent = "50", viewpoint_deg = "0"))
  expect_equal(effect_words(c("speed_percent: 50 against 0", "level × viewpoint_deg", "my.level: 1")),
    c("speed at a level: 50 against 0", "level of the tree × viewpoint", "my.level: 1"))
})

test_that("what was shown by condition stands in the protocol's order", {
  rows <- data.frame(participant = "P01", trial = 1:4, level = 0, stopped = "finest", gap_arcmin = 1,
    hidden_share = 0, away_deg = NA, spun = 0)
  levels <- data.frame(trial = 1:4, factor = rep(c("b", "a"), each = 4), of = c("y", "x", "y", "x",
    "2", "10", "2", "10"))
  withr::local_options(impetus.levels = list(b = c("y", "x"), a = c("2", "10")))
  table <- levels_by_factor(rows, levels)
  expect_equal(table$level, c("y", "x", "2", "10"))
})

test_that("the report's tables hold what the views hold, and give it back", {
  trials <- causality_trials(31, participants = 2, repetitions = 1)
  trials$participant <- c("007", "NA")[factor(trials$participant)]
  path <- add_exclusion(small_study(trials), "NA", NA, "a \"quoted\",\nreason")
  folder <- tempfile()
  dir.create(folder)
  write_report_data(path, folder)
  again <- study_of_report_data(folder)
  for (view in names(kReportViews)) {
    columns <- utils::read.csv(file.path(folder, "columns.csv"))
    names <- paste(columns$column[columns$view == view], collapse = ", ")
    where <- kReportViews[[view]]$where
    ask <- sprintf("SELECT %s FROM %s%s", names, view,
      if (is.null(where)) "" else paste(" WHERE", where))
    first <- query_study(path, ask)
    second <- query_study(again, ask)
    expect_equal(nrow(second), nrow(first), info = view)
    for (column in names(first)) {
      expect_equal(as.character(second[[column]]), as.character(first[[column]]),
        info = paste(view, column))
    }
  }
  expect_setequal(query_study(again, "SELECT DISTINCT participant FROM rated_trial")$participant,
    c("007", "NA"))
})

test_that("a figure of two factors shows every cell, also where a factor is called level or mean", {
  trials <- gap_trials(71, participants = 4, repetitions = 1)
  trials$mean <- trials$speed_percent
  trials$speed_percent <- NULL
  path <- small_study(trials, protocol = "gap")
  part <- parts_of_protocol(path, "gap")[[1]]
  expect_setequal(part$factors, c("level", "viewpoint_deg", "factor_mean"))
  expect_no_warning(figures <- figures_of_part(part))
  for (figure in figures) {
    for (layer in seq_along(figure$plot$layers)) {
      expect_no_warning(drawn <- ggplot2::layer_data(figure$plot, layer))
      expect_true(all(is.finite(drawn$x)), info = figure$name)
    }
    points <- ggplot2::layer_data(figure$plot, length(figure$plot$layers))
    expect_equal(nrow(points), if (grepl("-and-", figure$name)) 9 else 3, info = figure$name)
  }
})

test_that("a factorial study of ratings is recognised and reported whole", {
  trials <- few_trials(32, participants = 5, speeds = c(5, 15))
  trials$late_timed_frames <- ifelse(trials$participant == "P02" & trials$delay_ms == 0, 2, 0)
  path <- add_exclusion(small_study(trials, practice = 2), "P01", 1, "<i>coughed</i> & left")
  report <- made_report(path)
  expect_says(report, "&lt;i&gt;coughed&lt;/i&gt; &amp; left", "Delay (ms)", "Speed (°/s)",
    "SIMULATED", "ratings depended on delay", "Odds ratios of a higher rating",
    "Greenhouse–Geisser", "proportional odds", "without trials with late frames",
    "with what was excluded", "probit", "81 of each of 20 participants",
    "it rejected in 45 % of 2,000", "Christensen", "R version",
    "In this folder", "50.0 × 30.0 cm (1920 × 1080 pixels, 60 Hz)")
  stems <- list.files(file.path(report$folder, "figures"))
  expect_setequal(sub("[.][a-z]+$", "", stems), paste0("causality-rating-by-", c("delay_ms",
    "speed_deg_s", "delay_ms-and-speed_deg_s")))
  expect_equal(sum(endsWith(stems, ".svg")), sum(endsWith(stems, ".pdf")))
  expect_equal(lengths(regmatches(report$page, gregexpr("<svg ", report$page))), 3)
  # 85 mm in points, the width of a journal's column.
  svg <- readLines(file.path(report$folder, "figures", stems[grepl("svg$", stems)][1]), n = 3)
  width_pt <- as.numeric(sub(".*width=\"([0-9.]+)pt?\".*", "\\1", grep("<svg", svg, value = TRUE)))
  expect_equal(width_pt, 85 / 25.4 * 72, tolerance = 0.01)
  tests <- read.csv(file.path(report$folder, "tables/causality-rating-tests.csv"))
  expect_true(all(c("mixed model, effects", "equivalence", "Friedman") %in% tests$family))

  # The same from its own data, figures and numbers alike.
  again <- new_folder()
  result <- run_script("report.R", file.path(report$folder, "data"), "--out", again)
  expect_equal(result$status, 0L, info = paste(result$stderr, collapse = "\n"))
  for (file in c("report.html", list.files(report$folder, "[.](csv|svg)$", recursive = TRUE))) {
    expect_equal(readLines(file.path(again, file)), readLines(file.path(report$folder, file)),
      info = file)
  }
})

test_that("the words print each test's own p and the corrected one, as the table has them", {
  report <- made_report(small_study(few_trials(47, participants = 5, speeds = c(5, 15))))
  tests <- read.csv(file.path(report$folder, "tables/causality-rating-tests.csv"))
  effects <- tests[tests$family == kEffectsFamily, ]
  expect_equal(effects$effect, c("delay_ms", "speed_deg_s"))
  for (i in 1:2) {
    printed <- chi_squared_words(effects[i, ])
    expect_match(printed, "Holm-corrected p")
    expect_says(report, html_text(printed))
  }
})

test_that("each factor's own slope is in the model that tests it", {
  trials <- causality_trials(33, participants = 8, repetitions = 1)
  columns <- c("delay_ms", "speed_deg_s")
  trials[columns] <- lapply(trials[columns], factor)
  fitted <- suppressMessages(factor_tests(trials, columns))
  rated <- transform(trials, rating = factor(rating, ordered = TRUE))
  alone <- model_tests(fit_models(rated, columns, "delay_ms"), rated, columns)
  of_delay <- function(result) result$rows[result$rows$effect == "delay_ms", c("statistic", "df1", "p")]
  expect_equal(of_delay(fitted), of_delay(alone), tolerance = 1e-3)
  # Fitted shares are those of ordinal's own fitted values.
  model <- fitted$models$delay_ms$full
  expect_lt(largest_misfit(model, fitted$trials, "delay_ms"), 0.2)
})

test_that("one participant is described, without a test", {
  report <- made_report(small_study(few_trials(34, participants = 1)))
  expect_says(report, "One participant: the figure and the means describe; no inferential test was made.",
    "No test was made.", "Mean rating by delay (ms): 0: ")
  expect_says(report, "data are described; no test across participants was made")
  expect_false(grepl("cumulative-link mixed models (logit link", report$page, fixed = TRUE))
})

test_that("ratings that are all equal are a clear sentence", {
  trials <- few_trials(35, participants = 3)
  trials$rating <- 2
  report <- made_report(small_study(trials))
  expect_says(report, "Every rating was 2: nothing varies, so no test was made.")
})

test_that("complete separation leaves the tests of means", {
  trials <- few_trials(36, participants = 4)
  trials$rating <- match(trials$delay_ms, kDelaysMs)
  report <- made_report(small_study(trials))
  expect_says(report, "separate the ratings completely", "Friedman")
})

test_that("a study in progress, and one that has only begun, are told as such", {
  trials <- few_trials(37, participants = 3)
  trials$rating[trials$participant == "P03"][4:6] <- NA
  report <- made_report(small_study(trials))
  expect_says(report, "The study is in progress: 1 participant has not finished", "in progress",
    "participants who have finished")
  trials$rating <- NA
  report <- made_report(small_study(trials))
  expect_says(report, "There are no answers of the main phase to analyse: none yet", "enrolled")
})

test_that("a study of which everything is excluded says so", {
  path <- small_study(few_trials(38, participants = 1))
  report <- made_report(add_exclusion(path, "P01", NA, "asked to"))
  expect_says(report, "got only catch trials and excluded ones", "asked to")
})

test_that("clicks are counted, and nobody clicking is a clear sentence", {
  trials <- few_gaze_trials(39, participants = 4)
  report <- made_report(write_gaze_study(tempfile(fileext = ".sqlite"), trials))
  expect_says(report, "Clicks per second by scheduling", "Rate ratios", "Gaze from a simulated eye")
  trials$clicks <- 0
  report <- made_report(write_gaze_study(tempfile(fileext = ".sqlite"), trials))
  expect_says(report, "Nobody clicked, so there is nothing to test.")
})

test_that("gaze that is missing in some trials, or in all, is told", {
  trials <- few_gaze_trials(43, participants = 2)
  trials$gaze_source <- ifelse(trials$participant == "P01", NA, "simulated eye")
  trials$gaze_latency_p95_ms <- NA
  report <- made_report(write_gaze_study(tempfile(fileext = ".sqlite"), trials))
  expect_says(report, "Gaze from a simulated eye in 6 trials of 1 participant",
    "Gaze was not followed in 6 trials of 1 participant.", "No latency from sample to flip is known.")
  trials$gaze_source <- NA
  report <- made_report(write_gaze_study(tempfile(fileext = ".sqlite"), trials))
  expect_says(report, "The gaze was not followed.")
})

test_that("thresholds are found by the number of levels, and each function is told", {
  answers <- gap_answers(40, participants = 3)
  report <- made_report(write_threshold_study(tempfile(fileext = ".sqlite"),
    answers[answers$distractors == 0, ], "anything"))
  expect_says(report, "Thresholds of gap (′)", "Each participant&#39;s function", "guess rate of 0",
    "parametric bootstrap", "Hierarchical model")
})

test_that("a level that a track chose makes a threshold, however few there were", {
  trials <- gap_answers(44, participants = 2)
  trials <- trials[trials$gap_arcmin %in% c(5, 20, 80) & trials$eccentricity_deg == 0, ]
  path <- write_threshold_study(tempfile(fileext = ".sqlite"), trials, "anything")
  study <- DBI::dbConnect(RSQLite::SQLite(), path)
  DBI::dbExecute(study, "UPDATE trial SET track = json_extract(condition, '$.distractors')")
  DBI::dbDisconnect(study)
  part <- parts_of_protocol(study_of_report_data(data_folder_of(path)), "anything")[[1]]
  expect_equal(part$response, "threshold")
  expect_equal(part$axis, "gap_arcmin")
  expect_true(part$log10)
})

test_that("yes or no at few levels is modelled as one of two", {
  trials <- gap_answers(41, participants = 6)
  trials <- trials[trials$gap_arcmin %in% c(10, 20) & trials$distractors == 0, ]
  report <- made_report(write_threshold_study(tempfile(fileext = ".sqlite"), trials, "anything"))
  expect_says(report, "Answers yes or no", "Odds ratios of a positive answer", "Share answered yes by",
    "answers depended on gap", "Pearson")
})

test_that("answers that are all alike are a clear sentence", {
  trials <- gap_answers(45, participants = 3)
  trials <- trials[trials$gap_arcmin %in% c(10, 20), ]
  trials$positive <- 1
  report <- made_report(write_threshold_study(tempfile(fileext = ".sqlite"), trials, "anything"))
  expect_says(report, "Every answer was alike: nothing varies, so no test was made.")
  report <- made_report(write_threshold_study(tempfile(fileext = ".sqlite"), transform(
    gap_answers(46, participants = 2, n = 2), positive = 1), "anything"))
  expect_says(report, "No participant has a threshold yet.")
})

test_that("a factor named as a column of the trials keeps its own column", {
  trials <- causality_trials(42, participants = 3, repetitions = 1)
  names(trials)[names(trials) == "speed_deg_s"] <- "slot"
  trials$rating[] <- rep_len(1:3, nrow(trials))
  part <- parts_of_protocol(study_of_report_data(data_folder_of(small_study(trials))), "causality")[[1]]
  expect_setequal(unname(part$factors), c("delay_ms", "factor_slot", "viewpoint_deg"))
  expect_setequal(levels(part$trials$factor_slot), c("5", "10", "15"))
})

test_that("the warning about the pooled test says what the null studies found", {
  null <- read.csv(file.path(root, "tests/analysis/null_studies.csv"))
  expect_equal(kPooledNullRate, mean(null$pooled_p < 0.05))
})

test_that("what is no study and no data is refused in one sentence", {
  result <- run_script("report.R", "nowhere.sqlite", "--out", new_folder())
  expect_equal(result$status, 2L)
  expect_equal(result$stderr, "report.R: nowhere.sqlite: expected a study file, found no such file")
  result <- run_script("report.R", tempdir(), "--out", new_folder())
  expect_match(result$stderr, "expected the data of a report, found no columns.csv in it")
})

test_that("only a study with clicks needs the package of their models", {
  expect_null(packages_for_data(data_folder_of(small_study(few_trials(1, 2)))))
  clicked <- write_gaze_study(tempfile(fileext = ".sqlite"), few_gaze_trials(1, 2))
  expect_equal(packages_for_data(data_folder_of(clicked)), "glmmTMB")
  expect_silent(need_packages(NULL))
})
