// SPDX-License-Identifier: MIT
#include "experiments/site/http_server.hpp"

#include <httplib.h>

#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "experiments/settings/input_error.hpp"

namespace impetus::inline site {
namespace {

constexpr std::size_t kMostBytes = 64'000'000;  // of one post
constexpr std::size_t kThreads = 64;            // each page keeps one busy while it is heard
constexpr time_t kWait_s = 10;                  // for a page that falls silent in the middle

/// How often one address may post: a room full of participants behind one, but no flood.
class PostRate {
 public:
  bool allows(const std::string& address) {
    const auto now = std::chrono::steady_clock::now();
    const std::lock_guard lock(mutex_);
    if (buckets_.size() > kMostAddresses) {
      buckets_.clear();
    }
    Bucket& bucket = buckets_.try_emplace(address, Bucket{kBurst, now}).first->second;
    const double passed_s = std::chrono::duration<double>(now - bucket.filled).count();
    bucket = {std::min(kBurst, bucket.left + kPerSecond * passed_s), now};
    const bool allowed = bucket.left >= 1.0;
    bucket.left -= allowed ? 1.0 : 0.0;
    return allowed;
  }

 private:
  static constexpr double kBurst = 200.0;
  static constexpr double kPerSecond = 30.0;
  static constexpr std::size_t kMostAddresses = 10'000;

  /// What an address has left, as of when.
  struct Bucket {
    double left;
    std::chrono::steady_clock::time_point filled;
  };

  std::mutex mutex_;
  std::map<std::string, Bucket> buckets_;
};

HttpAnswer refusal(int status, const std::string& sentence) {
  return {status, R"({"refused": ")" + sentence + R"("})"};
}

}  // namespace

/// The library's server and the thread on which it listens.
struct HttpServer::Running {
  explicit Running(HttpSite given) : site(std::move(given)) {
    server.set_payload_max_length(kMostBytes);
    // The library lets several programs share a port: then nobody knows who takes a trial.
    server.set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    server.set_tcp_nodelay(true);
    server.set_read_timeout(kWait_s);
    server.set_write_timeout(kWait_s);
    server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    // Isolated pages have the finest clock; nothing of the site is of use to other pages.
    server.set_default_headers({{"Cross-Origin-Opener-Policy", "same-origin"},
                                {"Cross-Origin-Embedder-Policy", "require-corp"},
                                {"Cross-Origin-Resource-Policy", "same-origin"},
                                {"X-Content-Type-Options", "nosniff"},
                                {"Referrer-Policy", "no-referrer"},
                                {"Cache-Control", "no-cache"}});
    server.set_mount_point("/", site.folder.string());
    answer("/parts", site.take_part);
    answer("/standing", site.standing);
    port = site.port == 0                                 ? server.bind_to_any_port(site.address)
           : server.bind_to_port(site.address, site.port) ? site.port
                                                          : -1;
    if (port < 0) {
      throw InputError(site.address + ":" + std::to_string(site.port) +
                       ": expected an address of this machine and a port that is free (--address, "
                       "--port)");
    }
    listening = std::thread([this] { server.listen_after_bind(); });
  }

  ~Running() {
    while (!server.is_running()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    server.stop();
    listening.join();
  }

  void answer(const char* path, const AnswerPost& act) {
    server.Post(path, [this, &act](const httplib::Request& asked, httplib::Response& said) {
      HttpAnswer answer = refused(asked).value_or(HttpAnswer{0, ""});
      if (answer.status == 0) {
        answer = act(asked.body);
      }
      said.status = answer.status;
      said.set_content(answer.json, "application/json");
    });
  }

  std::optional<HttpAnswer> refused(const httplib::Request& asked) {
    if (!rate.allows(asked.remote_addr)) {
      return refusal(429, "too many at once: try again in a moment");
    }
    if (asked.get_header_value("Content-Type").rfind("application/json", 0) != 0) {
      return refusal(415, "expected application/json");
    }
    const std::string from = asked.get_header_value("Origin");
    const std::string host = asked.get_header_value("Host");
    const bool own = site.origin.empty() ? from == "http://" + host || from == "https://" + host
                                         : from == site.origin;
    if (!from.empty() && !own) {
      return refusal(403, "expected a page of this site");
    }
    return std::nullopt;
  }

  HttpSite site;
  PostRate rate;
  httplib::Server server;
  int port{-1};
  std::thread listening;
};

HttpServer::HttpServer(HttpSite site) : running_(std::make_unique<Running>(std::move(site))) {}
HttpServer::~HttpServer() = default;
int HttpServer::port() const { return running_->port; }

}  // namespace impetus::inline site
