// A web server that hands out the files of one folder and answers two kinds of posts. It knows
// nothing of studies, so that what it includes meets nobody else.
//
//   GET  /...        a file of the folder
//   POST /parts      {"filename", "data", "key"}     ─> take_part
//   POST /standing   {"participant", "key"}          ─> standing
//
// Refused before anybody is asked: what is too large, comes too often from one address, is no JSON,
// or was sent by a page of another origin.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace impetus::inline site {

/// What a post is answered with.
struct HttpAnswer {
  int status{200};
  std::string json{"{}"};
};

/// Called on any of many threads, with the post's body.
using AnswerPost = std::function<HttpAnswer(const std::string& body)>;

/// Where and what to serve.
struct HttpSite {
  std::string address{"127.0.0.1"};
  int port{8080};      ///< 0: any that is free
  std::string origin;  ///< of the pages that may post, "https://lab.example"; "": the server's own
  std::filesystem::path folder;
  AnswerPost take_part;
  AnswerPost standing;
};

/// Serves from its making until it is destroyed.
class HttpServer {
 public:
  /// Throws InputError when nothing can be served at this address and port.
  explicit HttpServer(HttpSite site);
  ~HttpServer();  ///< once all that came in is answered
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] int port() const;

 private:
  struct Running;
  std::unique_ptr<Running> running_;
};

}  // namespace impetus::inline site
