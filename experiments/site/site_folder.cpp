// SPDX-License-Identifier: MIT
#include "experiments/site/site_folder.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <vector>

#include "experiments/exports/own_files.hpp"
#include "experiments/exports/whole_output.hpp"
#include "experiments/protocol/protocol_scenes.hpp"
#include "experiments/protocol/screen_file.hpp"
#include "experiments/scenes/scene_file.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/site/embedded_page.hpp"

namespace impetus::inline site {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kMark = "site.json";
constexpr const char* kProgramFiles[] = {"impetus.js", "impetus.wasm"};

/// "https://host:port" of a link; "" where it is none that a page may use: but for this machine's
/// own, what is sent must be sealed.
std::string origin_of(const std::string& link) {
  static const std::regex usable(
      R"((https://[A-Za-z0-9.-]+(:[0-9]+)?|http://(localhost|127\.0\.0\.1)(:[0-9]+)?)(/[^\s"'<>;,]*)?)");
  std::smatch parts;
  return std::regex_match(link, parts, usable) ? parts[1].str() : "";
}

void require_link(const std::string& option, const std::string& link) {
  if (!link.empty() && origin_of(link).empty()) {
    throw InputError(option + ": expected a link that begins with https://, got " + link);
  }
}

/// The page asks nothing of other origins than its own and the drop's.
std::string policy_of(const SiteOptions& options) {
  return "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; "
         "img-src data:; base-uri 'none'; form-action 'none'; connect-src 'self' " +
         origin_of(options.drop_url);
}

std::string with_policy(std::string page, const SiteOptions& options) {
  const std::string place = "<meta charset=\"utf-8\">\n";
  page.insert(
      page.find(place) + place.size(),
      "<meta http-equiv=\"Content-Security-Policy\" content=\"" + policy_of(options) + "\">\n");
  return page;
}

/// Builds the shapes of all conditions with a cache in the folder; returns the files that it kept.
std::vector<std::string> write_trees(const Protocol& protocol, const fs::path& folder) {
  const auto shapes = std::make_shared<ShapeLibrary>(TreeCache(folder));
  ProtocolScenes(protocol, kUnroundedHold, shapes).build_shapes(assumed_screen());
  std::vector<std::string> files;
  if (fs::exists(folder)) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      files.push_back(entry.path().filename().string());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// What the page itself says, by key.
json texts_json(const Language& language) {
  json texts = json::object();
  for (std::size_t i = 0; i < kTextRows.size(); ++i) {
    texts[std::string(kTextRows[i].key)] = language.texts()[i];
  }
  return texts;
}

json site_json(const Protocol& protocol, const SiteOptions& options,
               const std::vector<std::string>& trees) {
  const json language = protocol.document.value.value("language", json("en"));
  json site{{"study", protocol.hash},
            {"title", protocol.title},
            {"language", language.is_string() ? language : json("")},
            {"phones", options.phones},
            {"completion", options.completion},
            {"assume_screen", options.assume_screen},
            {"in_window", options.in_window},
            {"allow_failed_sync", options.allow_failed_sync},
            {"texts", texts_json(protocol.script.language)},
            {"trees", trees},
            {"drop", nullptr}};
  if (!options.drop_url.empty()) {
    site["drop"] = {{"url", options.drop_url}, {"experiment", options.experiment}};
  }
  if (options.served) {
    site["drop"] = {{"url", "parts"}, {"experiment", ""}};
  }
  site["standing"] = options.served ? json("standing") : json();
  return site;
}

/// The trees of a site's mark; null where it is none.
json trees_of(const fs::path& folder) {
  std::ifstream stream(folder / kMark);
  const json site = json::parse(stream, nullptr, false);
  return site.is_object() && site.contains("study") && site.contains("trees") ? site["trees"]
                                                                              : json();
}

/// Whether a site with these trees has such a file.
bool is_of_site(const std::string& name, const json& trees) {
  const auto is_name = [&](const auto& other) { return name == other; };
  return name == kMark || name == "study.json" || name == "trees/" ||
         std::any_of(std::begin(kPageFiles), std::end(kPageFiles),
                     [&](const EmbeddedFile& file) { return is_name(file.name); }) ||
         std::any_of(std::begin(kProgramFiles), std::end(kProgramFiles), is_name) ||
         std::any_of(trees.begin(), trees.end(), [&](const json& tree) {
           return tree.is_string() && is_name("trees/" + tree.get<std::string>());
         });
}

/// Throws InputError unless a folder of files may be replaced.
void check_target(const fs::path& target, const SiteOptions& options) {
  const std::string expected = target.string() + ": expected a new folder, got one that holds ";
  if (!options.replace) {
    throw InputError(expected + "files; --force replaces a site");
  }
  const json trees = trees_of(target);
  if (!trees.is_array()) {
    throw InputError(expected + "files that are no site");
  }
  const std::string foreign =
      foreign_name(target, [&](const std::string& name) { return is_of_site(name, trees); });
  if (!foreign.empty()) {
    throw InputError(expected + foreign + ", which is of no site");
  }
}

void require_program(const fs::path& program) {
  for (const char* file : kProgramFiles) {
    if (!fs::is_regular_file(program / file)) {
      throw InputError(
          "expected " + (program / file).string() +
          ", the program that runs in a page, but there is none; `cmake --preset browser && cmake "
          "--build build-browser --target impetus_page` makes it, with emscripten");
    }
  }
}

}  // namespace

void require_publishable(const Protocol& protocol) {
  if (!protocol.has_participants) {
    refuse(protocol.document, "/participants",
           "expected a protocol in which somebody takes part, got none");
  }
  if (protocol.script.gaze && protocol.script.gaze->yoked_to) {
    refuse(protocol.document, "/gaze/yoked_to",
           "expected none in a page, which does not know the gaze of others");
  }
  if (protocol.scene.value.contains("sound")) {
    refuse(protocol.scene, "/sound", "expected none in a page, which plays no sounds");
  }
}

void require_links(const SiteOptions& options) {
  require_link("--drop", options.drop_url);
  require_link("--completion", options.completion);
  if (options.drop_url.empty() != options.experiment.empty()) {
    throw InputError("--drop and --experiment: expected both or neither");
  }
}

void write_site(const PublishedStudy& study, const Protocol& protocol, const SiteOptions& options,
                const fs::path& program, const fs::path& folder) {
  require_program(program);
  WholeFolder whole(folder, [&](const fs::path& target) { check_target(target, options); });
  for (const EmbeddedFile& file : kPageFiles) {
    const std::string name = file.name;
    write_output_file(whole.path() / name,
                      name == "index.html" ? with_policy(file.text, options) : file.text);
  }
  for (const char* file : kProgramFiles) {
    fs::copy_file(program / file, whole.path() / file);
  }
  write_output_file(whole.path() / "study.json", to_json(study).dump());
  const std::vector<std::string> trees = write_trees(protocol, whole.path() / "trees");
  write_output_file(whole.path() / kMark, site_json(protocol, options, trees).dump(2) + "\n");
  whole.put_in_place();
}

}  // namespace impetus::inline site
