# Results in words: sentences on each test.
#
# Three rules: a p above .05 is never called "no difference" (the equivalence tests speak to that);
# beside every test's own p stands the one corrected within its family, by name; and what is said to
# be found rests on the corrected one.
# SPDX-License-Identifier: MIT

scale_words <- function(scale) sprintf("Ratings ran from %s.", as_typed(describe_scale(scale)))

# `measure`: list(of, title), the column and what its mean is called.
means_words <- function(trials, factor, measure = list(of = "rating", title = "Mean rating")) {
  rows <- means_with_intervals(trials, factor, measure$of)
  limits <- ifelse(is.na(rows$low), "", sprintf(" [%.2f, %.2f]", rows$low, rows$high))
  sprintf("%s by %s: %s%s.%s", measure$title, name_and_unit(factor),
    paste0(rows$cell, ": ", sprintf("%.2f", rows$mean), limits, collapse = "; "),
    if (all(is.na(rows$low))) "" else
      if (length(between_factors(trials, factor)) > 0) " (Student's 95 % intervals over participants)" else
        " (within-participant 95 % intervals)", mean_base_words(trials, factor, measure$of))
}

# What the mixed model of a response found about one factor.
model_words <- function(tests, factor, response = "rating") {
  of <- response_model(response)
  row <- tests_of(tests, of$effects, factor)
  if (nrow(row) == 0) return(character())
  sprintf("In the %s for %s (%s), %s: %s.", sub("(mixed model).*", "\\1", row$method),
    plain_name(factor), random_words(row$method), if (row$p_holm < kSignificance)
    paste(of$noun, "depended on", plain_name(factor)) else paste("an effect of",
      plain_name(factor), "was not detected, which is not evidence of its absence"),
    chi_squared_words(row))
}

random_words <- function(method) paste("random", random_part(method), "for each participant")

# Odds or rate ratios of a factor's levels; `scale`: of ratings, to say which end is high.
ratio_words <- function(tests, factor, response = "rating", scale = NULL) {
  of <- response_model(response)
  rows <- level_comparisons(tests, of$ratios, factor)
  if (nrow(rows) == 0) return(character())
  sprintf("%s%s: %s.", sub("ratio", "ratios", sentence_case(of$size)), if (is.null(scale)) "" else
    sprintf(" (towards \"%s\")", as_typed(scale$high_anchor)),
    paste0(sub("^.*?: ", "", rows$effect, perl = TRUE), ", ", ratio_size_words(rows), collapse = "; "))
}

# Small ratios by their first two digits: 0.00 would say that there is nothing.
ratio_size_words <- function(rows) {
  text <- function(x) {
    ifelse(x < 0.095, formatC(x, digits = 2, format = "fg", flag = "#"), sprintf("%.2f", x))
  }
  sprintf("%s, %.0f %% CI [%s, %s]", text(rows$effect_size), 100 * rows$interval_level,
    text(rows$interval_low), text(rows$interval_high))
}

# What the mixed model found about one factor: its effect and its ratios.
factor_words <- function(tests, factor, response = "rating", scale = NULL) {
  c(model_words(tests, factor, response), ratio_words(tests, factor, response, scale))
}

# "1.92, 95 % CI [1.20, 3.05]" of each row.
size_words <- function(rows, format = "%.2f") {
  sprintf(gsub("N", format, "N, %.0f %% CI [N, N]", fixed = TRUE), rows$effect_size,
    100 * rows$interval_level, rows$interval_low, rows$interval_high)
}

# Each interaction that the mixed model of a response tested.
interaction_words <- function(tests, response = "rating") {
  of <- response_model(response)
  rows <- tests_of(tests, of$interactions)
  vapply(seq_len(nrow(rows)), function(i) {
    names <- vapply(strsplit(rows$effect[i], ":", fixed = TRUE)[[1]], plain_name, "")
    sprintf("In the %s with interactions (%s%s), one of %s was %s: %s.", of$kind,
      random_words(rows$method[i]), if (grepl("cells|slope", random_part(rows$method[i]))) "" else
        ", without which it is found too often (Barr 2013)",
      paste(names, collapse = " and "), if (rows$p_holm[i] < kSignificance) "detected" else
        "not detected, which is not evidence of its absence", chi_squared_words(rows[i, ]))
  }, "")
}

equivalence_words <- function(rows, factor) {
  if (nrow(rows) == 0) return(character())
  shown <- rows$p_holm < kSignificance
  largest <- rows[which.max(abs(rows$effect_size)), ]
  summary <- sprintf("largest difference %+.2f, 90 %% CI [%.2f, %.2f]", largest$effect_size,
    largest$interval_low, largest$interval_high)
  pairs <- sub("^.*: ", "", rows$effect)
  margin <- if (grepl("margin ±", rows$method[1])) sub("^.*margin ", "", rows$method[1]) else
    sprintf("±%.2f", kEquivalenceMargin)
  if (all(shown)) {
    return(sprintf("All differences by %s lie within %s points (two one-sided tests, %s; %s).",
      plain_name(factor), margin, largest_p(rows), summary))
  }
  sprintf("For %s, equivalence within %s points was not shown between %s (%s).",
    name_and_unit(factor), margin, paste(gsub("against", "and", pairs[!shown]), collapse = ", "),
    summary)
}

anova_words <- function(tests, factor) {
  row <- tests_of(tests, kAnovaFamily, factor)
  if (nrow(row) == 0) return(character())
  sprintf("Repeated-measures ANOVA of cell means (%s), %s: %s, generalised η² = %s.",
    sub("^.*, ", "", row$method), plain_name(factor), F_words(row), size_words(row, "%.3f"))
}

# The interactions of the ANOVA.
anova_interaction_words <- function(tests) {
  rows <- tests_of(tests, kAnovaFamily)
  rows <- rows[grepl(":", rows$effect, fixed = TRUE), ]
  if (nrow(rows) == 0) return(character())
  names <- vapply(strsplit(rows$effect, ":", fixed = TRUE), function(parts) {
    paste(vapply(parts, plain_name, ""), collapse = " × ")
  }, "")
  found <- rows$p_holm < kSignificance
  c(
    if (any(found)) sprintf("Interactions in the repeated-measures ANOVA: %s.", paste(names[found],
      F_words(rows[found, ]), sep = ", ", collapse = "; ")),
    if (any(!found)) sprintf(paste("Interactions not detected in the repeated-measures ANOVA, which is",
      "not evidence of their absence: %s."),
      paste(names[!found], both_p_words(rows[!found, ]), sep = ", ", collapse = "; ")))
}

friedman_words <- function(tests, factor) {
  row <- tests_of(tests, kFriedmanFamily, factor)
  if (nrow(row) == 0) return(character())
  sprintf("Friedman's test, %s: %s, Kendall's W = %.2f.", plain_name(factor),
    chi_squared_words(row), row$effect_size)
}

# "speed_deg_s" -> "speed", "speed (°/s)"
plain_name <- function(factor) sub(" \\(.*$", "", name_and_unit(factor))
name_and_unit <- function(factor) {
  label <- label_of(factor)
  paste0(tolower(substr(label, 1, 1)), substring(label, 2))
}

sentence_case <- function(words) paste0(toupper(substr(words, 1, 1)), substring(words, 2))

and_words <- function(words) {
  n <- length(words)
  if (n < 2) words else paste(paste(words[-n], collapse = ", "), "and", words[n])
}

# "1 rating", "2 ratings"
count_of <- function(count, noun) {
  paste0(format(count, big.mark = ",", trim = TRUE), " ", noun, if (count == 1) "" else "s")
}

who_words <- function(simulated) if (simulated) "simulated participant" else "participant"

# Before a number stands a minus sign, not a hyphen.
with_minus_signs <- function(words) gsub("(^|[ [])-([0-9])", "\\1−\\2", words)

chi_squared_words <- function(row) {
  sprintf("χ²(%d) = %.1f, %s", as.integer(row$df1), row$statistic, both_p_words(row))
}

F_words <- function(rows) {
  df <- function(x) ifelse(x == round(x), sprintf("%.0f", x), sprintf("%.1f", x))
  sprintf("F(%s, %s) = %.1f, %s", df(rows$df1), df(rows$df2), rows$statistic, both_p_words(rows))
}

p_words <- function(p) {
  ifelse(p < 0.001, "p < .001", paste0("p = ", sub("^0", "", sprintf("%.3f", p))))
}

# "p = .449, Holm-corrected p = .889": of each test its own, and the one corrected within its family.
both_p_words <- function(rows) {
  sprintf("%s, Holm-corrected %s", p_words(rows$p), p_words(rows$p_holm))
}

# "largest p = .004, Holm-corrected .012" of several tests.
largest_p <- function(rows) {
  largest <- data.frame(p = max(rows$p), p_holm = max(rows$p_holm))
  paste(if (largest$p_holm < 0.001) "all" else "largest", both_p_words(largest))
}
