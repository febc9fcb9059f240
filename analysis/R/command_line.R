# How a command of analysis/ runs: its code, its arguments, where its words go, and refusals in one
# sentence. Results go to stdout, progress and refusals to stderr.
# SPDX-License-Identifier: MIT

# Runs `main(words)` of the command at `script` with its words; whatever stops it becomes one
# sentence on stderr and exit status 2. The code is the folder R/ beside the script, whose path is that
# of commandArgs(), where Rscript writes a space as "~+~".
run_command <- function(script, main) {
  script <- gsub("~+~", " ", script, fixed = TRUE)
  # UTF-8 letters and one order of sorting, whatever the machine is set to.
  suppressWarnings(Sys.setlocale("LC_ALL", "C.UTF-8"))
  options(impetus.analysis = dirname(script))
  for (file in list.files(file.path(dirname(script), "R"), "[.]R$", full.names = TRUE)) {
    source(file, encoding = "UTF-8")
  }
  save_time()
  exit <- function(sentence) {
    end_progress()
    message(basename(script), ": ", gsub("\\s*\n\\s*", " ", trimws(sentence)))
    quit(save = "no", status = 2)
  }
  tryCatch(invisible(main(commandArgs(trailingOnly = TRUE))),
    refusal = function(condition) exit(conditionMessage(condition)),
    error = function(condition) {
      exit(paste("could not finish; this is a defect of the script:", conditionMessage(condition)))
    }
  )
}

# R spends no time on what gains none here. Most functions are called once or twice: compiling them
# first takes a sixth of a report. And packages time what they do (mcmc each chain, TMB each fit) by
# a function that first collects the garbage of all that is loaded: it takes longer than a small fit.
save_time <- function() {
  compiler::enableJIT(0)
  time <- base::system.time
  formals(time)$gcFirst <- FALSE
  unlockBinding("system.time", baseenv())
  assign("system.time", time, baseenv())
  lockBinding("system.time", baseenv())
}

# A file that stands beside the code.
code_file <- function(name) file.path(getOption("impetus.analysis"), "R", name)

# The command of a study: analysis/NAME.R is the report of the study NAME (studies.R) alone.
run_study_command <- function(script) {
  name <- sub("[.]R$", "", basename(script))
  run_command(script, function(words) {
    report_page(read_arguments(words, sprintf("Rscript analysis/%s.R study.sqlite --out report/", name)),
      name)
  })
}

# Stops with one sentence for the user, which run_command says.
refuse <- function(...) stop_with_sentence("refusal", ...)

# The same where a study has no answers to analyse (yet): a simulated one may end so.
refuse_without_answers <- function(...) stop_with_sentence(c("without_answers", "refusal"), ...)

stop_with_sentence <- function(classes, ...) {
  stop(structure(class = c(classes, "error", "condition"), list(message = paste0(...), call = NULL)))
}

# "study.sqlite [more.sqlite ...] --out folder" -> list(studies, out). Prints `usage` for --help.
read_arguments <- function(words, usage) {
  if (any(words %in% c("-h", "--help"))) {
    say(paste("usage:", usage))
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

# Refuses unless every package is installed, naming the Debian packages that are missing. A package is
# loaded where it is first used: together they take seconds, and a small study needs few of them.
need_packages <- function(packages) {
  missing <- packages[!vapply(packages, function(package) nzchar(system.file(package = package)), NA)]
  if (length(missing) == 0) return(invisible())
  refuse("expected these R packages to be installed: ", paste(missing, collapse = ", "),
    " (on Debian: apt-get install ", paste0("r-cran-", tolower(missing), collapse = " "), ")")
}

# Makes the folder where it is absent; refuses where it cannot be written.
prepare_folder <- function(folder) {
  if (!dir.exists(folder)) suppressWarnings(dir.create(folder, recursive = TRUE))
  if (!dir.exists(folder) || file.access(folder, 2) != 0) {
    refuse(folder, ": expected a folder to write to, could not make it or write in it")
  }
}

say <- function(lines) writeLines(enc2utf8(lines), stdout(), useBytes = TRUE)

# Evaluates `expression` in silence. Returns list(value, complaints): value is NULL after an
# error, complaints holds the text of every warning and of the error.
listen_to <- function(expression) {
  complaints <- character()
  hear <- function(condition) complaints <<- c(complaints, conditionMessage(condition))
  value <- withCallingHandlers(
    tryCatch(expression, error = function(condition) { hear(condition); NULL }),
    warning = function(condition) { hear(condition); tryInvokeRestart("muffleWarning") },
    message = function(condition) tryInvokeRestart("muffleMessage"))
  list(value = value, complaints = complaints)
}
