# What the methods section says of the apparatus.
# SPDX-License-Identifier: MIT
library(testthat)

test_that("luminance is said where it was measured, with that of the ground", {
  screens <- data.frame(screen_black_cd_m2 = c(0.3, 0.3, NA), screen_white_cd_m2 = c(180, 180, NA),
    screen_gamma = c(2.2, 2.2, NA))
  ground <- 0.3 + 179.7 * (128 / 255)^2.2
  expect_equal(luminance_words(screens[1:2, ]), sprintf(paste0("The screen's luminance was from 0.3 ",
    "to 180 cd/m² (gamma 2.2), that of the ground %.3g cd/m²."), ground))
  expect_match(luminance_words(screens), "; it was not measured in 1 sitting.", fixed = TRUE)
  expect_null(luminance_words(screens[3, ]))
})

test_that("what ran in a web page is named with its browsers", {
  sessions <- data.frame(browser = c("Firefox 153", NA, "Chrome 156", "Chrome 156"))
  expect_match(page_words(sessions), "3 sittings ran in a web page (Chrome 156, Firefox 153)", fixed = TRUE)
  expect_null(page_words(sessions[2, , drop = FALSE]))
})
