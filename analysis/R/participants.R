# Who is analysed, and their means: the unit of every test is the participant.
# SPDX-License-Identifier: MIT

# Keeps people and simulated participants apart. Where a study has both, the simulated ones are
# left out, and study$excluded says so: one row per participant left out, with the reason.
keep_people_apart <- function(study) {
  trials <- study$trials
  made_up <- trials$simulated == 1 | trials$device == "simulated"
  study$excluded <- data.frame(participant = character(), trials = integer(), reason = character())
  study$all_simulated <- all(made_up)
  if (!any(made_up) || all(made_up)) return(study)
  counts <- table(trials$participant[made_up])
  study$excluded <- data.frame(
    participant = names(counts), trials = as.integer(counts),
    reason = "simulated, in a study that has people"
  )
  study$trials <- trials[!made_up, ]
  study$trials[study$factors] <- lapply(study$trials[study$factors], droplevels)
  study$catch <- study$catch[study$catch$participant %in% study$trials$participant, ]
  study
}

participant_count <- function(trials) length(unique(trials$participant))

# The design's factors that vary in these trials.
varying_factors <- function(trials, factors) {
  factors[vapply(factors, function(f) nlevels(droplevels(trials[[f]])) > 1, logical(1))]
}

# Means of the column `of` as a matrix: participants by cells of `factors`, the last factor varying
# fastest. NA where a participant has no trial. Columns are named by their levels, "100 : 5".
participant_means <- function(trials, factors, of = "rating") {
  cell <- interaction(trials[rev(factors)], drop = FALSE)
  cells <- expand.grid(lapply(trials[rev(factors)], levels))
  means <- tapply(trials[[of]], list(as.character(trials$participant), cell), mean)
  colnames(means) <- do.call(paste, c(unname(as.list(rev(cells))), sep = " : "))
  means
}

# The participants who have a rating in every cell.
complete_participants <- function(means) means[stats::complete.cases(means), , drop = FALSE]

# Means with within-participant intervals over the participants who have every cell; without
# intervals, over everybody, when nobody has.
means_with_intervals <- function(trials, factors, of = "rating") {
  trials[factors] <- lapply(trials[factors], droplevels)
  means <- participant_means(trials, factors, of)
  complete <- complete_participants(means)
  rows <- if (nrow(complete) > 0) cousineau_morey(complete) else data.frame(
    cell = colnames(means), mean = colMeans(means, na.rm = TRUE), low = NA_real_, high = NA_real_
  )
  rows[factors] <- do.call(rbind, strsplit(as.character(rows$cell), " : ", fixed = TRUE))
  rows$x <- position_of(rows[[factors[1]]])
  rows[!is.nan(rows$mean), ]
}

# Numbers stand at their value on the axis, words at 1, 2, 3 in their order.
position_of <- function(level) {
  number <- suppressWarnings(as.numeric(level))
  if (anyNA(number)) as.integer(factor(level, unique(level))) else number
}
