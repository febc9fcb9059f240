# How far a piece of work has come, on stderr: on a terminal one line that changes, else a line for
# each step.
#
#   expect_steps(c("fitting ..." = 3, "drawing ..." = 1))     the steps to come, and how long each takes
#   say_progress("fitting ...")                               one of them begins
#   end_progress()                                            the terminal's line is emptied
#
# A step that turns out not to be needed is passed over and counts as done. Without steps to come,
# progress is words alone.
# SPDX-License-Identifier: MIT

work <- new.env()
work$steps <- numeric()

# `steps`: how long each takes against the others, named by the words with which it begins.
expect_steps <- function(steps) {
  work$steps <- steps
  work$at <- 0
  work$began <- Sys.time()
}

# One step begins; `...`: its words.
say_progress <- function(...) {
  words <- paste0(...)
  at <- work$at + match(words, names(work$steps)[seq_along(work$steps) > work$at])
  if (length(at) == 1 && !is.na(at)) {
    work$at <- at
    words <- paste(words, step_words(work$steps, at, as.numeric(Sys.time() - work$began,
      units = "secs")))
  }
  if (length(work$steps) > 0 && isatty(stderr())) cat("\r", words, "\033[K", sep = "", file = stderr())
  else message(words)
}

end_progress <- function() {
  if (length(work$steps) > 0 && isatty(stderr())) cat("\r\033[K", file = stderr())
  work$steps <- numeric()
}

# "(3 of 14; 12 s so far, about 40 s left)": what is left, from how long the steps before took, as
# soon as they are a tenth of all.
step_words <- function(steps, at, seconds) {
  before <- sum(utils::head(steps, at - 1))
  left <- seconds * (sum(steps) - before) / before
  sprintf("(%d of %d; %s so far%s)", as.integer(at), length(steps), time_words(seconds),
    if (before >= sum(steps) / 10) sprintf(", about %s left", time_words(left)) else "")
}

# "12 s", "4 min"
time_words <- function(seconds) {
  if (seconds < 90) sprintf("%.0f s", seconds) else sprintf("%.0f min", seconds / 60)
}
