# The methods section in words: who, on what, which design, which analysis; versions and references.
# Everything is said from the views, so what nobody recorded is not said.
# SPDX-License-Identifier: MIT

kReferences <- c(
  ordinal = "Christensen, R. H. B. (2018). Cumulative link models for ordinal regression with the R package ordinal.",
  lme4 = "Bates, D., Mächler, M., Bolker, B., & Walker, S. (2015). Fitting linear mixed-effects models using lme4. Journal of Statistical Software, 67(1).",
  glmmTMB = "Brooks, M. E., et al. (2017). glmmTMB balances speed and flexibility among packages for zero-inflated generalized linear mixed modeling. The R Journal, 9(2), 378–400.",
  afex = "Singmann, H., Bolker, B., Westfall, J., Aust, F., & Ben-Shachar, M. S. afex: Analysis of factorial experiments. R package.",
  ggplot2 = "Wickham, H. (2016). ggplot2: Elegant graphics for data analysis. Springer.",
  barr = "Barr, D. J. (2013). Random effects structure for testing interactions in linear mixed-effects models. Frontiers in Psychology, 4, 328.",
  cousineau = "Cousineau, D. (2005). Confidence intervals in within-subject designs. Tutorials in Quantitative Methods for Psychology, 1(1), 42–45.",
  morey = "Morey, R. D. (2008). Confidence intervals from normalized data: A correction to Cousineau (2005). Tutorials in Quantitative Methods for Psychology, 4(2), 61–64.",
  eta = "Olejnik, S., & Algina, J. (2003). Generalized eta and omega squared statistics. Psychological Methods, 8(4), 434–447.",
  holm = "Holm, S. (1979). A simple sequentially rejective multiple test procedure. Scandinavian Journal of Statistics, 6(2), 65–70.",
  lakens = "Lakens, D. (2017). Equivalence tests. Social Psychological and Personality Science, 8(4), 355–362.",
  wichmann = "Wichmann, F. A., & Hill, N. J. (2001). The psychometric function: I. Fitting, sampling, and goodness of fit. Perception & Psychophysics, 63(8), 1293–1313.",
  lin = "Lin, D. Y., & Ying, Z. (1994). Semiparametric analysis of the additive risk model. Biometrika, 81(1), 61–71.",
  hautus = "Hautus, M. J. (1995). Corrections for extreme proportions and their biasing effects on estimated values of d′. Behavior Research Methods, Instruments, & Computers, 27(1), 46–51.",
  dingliana = "Dingliana, J. (2002). Adaptive levels of detail for interactive collision handling. PhD thesis, Trinity College Dublin.",
  okabe = "Okabe, M., & Ito, K. (2008). Color universal design. jfly.uni-koeln.de/color.")

kReferencesOf <- list(
  all = c("cousineau", "morey", "holm", "ggplot2", "okabe", "dingliana"),
  rating = c("ordinal", "barr", "afex", "eta", "lakens"),
  answer = c("lme4", "barr", "afex", "eta"),
  threshold = c("wichmann", "lme4", "afex"),
  clicks = c("glmmTMB", "lme4", "barr", "afex", "lin", "hautus"))

# Sentences of the methods section of a protocol. `parts`: of parts_of_protocol, without refused ones.
methods_sentences <- function(path, protocol, parts) {
  sessions <- rows_of_view(path, "session_provenance", protocol)
  c(people_words(path, protocol, sessions), apparatus_words(sessions),
    unlist(lapply(parts, part_methods)), analysis_words(parts))
}

people_words <- function(path, protocol, sessions) {
  rows <- rows_of_view(path, "enrolment_summary", protocol)
  whole <- query_study(path, "SELECT DISTINCT participant FROM excluded WHERE trial IS NULL")
  out <- sum(rows$participant %in% whole$participant)
  sprintf("%s took part in %s (protocol '%s')%s.",
    count_of(nrow(rows), who_words(all(rows$simulated == 1))),
    count_of(nrow(sessions), "sitting"), protocol, if (out == 0) "" else
      sprintf("; the data of %d were excluded", out))
}

# The screens, the refresh, the machines and the program, each said once.
apparatus_words <- function(sessions) {
  if (nrow(sessions) == 0) return("No sitting has begun.")
  each <- function(words) paste(unique(words), collapse = "; or ")
  synced <- sessions$sync_tries > 0 & !is.na(sessions$sync_mean_interval_ms)
  c(
    sprintf("Stimuli were shown by %s on a screen of %s, seen from %s.",
      each(sessions$build), each(sprintf("%.1f × %.1f cm (%d × %d pixels, %.4g Hz)",
        100 * sessions$screen_width_m, 100 * sessions$screen_height_m,
        as.integer(sessions$screen_width_px), as.integer(sessions$screen_height_px),
        sessions$refresh_hz)), each(sprintf("%.4g cm", 100 * sessions$viewing_distance_m))),
    if (any(sessions$screen_measured == 0)) sprintf(
      "Size and distance of the screen were assumed, not measured, in %s.",
      count_of(sum(sessions$screen_measured == 0), "sitting")),
    sprintf("Machine: %s. Display: %s.", each(sessions$machine), each(sessions$display)),
    if (any(synced)) sprintf(paste("Before a sitting the display's timing was tested: intervals",
      "between flips of %s ms with standard deviations of at most %.3g ms."),
      paste(unique(sprintf("%.2f", range(sessions$sync_mean_interval_ms[synced]))), collapse = " to "),
      max(sessions$sync_sd_interval_ms[synced])),
    if (any(sessions$sync_overridden == 1)) sprintf("The test failed and was overridden in %s.",
      count_of(sum(sessions$sync_overridden), "sitting")))
}

# The design and the response of one part.
part_methods <- function(part) {
  trials <- part$trials
  factors <- vapply(unname(part$factors), function(f) {
    sprintf("%s (%s)", name_and_unit(f), levels_words(levels(droplevels(trials[[f]])),
      "%d levels from %s to %s"))
  }, "")
  per <- range(table(trials$participant))
  c(
    sprintf("%s: %s, %s %ss of each participant.", title_of_part(part),
      if (length(factors) == 0) "no factor varied" else paste(and_words(factors),
        if (length(factors) == 1) "was varied within participants" else
          "were varied within participants"), paste(unique(per), collapse = " to "), answer_noun(part)),
    switch(part$response,
      rating = sprintf("Participants rated from %s.", describe_scale(part$scale)),
      clicks = "Participants clicked during the stimulus whenever they saw what was asked for.",
      threshold = scale_sentence(part),
      answer = if (part$kind == "two_interval") "Participants chose one of two intervals." else
        "Participants answered yes or no."))
}

kAnalysisWords <- c(
  rating = paste("Ratings were analysed with cumulative-link mixed models (logit link, Laplace",
    "approximation, maximised by its exact gradient), each factor in a model with all factors as fixed effects and an intercept and a",
    "slope of that factor for each participant (an intercept alone where that did not converge),",
    "tested by likelihood ratio; odds ratios have 95 % Wald intervals, which are too narrow for few",
    "participants. Beside them stand a repeated-measures ANOVA of participants' cell means",
    "(Greenhouse–Geisser correction, generalised η²), Friedman's test, and equivalence tests (two",
    "one-sided t tests)."),
  answer = paste("Answers were analysed with binomial mixed models (logit link), each factor in a",
    "model with an intercept and a slope of that factor for each participant, tested by likelihood",
    "ratio (odds ratios with 95 % Wald intervals, too narrow for few participants), and with a",
    "repeated-measures ANOVA of participants' shares."),
  threshold = paste("A cumulative normal was fitted to each participant's answers in each condition",
    "by maximum likelihood, with a lapse rate; intervals are by parametric bootstrap. A hierarchical",
    "probit mixed model of all answers stands beside."),
  clicks = paste("Numbers of clicks were analysed with negative-binomial mixed models, the log of the",
    "exposure as offset (Poisson where that did not converge), each factor in a model with a slope of",
    "its own; rate ratios have 95 % Wald intervals, which are too narrow for few participants. Where",
    "collisions of the coarsest level stood beside finer ones, the click rate was regressed on the",
    "events before it."))

analysis_words <- function(parts) {
  kinds <- unique(vapply(parts, `[[`, "", "response"))
  people <- unique(unlist(lapply(parts, function(part) as.character(part$trials$participant))))
  c(if (length(people) < 2) "One participant's data are described; no test across participants was made." else c(
    unname(kAnalysisWords[kinds]),
    paste("The unit of every test is the participant. Beside each test's own p stands the one",
      "corrected after Holm within its family; what is said to be found rests on the corrected one.")),
    sprintf("Analyses ran in %s with %s.", R.version.string, and_words(package_versions(kinds))))
}

package_versions <- function(kinds) {
  packages <- unique(c(unlist(list(rating = c("ordinal", "afex"), answer = c("lme4", "afex"),
    threshold = c("lme4", "afex"), clicks = c("glmmTMB", "lme4", "afex"))[kinds]), "ggplot2"))
  packages <- packages[vapply(packages, requireNamespace, NA, quietly = TRUE)]
  paste(packages, vapply(packages, function(p) as.character(utils::packageVersion(p)), ""))
}

references_of <- function(parts) {
  kinds <- unique(vapply(parts, `[[`, "", "response"))
  sort(unname(kReferences[unique(unlist(kReferencesOf[c("all", kinds)]))]))
}
