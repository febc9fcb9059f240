// `impetus serve` as a browser meets it: what is served, what is refused before anybody is asked,
// several participants at once, and a program that is killed in the middle.
// SPDX-License-Identifier: MIT
#include "experiments/site/http_server.hpp"

#include <atomic>
#include <map>

#include "tests/experiments/site/serving_program.hpp"

namespace impetus::http_server_test {

using nlohmann::json;

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

TEST(Serve, SeveralAtOnceAreEachKeptWhole) { expect_kept_at_once(6); }

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
