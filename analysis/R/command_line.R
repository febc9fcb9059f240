# What an analysis script is called with, and where its words go: results to stdout, progress and
# refusals to stderr.
# SPDX-License-Identifier: MIT

# "study.sqlite [more.sqlite ...] --out folder" -> list(studies, out). Prints `usage` for --help.
read_arguments <- function(words, usage) {
  if (any(words %in% c("-h", "--help"))) {
    say(c(paste("usage:", usage)))
    quit(save = "no", status = 0)
  }
  words <- unlist(strsplit(sub("^--out=", "--out\n", words), "\n", fixed = TRUE))
  flag <- which(words == "--out")
  if (length(flag) != 1 || flag == length(words)) {
    refuse("expected one --out and a folder; usage: ", usage)
  }
  studies <- words[-c(flag, flag + 1)]
  unknown <- grep("^--", studies, value = TRUE)
  if (length(unknown) > 0) refuse("unknown option ", unknown[1], "; usage: ", usage)
  if (length(studies) == 0) refuse("expected at least one study file; usage: ", usage)
  list(studies = studies, out = words[flag + 1])
}

# Makes the folder where it is absent; refuses where it cannot be written.
prepare_folder <- function(folder) {
  if (!dir.exists(folder)) suppressWarnings(dir.create(folder, recursive = TRUE))
  if (!dir.exists(folder) || file.access(folder, 2) != 0) {
    refuse(folder, ": expected a folder to write to, could not make it or write in it")
  }
}

say <- function(lines) writeLines(enc2utf8(lines), stdout(), useBytes = TRUE)
