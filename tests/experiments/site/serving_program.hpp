// The program as it serves a study, and those who take part.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "tests/experiments/program.hpp"
#include "tests/experiments/site/page_session.hpp"

// Last: its macros meet nobody.
#include <httplib.h>

namespace impetus {

inline constexpr const char* kJson = "application/json";

/// The program, serving the short causality study of a folder.
class ServingProgram {
 public:
  explicit ServingProgram(const TemporaryFolder& folder) : folder_(folder) {
    folder.write("protocols/short.json", short_causality().protocol_json);
    folder.write("stimuli/two-spheres.json", short_causality().scene_json);
    folder.write("page/impetus.js", "js");
    folder.write("page/impetus.wasm", "wasm");
    begin();
  }
  ~ServingProgram() { end(SIGTERM); }
  ServingProgram(const ServingProgram&) = delete;
  ServingProgram& operator=(const ServingProgram&) = delete;

  void begin() {
    std::filesystem::remove(folder_ / "stdout");  // of the one before
    process_ = start_program(folder_, {"serve", "protocols/short.json", "--db", "a.sqlite",
                                       "--program", "page", "--port", "0", "--links", "2"});
    for (int wait = 0; wait < 3000 && port_of_output() == 0; ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }

  int end(int signal) {
    kill(process_, signal);
    return wait_for(folder_, process_).status;
  }

  [[nodiscard]] int port_of_output() const {
    const std::string words = text_of(folder_ / "stdout");
    const std::size_t at = words.find("http://127.0.0.1:");
    return at == std::string::npos || words.find('\n') == std::string::npos
               ? 0
               : std::atoi(words.c_str() + at + 17);
  }

  /// Posts until it is answered, and again where it was one of too many, as a page does; the
  /// status.
  [[nodiscard]] int post(const PagePart& part) const {
    char number[16];
    std::snprintf(number, sizeof number, "%04d", static_cast<int>(part.number));
    const nlohmann::json body{{"experimentID", ""},
                              {"filename", part.name + "_" + number + ".jsonl"},
                              {"data", part.lines},
                              {"key", kPageKey}};
    httplib::Client client("127.0.0.1", port_of_output());
    client.set_read_timeout(60);
    for (int attempt = 0; attempt < 300; ++attempt) {
      const auto answer = client.Post("/parts", {}, body.dump(), kJson);
      if (answer && answer->status != 429) {
        return answer->status;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(200));  // as a page waits
    }
    return -1;
  }

  [[nodiscard]] nlohmann::json standing(const std::string& code, const std::string& key) const {
    const auto answer =
        httplib::Client("127.0.0.1", port_of_output())
            .Post("/standing", {}, nlohmann::json{{"participant", code}, {"key", key}}.dump(),
                  kJson);
    return answer ? nlohmann::json{{"status", answer->status},
                                   {"answer", nlohmann::json::parse(answer->body)}}
                  : nlohmann::json();
  }

 private:
  const TemporaryFolder& folder_;
  pid_t process_{0};
};

/// So many sessions, each posted as fast as it is taken, are each kept whole, verified and
/// replayed.
inline void expect_kept_at_once(int people_count) {
  std::vector<std::vector<PagePart>> sessions;
  for (int person = 0; person < people_count; ++person) {
    const std::string code = "P" + std::to_string(person);
    sessions.push_back(parts_of(lines_from(short_causality(), {}, code), code + "_2026"));
  }
  const TemporaryFolder folder;
  {
    ServingProgram serving(folder);
    std::atomic<int> refused{0};
    std::vector<std::thread> people;
    for (const std::vector<PagePart>& session : sessions) {
      people.emplace_back([&] {
        for (const PagePart& part : session) {
          refused += serving.post(part) == 200 ? 0 : 1;
        }
      });
    }
    for (std::thread& person : people) {
      person.join();
    }
    EXPECT_EQ(refused, 0);
    EXPECT_EQ(serving.end(SIGINT), 0);
    serving.begin();
  }
  EXPECT_EQ(value_of(folder / "a.sqlite",
                     "SELECT count(*) || ' ' || count(DISTINCT trial_id) FROM attempt"),
            std::to_string(33 * people_count) + " " + std::to_string(33 * people_count));
  EXPECT_EQ(run_program(folder, {"verify", "a.sqlite"}).status, 0);
  const ProgramResult replayed = run_program(folder, {"replay", "a.sqlite"});
  EXPECT_NE(replayed.output.find(" 0 divergent"), std::string::npos) << replayed.output;
}

}  // namespace impetus
