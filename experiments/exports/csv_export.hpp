// A study as CSV: a file for each table, the protocols' own files, and a codebook.
//
//   trials.csv, collisions.csv, clicks.csv, ... , codebook.json, codebook.md
//   protocols/NAME-HASH.protocol.json, protocols/NAME-HASH.scene.json
//
// Every value of the study stands in one of them, exactly.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "experiments/exports/codebook.hpp"
#include "experiments/store/study_file.hpp"

namespace impetus::inline exports {

/// What was written, and what its reader should know.
struct ExportReport {
  std::int64_t files{0};
  std::int64_t rows{0};
  std::int64_t formula_like_texts{0};  ///< that a spreadsheet may take for formulas
  std::int64_t mended_texts{0};        ///< that were no UTF-8: bytes were replaced
};

/// Writes into `folder`, which exists and is empty. Throws StoreError when the study cannot be read
/// or a file cannot be written.
ExportReport export_csv(StudyFile& study, const CodebookHead& head,
                        const std::filesystem::path& folder);

}  // namespace impetus::inline exports
