# Refusals in one sentence, and warnings kept as words instead of printed.
# SPDX-License-Identifier: MIT

# Stops with one sentence for the user. The script turns it into stderr and exit status 2.
refuse <- function(...) {
  stop(structure(
    class = c("refusal", "error", "condition"),
    list(message = paste0(...), call = NULL)
  ))
}

# Evaluates `script`; whatever stops it becomes one sentence on stderr and exit status 2.
or_exit_2 <- function(name, script) {
  exit <- function(sentence) {
    end_progress()
    message(name, ": ", gsub("\\s*\n\\s*", " ", trimws(sentence)))
    quit(save = "no", status = 2)
  }
  tryCatch(script,
    refusal = function(condition) exit(conditionMessage(condition)),
    error = function(condition) {
      exit(paste("could not finish; this is a defect of the script:", conditionMessage(condition)))
    }
  )
}

# Refuses unless every package is installed, naming the Debian packages that are missing. A package is
# loaded where it is first used: together they take seconds, and a small study needs few of them.
need_packages <- function(packages) {
  missing <- packages[!vapply(packages, function(package) nzchar(system.file(package = package)), NA)]
  if (length(missing) == 0) return(invisible())
  refuse(
    "expected these R packages to be installed: ", paste(missing, collapse = ", "),
    " (on Debian: apt-get install ", paste0("r-cran-", tolower(missing), collapse = " "), ")"
  )
}

# Evaluates `expression` in silence. Returns list(value, complaints): value is NULL after an
# error, complaints holds the text of every warning and of the error.
listen_to <- function(expression) {
  complaints <- character()
  hear <- function(condition) complaints <<- c(complaints, conditionMessage(condition))
  value <- withCallingHandlers(
    tryCatch(expression, error = function(condition) { hear(condition); NULL }),
    warning = function(condition) { hear(condition); tryInvokeRestart("muffleWarning") },
    message = function(condition) tryInvokeRestart("muffleMessage")
  )
  list(value = value, complaints = complaints)
}

