# The tables of analysis/README.md that say what each column of each view is, from the comments of
# experiments/store/schema.sql and views.sql:
#
#   Rscript tests/analysis/view_columns.R <repo root>      writes them anew
#
#   table.column AS name,            the table's own comment on that column
#   anything else AS name,  -- words the comment beside it
#
# In the schema a comment stands beside its column, goes on below it, or above for all columns below
# that say nothing.
# SPDX-License-Identifier: MIT

kBeforeColumns <- "## Every column of the views"

# By "table.column": list(type, meaning) for every column of schema.sql.
schema_columns <- function(lines) {
  found <- list()
  table <- ""
  above <- ""
  latest <- character()
  used <- FALSE
  for (line in lines) {
    if (grepl("^CREATE TABLE", line)) {
      table <- sub("^CREATE TABLE (\\w+).*", "\\1", line)
      above <- ""
      next
    }
    if (startsWith(line, ")") || table == "") {
      table <- ""
      next
    }
    comment <- if (grepl("--", line, fixed = TRUE)) trimws(sub("^.*?-- ?", "", line, perl = TRUE)) else ""
    code <- sub("--.*$", "", line)
    if (nzchar(trimws(code))) {
      if (nzchar(comment) && used) above <- ""
      names <- regmatches(code, gregexpr("(^|, ) *\\w+ (INTEGER|REAL|TEXT|BLOB)\\b", code))[[1]]
      latest <- character()
      for (name in trimws(sub("^, *", "", names))) {
        words <- strsplit(name, " ")[[1]]
        latest <- c(latest, paste(table, words[1], sep = "."))
        found[[utils::tail(latest, 1)]] <- list(type = words[2], meaning = joined(comment, above, "; "))
      }
      used <- TRUE
      if (nzchar(comment)) above <- ""
    } else if (grepl("^   ", line)) {
      for (column in latest) {
        found[[column]]$meaning <- joined(found[[column]]$meaning, comment, " ")
      }
    } else {
      above <- if (used) comment else joined(above, comment, " ")
      used <- FALSE
    }
  }
  found
}

joined <- function(first, second, between) {
  paste(c(first, second)[nzchar(c(first, second))], collapse = between)
}

# By view: list(rows, columns); `rows`: the comment above it; `columns`: column, meaning, type.
view_columns <- function(view_lines, schema) {
  starts <- grep("^CREATE VIEW", view_lines)
  views <- lapply(starts, function(start) {
    before <- start - 1
    while (startsWith(view_lines[before], "--")) before <- before - 1
    rows <- paste(sub("^-- ?", "", view_lines[(before + 1):(start - 1)]), collapse = " ")
    to <- start + min(which(grepl("^FROM ", view_lines[-seq_len(start)])))
    body <- view_lines[(start + 1):(to - 1)]
    list(rows = rows, columns = do.call(rbind, select_parts(body, schema)))
  })
  stats::setNames(views, sub("^CREATE VIEW (\\w+).*", "\\1", view_lines[starts]))
}

# Each column that a view's SELECT names, in its order.
select_parts <- function(body, schema) {
  comment <- ifelse(grepl("-- ", body), sub("^.*-- ", "", body), "")
  code <- sub(" *--.*$", "", body)
  found <- regmatches(code, gregexpr("[^,()]*\\bAS (\\w+)(,|$)", code))
  rows <- list()
  for (i in seq_along(body)) {
    for (part in found[[i]]) {
      name <- sub(".*\\bAS (\\w+),?$", "\\1", part)
      origin <- sub("^\\s*(SELECT )?\\s*(\\w+\\.\\w+) AS .*$", "\\2", part)
      known <- schema[[origin]]
      meaning <- if (nzchar(comment[i])) comment[i] else if (!is.null(known)) known$meaning else ""
      if (meaning == "" && grepl("[._]id$", origin)) {
        meaning <- paste0("`id` of the row in the table ", sub("^.*[.](?!id$)|[._]id$", "",
          sub("[._]id$", "", origin), perl = TRUE))
      }
      rows[[length(rows) + 1]] <- data.frame(column = name, meaning = meaning,
        type = if (!is.null(known) && !grepl("\\bAS\\b.*\\bAS\\b", part)) tolower(known$type) else
          "computed")
    }
  }
  rows
}

# The part of the page, as lines.
view_page <- function(root) {
  read <- function(file) readLines(file.path(root, "experiments/store", file), encoding = "UTF-8")
  views <- view_columns(read("views.sql"), schema_columns(read("schema.sql")))
  c(kBeforeColumns, "", paste("Made from the comments of `experiments/store/schema.sql` and",
    "`views.sql` by `Rscript tests/analysis/view_columns.R .`; change them there."), "",
    unlist(lapply(names(views), function(name) {
      columns <- views[[name]]$columns
      c(sprintf("### `%s`", name), "", views[[name]]$rows, "", "| column | meaning | type |",
        "|---|---|---|", sprintf("| `%s` | %s | %s |", columns$column,
          gsub("|", "\\|", columns$meaning, fixed = TRUE), columns$type), "")
    })))
}

# The README with this part anew; it stands before the next heading of its rank.
with_view_page <- function(readme, page) {
  from <- which(readme == kBeforeColumns)
  stopifnot(length(from) == 1)
  after <- which(grepl("^## ", readme) & seq_along(readme) > from)[1]
  c(readme[seq_len(from - 1)], page, readme[after:length(readme)])
}

if (sys.nframe() == 0) {
  root <- commandArgs(trailingOnly = TRUE)[1]
  readme <- file.path(root, "analysis/README.md")
  writeLines(enc2utf8(with_view_page(readLines(readme, encoding = "UTF-8"), view_page(root))), readme,
    useBytes = TRUE)
}
