# How often the tests of simulated studies reject: power, and the type-I error without an effect.
#
#   ledger: study, test ─> one row per (effect, participants, factor): rejected, rate, its interval
#
# The interval is the Monte-Carlo one: exact (Clopper and Pearson 1934), for a limited number of
# studies. Rejected: p < .05 after Holm within the factors that are tested, as the report of a real
# study decides; `alone`: p < .05 as it is, which is what a test's own type-I error is about.
# A study whose test could not be made did not reject.
# SPDX-License-Identifier: MIT

kWantedPower <- 0.8

power_rates <- function(ledger) {
  tests <- DBI::dbGetQuery(ledger, "SELECT * FROM test ORDER BY effect DESC, number, participants, factor")
  if (nrow(tests) == 0) refuse("expected studies in the ledger, got none yet")
  study <- paste(tests$effect, tests$number, tests$participants)
  tests$p_holm <- stats::ave(tests$p, study, FUN = function(p) stats::p.adjust(p, "holm"))
  cells <- split(tests, list(tests$participants, tests$effect, tests$factor), drop = TRUE)
  rates <- do.call(rbind, lapply(unname(cells), function(cell) {
    holm <- rejection_share(cell$p_holm)
    alone <- rejection_share(cell$p)
    data.frame(factor = cell$factor[1], effect = cell$effect[1],
      participants = cell$participants[1], studies = nrow(cell), untested = sum(is.na(cell$p)),
      rejected = holm$rejected, rate = holm$rate, low = holm$low, high = holm$high,
      alone = alone$rejected, alone_rate = alone$rate, alone_low = alone$low,
      alone_high = alone$high)
  }))
  rates[order(-rates$effect, rates$factor, rates$participants), ]
}

# How many p are below .05, with the exact 95 % interval of the rate.
rejection_share <- function(p) {
  rejected <- sum(p < kSignificance, na.rm = TRUE)
  interval <- stats::binom.test(rejected, length(p))$conf.int
  data.frame(rejected = rejected, rate = rejected / length(p), low = interval[1],
    high = interval[2])
}

# The families of a factor tested alone need no correction.
power_family_size <- function(rates) length(unique(rates$factor))

# ".987 [.978, .993]"
rate_words <- function(rate, low, high) {
  digits <- function(x) ifelse(x == 1, "1", sub("^0", "", sprintf("%.3f", x)))
  sprintf("%s [%s, %s]", digits(rate), digits(low), digits(high))
}
