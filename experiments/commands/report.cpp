// `impetus report`: a study as a page of figures, statistics and words, with all it takes to repeat
// them.
//
//   study ─> a folder beside, with the scripts built into the program ─ Rscript ─> report.html
//         ─> renamed to --out, whole or not at all
//
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/r_program.hpp"
#include "experiments/exports/own_files.hpp"
#include "experiments/exports/r_scripts.hpp"
#include "experiments/exports/whole_output.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

namespace fs = std::filesystem;

/// What `impetus report` was asked for.
struct ReportOptions {
  std::string study;
  std::string out{"report"};
};

/// Of the file in which a report names all that it wrote, a name a line.
constexpr const char* kListName = "analysis/files.txt";

/// Throws StoreError.
void list_files(const fs::path& folder) {
  std::string list = std::string(kListName) + "\n";
  for (const std::string& name : names_below(folder)) {
    list += name + "\n";
  }
  write_output_file(folder / kListName, list);
}

/// The names in the list; of a report from before there were lists, those that it gives.
OwnName own_names(const fs::path& folder) {
  static const std::regex kUnlisted(
      R"(report\.html|analysis/(report\.R|R/[A-Za-z0-9_-]+\.(R|dcf|css))|data/([a-z_]+\.csv)?|)"
      R"(figures/([A-Za-z0-9_-]+\.(svg|pdf|png))?|tables/([A-Za-z0-9_-]+\.csv)?)");
  std::ifstream list(folder / kListName);
  if (!list) {
    return [](const std::string& name) { return std::regex_match(name, kUnlisted); };
  }
  std::set<std::string> names;
  for (std::string name; std::getline(list, name);) {
    names.insert(name);
  }
  return [names](const std::string& name) { return names.count(name) > 0; };
}

/// Throws InputError unless the folder is an earlier report and holds nothing else.
void require_earlier_report(const fs::path& folder) {
  const std::string expected =
      folder.string() + ": expected a new folder, an empty one or an earlier report, got one ";
  if (const std::string foreign = foreign_name(folder, own_names(folder)); !foreign.empty()) {
    throw InputError(expected + "that holds " + foreign);
  }
  if (!fs::exists(folder / "report.html")) {
    throw InputError(expected + "without report.html");
  }
}

/// The file that R reads: the study itself, or a copy of this schema where it is of an older one.
fs::path readable_study(const std::string& study, const fs::path& folder) {
  StudyFile file = StudyFile::open_for_reading(study);
  const bool in_memory = file.database()
                             .execAndGet("SELECT coalesce(file, '') = '' FROM pragma_database_list")
                             .getInt();
  if (!in_memory) {
    return fs::absolute(study);
  }
  fs::path copy = folder / "study" / fs::path(study).filename();
  fs::create_directories(copy.parent_path());
  write_study_copy(file, copy);
  return copy;
}

int report(const ReportOptions& options) {
  StudyFile::open_for_reading(options.study);  // refused before anything is made
  WholeFolder folder(options.out, FolderCheck(require_earlier_report));
  const fs::path script = write_r_scripts(folder.path(), {"report.R"}) / "report.R";
  const fs::path study = readable_study(options.study, folder.path());
  const int status =
      run_needed_r_script({script.string(), study.string(), "--out", folder.path().string()});
  fs::remove_all(folder.path() / "study");
  if (status == kCouldNotRun) {
    return kCouldNotRun;  // R has said why, in one sentence
  }
  const fs::path page = fs::path(options.out) / "report.html";
  if (status != 0 || !fs::exists(folder.path() / "report.html")) {
    throw std::runtime_error(page.string() + ": not written, for R ended with status " +
                             std::to_string(status));
  }
  list_files(folder.path());
  folder.put_in_place();
  std::printf("%s: open it in a browser; beside it figures, tables, data and the code to repeat\n",
              page.c_str());
  return kDone;
}

}  // namespace

void add_report(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<ReportOptions>(
      app, chosen, report, "report",
      "Figures, statistics and a methods section of a study, as a page to repeat (needs R)");
  command->add_option("study", options->study, "Study file; it is not changed")->required();
  command
      ->add_option("--out", options->out,
                   "The folder to write to: new, empty, or an earlier report, which it replaces")
      ->capture_default_str();
}

}  // namespace impetus::inline commands
