# The fit of a cumulative-link mixed model: ratings with random effects of each participant, by
# Laplace's approximation and its exact gradient.
#
#   P(rating <= k) = F(alpha_k - eta),   eta = x' beta + z' L u,   u ~ N(0, I) of each participant
#   inner:  u of each participant at the top of its likelihood, by Newton's method
#   outer:  minimise sum over participants of h + 1/2 log det H, where
#           h = u'u / 2 - log P(the participant's ratings | u) and H is its second derivative in u
#
# z says what of u a rating sees, and L how much of it: a matrix whose elements are the parameters,
# which random_effects() places.
#
#   intercept            z = 1                    L = a
#   intercept and slope  z = (1, slope)           L = (a, 0; b, c)
#   levels, cells        z = (1, 0 0 1 0, ...)    L = diagonal, one parameter for all levels of a term
#
# The model and its approximation are those of ordinal::clmm (Christensen 2018), which takes the
# outer derivatives by differences and a hundred times as long; the tests compare the two. Matrices of
# each participant are rows of one matrix, column by column, so that all participants are computed at
# once.
# SPDX-License-Identifier: MIT

kFarOut <- 200  # stands for infinity: F is 0 or 1 there to the last digit, whatever the link

# Each link's F below and above x, its density and the density's first two derivatives.
kLinks <- list(
  logit = function(x) {
    f <- stats::dlogis(x)
    below <- stats::plogis(x)
    list(below = below, above = stats::plogis(-x), f = f, f1 = f * (1 - 2 * below), f2 = f * (1 - 6 * f))
  },
  probit = function(x) {
    f <- stats::dnorm(x)
    list(below = stats::pnorm(x), above = stats::pnorm(-x), f = f, f1 = -x * f, f2 = (x^2 - 1) * f)
  },
  cloglog = function(x) {
    rate <- exp(x)
    f <- exp(x - rate)
    list(below = -expm1(-rate), above = exp(-rate), f = f, f1 = f * (1 - rate),
      f2 = f * ((1 - rate)^2 - rate))
  })

# The random effects in lme4's words, such as "(1 + slope | participant)" or "(1 | participant) +
# (1 | participant:level)", of each row of trials: list(Z, rows by elements of u; places, of each
# parameter of L its elements as matrix(row, column); of, what deviates by it).
random_effects <- function(trials, random) {
  if (has_slope(random)) {
    return(list(Z = cbind(1, trials$slope), of = c("intercept", "slope", "slope"),
      places = list(cbind(1, 1), cbind(2, 1), cbind(2, 2))))
  }
  terms <- random_terms(random)
  Z <- lapply(terms, function(columns) {
    if (length(columns) == 0) return(matrix(1, nrow(trials)))
    cell <- as.integer(interaction(trials[columns], drop = TRUE))
    outer(cell, seq_len(max(cell)), `==`) + 0
  })
  of_term <- rep(seq_along(Z), vapply(Z, ncol, 0L))
  list(Z = do.call(cbind, Z), places = lapply(seq_along(Z), function(term) {
    cbind(which(of_term == term), which(of_term == term))
  }), of = c("intercept", vapply(terms[-1], paste, "", collapse = " × ")))
}

# The columns whose levels within a participant have an effect, of each term without a slope.
random_terms <- function(random) {
  of <- regmatches(random, gregexpr("participant[^)]*", random))[[1]]
  lapply(strsplit(of, ":", fixed = TRUE), `[`, -1)
}

# The fit from `start`, c(alpha, beta), and `spread`, the parameters of L: list(alpha, beta,
# covariance (of beta), log_likelihood, df (coefficients), spread, deviations, eta, gradient,
# Hessian), or list(failure = words).
# `design`: one row per rating, without an intercept; `person`: whole numbers from 1.
fit_cumulative_link <- function(rating, design, person, random, link, start, spread) {
  data <- link_data(rating, design, person, random, link)
  at <- remembered_fit(data)
  found <- stats::nlminb(c(start, spread), function(place) at(place)$value,
    function(place) at(place)$gradient, control = list(eval.max = 1000, iter.max = 500))
  described_link_fit(data, at, found)
}

# What every evaluation needs; `parts`: each parameter's derivative of L; `pairs`: products of two
# columns of Z, where they are not 0 throughout; `pair_at`: of each element of a matrix, its pair.
link_data <- function(rating, design, person, random, link) {
  q <- ncol(random$Z)
  elements <- expand.grid(row = seq_len(q), column = seq_len(q))
  pairs <- subset(elements, row <= column)
  products <- random$Z[, pairs$row, drop = FALSE] * random$Z[, pairs$column, drop = FALSE]
  met <- colSums(products != 0) > 0
  pair_at <- outer(pmin(elements$row, elements$column), pairs$row[met], `==`) *
    outer(pmax(elements$row, elements$column), pairs$column[met], `==`)
  list(rating = rating, design = design, person = person, link = kLinks[[link]], Z = random$Z,
    pairs = products[, met, drop = FALSE], pair_at = pair_at,
    parts = lapply(random$places, function(place) replace(matrix(0, q, q), place, 1)),
    of = random$of, people = max(person), thresholds = max(rating) - 1)
}

# The objective at a place, as a function that begins each search for u where the last one ended and
# computes the same place once.
remembered_fit <- function(data) {
  last <- list(place = NULL, u = matrix(0, data$people, ncol(data$Z)))
  function(place) {
    if (!identical(place, last$place)) last <<- laplace_at(data, place, last$u)
    last
  }
}

# What a place says: alpha, beta, the parameters of L, L, and LL, by which L' M L is one product.
parts_of_place <- function(data, place) {
  alpha <- seq_len(data$thresholds)
  beta <- data$thresholds + seq_len(ncol(data$design))
  spread <- place[-c(alpha, beta)]
  L <- Reduce(`+`, Map(`*`, spread, data$parts))
  list(alpha = place[alpha], beta = place[beta], spread = spread, L = L, LL = L %x% L)
}

# list(place, value, gradient, u, eta) of the objective. `u`: where the search for u begins.
laplace_at <- function(data, place, u) {
  parts <- parts_of_place(data, place)
  if (is.unsorted(parts$alpha, strictly = TRUE) || any(!is.finite(place))) {
    return(list(place = place, value = Inf, gradient = NA * place, u = u))
  }
  fixed <- as.vector(data$design %*% parts$beta)
  inner <- top_of_likelihood(data, parts, fixed, u)
  value <- sum(inner$h) + sum(inner$log_det) / 2
  list(place = place, value = value, gradient = laplace_gradient(data, parts, inner), u = inner$u,
    eta = inner$eta)
}

# Newton's method in every participant's u at once; a step that does not lower h is halved. h is
# convex in u, so there is one lowest place.
top_of_likelihood <- function(data, parts, fixed, u) {
  here <- likelihood_at(data, parts, fixed, u)
  for (round in 1:100) {
    if (max(abs(here$g)) < 1e-9) break
    step <- times_each(here$V, here$g)
    repeat {
      there <- likelihood_at(data, parts, fixed, here$u - step)
      worse <- !(there$h <= here$h + 1e-9 * abs(here$h))
      if (!any(worse) || max(abs(step)) < 1e-12) break
      step[worse, ] <- step[worse, ] / 2
    }
    here <- there
  }
  here
}

# At given u: h of each participant, its gradient g and the inverse V of its second derivative H;
# S and M: the sums over a participant of Z l1 and of -Z Z' l2.
likelihood_at <- function(data, parts, fixed, u) {
  eta <- fixed + rowSums(data$Z * (u %*% t(parts$L))[data$person, , drop = FALSE])
  terms <- rating_terms(data, parts$alpha, eta)
  S <- sums_of_each(data, data$Z * terms$l1)
  M <- tcrossprod(sums_of_each(data, data$pairs * -terms$l2), data$pair_at)
  H <- M %*% parts$LL
  H <- H + rep(diag(ncol(u)), each = nrow(u))
  inverse <- inverse_of_each(H)
  list(u = u, eta = eta, terms = terms, h = rowSums(u^2) / 2 - sums_of_each(data, terms$log_p)[, 1],
    log_det = inverse$log_det, S = S, M = M, g = u - S %*% parts$L, V = inverse$V)
}

sums_of_each <- function(data, x) rowsum(x, data$person, reorder = TRUE)

# The inverse of each row's symmetric positive-definite matrix, by Gauss and Jordan, and the
# logarithm of its determinant.
inverse_of_each <- function(A) {
  q <- sqrt(ncol(A))
  row_of <- rep(seq_len(q), q)
  column_of <- rep(seq_len(q), each = q)
  log_det <- 0
  for (k in seq_len(q)) {
    column <- A[, column_of == k, drop = FALSE]
    pivot <- column[, k]
    row <- A[, row_of == k, drop = FALSE] / pivot
    A <- A - column[, row_of, drop = FALSE] * row[, column_of, drop = FALSE]
    A[, row_of == k] <- row
    A[, column_of == k] <- -column / pivot
    A[, (k - 1) * q + k] <- 1 / pivot
    log_det <- log_det + log(pivot)
  }
  list(V = A, log_det = log_det)
}

# Each row's matrix by the same row's vector.
times_each <- function(A, x) {
  q <- ncol(x)
  products <- A * x[, rep(seq_len(q), each = q), drop = FALSE]
  products %*% (matrix(1, q) %x% diag(q))
}

# log P of each rating, and its first three derivatives in eta (l1, l2, l3); `high` and `low`: what
# the threshold above and the one below need for theirs.
rating_terms <- function(data, alpha, eta) {
  edges <- c(-Inf, alpha, Inf)
  within <- function(x) pmin(pmax(x, -kFarOut), kFarOut)
  high <- data$link(within(edges[data$rating + 1] - eta))
  low <- data$link(within(edges[data$rating] - eta))
  # The difference of the smaller tails, which loses no digits.
  P <- pmax(ifelse(low$below > 0.5, low$above - high$above, high$below - low$below), 1e-300)
  l1 <- (low$f - high$f) / P
  second <- (high$f1 - low$f1) / P
  l2 <- second - l1^2
  l3 <- (low$f2 - high$f2) / P - 3 * l1 * second + 2 * l1^3
  list(log_p = log(P), l1 = l1, l2 = l2, l3 = l3, P = P, high = high, low = low)
}

# Derivatives of log P in a threshold, and of that once and twice in eta. `edge`: high or low.
threshold_terms <- function(terms, edge, sign) {
  first <- sign * edge$f / terms$P
  mixed <- -sign * edge$f1 / terms$P
  second <- mixed - first * terms$l1
  list(d1 = first, d2 = second, d3 = sign * edge$f2 / terms$P - mixed * terms$l1 -
    second * terms$l1 - first * terms$l2)
}

# The exact gradient of the objective. v is the variance of eta given the ratings, K the sum of Z v l3
# over a participant; what a change of u adds through H is carried by r = L W, W = V L' K.
laplace_gradient <- function(data, parts, inner) {
  terms <- inner$terms
  L <- parts$L
  M <- inner$M
  v <- rowSums((tcrossprod(inner$V, parts$LL) %*% data$pair_at)[data$person, , drop = FALSE] * data$pairs)
  K <- sums_of_each(data, data$Z * (v * terms$l3))
  W <- times_each(inner$V, K %*% L)
  r <- W %*% t(L)
  carried <- rowSums(data$Z * r[data$person, , drop = FALSE])
  of_spread <- vapply(data$parts, function(D) {
    Du <- inner$u %*% t(D)
    sum(M * (inner$V %*% t(D %x% L))) - sum((inner$S + K / 2) * Du) -
      sum(inner$S * (W %*% t(D))) / 2 + sum(r * times_each(M, Du)) / 2
  }, 0)
  total <- function(d1, d2, d3) d1 + v * d3 / 2 + carried * d2 / 2
  high <- do.call(total, threshold_terms(terms, terms$high, 1))
  low <- do.call(total, threshold_terms(terms, terms$low, -1))
  of_alpha <- vapply(seq_len(data$thresholds), function(k) {
    sum(high[data$rating == k]) + sum(low[data$rating == k + 1])
  }, 0)
  of_beta <- crossprod(data$design, total(terms$l1, terms$l2, terms$l3))
  c(-of_alpha, -of_beta, of_spread)
}

# The fit at the place that was found, or why it is none. A participant's spread of 0 is at the edge
# of what it may be: the other numbers' errors are those of the model without it.
described_link_fit <- function(data, at, found) {
  here <- at(found$par)
  if (anyNA(here$gradient)) return(list(failure = "the optimiser found no likelihood"))
  parts <- parts_of_place(data, found$par)
  of_spread <- utils::tail(seq_along(found$par), length(data$parts))
  # Where a column of L has nothing on its diagonal, the rest of it turns an element of u alone.
  edge <- of_spread[abs(diag(parts$L))[column_of_parameter(data)] < kNoSpread]
  inside <- setdiff(seq_along(found$par), edge)
  Hessian <- derivative_of_gradient(at, found$par)[inside, inside, drop = FALSE]
  covariance <- listen_to(chol2inv(chol(Hessian)))$value
  # Without any spread this is no mixed model: the logarithm of the spread has no estimate.
  if (is.null(covariance) || length(edge) == length(of_spread)) {
    return(list(failure = "its Hessian is singular"))
  }
  # How far the log likelihood is from its top, were it a parabola.
  step <- as.vector(covariance %*% here$gradient[inside])
  if (sum(here$gradient[inside] * step) / 2 > kBelowTop) {
    return(list(failure = "the optimiser stopped before the top"))
  }
  here <- at(replace(found$par, inside, found$par[inside] - step))  # the last step, Newton's
  parts <- parts_of_place(data, here$place)
  of_beta <- data$thresholds + seq_len(ncol(data$design))
  names <- colnames(data$design)
  list(alpha = parts$alpha, beta = stats::setNames(parts$beta, names),
    covariance = matrix(covariance[of_beta, of_beta], length(names), dimnames = list(names, names)),
    log_likelihood = -here$value, df = length(parts$beta), spread = parts$spread,
    deviations = vapply(split(parts$spread^2, factor(data$of, unique(data$of))), function(squares) {
      sqrt(sum(squares))
    }, 0), eta = here$eta, gradient = here$gradient, Hessian = Hessian)
}

# The first column of L in which each parameter stands.
column_of_parameter <- function(data) {
  vapply(data$parts, function(D) which(colSums(D) > 0)[1], 0L)
}

kBelowTop <- 1e-5  # of log likelihood: a hundredth of what fit_rating_model takes for a better model
kNoSpread <- 1e-3  # logits: participants who differ by less do not differ

# Second derivatives by central differences of the exact gradient.
derivative_of_gradient <- function(at, place) {
  step <- 1e-4
  columns <- vapply(seq_along(place), function(i) {
    shift <- replace(numeric(length(place)), i, step)
    (at(place + shift)$gradient - at(place - shift)$gradient) / (2 * step)
  }, numeric(length(place)))
  (columns + t(columns)) / 2
}
