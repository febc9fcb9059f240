# Results in words: one paragraph, a caption, and the file that holds them.
#
# Three rules: a p above .05 is never called "no difference" (the equivalence tests speak to that);
# beside every test's own p stands the one corrected within its family, by name; and what is said to
# be found rests on the corrected one.
# SPDX-License-Identifier: MIT

# The paragraph. `main`: the factor of interest; `others`: those tested for equivalence too.
results_paragraph <- function(trials, scale, tests, main, others) {
  sentences <- c(
    scale_words(scale), means_words(trials, main), model_words(tests, main),
    odds_words(tests, main, scale),
    unlist(lapply(others, function(factor) other_factor_words(tests, factor))),
    interaction_words(tests),
    anova_words(tests, main), friedman_words(tests, main), pooled_words(tests, main)
  )
  paste(sentences, collapse = " ")
}

scale_words <- function(scale) sprintf("Ratings ran from %s.", as_typed(describe_scale(scale)))

means_words <- function(trials, main) {
  rows <- means_with_intervals(trials, main)
  limits <- ifelse(is.na(rows$low), "", sprintf(" [%.2f, %.2f]", rows$low, rows$high))
  sprintf("Mean ratings by %s: %s%s.", name_and_unit(main),
    paste0(rows$cell, ": ", sprintf("%.2f", rows$mean), limits, collapse = "; "),
    if (all(is.na(rows$low))) "" else " (within-participant 95 % intervals)")
}

model_words <- function(tests, main) {
  row <- tests_of(tests, kEffectsFamily, main)
  if (nrow(row) == 0) return(character())
  sprintf("In the cumulative-link mixed model (%s), %s: %s.", random_words(row$method),
    effect_words(row), chi_squared_words(row))
}

effect_words <- function(row) {
  name <- plain_name(row$effect)
  if (row$p_holm < kSignificance) return(paste("ratings depended on", name))
  paste("an effect of", name, "was not detected, which is not evidence of its absence")
}

odds_words <- function(tests, main, scale) {
  rows <- tests_of(tests, kOddsFamily)
  rows <- rows[startsWith(rows$effect, paste0(main, ": ")), ]
  if (nrow(rows) == 0) return(character())
  sprintf("Odds ratios of a higher rating (towards \"%s\"): %s.", as_typed(scale$high_anchor), paste(sprintf(
    "%s, %.2f, 95 %% CI [%.2f, %.2f]", sub("^.*: ", "", rows$effect), rows$effect_size,
    rows$interval_low, rows$interval_high
  ), collapse = "; "))
}

# Each interaction that the mixed model tested.
interaction_words <- function(tests) {
  rows <- tests_of(tests, kInteractionFamily)
  vapply(seq_len(nrow(rows)), function(i) {
    names <- vapply(strsplit(rows$effect[i], ":", fixed = TRUE)[[1]], plain_name, "")
    sprintf("In the mixed model with interactions, one of %s was %s: %s.",
      paste(names, collapse = " and "),
      if (rows$p_holm[i] < kSignificance) "detected" else
        "not detected, which is not evidence of its absence", chi_squared_words(rows[i, ]))
  }, "")
}

# One other factor: what the model found, then what the equivalence tests show.
other_factor_words <- function(tests, factor) {
  row <- tests_of(tests, kEffectsFamily, factor)
  effect <- if (nrow(row) > 0) sprintf("In the model for %s (%s), %s: %s.", plain_name(factor),
    random_words(row$method), effect_words(row), chi_squared_words(row))
  rows <- tests_of(tests, kEquivalenceFamily)
  rows <- rows[startsWith(rows$effect, paste0(factor, ": ")), ]
  if (nrow(rows) == 0) return(effect)
  c(effect, equivalence_words(rows, factor))
}

equivalence_words <- function(rows, factor) {
  shown <- rows$p_holm < kSignificance
  largest <- rows[which.max(abs(rows$effect_size)), ]
  summary <- sprintf("largest difference %+.2f, 90 %% CI [%.2f, %.2f]", largest$effect_size,
    largest$interval_low, largest$interval_high)
  pairs <- sub("^.*: ", "", rows$effect)
  margin <- if (grepl("margin ±", rows$method[1])) sub("^.*margin ", "", rows$method[1]) else
    sprintf("±%.2f", kEquivalenceMargin)
  margin <- paste(margin, "points")
  if (all(shown)) {
    return(sprintf("All differences by %s lie within %s (two one-sided tests, %s; %s).",
      plain_name(factor), margin, largest_p(rows), summary))
  }
  sprintf("For %s, equivalence within %s was not shown between %s (%s).", name_and_unit(factor),
    margin, paste(gsub("against", "and", pairs[!shown]), collapse = ", "), summary)
}

anova_words <- function(tests, main) {
  rows <- tests_of(tests, kAnovaFamily)
  if (nrow(rows) == 0) return(character())
  row <- rows[rows$effect == main, ]
  sentence <- sprintf(
    paste(
      "Repeated-measures ANOVA of cell means (Greenhouse–Geisser), %s: %s,",
      "generalised η² = %.3f, 90 %% CI [%.3f, %.3f]."
    ),
    plain_name(main), F_words(row), row$effect_size, row$interval_low, row$interval_high
  )
  interactions <- rows[grepl(":", rows$effect, fixed = TRUE), ]
  if (nrow(interactions) == 0) return(sentence)
  found <- interactions[interactions$p_holm < kSignificance, ]
  paste(sentence, if (nrow(found) == 0) "No interaction was detected." else
    sprintf("Interactions detected: %s.", paste(found$effect, both_p_words(found),
      sep = ", ", collapse = "; ")))
}

friedman_words <- function(tests, main) {
  row <- tests_of(tests, kFriedmanFamily, main)
  if (nrow(row) == 0) return(character())
  sprintf("Friedman's test, %s: %s, Kendall's W = %.2f.", plain_name(main), chi_squared_words(row),
    row$effect_size)
}

pooled_words <- function(tests, main) {
  rows <- tests_of(tests, kPooledFamily)
  row <- rows[rows$effect == main, ]
  if (nrow(row) == 0) return(character())
  apart <- rows[rows$effect != main, ]
  place <- strsplit(sub("^.* at ", "", apart$effect), " ", fixed = TRUE)
  each <- vapply(place, function(words) paste(name_and_unit(words[1]), words[2]), "")
  separately <- paste0("; at ", each, ", ", both_p_words(apart), collapse = "")
  sprintf("As in the thesis, a pooled single-factor ANOVA (treats trials as independent): %s%s.",
    F_words(row), if (nrow(apart) == 0) "" else separately)
}

# "speed_deg_s" -> "speed", "speed (°/s)"
plain_name <- function(factor) sub(" \\(.*$", "", name_and_unit(factor))
name_and_unit <- function(factor) {
  label <- label_of(factor)
  paste0(tolower(substr(label, 1, 1)), substring(label, 2))
}

chi_squared_words <- function(row) {
  sprintf("χ²(%d) = %.1f, %s", as.integer(row$df1), row$statistic, both_p_words(row))
}

F_words <- function(row) {
  df <- function(x) format(round(x, 1), nsmall = if (x == round(x)) 0 else 1, trim = TRUE)
  sprintf("F(%s, %s) = %.1f, %s", df(row$df1), df(row$df2), row$statistic, both_p_words(row))
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

# What the figure shows, for beneath it.
figure_caption <- function(trials, main, beside, simulated) {
  shown <- nrow(complete_participants(participant_means(trials, main)))
  split <- vapply(varying_factors(trials, beside), name_and_unit, "")
  paste0(
    "Mean rating by ", name_and_unit(main), ", ", count_of(max(shown, 1),
      if (simulated) "simulated participant" else "participant"), ". ",
    if (shown > 1) "Bars: within-participant 95 % confidence intervals (Cousineau–Morey). ",
    "Thin lines: participants, shifted sideways a little to keep them apart.",
    if (length(split) > 0) paste0(" Beside it, the same by ", paste(split, collapse = " and by "),
      ".")
  )
}

# Writes the report as Markdown: results, the data behind them, what is left out, remarks, caption.
# `section`, `left_out`: lines of Markdown.
write_report <- function(path, title, paragraph, sentences, remarks, caption, section = NULL,
                         left_out = NULL) {
  bullets <- function(lines) if (length(lines) > 0) paste("-", lines) else "- none"
  text <- c(
    paste("#", title), "", paragraph, "", section, "## Data", "", bullets(sentences), "",
    if (!is.null(left_out)) c("## Left out, and other trials to know of", "", left_out, ""),
    "## Remarks on the tests", "", bullets(remarks), "", "## Figure", "", caption
  )
  writeLines(enc2utf8(text), path, useBytes = TRUE)
}
