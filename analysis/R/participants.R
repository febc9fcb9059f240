# Who is analysed, their means, which are the unit of every test, and intervals of means over them.
# SPDX-License-Identifier: MIT

kAmongPeople <- "simulated, in a study that has people"  # why one is left out

# Keeps people and simulated participants apart. Where a study has both, the simulated ones are
# left out, and study$excluded says so: one row per participant left out, with the reason.
keep_people_apart <- function(study) {
  trials <- study$trials
  made_up <- trials$simulated == 1 | trials$device == "simulated"
  study$all_simulated <- all(made_up)
  counts <- table(trials$participant[made_up & !all(made_up)])
  study$excluded <- data.frame(participant = as.character(names(counts)),
    trials = as.integer(counts),
    reason = rep(kAmongPeople, length(counts)))
  if (length(counts) == 0) return(study)
  study$trials <- trials[!made_up, ]
  study$trials[study$factors] <- lapply(study$trials[study$factors], droplevels)
  study$catch <- study$catch[study$catch$participant %in% study$trials$participant, ]
  study
}

participant_count <- function(rows) length(unique(rows$participant))

# The design's factors that vary in these trials.
varying_factors <- function(trials, factors) {
  factors[vapply(factors, function(f) nlevels(droplevels(trials[[f]])) > 1, NA)]
}

# Those of the factors of which every participant has one level: they are tested between participants.
between_factors <- function(trials, factors) {
  if (participant_count(trials) < 2) return(character())
  unname(factors[vapply(factors, function(f) {
    own <- tapply(as.character(trials[[f]]), as.character(trials$participant),
      function(level) length(unique(level)))
    nlevels(droplevels(trials[[f]])) > 1 && all(own == 1)
  }, NA)])
}

within_factors <- function(trials, factors) setdiff(factors, between_factors(trials, factors))

# Why tests that pair a participant's means say nothing of them; nothing where there are none.
between_remark <- function(test, factors) {
  if (length(factors) == 0) return(character())
  sprintf("%s of %s: each participant has one level of it.", test, and_words(factors))
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

# participant_means in long form: participant, mean and a column for each factor; no empty cells.
long_means <- function(means, factors) {
  rows <- data.frame(participant = rep(rownames(means), ncol(means)), mean = as.vector(means))
  rows[factors] <- cell_factors(rep(colnames(means), each = nrow(means)))
  rows[!is.na(rows$mean), ]
}

cell_factors <- function(cells) {
  do.call(rbind, strsplit(as.character(cells), " : ", fixed = TRUE))
}

# Means with within-participant intervals over the participants who have every cell; with Student's
# t intervals over those of each cell where a factor is between participants; without intervals, over
# everybody, when nobody has every cell.
means_with_intervals <- function(trials, factors, of = "rating") {
  trials[factors] <- lapply(trials[factors], droplevels)
  means <- participant_means(trials, factors, of)
  complete <- complete_participants(means)
  rows <- if (nrow(complete) > 0) cousineau_morey(complete) else
    if (length(between_factors(trials, factors)) > 0) t_intervals(means) else data.frame(
    cell = colnames(means), mean = colMeans(means, na.rm = TRUE), low = NA_real_, high = NA_real_)
  rows[factors] <- cell_factors(rows$cell)
  if (of == "positive") {  # a share
    rows$low <- pmax(rows$low, 0)
    rows$high <- pmin(rows$high, 1)
  }
  rows[!is.nan(rows$mean), ]
}

# Over whom means_with_intervals() takes its means, where that is not everybody: " Means: ..."; nothing
# where a factor is between participants, whose means are of each level's own.
mean_base_words <- function(trials, factors, of = "rating") {
  trials[factors] <- lapply(trials[factors], droplevels)
  means <- participant_means(trials, factors, of)
  shown <- nrow(complete_participants(means))
  cell <- if (length(factors) > 1) "combination" else "level"
  if (shown == nrow(means)) return("")
  if (shown > 0) return(sprintf(" Means: %d of %d participants, those with a trial at every %s.", shown,
    nrow(means), cell))
  if (length(between_factors(trials, factors)) > 0) return("")
  sprintf(" Nobody has a trial at every %s: each mean is over those who have it.", cell)
}

# Who has no trial in some combination of the factors within participants, and what that does.
unbalanced_sentence <- function(study) {
  trials <- study$trials
  factors <- within_factors(trials, varying_factors(trials, unname(study$factors)))
  if (length(factors) < 2 || identical(study$response, "threshold")) return(character())
  trials$there <- 1
  trials[factors] <- lapply(trials[factors], droplevels)
  means <- participant_means(trials, factors, "there")
  lacking <- nrow(means) - nrow(complete_participants(means))
  if (lacking == 0) return(character())
  sprintf(paste("%d of %d participants %s some combination of %s: means by one factor, Friedman's test",
    "and comparisons of two levels take what trials there are, so that they also hold effects of the",
    "other factors; the ANOVA leaves these participants out."), lacking, nrow(means),
    if (lacking == 1) "lacks" else "lack", and_words(vapply(factors, plain_name, "")))
}

# Student's t interval of the mean of `x`: c(mean, low, high); no limits for fewer than two values.
t_interval <- function(x, level = 0.95) {
  n <- length(x)
  half <- if (n > 1) stats::qt((1 + level) / 2, n - 1) * stats::sd(x) / sqrt(n) else NA
  c(mean = mean(x), low = mean(x) - half, high = mean(x) + half)
}

# Student's t intervals of the columns' means, each over the participants who have it.
t_intervals <- function(means) {
  rows <- apply(means, 2, function(x) t_interval(x[!is.na(x)]))
  data.frame(cell = colnames(means), mean = rows["mean", ], low = rows["low", ],
    high = rows["high", ], row.names = NULL)
}

# Within-participant intervals of the columns' means, one row per column of `means`.
#
# Each participant's own mean is taken out, the grand mean put back (Cousineau 2005), and the
# standard error widened by sqrt(J / (J - 1)) for J columns (Morey 2008). They show what a
# comparison between the columns can show, not how people differ. Precondition: no NA.
cousineau_morey <- function(means, level = 0.95) {
  columns <- ncol(means)
  normalised <- means - rowMeans(means) + mean(means)
  half <- if (nrow(means) > 1 && columns > 1) sqrt(columns / (columns - 1)) *
    apply(normalised, 2, function(x) diff(t_interval(x, level)[c("mean", "high")])) else NA
  data.frame(cell = colnames(means), mean = colMeans(means), low = colMeans(means) - half,
    high = colMeans(means) + half, row.names = NULL)
}

# Interval of partial eta squared from the noncentral F: c(low, high) (Smithson 2001; Steiger 2004).
#
# A limit is lambda / (lambda + df1 + df2 + 1), where the noncentrality lambda puts the observed F
# at the tail's probability. 90 % by convention: its lower limit exceeds 0 just when p < .05.
eta_squared_interval <- function(F, df1, df2, level = 0.90) {
  as_eta_squared(noncentrality_limits(F, df1, df2, level), df1, df2)
}

# c(low, high) of the noncentrality.
noncentrality_limits <- function(F, df1, df2, level = 0.90) {
  tail <- (1 - level) / 2
  vapply(c(low = 1 - tail, high = tail), function(p) noncentrality_at(p, F, df1, df2), 0)
}

as_eta_squared <- function(lambda, df1, df2) lambda / (lambda + df1 + df2 + 1)

# The noncentrality at which P(F' <= F) = probability; 0 where even the central F is below it.
noncentrality_at <- function(probability, F, df1, df2) {
  below <- function(lambda) stats::pf(F, df1, df2, ncp = lambda) - probability
  if (below(0) <= 0) return(0)
  upper <- max(1, F * df1)
  while (suppressWarnings(below(upper)) > 0) upper <- 2 * upper
  suppressWarnings(stats::uniroot(below, c(0, upper), tol = 1e-9 * upper)$root)
}

# Percentile bootstrap over participants (rows) of `statistic(means)`: c(low, high). Its tails are
# those that the normal law gives Student's t interval, wider by sqrt(n / (n - 1)): plain percentiles
# of n participants are too narrow (Hesterberg 2015, "expanded percentile"). Seeded, so that a table is
# the same every time it is made; the caller's random numbers are left as they were.
bootstrap_interval <- function(means, statistic, level = 0.95, draws = 2000) {
  n <- nrow(means)
  values <- withr::with_seed(1, replicate(draws, {
    statistic(means[sample(n, replace = TRUE), , drop = FALSE])
  }))
  tail <- if (n < 2) (1 - level) / 2 else
    stats::pnorm(-sqrt(n / (n - 1)) * stats::qt((1 + level) / 2, n - 1))
  stats::setNames(stats::quantile(values, c(tail, 1 - tail), na.rm = TRUE), c("low", "high"))
}
