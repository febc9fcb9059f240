# Draws from a posterior whose logarithm a function gives: Metropolis' random walk by the package
# mcmc, four chains at a time, their steps learnt from what the chains before them drew (Roberts,
# Gelman and Gilks 1997), until the chains agree (Vehtari et al. 2021).
# SPDX-License-Identifier: MIT

kChains <- 4
kWarmUps <- 3
kWarmUpDraws <- 300    # of a chain, each time
kFirstDraws <- 500     # then half as many again, each time: judging chains takes long, too
kRoundDraws <- 4000    # at most at once, so that it can be told how far it is
kMostDraws <- 30000
kEnoughDraws <- 400    # that are worth as many independent ones, of each parameter
kLargestRhat <- 1.01

# `density(x)` is the logarithm, but for a constant; -Inf where nothing can be. `mode` and
# `covariance` are a normal distribution that is not far from it. `tell(share)` hears how far it is.
# Returns list(chains, rhat, enough): draws x parameters of each chain; of each parameter Rhat and the
# number of independent draws that its draws are worth.
sample_posterior <- function(density, mode, covariance, tell = function(share) NULL) {
  last <- lapply(seq_len(kChains), function(chain) dispersed_start(density, mode, covariance))
  walk <- function(draws) {
    chains <- lapply(last, function(from) {
      mcmc::metrop(density, from, draws, scale = walk_scale(covariance))$batch
    })
    last <<- lapply(chains, function(chain) chain[nrow(chain), ])
    chains
  }
  for (time in seq_len(kWarmUps)) {
    drawn <- do.call(rbind, lapply(walk(kWarmUpDraws), utils::tail, kWarmUpDraws %/% 2))
    covariance <- stats::cov(drawn) + 1e-10 * diag(length(mode))
  }
  chains <- walk(kFirstDraws)
  repeat {
    sampled <- judge_chains(chains)
    tell(min(1, sampled$enough / kEnoughDraws))
    drawn <- nrow(chains[[1]])
    agree <- all(sampled$rhat <= kLargestRhat) && all(sampled$enough >= kEnoughDraws)
    if (agree || drawn >= kMostDraws) return(sampled)
    chains <- Map(rbind, chains, walk(min(drawn %/% 2, kRoundDraws, kMostDraws - drawn)))
  }
}

# The step of a random walk that is best for a normal distribution.
walk_scale <- function(covariance) 2.38 / sqrt(nrow(covariance)) * t(chol(covariance))

# Where a chain begins: twice as far from the middle as its draws will be.
dispersed_start <- function(density, mode, covariance) {
  for (time in 1:100) {
    start <- mode + 2 * drop(t(chol(covariance)) %*% stats::rnorm(length(mode)))
    if (is.finite(density(start))) return(start)
  }
  mode
}

judge_chains <- function(chains) {
  list_of_chains <- do.call(coda::mcmc.list, lapply(chains, coda::mcmc))
  rhat <- coda::gelman.diag(list_of_chains, autoburnin = FALSE, multivariate = FALSE)$psrf[, 1]
  rhat[is.nan(rhat)] <- Inf  # a chain that never moved
  list(chains = chains, rhat = unname(rhat), enough = unname(coda::effectiveSize(list_of_chains)))
}
