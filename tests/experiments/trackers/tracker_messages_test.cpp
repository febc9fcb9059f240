// What trackers send, and what is made of it; URLs, and the sentences with which they are refused.
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "experiments/trackers/gazepoint.hpp"
#include "experiments/trackers/pupil.hpp"
#include "experiments/trackers/tracker_kinds.hpp"
#include "experiments/trackers/zeromq.hpp"
#include "tests/experiments/refusals.hpp"
#include "tests/experiments/trackers/stand_in.hpp"

namespace impetus::tracker_messages_test {

std::string packed(const json& message) {
  const std::vector<std::uint8_t> bytes = json::to_msgpack(message);
  return {bytes.begin(), bytes.end()};
}

json gaze(double time_s, json place, double confidence, bool is_on) {
  return {
      {"timestamp", time_s}, {"norm_pos", place}, {"confidence", confidence}, {"on_surf", is_on}};
}

std::vector<Reading> read(const json& message) {
  return surface_readings(packed(message), "screen", {1000, 0});
}

TEST(PupilMessages, HaveGazeOfOneSurfaceInOrderOfTime) {
  const std::vector<Reading> readings =
      read({{"name", "screen"},
            {"gaze_on_surfaces",
             {gaze(2.0, {0.75, 0.5}, 1.0, true), gaze(1.0, {0.25, 1.0}, 0.6, true)}}});
  ASSERT_EQ(readings.size(), 2U);
  EXPECT_EQ(readings[0].taken_ns, 1'000'001'000);
  EXPECT_EQ(readings[0].x_share, 0.25);
  EXPECT_EQ(readings[0].y_share, 1.0);  // from below, as Pupil counts
  EXPECT_EQ(readings[0].loss, GazeLoss::kNone);
  EXPECT_EQ(readings[1].taken_ns, 2'000'001'000);
  EXPECT_TRUE(
      read({{"name", "screen left"}, {"gaze_on_surfaces", {gaze(1, {0, 0}, 1, true)}}}).empty());
}

TEST(PupilMessages, SayWhatIsLost) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Reading> readings =
      read({{"name", "screen"},
            {"gaze_on_surfaces",
             {gaze(1, {0.5, 0.5}, 0.59, true), gaze(2, {1.5, 0.5}, 1.0, false),
              gaze(3, {nan, 0.5}, 1.0, true), gaze(4, "here", 1.0, true),
              gaze(5, {0.5, 0.5}, nan, true)}}});
  ASSERT_EQ(readings.size(), 5U);
  EXPECT_EQ(readings[0].loss, GazeLoss::kLost);
  EXPECT_EQ(readings[1].loss, GazeLoss::kOffScreen);
  EXPECT_EQ(readings[2].loss, GazeLoss::kLost);
  EXPECT_EQ(readings[3].loss, GazeLoss::kLost);
  EXPECT_EQ(readings[4].loss, GazeLoss::kLost);
}

TEST(PupilMessages, ThatCannotBeReadArePassedOver) {
  const std::string whole =
      packed({{"name", "screen"}, {"gaze_on_surfaces", {gaze(1, {0.5, 0.5}, 1, true)}}});
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_TRUE(surface_readings(whole.substr(0, length), "screen", {}).empty()) << length;
  }
  EXPECT_TRUE(read({{"name", "screen"}}).empty());
  EXPECT_TRUE(read({{"name", "screen"}, {"gaze_on_surfaces", {1, nullptr, {{"timestamp", "now"}}}}})
                  .empty());
  EXPECT_TRUE(read({{"name", 7}, {"gaze_on_surfaces", 7}}).empty());
  EXPECT_TRUE(read(json::array({1})).empty());
}

TEST(GazepointLines, AreTheSameHoweverTheyAreCut) {
  const std::string sent = "<ACK />\r\n<REC TIME=\"1\" />\r\n\r\n<REC TIME=\"2\" />\r\n";
  const std::vector<std::string> lines = {"<ACK />", "<REC TIME=\"1\" />", "",
                                          "<REC TIME=\"2\" />"};
  for (std::size_t cut = 0; cut <= sent.size(); ++cut) {
    std::string pending;
    std::vector<std::string> taken = take_lines(pending, sent.substr(0, cut));
    for (const std::string& line : take_lines(pending, sent.substr(cut))) {
      taken.push_back(line);
    }
    EXPECT_EQ(taken, lines) << "cut at " << cut;
    EXPECT_EQ(pending, "");
  }
}

TEST(GazepointLines, HaveTheBestPointFromTheUpperLeft) {
  const auto record = gazepoint_record(
      R"(<REC TIME="12.5" FPOGX="0.1" FPOGY="0.1" FPOGV="0" BPOGX="0.25" BPOGY="0.125" BPOGV="1" />)");
  ASSERT_TRUE(record);
  EXPECT_EQ(record->remote_ns, 12'500'000'000);
  EXPECT_EQ(record->reading.x_share, 0.25);
  EXPECT_EQ(record->reading.y_share, 0.875);
  EXPECT_EQ(record->reading.loss, GazeLoss::kNone);
  const auto fixation = gazepoint_record(R"(<REC TIME="1" FPOGX="0.5" FPOGY="0.25" FPOGV="1"/>)");
  ASSERT_TRUE(fixation);
  EXPECT_EQ(fixation->reading.y_share, 0.75);
}

TEST(GazepointLines, SayWhatIsLostAndOthersArePassedOver) {
  const auto loss = [](const std::string& words) {
    return gazepoint_record("<REC TIME=\"1\" " + words + " />").value().reading.loss;
  };
  EXPECT_EQ(loss(R"(BPOGX="0.5" BPOGY="0.5" BPOGV="0")"), GazeLoss::kLost);
  EXPECT_EQ(loss(R"(BPOGX="0.5" BPOGY="0.5")"), GazeLoss::kLost);
  EXPECT_EQ(loss(R"(BPOGX="0.5" BPOGY="no" BPOGV="1")"), GazeLoss::kLost);
  EXPECT_EQ(loss(R"(BPOGX="-0.1" BPOGY="0.5" BPOGV="1")"), GazeLoss::kOffScreen);
  EXPECT_EQ(loss(R"(BPOGX="0.5" BPOGY="nan" BPOGV="1")"), GazeLoss::kOffScreen);
  for (const char* line : {"", "<ACK ID=\"ENABLE_SEND_DATA\" />", "<CAL TIME=\"1\" />", "<REC />",
                           "<REC TIME=\"soon\" />", "<REC TIME=\"1", "<REC TIME=\"1e99\" />"}) {
    EXPECT_FALSE(gazepoint_record(line)) << line;
  }
}

std::string url_refusal(const std::string& url) {
  return refusal([&] { parse_tracker(url); });
}

TEST(TrackerUrls, NameHostPortAndOptions) {
  const NamedTracker pupil = parse_tracker("pupil://lab-2:50021?surface=left half");
  EXPECT_EQ(pupil.kind, &pupil_tracker());
  EXPECT_EQ(pupil.address.host, "lab-2");
  EXPECT_EQ(pupil.address.port, 50021);
  EXPECT_EQ(pupil.address.options.at("surface"), "left half");
  EXPECT_EQ(parse_tracker("gazepoint://192.168.0.7/").address.port, 4242);
  EXPECT_EQ(parse_tracker("gazepoint://192.168.0.7/").address.host, "192.168.0.7");
  EXPECT_FALSE(is_tracker_url("gaze.csv"));
}

TEST(TrackerUrls, ThatAreNoneAreRefusedInASentence) {
  EXPECT_EQ(url_refusal("tobii://here"),
            "--gaze tobii://here: expected a file of recorded gaze or one of pupil://HOST, "
            "gazepoint://HOST, lsl://HOST");
  EXPECT_EQ(url_refusal("pupil://"),
            "--gaze pupil://: expected a host, such as pupil://localhost:50020");
  EXPECT_EQ(url_refusal("pupil://a:0"),
            "--gaze pupil://a:0: expected a port from 1 to 65535 behind the host, got \"0\"");
  EXPECT_EQ(url_refusal("pupil://a:80x"),
            "--gaze pupil://a:80x: expected a port from 1 to 65535 behind the host, got \"80x\"");
  EXPECT_EQ(url_refusal("pupil://a?eye=left"),
            "--gaze pupil://a?eye=left: expected surface, topic=VALUE behind \"?\", got "
            "\"eye=left\"");
  EXPECT_EQ(url_refusal("gazepoint://a?surface=b"),
            "--gaze gazepoint://a?surface=b: expected nothing behind \"?\", got \"surface=b\"");
}

TEST(Trackers, WhereNobodyAnswersAreRefusedInASentence) {
  const std::string there = "://127.0.0.1:" + std::to_string(free_port());
  EXPECT_EQ(
      refusal([&] { open_tracker("gazepoint" + there); }),
      "--gaze gazepoint" + there +
          ": expected Gazepoint Control or another Open Gaze server there, but nobody answers: "
          "Connection refused");
  EXPECT_EQ(
      refusal([&] { open_tracker("pupil" + there); }),
      "--gaze pupil" + there +
          ": expected Pupil Capture or Pupil Service with Pupil Remote there, but nobody answers");
  EXPECT_EQ(refusal([&] { open_tracker("pupil" + there + "?topic=gaze"); }),
            "--gaze pupil" + there +
                "?topic=gaze: expected the topic surfaces, for gaze in the world camera's image "
                "cannot be mapped to the screen; define a surface around it in Pupil Capture");
  EXPECT_EQ(refusal([] { require_zeromq("libnone.so.5"); }),
            "pupil://: expected the library ZeroMQ, by which Pupil sends, but libnone.so.5 is not "
            "installed; `apt install libzmq5`");
}

}  // namespace impetus::tracker_messages_test
