# What the methods section says of eye trackers, of markers for another recorder and of sounds.
# SPDX-License-Identifier: MIT

# Rows of a query on the sittings of a protocol; none where the study is older than the table.
rows_of_sittings <- function(path, table, query, sessions) {
  tables <- query_study(path, "SELECT name FROM sqlite_master WHERE type = 'table'")$name
  if (!table %in% tables) return(NULL)
  rows <- query_study(path, query)
  rows[rows$session %in% sessions$session, , drop = FALSE]
}

device_words <- function(path, sessions) {
  c(tracker_words(rows_of_sittings(path, "note",
      "SELECT session_id AS session, text FROM note WHERE kind = 'gaze tracker'", sessions)),
    marker_words(rows_of_sittings(path, "marker", "SELECT session_id AS session,
      (written_ns - event_ns) / 1e6 AS sent_after_ms
      FROM marker JOIN attempt ON attempt.id = attempt_id", sessions)),
    sound_words(rows_of_sittings(path, "sound", "SELECT session_id AS session, lag_ms,
      (realised_ns - shown_ns) / 1e6 AS realised_lag_ms
      FROM sound JOIN attempt ON attempt.id = attempt_id", sessions)))
}

# `notes`: session, text, as a sitting keeps it at its start and end: "Pupil's clock plus 1.5 s is this
# machine's, known to 0.1 ms; it fell silent 2 times".
tracker_words <- function(notes) {
  form <- "^(.*)'s clock plus .* ([0-9.]+) ms; it fell silent ([0-9]+) times$"
  notes <- notes[grepl(form, notes$text), , drop = FALSE]
  if (NROW(notes) == 0) return(NULL)
  part <- function(place) sub(form, paste0("\\", place), notes$text)
  one_way <- grepl("fastest delivery", notes$text)
  silences <- sum(tapply(as.numeric(part(3)), notes$session, max))
  sprintf("Gaze was followed by %s in %s. %s%s",
    and_words(sort(unique(part(1)))), count_of(length(unique(notes$session)), "sitting"),
    paste(c(if (any(!one_way)) sprintf("Its stamps were brought to this machine's clock to within %.2g ms.",
        max(as.numeric(part(2))[!one_way])),
      if (any(one_way)) sprintf(paste("Its clock is known by its fastest delivery alone, whose own delay is",
        "not; 95 %% came later by at most %.2g ms."), max(as.numeric(part(2))[one_way]))), collapse = " "),
    if (silences == 0) "" else sprintf(" It fell silent %s, which lost gaze and no trial.",
      count_of(silences, "time")))
}

# `markers`: sent_after_ms, NA where one was not sent in time.
marker_words <- function(markers) {
  if (NROW(markers) == 0) return(NULL)
  sent <- markers$sent_after_ms[!is.na(markers$sent_after_ms)]
  lost <- nrow(markers) - length(sent)
  paste0(sprintf("Events were marked for another recorder by %s", count_of(nrow(markers), "code")),
    if (length(sent) > 0) sprintf(paste(", handed to the system %.2g ms (median; 99 %% within %.2g ms)",
      "after the flip or the arrival that each marks"), stats::median(sent), stats::quantile(sent, 0.99)),
    if (lost > 0) sprintf("; %s not sent in time", if (lost == 1) "1 was" else paste(lost, "were")), ".")
}

# `sounds`: lag_ms, realised_lag_ms, NA where an onset is not known, as of simulated participants.
sound_words <- function(sounds) {
  if (NROW(sounds) == 0) return(NULL)
  off <- (sounds$realised_lag_ms - sounds$lag_ms)[!is.na(sounds$realised_lag_ms)]
  unknown <- nrow(sounds) - length(off)
  paste0(sprintf("%s at lags of %s ms from the flip that showed the contact",
      if (nrow(sounds) == 1) "1 sound was played" else paste(count_of(nrow(sounds), "sound"), "were played"),
      paste(sort(unique(sounds$lag_ms)), collapse = ", ")),
    if (length(off) > 0) sprintf(paste("; onsets left the device's buffer %.2g ms from that in the median (half of",
      "them between %.2g and %.2g ms), before what driver and loudspeaker add"), stats::median(off),
      stats::quantile(off, 0.25), stats::quantile(off, 0.75)),
    if (unknown > 0) sprintf("; of %d nobody knows when they were heard", unknown), ".")
}
