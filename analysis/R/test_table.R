# The table of tests: one row per test, families declared, Holm within a family.
#
# Every test function returns outcome(rows, remarks): rows of this table, and sentences about
# whatever was left out or went wrong.
# SPDX-License-Identifier: MIT

kSignificance <- 0.05

outcome <- function(rows = NULL, remarks = character()) list(rows = rows, remarks = remarks)

# What `make` gives for each of the items, row by row as one table.
each_row <- function(items, make, ...) do.call(rbind, unname(lapply(items, make, ...)))

test_row <- function(family, method, effect, statistic_name, statistic, df1, df2 = NA, p,
                     size_name = NA, size = NA, interval = c(NA, NA), interval_level = NA,
                     participants = NA, trials = NA) {
  data.frame(family = family, method = method, effect = effect, statistic_name = statistic_name,
    statistic = statistic, df1 = df1, df2 = df2, p = p, p_holm = NA_real_,
    effect_size_name = size_name, effect_size = size, interval_low = interval[[1]],
    interval_high = interval[[2]], interval_level = interval_level, participants = participants,
    trials = trials, row.names = NULL)
}

# All outcomes as one, rows and remarks in their order.
all_outcomes <- function(...) {
  outcome(each_row(list(...), `[[`, "rows"),
    as.character(unlist(lapply(list(...), `[[`, "remarks"), use.names = FALSE)))
}

# All outcomes as one: rows with Holm's p within each family, remarks without repeats.
combine_outcomes <- function(...) {
  all <- all_outcomes(...)
  if (is.null(all$rows)) all$rows <- test_row("", "", "", "", NA, NA, p = NA)[0, ]
  all$rows$p_holm <- stats::ave(all$rows$p, all$rows$family,
    FUN = function(p) stats::p.adjust(p, "holm"))
  outcome(all$rows, unique(all$remarks))
}

# The rows of a family, of one effect when it is named.
tests_of <- function(tests, family, effect = NULL) {
  rows <- tests$rows[tests$rows$family == family, ]
  if (is.null(effect)) rows else rows[rows$effect == effect, ]
}

# The rows of a family whose effect compares levels of this factor: "factor: 2 against 1".
level_comparisons <- function(tests, family, factor) {
  rows <- tests_of(tests, family)
  rows[startsWith(rows$effect, paste0(factor, ": ")), ]
}

# Writes any table as CSV, numbers with six significant digits; NA is left empty.
write_table <- function(rows, path) {
  numeric <- vapply(rows, is.numeric, NA)
  six_digits <- function(x) ifelse(is.na(x), NA, vapply(x, format, "", digits = 6))
  rows[numeric] <- lapply(rows[numeric], six_digits)
  utils::write.csv(rows, path, row.names = FALSE, na = "", quote = which(!numeric),
    fileEncoding = "UTF-8")
}

# A table as Markdown; `rows` have " | " between their cells.
markdown_table <- function(heads, rows) {
  sprintf("|%s|", c(paste0(" ", paste(heads, collapse = " | "), " "),
    paste(rep("---", length(heads)), collapse = "|"), if (length(rows) > 0) paste0(" ", rows, " ")))
}
