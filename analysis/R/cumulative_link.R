# The fit of a cumulative-link mixed model: ratings with an intercept, and perhaps a slope, of each
# participant, by Laplace's approximation and its exact gradient.
#
#   P(rating <= k) = F(alpha_k - eta),   eta = x' beta + z' L u,   z = (1, slope),   u ~ N(0, I)
#   inner:  u of each participant at the top of its likelihood, by Newton's method
#   outer:  minimise sum over participants of h + 1/2 log det H, where
#           h = u'u / 2 - log P(the participant's ratings | u) and H is its second derivative in u
#
# The model and its approximation are those of ordinal::clmm (Christensen 2018), which takes the
# outer derivatives by differences and a hundred times as long; the tests compare the two.
# L = (a, 0; b, c) is lower triangular; every participant's 2 by 2 matrices are written out, so that
# all participants are computed at once. An intercept alone is z = (1, 0) and L = (a, 0; 0, 0).
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

# The fit from `start`, c(alpha, beta), and `spread`, c(a, b, c): list(alpha, beta, covariance (of
# beta), log_likelihood, df (coefficients), spread, deviations, eta, gradient, Hessian), or
# list(failure = words).
# `design`: one row per rating, without an intercept; `slope`: NULL for an intercept alone;
# `person`: whole numbers from 1.
fit_cumulative_link <- function(rating, design, person, slope, link, start, spread) {
  data <- list(rating = rating, design = design, person = person, link = kLinks[[link]],
    slope = if (is.null(slope)) numeric(length(rating)) else slope, people = max(person),
    thresholds = max(rating) - 1, free = if (is.null(slope)) 1 else 1:3)
  at <- remembered_fit(data)
  start <- c(start, spread[data$free])
  found <- stats::nlminb(start, function(place) at(place)$value, function(place) at(place)$gradient,
    control = list(eval.max = 1000, iter.max = 500))
  described_link_fit(data, at, found)
}

# The objective at a place, as a function that begins each search for u where the last one ended and
# computes the same place once.
remembered_fit <- function(data) {
  last <- list(place = NULL, u = matrix(0, data$people, 2))
  function(place) {
    if (!identical(place, last$place)) last <<- laplace_at(data, place, last$u)
    last
  }
}

# What a place says: alpha, beta and L's a, b, c.
parts_of_place <- function(data, place) {
  alpha <- seq_len(data$thresholds)
  beta <- data$thresholds + seq_len(ncol(data$design))
  spread <- numeric(3)
  spread[data$free] <- place[-c(alpha, beta)]
  list(alpha = place[alpha], beta = place[beta], a = spread[1], b = spread[2], c = spread[3])
}

# list(place, value, gradient, u, eta) of the objective. `u`: where the search for u begins.
laplace_at <- function(data, place, u) {
  parts <- parts_of_place(data, place)
  if (is.unsorted(parts$alpha, strictly = TRUE) || any(!is.finite(place))) {
    return(list(place = place, value = Inf, gradient = NA * place, u = u))
  }
  fixed <- as.vector(data$design %*% parts$beta)
  inner <- top_of_likelihood(data, parts, fixed, u)
  value <- sum(inner$h) + sum(log(inner$det)) / 2
  list(place = place, value = value, gradient = laplace_gradient(data, parts, inner), u = inner$u,
    eta = inner$eta)
}

# Newton's method in every participant's u at once; a step that does not lower h is halved. h is
# convex in u, so there is one lowest place.
top_of_likelihood <- function(data, parts, fixed, u) {
  here <- likelihood_at(data, parts, fixed, u)
  for (round in 1:100) {
    if (max(abs(here$g1), abs(here$g2)) < 1e-9) break
    step <- cbind(here$V11 * here$g1 + here$V12 * here$g2, here$V12 * here$g1 + here$V22 * here$g2)
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

# At given u: h of each participant, its gradient g and the inverse V of its second derivative.
likelihood_at <- function(data, parts, fixed, u) {
  effects <- cbind(parts$a * u[, 1], parts$b * u[, 1] + parts$c * u[, 2])
  eta <- fixed + effects[data$person, 1] + data$slope * effects[data$person, 2]
  terms <- rating_terms(data, parts$alpha, eta)
  s <- data$slope
  sums <- rowsum(cbind(terms$log_p, terms$l1, s * terms$l1, -terms$l2, -s * terms$l2,
    -s^2 * terms$l2), data$person, reorder = TRUE)
  with(parts, {
    M11 <- sums[, 4]
    M12 <- sums[, 5]
    M22 <- sums[, 6]
    H11 <- 1 + a^2 * M11 + 2 * a * b * M12 + b^2 * M22
    H12 <- c * (a * M12 + b * M22)
    H22 <- 1 + c^2 * M22
    det <- H11 * H22 - H12^2
    list(u = u, eta = eta, terms = terms, h = rowSums(u^2) / 2 - sums[, 1], det = det,
      S1 = sums[, 2], S2 = sums[, 3], M11 = M11, M12 = M12, M22 = M22,
      g1 = u[, 1] - a * sums[, 2] - b * sums[, 3], g2 = u[, 2] - c * sums[, 3],
      V11 = H22 / det, V12 = -H12 / det, V22 = H11 / det)
  })
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

# The exact gradient of the objective. v is the variance of eta given the ratings, K the sum of v l3
# over a participant; what a change of u adds through H is carried by r = L V L' K.
laplace_gradient <- function(data, parts, inner) {
  s <- data$slope
  person <- data$person
  terms <- inner$terms
  spread <- with(c(parts, inner), {
    G11 <- a^2 * V11
    G12 <- a * (b * V11 + c * V12)
    G22 <- b^2 * V11 + 2 * b * c * V12 + c^2 * V22
    v <- G11[person] + 2 * s * G12[person] + s^2 * G22[person]
    K <- rowsum(cbind(v * terms$l3, s * v * terms$l3), person, reorder = TRUE)
    W1 <- V11 * (a * K[, 1] + b * K[, 2]) + V12 * c * K[, 2]
    W2 <- V12 * (a * K[, 1] + b * K[, 2]) + V22 * c * K[, 2]
    r1 <- a * W1
    r2 <- b * W1 + c * W2
    u1 <- u[, 1]
    u2 <- u[, 2]
    list(v = v, carried = r1[person] + s * r2[person], gradient = c(
      sum((M11 * a + M12 * b) * V11 + M12 * c * V12 - S1 * u1 - K[, 1] * u1 / 2 - S1 * W1 / 2 +
        (M11 * r1 + M12 * r2) * u1 / 2),
      sum((M12 * a + M22 * b) * V11 + M22 * c * V12 - S2 * u1 - K[, 2] * u1 / 2 - S2 * W1 / 2 +
        (M12 * r1 + M22 * r2) * u1 / 2),
      sum((M12 * a + M22 * b) * V12 + M22 * c * V22 - S2 * u2 - K[, 2] * u2 / 2 - S2 * W2 / 2 +
        (M12 * r1 + M22 * r2) * u2 / 2)))
  })
  total <- function(d1, d2, d3) d1 + spread$v * d3 / 2 + spread$carried * d2 / 2
  high <- do.call(total, threshold_terms(terms, terms$high, 1))
  low <- do.call(total, threshold_terms(terms, terms$low, -1))
  of_alpha <- vapply(seq_len(data$thresholds), function(k) {
    sum(high[data$rating == k]) + sum(low[data$rating == k + 1])
  }, 0)
  of_beta <- crossprod(data$design, total(terms$l1, terms$l2, terms$l3))
  c(-of_alpha, -of_beta, spread$gradient[data$free])
}

# The fit at the place that was found, or why it is none. A participant's spread of 0 is at the edge
# of what it may be: the other numbers' errors are those of the model without it.
described_link_fit <- function(data, at, found) {
  here <- at(found$par)
  if (anyNA(here$gradient)) return(list(failure = "the optimiser found no likelihood"))
  parts <- parts_of_place(data, found$par)
  of_spread <- utils::tail(seq_along(found$par), length(data$free))
  edge <- of_spread[abs(c(parts$a, parts$a, parts$c))[data$free] < kNoSpread]
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
    log_likelihood = -here$value, df = length(parts$beta), spread = c(parts$a, parts$b, parts$c),
    deviations = c(intercept = abs(parts$a),
      if (length(data$free) == 3) c(slope = sqrt(parts$b^2 + parts$c^2))),
    eta = here$eta, gradient = here$gradient, Hessian = Hessian)
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
