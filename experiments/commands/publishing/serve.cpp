// `impetus serve`: a study as a web page, its sessions kept as they happen.
// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/publishing/publication.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/site/http_server.hpp"
#include "experiments/site/served_study.hpp"
#include "experiments/tables/number_text.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What `impetus serve` was asked for.
struct ServeOptions {
  PublishOptions publishing;
  std::string database;
  std::string address{"127.0.0.1"};
  int port{8080};
  std::string origin;
  int links{0};
};

/// For the site while it is served.
class ServedFolder {
 public:
  ServedFolder() {
    std::string name = (fs::temp_directory_path() / "impetus-site-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw InputError(fs::temp_directory_path().string() +
                       ": expected a folder in which one for the site can be made");
    }
    path_ = name;
  }
  ~ServedFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ServedFolder(const ServedFolder&) = delete;
  ServedFolder& operator=(const ServedFolder&) = delete;

  [[nodiscard]] fs::path site() const { return path_ / "site"; }

 private:
  fs::path path_;
};

HttpAnswer sentence(int status, const std::string& words) {
  return {status, json{{"refused", words}}.dump(-1, ' ', false, json::error_handler_t::replace)};
}

/// What a page is told, whatever came of it; the file that could not be written is the lab's
/// affair.
HttpAnswer answer_of(const std::string& body, const std::function<json(const json& asked)>& act) {
  try {
    return {200, act(json::parse(body)).dump()};
  } catch (const NotYours& refused) {
    return sentence(403, refused.what());
  } catch (const InputError& refused) {
    return sentence(422, refused.what());
  } catch (const json::exception&) {
    return sentence(400, "expected JSON of the fields that a page sends");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "impetus: not kept: %s\n", error.what());
    return sentence(503, "what was sent could not be kept: try again");
  }
}

/// A code that nobody guesses.
std::string random_code() {
  std::random_device random;
  return printed("W%08x%08x", random(), random());
}

void print_links(const std::string& site, int count) {
  for (int link = 0; link < count; ++link) {
    std::printf("%s?participant=%s\n", site.c_str(), random_code().c_str());
  }
}

int serve(const ServeOptions& options) {
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);  // by all threads: this one waits for them

  require_links(options.publishing.site);
  const Publication publication = publication_of(options.publishing);
  const ServedFolder folder;
  write_site(publication.study, publication.protocol, options.publishing.site, publication.program,
             folder.site());
  StudyFile study = StudyFile::open_for_writing(options.database, build_name());
  ServedStudy served(publication.study, publication.protocol, study);
  served.tell([](const std::string& words) {
    std::printf("%s\n", words.c_str());
    std::fflush(stdout);
  });
  const HttpServer server({options.address, options.port, options.origin, folder.site(),
                           [&](const std::string& body) {
                             return answer_of(body, [&](const json& asked) {
                               served.take(posted_part_from(asked));
                               return json::object();
                             });
                           },
                           [&](const std::string& body) {
                             return answer_of(body, [&](const json& asked) {
                               return served.standing(asked.at("participant").get<std::string>(),
                                                      asked.at("key").get<std::string>());
                             });
                           }});
  const std::string origin = options.origin.empty()
                                 ? "http://" + options.address + ":" + std::to_string(server.port())
                                 : options.origin;
  std::printf("%s at %s/ into %s; Ctrl-C ends\n", publication.protocol.name.c_str(), origin.c_str(),
              options.database.c_str());
  print_links(origin + "/", options.links);
  std::fflush(stdout);
  int ended = 0;
  sigwait(&ends, &ended);
  std::printf("ending: what came in so far is kept\n");
  return kDone;
}

}  // namespace

void add_serve(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<ServeOptions>(
      app, chosen, serve, "serve", "Serve a study as a web page and keep its sessions");
  options->publishing.site.served = true;
  add_publish_options(*command, options->publishing);
  command->add_option("--db", options->database, "Study file; made when it does not exist")
      ->required();
  command->add_option("--port", options->port, "Port to serve at; 0: any that is free")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command
      ->add_option("--address", options->address,
                   "Address to serve at; 0.0.0.0: whoever reaches this machine")
      ->capture_default_str();
  command->add_option("--origin", options->origin,
                      "Where participants see it, behind a web server, as https://lab.example");
  command->add_option("--links", options->links, "Print so many links, each for one participant")
      ->check(CLI::Range(0, 100'000));
}

}  // namespace impetus::inline commands
