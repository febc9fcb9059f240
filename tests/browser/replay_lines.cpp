// Simulates recorded trials again, from the lines that recording_lines writes, and compares the
// hash of every step: replay_lines FILE... Compiled to WebAssembly, it runs in Node as it would in
// a page.
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "experiments/lines/replayed_attempt.hpp"
#include "experiments/protocol/protocol_file.hpp"

namespace impetus {
namespace {

using nlohmann::json;

/// What the lines so far have said, and what came of it.
struct Told {
  std::map<std::int64_t, Protocol> protocols;
  const Protocol* protocol{nullptr};
  int recording_format{0};
  SessionRecord session;
  PlannedTrial trial;
  std::int64_t steps{0};
  std::chrono::duration<double> taken{0.0};  ///< by the steps, and by what is made for each trial
  bool diverged{false};
};

void take_protocol(const json& line, Told& told) {
  const auto id = line.at("id").get<std::int64_t>();
  if (!told.protocols.contains(id)) {
    told.protocols.emplace(
        id, trusted_protocol(parse_json("the protocol", line.at("protocol").get<std::string>()),
                             parse_json("the scene", line.at("scene").get<std::string>())));
  }
  told.protocol = &told.protocols.at(id);
  told.recording_format = line.at("recording_format").get<int>();
}

void take_attempt(AttemptRecord attempt, const char* file, Told& told) {
  const auto began = std::chrono::steady_clock::now();
  const ReplayedAttempt found = AttemptReplay(*told.protocol, told.session, told.recording_format)
                                    .replay(told.trial, attempt);
  told.taken += std::chrono::steady_clock::now() - began;
  told.steps += found.steps;
  if (found.divergence) {
    told.diverged = true;
    std::printf("%s: diverges at %s\n", file,
                divergence_words(attempt.slot, *found.divergence).c_str());
  }
}

void take_line(const std::string& text, const char* file, Told& told) {
  const json line = json::parse(text);
  if (line.at("kind") == "protocol") {
    return take_protocol(line, told);
  }
  AnyRecord record = record_from(line);
  if (auto* session = std::get_if<SessionRecord>(&record)) {
    told.session = *session;
  } else if (auto* trial = std::get_if<PlannedTrial>(&record)) {
    told.trial = *trial;
  } else if (auto* attempt = std::get_if<AttemptRecord>(&record)) {
    take_attempt(std::move(*attempt), file, told);
  }
}

/// Whether every trial of the file ends each step in the state that it did.
bool replays(const char* file) {
  std::ifstream lines(file);
  Told told;
  for (std::string text; std::getline(lines, text);) {
    take_line(text, file, told);
  }
  if (!told.diverged) {
    std::printf("%s: %lld steps, the same bits, %.2f us a step\n", file,
                static_cast<long long>(told.steps),
                1e6 * told.taken.count() / static_cast<double>(told.steps));
  }
  return told.steps > 0 && !told.diverged;
}

}  // namespace
}  // namespace impetus

int main(int count, char** words) {
  try {
    bool all = count > 1;
    for (int i = 1; i < count; ++i) {
      all = impetus::replays(words[i]) && all;
    }
    return all ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
