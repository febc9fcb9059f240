# Clicks in a crowd, where its protocol asks for them: how many, by number of bodies and scheduler.
# SPDX-License-Identifier: MIT

# The part of the report about clicks: list(words, section); empty for a protocol without clicks.
crowd_clicks <- function(study) {
  columns <- unname(study$factors[c("bodies", "scheduler")])
  rows <- do.call(rbind, lapply(unique(study$trials$path), read_click_trials, study$protocol))
  key <- function(rows) paste(rows$path, rows$trial)
  at <- match(key(study$trials), key(rows))
  if (all(is.na(at))) return(list())
  trials <- study$trials[!is.na(at), ]
  trials[c("clicks", "exposure_s")] <- rows[at[!is.na(at)], c("clicks", "exposure_s")]
  cells <- split(trials, trials[rev(columns)], drop = TRUE)
  lines <- vapply(cells, function(cell) {
    each <- t_interval(tapply(cell$clicks, as.character(cell$participant), mean))
    sprintf("%s | %s | %d | %.2f | %s | %s", cell[[columns[1]]][1], cell[[columns[2]]][1],
      nrow(cell), each[["mean"]], if (is.na(each[["low"]])) "–" else
        sprintf("%.2f to %.2f", each[["low"]], each[["high"]]),
      or_dash(sum(cell$clicks) / sum(cell$exposure_s), "%.3f"))
  }, "")
  section <- c("## Clicks", "", markdown_table(c("bodies", "scheduler", "trials",
    "clicks per trial", "95 % CI over participants", "clicks per second"), unname(lines)), "")
  words <- sprintf("Participants clicked %s in %s.", count_of(sum(trials$clicks), "time"),
    count_of(nrow(trials), "trial"))
  list(words = words, section = section)
}

read_click_trials <- function(path, protocol) {
  study <- open_study(path, c(kViews, "click_trial"))
  on.exit(DBI::dbDisconnect(study))
  rows <- DBI::dbGetQuery(study, paste("SELECT trial, clicks, CAST(exposure_s AS REAL) AS",
    "exposure_s FROM click_trial WHERE protocol = ? AND phase = 'main'"), params = list(protocol))
  cbind(rows, path = rep(path, nrow(rows)))
}
