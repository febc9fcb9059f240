# The report of a study as one page of HTML: nothing on it is fetched, nothing on it runs.
#
#   data/ ─> for each protocol: participants, design, what was shown, results of each part, methods
#         ─> report.html, figures/*.svg, *.pdf, tables/*.csv
# SPDX-License-Identifier: MIT

kReportPackages <- c("RSQLite", "ordinal", "lme4", "afex", "ggplot2", "commonmark")

# Those that the data in folder/data need beside: the models of clicks have a package of their own.
packages_for_data <- function(data) {
  if (nrow(utils::read.csv(file.path(data, "click_trial.csv"), nrows = 1)) > 0) "glmmTMB"
}

# Makes the report of a study file, or of the data/ of an earlier report; `arguments`: as
# read_arguments() gives them; `only`: of this protocol alone, else of all.
report_page <- function(arguments, only = NULL) {
  need_packages(kReportPackages)
  study <- arguments$studies
  if (length(study) > 1) {
    refuse("expected one study file, got ", length(study), "; `impetus merge` makes one of several")
  }
  require_reportable(study, only)
  data <- file.path(arguments$out, "data")
  lapply(c(arguments$out, data), prepare_folder)
  if (dir.exists(study)) copy_report_data(study, data) else write_report_data(study, data)
  need_packages(packages_for_data(data))
  copy_code(arguments$out, only)
  write_study_report(arguments$out, only)
  end_progress()
  say_progress("wrote ", file.path(arguments$out, "report.html"), ", figures/ and tables/")
}

# Refuses what is neither a study file nor the data of a report and, where a protocol is named, one in
# which nobody takes part.
require_reportable <- function(path, protocol) {
  is_data <- dir.exists(path)
  if (is_data && !file.exists(file.path(path, "columns.csv"))) {
    refuse(path, ": expected the data of a report, found no columns.csv in it")
  }
  study <- withr::local_db_connection(if (is_data)
    open_study(study_of_report_data(path), "enrolment_summary") else open_study(path, kReadViews))
  if (is.null(protocol)) return(invisible())
  enrolled <- DBI::dbGetQuery(study, "SELECT 1 FROM enrolment_summary WHERE protocol = ?", list(protocol))
  if (nrow(enrolled) == 0) refuse_protocol(study, path, protocol)
}

# The script of a protocol's own report, or of all protocols'.
script_of <- function(only) paste0(c(only, "report")[1], ".R")

# The code of the report beside it, but where it is that code which makes it.
copy_code <- function(folder, only) {
  from <- getOption("impetus.analysis")
  to <- file.path(folder, "analysis")
  dir.create(to, showWarnings = FALSE)
  if (normalizePath(from) == normalizePath(to)) return(invisible())
  file.copy(file.path(from, c(script_of(only), "R", "studies")), to, recursive = TRUE, overwrite = TRUE)
}

# Makes the whole report in `folder` from the data in folder/data.
write_study_report <- function(folder, only = NULL) {
  for (part in c("figures", "tables")) dir.create(file.path(folder, part), showWarnings = FALSE)
  path <- study_of_report_data(file.path(folder, "data"))
  about <- utils::read.csv(file.path(folder, "data/study.csv"), colClasses = "character")
  protocols <- query_study(path,
    "SELECT DISTINCT protocol FROM enrolment_summary ORDER BY protocol")$protocol
  if (!is.null(only)) protocols <- intersect(protocols, only)
  in_words_of <- function(protocol, made) withr::with_options(design_words(path, protocol), made)
  parts <- lapply(protocols, function(one) in_words_of(one, parts_of_protocol(path, one)))
  expect_steps(unlist(Map(function(one, its) in_words_of(one, steps_of_parts(its)), protocols, parts,
    USE.NAMES = FALSE)))
  body <- if (length(protocols) == 0) "<p>Nobody has been enrolled yet.</p>" else
    unlist(Map(function(one, its) in_words_of(one, protocol_lines(one, its, path, folder)),
      protocols, parts))
  writeLines(enc2utf8(page_of(about, protocols, body, script_of(only))), file.path(folder, "report.html"),
    useBytes = TRUE)
}

page_of <- function(about, protocols, body, script) {
  html_page(paste("Report of", about$study), c(
    sprintf("<p class=\"note\">The study as it was on %s. %s</p>", html_text(about$read_utc),
      "Figures are also files in <code>figures/</code>, tables in <code>tables/</code>."),
    "<nav><ul>", sprintf("<li><a href=\"#%s\">%s</a></li>", anchor_of(protocols),
      html_text(protocols)), "<li><a href=\"#repeat\">How to repeat</a></li>", "</ul></nav>",
    body, repeat_lines(script)))
}

# A page of its own: it fetches nothing and runs nothing. `body`: lines below its heading.
html_page <- function(title, body) {
  c("<!DOCTYPE html>", "<html lang=\"en\">", "<head>", "<meta charset=\"utf-8\">",
    paste0("<meta http-equiv=\"Content-Security-Policy\" ",
      "content=\"default-src 'none'; style-src 'unsafe-inline'\">"),
    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">",
    sprintf("<title>%s</title>", html_text(title)), "<style>", readLines(code_file("page.css")),
    "</style>", "</head>",
    "<body>", sprintf("<h1>%s</h1>", html_text(title)), body, "</body>", "</html>")
}

anchor_of <- function(...) gsub("[^A-Za-z0-9_-]+", "-", paste(..., sep = "-"))

# Everything about one protocol.
protocol_lines <- function(protocol, parts, path, folder) {
  say_progress("protocol ", protocol)
  refused <- Filter(function(part) !is.null(part$why), parts)
  parts <- knowing_of_others(Filter(function(part) is.null(part$why), parts))
  results <- lapply(parts, function(part) {
    results_of_part(part, if (nrow(part$exclusions) > 0) trials_with_excluded(path, part))
  })
  distribution <- Filter(Negate(is.null), list(distribution_results(path, protocol)))
  results <- c(results, distribution)
  analysed <- c(parts, lapply(distribution, `[[`, "part"))
  c(sprintf("<h2 id=\"%s\">%s</h2>", anchor_of(protocol), html_text(protocol)),
    sprintf("<p>%s</p>", html_text(protocol_titles(path, protocol))), question_lines(protocol),
    simulated_lines(path, protocol), "<h3>Participants and exclusions</h3>",
    html_table(participants_table(path, protocol), kParticipantHeads),
    unlist(lapply(parts, part_data_lines)), design_lines(parts),
    "<h3>What was really shown</h3>", shown_lines(path, protocol), gaze_lines(path, protocol, folder),
    sprintf("<p>%s</p>", html_text(unique(vapply(refused, `[[`, "", "why")))),
    if (length(results) + length(refused) == 0) paste0("<h3>Results</h3><p>There are no answers of the",
      " main phase to analyse: none yet, free words alone, or the protocol asks for none.</p>"),
    unlist(lapply(results, result_lines, folder = folder)), "<h3>Methods, in words</h3>",
    html_paragraphs(paste(methods_sentences(path, protocol, analysed), collapse = " ")),
    "<h4>References</h4>", "<ul>", sprintf("<li>%s</li>", html_text(cited_references(analysed))),
    "</ul>")
}

# What a study that is described asks, and what the thesis found.
question_lines <- function(protocol) {
  study <- study_description(protocol)
  html_paragraphs(c(study$question, if (!is.null(study$found)) paste("The thesis:", study$found)))
}

# The box that stands above results that are of nobody but simulated participants.
simulated_lines <- function(path, protocol) {
  if (!analyses_simulated(path, protocol)) return(NULL)
  if (identical(study_description(protocol)$kind, "distribution")) return(NULL)  # nobody is meant to
  paste0("<p class=\"simulated\">SIMULATED: every participant is simulated; these results describe an",
    " observer model, not people.</p>")
}

part_data_lines <- function(part) {
  if (part$response == "scheduling") return(NULL)  # the trials with a rating, whose lines stand before
  words <- c(participants_sentence(part), exclusions_sentence(part), unclicked_sentence(part),
    unbalanced_sentence(part), catch_sentence(part), hashes_sentence(part), part$depths)
  c(sprintf("<h4>%s: what is in the analysis</h4>", html_text(title_of_part(part))),
    html_paragraphs(paste(words, collapse = " ")), html_of_lines(left_out_section(part)))
}

# Each part with `elsewhere`, the participants of the others: a question may be of some people only.
knowing_of_others <- function(parts) {
  people <- lapply(parts, function(part) as.character(unique(part$trials$participant)))
  Map(function(part, i) c(part, list(elsewhere = unique(unlist(people[-i])))), parts, seq_along(parts))
}

# The trials of all parts with every factor, each once: a part may have one level of what varies.
design_of_parts <- function(parts) {
  columns <- Reduce(intersect, lapply(parts, function(part) {
    setdiff(names(part$trials), c(part$factors, part$constant))
  }))
  whole <- parts[[1]]
  trials <- each_row(parts, function(part) rbind(part$trials[columns], part$unclicked[columns]))
  whole$trials <- trials[!duplicated(trials$trial), ]
  whole$levels <- each_row(parts, `[[`, "levels")
  with_factors_that_vary(with_every_factor(whole))
}

design_lines <- function(parts) {
  if (length(parts) == 0) return(NULL)
  part <- design_of_parts(parts)
  trials <- part$trials
  rows <- each_row(c(unname(part$factors), part$constant), function(f) {
    per <- table(trials$participant, droplevels(trials[[f]]))
    data.frame(factor = label_of(f), levels = levels_words(colnames(per), "%d, %s to %s"),
      trials = if (length(between_factors(trials, f)) > 0) sprintf(
        "%s, between participants: %s", paste(unique(range(per[per > 0])), collapse = " to "),
        and_words(colSums(per > 0))) else paste(unique(range(per)), collapse = " to "))
  })
  c("<h3>Design</h3>", html_table(rows, c("Factor", "Levels", "Main trials of a participant at each")),
    html_paragraphs(c(
      if (any(!is.na(trials$track))) "Levels were chosen trial by trial (adaptive tracks).",
      if (length(unique(trials$block)) > 1) sprintf("Trials came in %s.",
        count_of(length(unique(trials$block)), "block")))))
}

# All of the levels or, of more than twelve, `many`: how many, the first and the last.
levels_words <- function(levels, many) {
  if (length(levels) <= 12) return(paste(levels, collapse = ", "))
  sprintf(many, length(levels), levels[1], levels[length(levels)])
}

shown_lines <- function(path, protocol) {
  collisions <- analysed_collisions(path, protocol)
  gaps <- function(title, rows, by, more) {
    if (!is.null(rows)) c(title, html_table(rows, c(by, kGapHeads, more)))
  }
  c(html_paragraphs(paste(shown_sentences(path, protocol, collisions), collapse = " ")),
    gaps(NULL, levels_reached(collisions), "Level reached", "Refinement ended at"),
    gaps("<h4>By condition</h4>", levels_by_factor(collisions, levels_of_trials(path)),
      c("Factor", "Level"), "Levels of the tree reached"),
    gaps("<h4>By distance from the gaze</h4>", levels_looked_at(collisions), "From the gaze",
      "Level reached, mean"))
}

gaze_lines <- function(path, protocol, folder) {
  gaze <- gaze_shown(path, protocol)
  c(html_paragraphs(paste(gaze$words, collapse = " ")), table_lines(gaze$tables, anchor_of(protocol), folder))
}

# Tables (list of list(name, title, rows, heads, note)) on the page, but for those without a title, and
# each as a file of its own.
table_lines <- function(tables, name, folder) {
  unlist(lapply(tables, function(table) {
    write_table(table$rows, file.path(folder, "tables", paste0(name, "-", table$name, ".csv")))
    if (!is.null(table$title)) c(sprintf("<h4>%s</h4>", html_text(table$title)),
      html_table(table$rows, table$heads),
      if (!is.null(table$note)) sub("<p>", "<p class=\"note\">", html_paragraphs(table$note)))
  }))
}

# Figures, words, tables and files of a part.
result_lines <- function(result, folder) {
  part <- result$part
  name <- anchor_of(paste(c(part$protocol, part$response, part$kind), collapse = "-"))
  figures <- unlist(lapply(seq_along(result$figures), function(i) {
    figure <- result$figures[[i]]
    say_progress(figure_step(part, figure$name))
    svg <- write_figure(figure, file.path(folder, "figures", anchor_of(name, figure$name)))
    html_figure(svg, paste0(name, "-", i), figure$caption)
  }))
  write_table(result$tests$rows, file.path(folder, "tables", paste0(name, "-tests.csv")))
  tables <- table_lines(result$tables, name, folder)
  c(sprintf("<h3>%s</h3>", html_text(title_of_part(part))),
    if (!is.null(part$scale)) html_paragraphs(scale_words(part$scale)), figures,
    "<h4>Results in words</h4>",
    html_paragraphs(vapply(result$paragraphs, paste, "", collapse = " ")),
    "<h4>Tests and estimates</h4>", test_lines(result$tests$rows, part$response != "scheduling"),
    if (length(result$tests$remarks) > 0) c("<h4>Remarks on the tests</h4>",
      html_of_lines(paste("-", result$tests$remarks))), tables)
}

# A table for each family of tests. `named`: are effects called by their factors, or in words already?
test_lines <- function(rows, named = TRUE) {
  if (nrow(rows) == 0) return("<p>No test was made.</p>")
  unlist(lapply(unique(rows$family), function(family) {
    mine <- rows[rows$family == family, ]
    statistic <- ifelse(is.na(mine$statistic_name), NA, sprintf("%s%s = %s",
      sub("chi-squared", "χ²", mine$statistic_name), df_words(mine), format_number(mine$statistic)))
    statistic <- gsub(" ", "\u00a0", statistic)  # a table breaks no line inside a number
    effect <- gsub("(?<=\\S):(?=\\S)", " × ", mine$effect, perl = TRUE)
    if (named) effect <- effect_words(effect)
    interval <- ifelse(is.na(mine$interval_low), NA, sprintf("%s to %s",
      format_number(mine$interval_low), format_number(mine$interval_high)))
    shown <- data.frame(effect = effect, statistic = statistic, p = p_cell(mine$p),
      holm = p_cell(mine$p_holm), size = mine$effect_size, interval = interval,
      participants = mine$participants)
    size <- unique(stats::na.omit(mine$effect_size_name))
    level <- unique(stats::na.omit(mine$interval_level))
    c(sprintf("<h4>%s</h4>", html_text(family)),
      sprintf("<p class=\"note\">%s</p>", html_text(paste0(paste(unique(mine$method), collapse = "; or "),
        if (family == kAnovaFamily) paste0(". ", kEtaIntervalWords)))),
      html_table(shown, c("Effect", "Statistic", "p", "Holm-corrected p",
        if (length(size) == 1) sentence_case(size) else "Effect size",
        if (length(level) == 1) sprintf("%.0f %% interval", 100 * level) else "Interval",
        "Participants")))
  }))
}

# An effect with a study's own factors by their labels, as the words above the table call them.
effect_words <- function(effect) {
  factors <- unique(c(names(getOption("impetus.labels")), names(getOption("impetus.levels"))))
  if (length(factors) == 0) return(effect)
  one_of <- paste0("\\Q", factors[order(-nchar(factors))], "\\E", collapse = "|")
  head <- sub(": .*$", "", effect)  # what follows are levels
  found <- gregexpr(sprintf("(?<![\\w.])(%s)(?![\\w.])", one_of), head, perl = TRUE)
  named <- head
  regmatches(named, found) <- lapply(regmatches(head, found), function(names) {
    vapply(names, plain_name, "")
  })
  paste0(named, substring(effect, nchar(head) + 1))
}

df_words <- function(rows) {
  df <- function(x) format(round(x, 1), trim = TRUE, drop0trailing = TRUE)
  ifelse(is.na(rows$df1), "", ifelse(is.na(rows$df2), sprintf("(%s)", df(rows$df1)),
    sprintf("(%s, %s)", df(rows$df1), df(rows$df2))))
}

# The part's trials with what was excluded, for the table of sensitivity; NULL where none can be read.
trials_with_excluded <- function(path, part) {
  again <- file.path(tempfile("with-excluded"), basename(path))
  dir.create(dirname(again))
  file.copy(path, again)
  study <- DBI::dbConnect(RSQLite::SQLite(), again)
  DBI::dbExecute(study, "DELETE FROM excluded_rows")
  DBI::dbDisconnect(study)
  parts <- parts_of_protocol(again, part$protocol)
  same <- Filter(function(other) identical(other$response, part$response) &&
    identical(other$kind, part$kind), parts)
  if (length(same) == 1) same[[1]]$trials
}

repeat_lines <- function(script) {
  c("<h2 id=\"repeat\">How to repeat</h2>",
    "<p>The views of the study that this page is made of are the tables in <code>data/</code>",
    "(<code>columns.csv</code> names their columns and types; an empty cell is missing), and the code is",
    "in <code>analysis/</code>. In this folder,</p>",
    sprintf("<p><code>Rscript analysis/%s data --out again</code></p>", script),
    "<p>makes every figure, model and table again. What participants wrote in free words is not part",
    "of the data.</p>")
}
