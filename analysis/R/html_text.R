# Words, tables and figures as HTML. Everything that comes from a study (codes, reasons, questions,
# names of factors) passes through here, so that it stays words whatever it holds.
#
#   any words ─────────────────> html_text        escaped
#   a report's Markdown lines ─> html_of_lines    by commonmark; what as_typed kept stays words
#   a figure's SVG ────────────> inline_svg       its ids made its own, for a page holds many
# SPDX-License-Identifier: MIT

# The three signs that begin markup of HTML as entities.
with_entities <- function(words) {
  for (sign in list(c("&", "&amp;"), c("<", "&lt;"), c(">", "&gt;"))) {
    words <- gsub(sign[1], sign[2], words, fixed = TRUE)
  }
  words
}

# Words as they may stand in HTML or in an attribute between double quotes; NA is empty.
html_text <- function(words) {
  words <- enc2utf8(as.character(words))
  words[is.na(words)] <- ""
  words <- with_entities(gsub("[[:cntrl:]]+", " ", words))
  gsub("'", "&#39;", gsub("\"", "&quot;", words, fixed = TRUE), fixed = TRUE)
}

# Lines of the reports' Markdown as HTML: headings (all of one size), tables, lists and paragraphs.
html_of_lines <- function(lines) {
  html <- commonmark::markdown_html(enc2utf8(lines[!is.na(lines)]), extensions = "table")
  html <- gsub("(</?)h[1-6]>", "\\1h4>", html)
  html <- gsub("<table>", "<div class=\"wide\"><table>", html, fixed = TRUE)
  strsplit(gsub("</table>", "</table></div>", html, fixed = TRUE), "\n", fixed = TRUE)[[1]]
}

# Sentences of the reports' Markdown; one paragraph each.
html_paragraphs <- function(words) {
  unlist(lapply(words[nzchar(words)], html_of_lines))
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
    if (is.logical(column)) column <- ifelse(column, "yes", "no")
    words <- if (is_number) format_number(column) else as.character(column)
    words <- html_text(ifelse(is.na(column), "–", words))
    sprintf("<td%s>%s</td>", class, gsub(" (%|ms|′)", "\u00a0\\1", words))
  }, rows, number, class)
  cells <- matrix(cells, nrow = nrow(rows))
  c("<div class=\"wide\"><table>", "<thead>",
    paste0("<tr>", paste0("<th", class, ">", html_text(heads), "</th>", collapse = ""), "</tr>"),
    "</thead>", "<tbody>", paste0("<tr>", apply(cells, 1, paste, collapse = ""), "</tr>"),
    "</tbody>", "</table></div>")
}

# "< .001", ".042": p without its letter.
p_cell <- function(p) ifelse(is.na(p), NA, sub(" ", "\u00a0", sub("^p = |^p ", "", p_words(p))))

# 12, 1,234, 0.123, 45.6, 1.2e+10: whole numbers whole, others to three significant digits.
format_number <- function(x) {
  vapply(x, function(one) {
    if (is.na(one)) return("–")
    if (abs(one) < 1e-12) return("0")  # less is rounding
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
  lines <- gsub("(\\bid=\"|href=\"#|url\\(#)", paste0("\\1", prefix, "-"), lines)
  lines[1] <- sub("<svg ", sprintf("<svg role=\"img\" aria-label=\"%s\" ", html_text(description)),
    lines[1], fixed = TRUE)
  lines
}

# A figure of the page with its caption, from its SVG file.
html_figure <- function(svg, prefix, caption) {
  c("<figure>", inline_svg(svg, prefix, caption),
    sprintf("<figcaption>%s</figcaption>", html_text(caption)), "</figure>")
}
