# Words, tables and figures as HTML. Everything that comes from a study (codes, reasons, questions,
# names of factors) passes through here, so that it stays words whatever it holds.
#
#   any words ─────────────────> html_text        escaped
#   a report's Markdown lines ─> html_of_lines    tables, lists, `code`; what as_typed kept stays
#   a figure's SVG ────────────> inline_svg       its ids made its own, for a page holds many
# SPDX-License-Identifier: MIT

# Words as they may stand in HTML or in an attribute between double quotes; NA is empty.
html_text <- function(words) {
  words <- enc2utf8(as.character(words))
  words[is.na(words)] <- ""
  words <- gsub("[[:cntrl:]]+", " ", words)
  for (sign in list(c("&", "&amp;"), c("<", "&lt;"), c(">", "&gt;"), c("\"", "&quot;"),
      c("'", "&#39;"))) {
    words <- gsub(sign[1], sign[2], words, fixed = TRUE)
  }
  words
}

# One line of the reports' Markdown. as_typed() has written &, < and > of typed words as entities and
# put a backslash before signs of markup: both are kept; every other <, > and & is escaped.
html_of_line <- function(line) {
  line <- gsub("&(?!(amp|lt|gt);)", "&amp;", enc2utf8(line), perl = TRUE)
  line <- gsub("<", "&lt;", line, fixed = TRUE)
  line <- gsub(">", "&gt;", line, fixed = TRUE)
  line <- gsub("\"", "&quot;", line, fixed = TRUE)
  for (sign in strsplit("\\[]`*_|#~", "")[[1]]) {
    line <- gsub(paste0("\\", sign), sprintf("&#%d;", utf8ToInt(sign)), line, fixed = TRUE)
  }
  gsub("`([^`]*)`", "<code>\\1</code>", line)
}

# Lines of Markdown as HTML: headings (one level down), tables, lists and paragraphs.
html_of_lines <- function(lines) {
  lines <- lines[!is.na(lines)]
  kind <- ifelse(startsWith(lines, "|"), "table", ifelse(startsWith(lines, "- "), "list",
    ifelse(startsWith(lines, "#"), "heading", ifelse(nzchar(trimws(lines)), "words", "none"))))
  runs <- rle(kind)
  ends <- cumsum(runs$lengths)
  unlist(Map(function(kind, from, to) {
    part <- lines[from:to]
    switch(kind,
      table = html_of_markdown_table(part),
      list = c("<ul>", sprintf("<li>%s</li>", html_of_line(sub("^- ", "", part))), "</ul>"),
      heading = sprintf("<h4>%s</h4>", html_of_line(sub("^#+ *", "", part))),
      words = sprintf("<p>%s</p>", html_of_line(paste(part, collapse = " "))),
      none = NULL)
  }, runs$values, ends - runs$lengths + 1, ends), use.names = FALSE)
}

html_of_markdown_table <- function(lines) {
  cells <- lapply(html_of_line(lines), function(line) {
    trimws(strsplit(sub("\\s*\\|\\s*$", "", sub("^\\|\\s*", "", line)), "|", fixed = TRUE)[[1]])
  })
  row <- function(cells, tag) paste0("<tr>", paste0("<", tag, ">", cells, "</", tag, ">",
    collapse = ""), "</tr>")
  html_table_of(row(cells[[1]], "th"), vapply(cells[-(1:2)], row, "", "td"))
}

html_table_of <- function(head, rows) {
  c("<div class=\"wide\"><table>", "<thead>", head, "</thead>", "<tbody>", rows, "</tbody>",
    "</table></div>")
}

# A data frame of words and numbers; `heads`: the words above its columns. Numbers stand right; a
# column "p" is written as p values are; columns of which nothing is known are left out.
html_table <- function(rows, heads = names(rows)) {
  if (nrow(rows) == 0) return("<p>None.</p>")
  known <- !vapply(rows, function(column) all(is.na(column)), NA)
  rows <- rows[known]
  heads <- heads[known]
  if (is.numeric(rows[["p"]])) rows$p <- p_cell(rows[["p"]])  # `$p` would find "participants"
  number <- vapply(rows, is.numeric, NA)
  class <- ifelse(number, " class=\"number\"", "")
  cells <- mapply(function(column, is_number, class) {
    words <- if (is_number) format_number(column) else as.character(column)
    words <- html_text(ifelse(is.na(column), "–", words))
    sprintf("<td%s>%s</td>", class, gsub(" (%|ms|′)", "\u00a0\\1", words))
  }, rows, number, class)
  cells <- matrix(cells, nrow = nrow(rows))
  html_table_of(
    paste0("<tr>", paste0("<th", class, ">", html_text(heads), "</th>", collapse = ""), "</tr>"),
    paste0("<tr>", apply(cells, 1, paste, collapse = ""), "</tr>"))
}

# "< .001", ".042": p without its letter.
p_cell <- function(p) ifelse(is.na(p), NA, sub(" ", "\u00a0", sub("^p = |^p ", "", p_words(p))))

# 12, 1,234, 0.123, 45.6, 1.2e+10: whole numbers whole, others to three significant digits.
format_number <- function(x) {
  vapply(x, function(one) {
    if (is.na(one)) return("–")
    if (is.finite(one) && one == round(one) && abs(one) < 1e9) {
      return(format(one, big.mark = ",", scientific = FALSE))
    }
    gsub("-", "−", format(signif(one, 3), scientific = abs(one) >= 1e6 || abs(one) < 1e-4),
      fixed = TRUE)
  }, "")
}

# An SVG file as part of a page: its ids get `prefix`, so that those of two figures differ.
inline_svg <- function(path, prefix, description) {
  lines <- readLines(path, encoding = "UTF-8", warn = FALSE)
  lines <- lines[!grepl("^<\\?xml|^<!DOCTYPE", lines)]
  lines <- gsub("\\bid=\"", paste0("id=\"", prefix, "-"), lines)
  lines <- gsub("href=\"#", paste0("href=\"#", prefix, "-"), lines, fixed = TRUE)
  lines <- gsub("url(#", paste0("url(#", prefix, "-"), lines, fixed = TRUE)
  lines[1] <- sub("<svg ", sprintf("<svg role=\"img\" aria-label=\"%s\" ", html_text(description)),
    lines[1], fixed = TRUE)
  lines
}
