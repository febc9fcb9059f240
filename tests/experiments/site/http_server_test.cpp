// `impetus serve` as a browser meets it: what is served, what is refused before anybody is asked,
// several participants at once, and a program that is killed in the middle.
// SPDX-License-Identifier: MIT
#include "experiments/site/http_server.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <map>
#include <thread>

#include "tests/experiments/program.hpp"
#include "tests/experiments/site/page_session.hpp"

// Last: its macros meet nobody.
#include <httplib.h>

namespace impetus::http_server_test {

using nlohmann::json;

constexpr const char* kJson = "application/json";

/// A folder that is served; posts are answered with what they said.
struct ServedFiles {
  explicit ServedFiles(const std::string& origin = "") {
    folder.write("site/index.html", "<p>page</p>");
    folder.write("site/impetus.wasm", "wasm");
    folder.write("secret.sqlite", "others' data");
    HttpSite site;
    site.port = 0;
    site.origin = origin;
    site.folder = folder.path() / "site";
    site.take_part = [this](const std::string& body) {
      ++asked;
      return HttpAnswer{200, body};
    };
    site.standing = [](const std::string& /*body*/) { return HttpAnswer{403, "{}"}; };
    server = std::make_unique<HttpServer>(std::move(site));
  }

  [[nodiscard]] httplib::Client client() const {
    return httplib::Client("127.0.0.1", server->port());
  }

  int status(const httplib::Headers& headers, const char* type = kJson) {
    return client().Post("/parts", headers, "{}", type)->status;
  }

  TemporaryFolder folder;
  std::atomic<int> asked{0};
  std::unique_ptr<HttpServer> server;
};

TEST(HttpServer, ServesItsFolderAndNothingElse) {
  const ServedFiles served;
  const auto page = served.client().Get("/");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->body, "<p>page</p>");
  EXPECT_EQ(page->get_header_value("Cross-Origin-Embedder-Policy"), "require-corp");
  EXPECT_EQ(served.client().Get("/impetus.wasm")->get_header_value("Content-Type"),
            "application/wasm");
  for (const char* path : {"/secret.sqlite", "/../secret.sqlite", "/%2e%2e/secret.sqlite",
                           "/..%2fsecret.sqlite", "//etc/passwd", "/parts"}) {
    const auto answer = served.client().Get(path);
    ASSERT_TRUE(answer) << path;
    EXPECT_EQ(answer->status, 404) << path;
  }
}

TEST(HttpServer, PostsOfOtherPagesAndOtherKindsReachNobody) {
  ServedFiles served;
  const std::string own = "http://127.0.0.1:" + std::to_string(served.server->port());
  EXPECT_EQ(served.status({}), 200);
  EXPECT_EQ(served.status({{"Origin", own}}), 200);
  EXPECT_EQ(served.asked, 2);
  EXPECT_EQ(served.status({{"Origin", "https://elsewhere.example"}}), 403);
  EXPECT_EQ(served.status({{"Origin", "null"}}), 403);
  EXPECT_EQ(served.status({}, "text/plain"), 415);
  EXPECT_EQ(served.client().Post("/standing", {}, "{}", kJson)->status, 403);
  EXPECT_EQ(served.client().Post("/else", {}, "{}", kJson)->status, 404);
  EXPECT_EQ(served.asked, 2);
  ServedFiles behind("https://lab.example");
  EXPECT_EQ(behind.status({{"Origin", "https://lab.example"}}), 200);
  EXPECT_EQ(behind.status({{"Origin", own}}), 403);
}

TEST(HttpServer, FloodsAndWhatIsTooLargeAreTurnedAway) {
  ServedFiles served;
  httplib::Client client = served.client();
  client.set_keep_alive(true);
  client.set_tcp_nodelay(true);
  std::map<int, int> answers;
  for (int post = 0; post < 400; ++post) {
    ++answers[client.Post("/parts", {}, "{}", kJson)->status];
  }
  EXPECT_GE(answers[200], 200);
  EXPECT_GE(answers[429], 50);
  EXPECT_EQ(answers.size(), 2U);
  ServedFiles other;
  const auto large = other.client().Post("/parts", {}, std::string(65'000'000, ' '), kJson);
  EXPECT_TRUE(!large || large->status == 413);
  EXPECT_EQ(other.asked, 0);
}

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

  /// Posts until it is answered: the status.
  [[nodiscard]] int post(const PagePart& part) const {
    char number[16];
    std::snprintf(number, sizeof number, "%04d", static_cast<int>(part.number));
    const json body{{"experimentID", ""},
                    {"filename", part.name + "_" + number + ".jsonl"},
                    {"data", part.lines},
                    {"key", kPageKey}};
    httplib::Client client("127.0.0.1", port_of_output());
    client.set_read_timeout(60);
    const auto answer = client.Post("/parts", {}, body.dump(), kJson);
    return answer ? answer->status : -1;
  }

  [[nodiscard]] json standing(const std::string& code, const std::string& key) const {
    const auto answer =
        httplib::Client("127.0.0.1", port_of_output())
            .Post("/standing", {}, json{{"participant", code}, {"key", key}}.dump(), kJson);
    return answer ? json{{"status", answer->status}, {"answer", json::parse(answer->body)}}
                  : json();
  }

 private:
  const TemporaryFolder& folder_;
  pid_t process_{0};
};

TEST(Serve, SeveralAtOnceAreEachKeptWhole) {
  constexpr int kParticipants = 6;
  std::vector<std::vector<PagePart>> sessions;
  for (int person = 0; person < kParticipants; ++person) {
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
            "198 198");
  EXPECT_EQ(run_program(folder, {"verify", "a.sqlite"}).status, 0);
  const ProgramResult replayed = run_program(folder, {"replay", "a.sqlite"});
  EXPECT_NE(replayed.output.find(" 0 divergent"), std::string::npos) << replayed.output;
}

TEST(Serve, AProgramThatIsKilledLosesAndDoublesNothing) {
  const std::vector<PagePart> parts = parts_of(session_lines(), kPageName);
  const TemporaryFolder folder;
  {
    ServingProgram serving(folder);
    for (const PagePart& part : parts) {
      EXPECT_EQ(serving.post(part), 200);
      if (part.number % 11 == 0) {
        serving.end(SIGKILL);
        serving.begin();
        EXPECT_EQ(serving.post(part), 200);
      }
    }
  }
  EXPECT_EQ(value_of(folder / "a.sqlite",
                     "SELECT count(*) || ' ' || count(DISTINCT trial_id) FROM attempt"),
            "33 33");
  EXPECT_EQ(run_program(folder, {"verify", "a.sqlite"}).status, 0);
}

TEST(Serve, AnswersInWordsAndTellsNobodyOfOthers) {
  const std::vector<PagePart> parts = parts_of(session_lines(), kPageName);
  const TemporaryFolder folder;
  const ServingProgram serving(folder);
  EXPECT_EQ(serving.post(parts[0]), 200);
  EXPECT_EQ(serving.post(parts[2]), 422);
  EXPECT_EQ(serving.standing("P02", kPageKey), json({{"status", 200}, {"answer", nullptr}}));
  EXPECT_EQ(serving.standing("P01", "fedcba9876543210")["status"], 403);
  EXPECT_EQ(serving.standing("P01", kPageKey)["answer"]["completed"], json({1}));
  EXPECT_EQ(serving.standing("no code\n", kPageKey)["status"], 422);
  const std::string words = text_of(folder / "stdout");
  EXPECT_EQ(lines_of(words).size(), 4U) << words;  // where, two links, and that P01 begins
  EXPECT_NE(words.find("/?participant=W"), std::string::npos) << words;
}

TEST(Serve, APortThatIsTakenIsSaid) {
  const TemporaryFolder folder;
  const ServingProgram serving(folder);
  const std::string port = std::to_string(serving.port_of_output());
  const TemporaryFolder other;
  other.write("page/impetus.js", "js");
  other.write("page/impetus.wasm", "wasm");
  const ProgramResult second =
      run_program(other, {"serve", (folder.path() / "protocols/short.json").string(), "--db",
                          "b.sqlite", "--program", "page", "--port", port});
  EXPECT_EQ(second.status, 2);
  EXPECT_EQ(second.errors, "impetus: 127.0.0.1:" + port +
                               ": expected an address of this machine and a port that is free "
                               "(--address, --port)\n");
}

}  // namespace impetus::http_server_test
