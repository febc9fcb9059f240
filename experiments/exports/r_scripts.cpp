// SPDX-License-Identifier: MIT
#include "experiments/exports/r_scripts.hpp"

#include "experiments/exports/embedded_r_scripts.hpp"
#include "experiments/exports/whole_output.hpp"

namespace impetus::inline exports {

std::filesystem::path write_r_scripts(const std::filesystem::path& folder,
                                      const std::set<std::string>& names) {
  for (const EmbeddedFile& script : kRScripts) {
    const std::string name = script.name;
    const bool is_command = name.find('/') == std::string::npos;
    if (is_command && names.count(name) == 0) {
      continue;
    }
    const std::filesystem::path file = folder / "analysis" / name;
    std::filesystem::create_directories(file.parent_path());
    write_output_file(file, script.text);
  }
  return folder / "analysis";
}

}  // namespace impetus::inline exports
