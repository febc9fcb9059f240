# The table of tests: one row per test, families declared, Holm within a family.
#
# Every test function returns outcome(rows, remarks): rows of this table, and sentences about
# whatever was left out or went wrong.
# SPDX-License-Identifier: MIT

kSignificance <- 0.05

outcome <- function(rows = NULL, remarks = character()) list(rows = rows, remarks = remarks)

test_row <- function(family, method, effect, statistic_name, statistic, df1, df2 = NA, p,
                     size_name = NA, size = NA, interval = c(NA, NA), interval_level = NA,
                     participants = NA, trials = NA) {
  data.frame(
    family = family, method = method, effect = effect, statistic_name = statistic_name,
    statistic = statistic, df1 = df1, df2 = df2, p = p, p_holm = NA_real_,
    effect_size_name = size_name, effect_size = size, interval_low = interval[[1]],
    interval_high = interval[[2]], interval_level = interval_level, participants = participants,
    trials = trials, row.names = NULL
  )
}

# All outcomes as one, rows and remarks in their order.
all_outcomes <- function(...) {
  outcomes <- list(...)
  outcome(do.call(rbind, lapply(outcomes, `[[`, "rows")),
    as.character(unlist(lapply(outcomes, `[[`, "remarks"))))
}

# All outcomes as one: rows with Holm's p within each family, remarks without repeats.
combine_outcomes <- function(...) {
  outcomes <- list(...)
  rows <- do.call(rbind, lapply(outcomes, `[[`, "rows"))
  if (!is.null(rows)) {
    rows$p_holm <- stats::ave(rows$p, rows$family, FUN = function(p) stats::p.adjust(p, "holm"))
  } else {
    rows <- test_row("", "", "", "", NA, NA, p = NA)[0, ]
  }
  outcome(rows, unique(unlist(lapply(outcomes, `[[`, "remarks"))))
}

# The rows of a family, of one effect when it is named.
tests_of <- function(tests, family, effect = NULL) {
  rows <- tests$rows[tests$rows$family == family, ]
  if (is.null(effect)) rows else rows[rows$effect == effect, ]
}

# Writes the table of tests.
write_test_table <- function(tests, path) write_table(tests$rows, path)

# Writes any table as CSV, numbers with six significant digits; NA is left empty.
write_table <- function(rows, path) {
  numeric <- vapply(rows, is.numeric, logical(1))
  six_digits <- function(x) ifelse(is.na(x), NA, vapply(x, format, "", digits = 6))
  rows[numeric] <- lapply(rows[numeric], six_digits)
  utils::write.csv(rows, path, row.names = FALSE, na = "", quote = which(!numeric),
    fileEncoding = "UTF-8")
}

# A table as Markdown; `rows` have " | " between their cells.
markdown_table <- function(heads, rows) {
  c(
    sprintf("| %s |", paste(heads, collapse = " | ")), paste0("|", strrep("---|", length(heads))),
    sprintf("| %s |", rows)
  )
}
