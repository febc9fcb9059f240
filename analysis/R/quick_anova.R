# One factor's test in a repeated-measures ANOVA, at a thousandth of the cost of the whole one.
# SPDX-License-Identifier: MIT

# p of the effect that the columns of `means` (participants by levels, no NA) have, corrected after
# Greenhouse and Geisser (1959); NA where nothing varies. With a complete design it is the main effect
# of the whole factorial ANOVA. epsilon = tr(S)^2 / ((k - 1) tr(S S)), S the covariance of
# orthonormal contrasts.
greenhouse_geisser_p <- function(means) {
  n <- nrow(means)
  df <- ncol(means) - 1
  contrasts <- means %*% qr.Q(qr(stats::contr.helmert(ncol(means))))
  covariance <- stats::cov(contrasts)
  error <- sum(diag(covariance))
  if (is.na(error) || error < 1e-12) return(NA_real_)
  epsilon <- error^2 / (df * sum(covariance^2))
  stats::pf(n * sum(colMeans(contrasts)^2) / error, df * epsilon, df * (n - 1) * epsilon,
    lower.tail = FALSE)
}
