// The scripts that make a report (analysis/report.R and analysis/R/), as built into the program.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace impetus {

/// Writes them to `folder`/analysis. Returns the one to run:
/// Rscript report.R STUDY --out FOLDER. Throws StoreError when one cannot be written.
std::filesystem::path write_report_scripts(const std::filesystem::path& folder);

}  // namespace impetus
