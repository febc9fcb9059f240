// A timing report from its parts, in a lab without a window: measured, judged, written.
// SPDX-License-Identifier: MIT
#include "experiments/timing/timing_json.hpp"
#include "experiments/timing/timing_page.hpp"
#include "experiments/timing/timing_verdicts.hpp"
#include "experiments/timing/timing_words.hpp"
#include "tests/experiments/command_lines.hpp"
#include "tests/experiments/timing/virtual_lab.hpp"

namespace impetus::timing_report_test {

/// A report of a machine without fault.
TimingReport faultless() {
  VirtualLab lab;
  TimingReport report = report_of(lab).value();
  report.facts = {"build 1", "machine 1", "2026-01-01T00:00:00Z", "display 1", "none", 1280, 1024,
                  60.0,      0.5};
  for (InputDelay& input : report.inputs) {
    input.sent = 10;
    input.delays_ms.assign(10, 0.5);
  }
  return report;
}

TimingGrade grade_of(const TimingReport& report, const std::string& subject) {
  for (const TimingVerdict& verdict : timing_verdicts(report)) {
    if (verdict.subject.rfind(subject, 0) == 0) {
      return verdict.grade;
    }
  }
  ADD_FAILURE() << "no verdict on " << subject;
  return TimingGrade::kNotKnown;
}

// ---------------------------------------------------------------- measuring

TEST(TimingRun, MeasuresEveryPartByTheSessionsOwnPath) {
  VirtualLab lab;
  const auto report = report_of(lab);
  ASSERT_TRUE(report);
  ASSERT_EQ(report->runs.size(), 4U);
  EXPECT_EQ(report->runs[0].statistics.flips, 30);  // half a second
  for (const FlipSeries& run : report->runs) {
    EXPECT_EQ(run.statistics.late, 0);
    EXPECT_LT(run.statistics.spread_ms, 1e-6);  // virtual stamps are whole nanoseconds
    EXPECT_EQ(run.intervals_ms.size() + 1, run.missed_slots.size());
  }
  EXPECT_EQ(report->runs[3].bodies, 250);
  EXPECT_FALSE(report->gaze.latencies_ms.empty());
  // Sampled 5 ms before the frame was begun, and flipped a frame later.
  EXPECT_NEAR(distribution_of(report->gaze.latencies_ms).largest, 5.0 + 1e3 / 60.0, 1e-5);
  EXPECT_EQ(report->inputs.size(), 4U);
  EXPECT_EQ(report->inputs[0].delay_ms().median, 2.0);
  EXPECT_EQ(report->content.corner, "top right");
  EXPECT_TRUE(report->content.check.all_as_planned());
  EXPECT_GT(report->content.check.frames, 30);
}

TEST(TimingRun, TellsOfTrackersAndMarkersWhereThereAreAny) {
  VirtualLab alone;
  const auto without = report_of(alone);
  ASSERT_TRUE(without);
  EXPECT_TRUE(timing_json(*without)["flip_to_marker"].is_null());
  EXPECT_EQ(timing_page(*without).find("Markers for another recorder"), std::string::npos);

  VirtualLab lab;
  lab.tracker_clock = "the clocks agree to 0.1 ms";
  lab.marker_line = "tcp://eeg:5005";
  const auto report = report_of(lab);
  ASSERT_TRUE(report);
  ASSERT_FALSE(report->gaze.intervals_ms.empty());
  ASSERT_GE(report->markers.delays_ms.size(), 3U);  // cross, onset and end at least
  EXPECT_EQ(distribution_of(report->markers.delays_ms).largest, 0.2);
  EXPECT_EQ(grade_of(*report, "Flip to marker (tcp://eeg:5005)"), TimingGrade::kGood);
  const std::string page = timing_page(*report);
  EXPECT_NE(page.find("the clocks agree to 0.1 ms"), std::string::npos);
  EXPECT_NE(page.find("handed to the system 0.20 ms after"), std::string::npos);
  EXPECT_EQ(timing_json(*report)["flip_to_marker"]["lost"], 0);

  VirtualLab lossy;
  lossy.marker_line = "tcp://eeg:5005";
  // The first of the second of four runs alike, two of which are of the shown trial with markers.
  lossy.prompt.lost_at = lab.prompt.count / 4 + 1;
  const auto with_loss = report_of(lossy);
  ASSERT_TRUE(with_loss);
  EXPECT_EQ(with_loss->markers.lost, 1);
  EXPECT_EQ(grade_of(*with_loss, "Flip to marker"), TimingGrade::kWithCare);
}

TEST(TimingRun, TellsHowLateSoundsAre) {
  VirtualLab silent;
  const auto without = report_of(silent);
  ASSERT_TRUE(without);
  EXPECT_TRUE(timing_json(*without)["sounds"].is_null());
  EXPECT_EQ(timing_page(*without).find("Sounds"), std::string::npos);

  VirtualLab lab;
  lab.device = "a device";
  lab.late.late_ns = 500'000;
  const auto report = report_of(lab);
  ASSERT_TRUE(report);
  ASSERT_EQ(report->sounds.off_ms.size(),
            1U);  // a sound each quarter of a second, every other at once
  ASSERT_EQ(report->sounds.at_once_ms.size(), 1U);
  EXPECT_EQ(report->sounds.off_ms[0], 0.5);
  EXPECT_EQ(report->sounds.at_once_ms[0], 8.5);
  EXPECT_EQ(grade_of(*report, "Sounds that were foreseen"), TimingGrade::kGood);
  EXPECT_EQ(grade_of(*report, "Flip to a sound"), TimingGrade::kGood);
  EXPECT_NE(timing_page(*report).find("Sounds (a device) that were foreseen left the device"),
            std::string::npos);
  EXPECT_EQ(timing_json(*report)["sounds"]["lost"], 0);

  lab.late.late_ns = 3'000'000;
  EXPECT_EQ(grade_of(*report_of(lab), "Sounds that were foreseen"), TimingGrade::kWithCare);
  lab.late.late_ns = -60'000'000;  // too soon is as bad
  EXPECT_EQ(grade_of(*report_of(lab), "Sounds that were foreseen"), TimingGrade::kNotForTiming);
  lab.late.lost_every = 1;
  const auto unheard = report_of(lab);
  EXPECT_EQ(unheard->sounds.lost, 2);
  EXPECT_EQ(grade_of(*unheard, "Sounds that were foreseen"), TimingGrade::kNotForTiming);
}

TEST(TimingRun, AFrameThatTheScreenRepeatedIsFound) {
  VirtualLab lab;
  lab.repeated_at_patch = 40;
  const auto report = report_of(lab);
  ASSERT_TRUE(report);
  EXPECT_EQ(report->content.check.wrong, 1);
  EXPECT_EQ(report->content.check.first_wrong, 39);  // the fortieth
  EXPECT_EQ(grade_of(*report, "Frames as planned"), TimingGrade::kNotForTiming);
}

TEST(TimingRun, EscStopsInAnyPartAndNothingIsReported) {
  VirtualLab whole;
  ASSERT_TRUE(report_of(whole));
  for (const std::int64_t frame : {1, 31, 100, 400, 600}) {
    VirtualLab lab;
    lab.stopped_at_frame = frame;
    EXPECT_FALSE(report_of(lab)) << frame;
  }
}

TEST(TimingRun, SaysWhatIsMeasuredAndHowLongItStillTakes) {
  VirtualLab lab;
  std::vector<std::string> told;
  static_cast<void>(run_timing(lab, AnyScene(), {2.0, ScreenCorner::kTopRight},
                               [&](const SessionProgress& part) { told.push_back(part.label); }));
  ASSERT_EQ(told.size(), 6U);
  EXPECT_EQ(told[0], "Part 1 of 6: a blank picture; 12 s to go. Esc stops.");
  EXPECT_EQ(told[3], "Part 4 of 6: 250 bodies; 6 s to go. Esc stops.");
}

TEST(TimingScenes, HaveTheBodiesAndTheStepRateOfTheShippedOnes) {
  ShapeLibrary shapes{TreeCache()};
  const TimingScenes scenes(2.5, shapes);
  for (const int bodies : {1, 15}) {
    const StagedScene scene = scenes.stage(timing_trial(bodies), assumed_screen());
    EXPECT_EQ(scene.world.states().size(), static_cast<std::size_t>(bodies));
    EXPECT_EQ(scene.step_hz, 240.0);
    EXPECT_EQ(scene.duration_s, 2.5);
    EXPECT_TRUE(scene.depends_on_gaze);
  }
}

// ---------------------------------------------------------------- judging

TEST(TimingVerdicts, AFaultlessMachineIsGoodThroughout) {
  const TimingReport report = faultless();
  for (const TimingVerdict& verdict : timing_verdicts(report)) {
    EXPECT_EQ(verdict.grade, TimingGrade::kGood) << verdict.subject << ": " << verdict.measured;
    EXPECT_NE(verdict.criterion, "");
  }
  EXPECT_EQ(worst_of(timing_verdicts(report)), TimingGrade::kGood);
}

TEST(TimingVerdicts, EveryFaultIsSeenInItsLine) {
  struct Fault {
    std::string subject;
    std::function<void(TimingReport&)> make;
    TimingGrade grade;
  };
  const std::vector<Fault> faults{
      {"Flips follow", [](TimingReport& r) { r.sync.passed = false; }, TimingGrade::kNotForTiming},
      {"Spread", [](TimingReport& r) { r.runs[0].statistics.spread_ms = 1.0; },
       TimingGrade::kWithCare},
      {"Spread", [](TimingReport& r) { r.runs[0].statistics.spread_ms = 2.1; },
       TimingGrade::kNotForTiming},
      {"Drift", [](TimingReport& r) { r.runs[0].statistics.drift_ppm = -1000.0; },
       TimingGrade::kWithCare},
      {"Late frames with 250", [](TimingReport& r) { r.runs[3].statistics.late = 1; },
       TimingGrade::kWithCare},  // of 151
      {"Late frames with 250", [](TimingReport& r) { r.runs[3].statistics.late = 2; },
       TimingGrade::kNotForTiming},
      {"Arrival of key", [](TimingReport& r) { r.inputs[0].delays_ms.assign(10, 5.0); },
       TimingGrade::kWithCare},
      {"Arrival of key", [](TimingReport& r) { r.inputs[0].lost = 1; }, TimingGrade::kWithCare},
      {"Arrival of mouse movements put into the program",
       [](TimingReport& r) { r.inputs[1].delays_ms.assign(10, 11.0); }, TimingGrade::kNotForTiming},
      {"Gaze", [](TimingReport& r) { r.gaze.latencies_ms.assign(10, 70.0); },
       TimingGrade::kWithCare},
      {"Gaze", [](TimingReport& r) { r.gaze.latencies_ms.clear(); }, TimingGrade::kNotKnown},
      {"Frames as planned", [](TimingReport& r) { r.content.check.unreadable = 1; },
       TimingGrade::kNotForTiming},
      {"Frames as planned", [](TimingReport& r) { r.content.readable = false; },
       TimingGrade::kNotKnown}};
  for (const Fault& fault : faults) {
    TimingReport report = faultless();
    fault.make(report);
    EXPECT_EQ(grade_of(report, fault.subject), fault.grade) << fault.subject;
    EXPECT_EQ(worst_of(timing_verdicts(report)),
              fault.grade == TimingGrade::kNotKnown ? TimingGrade::kGood : fault.grade);
  }
}

TEST(TimingVerdicts, StampsThatAreAnchoredToNothingAreNeverCalledGood) {
  TimingReport report = faultless();
  report.sync.passed = false;
  EXPECT_EQ(grade_of(report, "Spread"), TimingGrade::kWithCare);
  EXPECT_EQ(grade_of(report, "Late frames with 15"), TimingGrade::kWithCare);
}

// ---------------------------------------------------------------- writing

TEST(TimingPage, MarkupInWhatTheMachineSaysStaysText) {
  TimingReport report = faultless();
  report.facts.machine = "<script>alert('x' & \"y\")</script>";
  const std::string page = timing_page(report);
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert(&#39;x&#39; &amp; &quot;y&quot;)&lt;/script&gt;"),
            std::string::npos);
}

TEST(TimingPage, HasEveryVerdictTheParagraphAndWhatIsNotKnownAndNeedsNoOtherFile) {
  const TimingReport report = faultless();
  const std::string page = timing_page(report);
  for (const TimingVerdict& verdict : timing_verdicts(report)) {
    EXPECT_NE(page.find(html_text(verdict.subject)), std::string::npos) << verdict.subject;
    EXPECT_NE(page.find(html_text(verdict.measured)), std::string::npos) << verdict.measured;
  }
  EXPECT_NE(page.find(html_text(methods_paragraph(report))), std::string::npos);
  for (const std::string& sentence : what_is_not_known(report)) {
    EXPECT_NE(page.find(html_text(sentence)), std::string::npos) << sentence;
  }
  for (const char* foreign : {"http:", "https:", "src=", "href=", "@import"}) {
    EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
  }
}

TEST(TimingPage, WithoutSynchronisationNoRefreshRateIsClaimed) {
  TimingReport report = faultless();
  EXPECT_NE(methods_paragraph(report).find("60.0000 Hz"), std::string::npos);
  report.sync.passed = false;
  const std::string paragraph = methods_paragraph(report);
  EXPECT_EQ(paragraph.find("confidence interval"), std::string::npos);
  EXPECT_NE(paragraph.find("not synchronised"), std::string::npos);
  EXPECT_TRUE(timing_json(report)["measured_refresh"].is_null());
}

TEST(TimingJson, HoldsTheNumbersOfThePageAndTheRawOnes) {
  const TimingReport report = faultless();
  const auto json = nlohmann::json::parse(timing_json(report).dump());
  EXPECT_EQ(json["flips"].size(), report.runs.size());
  EXPECT_EQ(json["flips"][2]["raw_interval_ms"].get<std::vector<double>>(),
            report.runs[2].intervals_ms);
  EXPECT_EQ(json["gaze_to_flip"]["raw_latency_ms"].size(), report.gaze.latencies_ms.size());
  EXPECT_EQ(json["verdicts"].size(), timing_verdicts(report).size());
  EXPECT_EQ(json["methods"].get<std::string>(), methods_paragraph(report));
  EXPECT_EQ(json["overall"].get<std::string>(), "good");
}

// ---------------------------------------------------------------- the command

TEST(TimingCommand, WhatCannotBeIsRefusedAndNothingIsWritten) {
  const TemporaryFolder folder;
#ifdef IMPETUS_PROGRAM_HAS_WINDOW
  folder.write("file", "");
  folder.write("old/timing.json", "");
  const std::vector<std::pair<Words, std::string>> cases{
      {{"timing"}, "no display could be opened: neither X11 nor Wayland answered"},
      {{"timing", "--patch", "middle"},
       "--patch: expected top left, top right, bottom left or bottom right, got middle"},
      {{"timing", "--window", "9x9"},
       "--window 9x9: expected WIDTHxHEIGHT of at least 640x480 pixels"},
      {{"timing", "--seconds", "0"}, "--seconds: Value 0 not in range 1.000000 to 3600.000000"},
      {{"timing", "--out", "file"}, "--out: expected a folder, but file is a file"},
      {{"timing", "--out", "file/below"}, "--out: expected a folder to write to, got file/below"},
      {{"timing", "--out", "old"},
       "old/timing.json: exists already and is not overwritten without --force"}};
  for (const auto& [arguments, sentence] : cases) {
    expect_refused(folder, arguments, sentence);
  }
#else
  expect_refused(folder, {"timing"},
                 "this build has no window, and without one there is no timing to report");
#endif
  EXPECT_FALSE(std::filesystem::exists(folder / "timing"));
}

}  // namespace impetus::timing_report_test
