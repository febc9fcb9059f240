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

test_that("an eye tracker is named with what is known of its clock", {
  notes <- data.frame(session = c(1, 1, 2), text = c(
    "Pupil's clock plus -1234.500000 s is this machine's, known to 0.050 ms; it fell silent 0 times",
    "Pupil's clock plus -1234.500100 s is this machine's, known to 0.110 ms; it fell silent 2 times",
    "Pupil's clock plus 3.000000 s is this machine's, known to 0.080 ms; it fell silent 1 times"))
  expect_equal(tracker_words(notes), paste("Gaze was followed by Pupil in 2 sittings. Its stamps were brought to",
    "this machine's clock to within 0.11 ms. It fell silent 3 times, which lost gaze and no trial."))
  one_way <- data.frame(session = 1, text = paste("Gazepoint's clock plus 3.0 s is this machine's, as the fastest",
    "delivery says; 95 % come later by at most 0.310 ms; it fell silent 0 times"))
  expect_equal(tracker_words(one_way), paste("Gaze was followed by Gazepoint in 1 sitting. Its clock is known by",
    "its fastest delivery alone, whose own delay is not; 95 % came later by at most 0.31 ms."))
  expect_null(tracker_words(notes[0, ]))
  expect_null(tracker_words(NULL))
})

test_that("markers are counted with how soon they were sent, and those that were not", {
  markers <- data.frame(sent_after_ms = c(rep(0.05, 198), 0.4, NA))
  expect_equal(marker_words(markers), sprintf(paste("Events were marked for another recorder by 200 codes, handed to",
    "the system 0.05 ms (median; 99 %% within %.2g ms) after the flip or the arrival that each marks; 1 was not",
    "sent in time."), quantile(markers$sent_after_ms, 0.99, na.rm = TRUE)))
  expect_equal(marker_words(data.frame(sent_after_ms = NA_real_)),
    "Events were marked for another recorder by 1 code; 1 was not sent in time.")
  expect_null(marker_words(markers[0, , drop = FALSE]))
})

test_that("sounds are counted with their lags and how far onsets lay from them", {
  sounds <- data.frame(lag_ms = c(-150, 0, 0, 150), realised_lag_ms = c(-149, 1, 3, NA))
  expect_equal(sound_words(sounds), paste("4 sounds were played at lags of -150, 0, 150 ms from the flip that showed",
    "the contact; onsets left the device's buffer 1 ms from that in the median (half of them between 1 and 2 ms),",
    "before what driver and loudspeaker add; of 1 nobody knows when they were heard."))
  expect_equal(sound_words(data.frame(lag_ms = 0, realised_lag_ms = NA_real_)), paste("1 sound was played at lags",
    "of 0 ms from the flip that showed the contact; of 1 nobody knows when they were heard."))
  expect_null(sound_words(sounds[0, ]))
})
