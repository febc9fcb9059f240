// `impetus export`: a study in files that other programs read, or as another study without people.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/exports/anonymise.hpp"
#include "experiments/exports/bids_export.hpp"
#include "experiments/exports/csv_export.hpp"
#include "experiments/exports/earlier_export.hpp"
#include "experiments/exports/whole_output.hpp"
#include "experiments/provenance/build_name.hpp"
#include "experiments/settings/input_error.hpp"
#include "experiments/study/stored_plan.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus export` was asked for.
struct ExportOptions {
  std::string database;
  std::string format{"csv"};
  std::string out;
  bool anonymise{false};
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

/// Without the people, where that was asked for; the study itself otherwise.
StudyFile& chosen_study(StudyFile& study, std::optional<StudyFile>& copy,
                        const ExportOptions& options) {
  if (!options.anonymise) {
    return study;
  }
  copy.emplace(StudyFile::copy_in_memory(study));
  anonymise(copy->database(), build_name(), hash_of);
  return *copy;
}

CodebookHead head_of(SQLite::Database& study) {
  return {build_name(), study.execAndGet("SELECT build FROM study").getString(),
          study.execAndGet("SELECT anonymised_by IS NOT NULL FROM study").getInt() != 0};
}

int export_file(StudyFile& original, const ExportOptions& options) {
  require_free_file(original, options.out, options.force);
  std::optional<StudyFile> copy;
  write_study_copy(chosen_study(original, copy, options), options.out);
  std::printf("%s: the study%s\n", options.out.c_str(),
              options.anonymise ? " without who took part" : "");
  return kDone;
}

/// What becomes of a folder that holds files.
FolderCheck check_of(const ExportOptions& options) {
  return [force = options.force](const std::filesystem::path& target) {
    if (!force) {
      throw InputError(target.string() +
                       ": holds files already and is not overwritten without --force");
    }
    require_earlier_export(target);
  };
}

int export_folder(StudyFile& original, const ExportOptions& options) {
  WholeFolder folder(options.out, check_of(options));
  original.database().exec("BEGIN");  // one state of the study, whoever writes to it meanwhile
  std::optional<StudyFile> copy;
  StudyFile& study = chosen_study(original, copy, options);
  const CodebookHead head = head_of(study.database());
  const bool bids = options.format == "bids";
  const ExportReport report =
      bids ? export_bids(study, head, folder.path()) : export_csv(study, head, folder.path());
  folder.put_in_place();
  warn(report);
  std::printf("%s: %lld files, %lld rows; %s says what each column means\n", options.out.c_str(),
              static_cast<long long>(report.files), static_cast<long long>(report.rows),
              bids ? "the .json beside each table" : "codebook.md");
  return kDone;
}

int run_export(const ExportOptions& options) {
  StudyFile study = StudyFile::open_for_reading(options.database);
  return while_reading(study, [&] {
    return options.format == "study" ? export_file(study, options) : export_folder(study, options);
  });
}

}  // namespace

void add_export(CLI::App& app, Command& chosen) {
  const auto [command, options] = add_command<ExportOptions>(
      app, chosen, run_export, "export", "Write a study as files that other programs read");
  command->add_option("study", options->database, "Study file")->required();
  command
      ->add_option("--format", options->format,
                   "csv: tables and a codebook; bids: a BIDS 1.11 dataset; study: a study file")
      ->check(CLI::IsMember({"csv", "bids", "study"}))
      ->capture_default_str();
  command->add_option("--out", options->out, "The folder to write to; of a study, the file")
      ->required();
  command->add_flag("--anonymise", options->anonymise,
                    "New codes; leave out what people typed, names of machines and dates");
  command->add_flag("--force", options->force,
                    "Overwrite an earlier export, which holds nothing else");
}

}  // namespace impetus::inline commands
