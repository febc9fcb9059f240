// SPDX-License-Identifier: MIT
#include "experiments/exports/report_scripts.hpp"

#include "experiments/exports/embedded_report_scripts.hpp"
#include "experiments/exports/output_file.hpp"

namespace impetus {

std::filesystem::path write_report_scripts(const std::filesystem::path& folder) {
  for (const EmbeddedFile& script : kReportScripts) {
    const std::filesystem::path file = folder / "analysis" / script.name;
    std::filesystem::create_directories(file.parent_path());
    write_output_file(file, script.text);
  }
  return folder / "analysis" / "report.R";
}

}  // namespace impetus
