// `impetus export`: a study in files that other programs read.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include "build_info.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/exports/csv_export.hpp"
#include "experiments/exports/whole_folder.hpp"
#include "experiments/session/input_error.hpp"

namespace impetus {
namespace {

struct ExportOptions {
  std::string database;
  std::string format{"csv"};
  std::string out;
  bool force{false};
};

void warn(const ExportReport& report) {
  if (report.formula_like_texts > 0) {
    std::fprintf(stderr,
                 "note: %lld texts begin with = + - or @; import text as text where a spreadsheet "
                 "would take it for a formula\n",
                 static_cast<long long>(report.formula_like_texts));
  }
  if (report.mended_texts > 0) {
    std::fprintf(stderr, "note: %lld texts were no UTF-8; bytes that are none became U+FFFD\n",
                 static_cast<long long>(report.mended_texts));
  }
}

int run_export(const ExportOptions& options) {
  StudyFile study = StudyFile::open_for_reading(options.database);
  WholeFolder folder(options.out, options.force);
  try {
    study.database().exec("BEGIN");  // one state of the study, whoever writes to it meanwhile
    const CodebookHead head{
        kBuild, study.database().execAndGet("SELECT build FROM study").getString(), false};
    const ExportReport report = export_csv(study, head, folder.path());
    folder.put_in_place();
    warn(report);
    std::printf("%s: %lld files, %lld rows; codebook.md says what each column means\n",
                options.out.c_str(), static_cast<long long>(report.files),
                static_cast<long long>(report.rows));
    return kDone;
  } catch (const SQLite::Exception& error) {
    throw StoreError(study.name() + ": could not be read (" + error.what() + ")");
  }
}

}  // namespace

void add_export(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command =
      app.add_subcommand("export", "Write a study as files that other programs read");
  command->add_option("study", options->database, "Study file")->required();
  command->add_option("--format", options->format, "csv")
      ->check(CLI::IsMember({"csv"}))
      ->capture_default_str();
  command->add_option("--out", options->out, "The folder to write to")->required();
  command->add_flag("--force", options->force, "Overwrite an earlier export");
  command->callback([options, &chosen] { chosen = [options] { return run_export(*options); }; });
}

}  // namespace impetus
