// SPDX-License-Identifier: MIT
#include "experiments/settings/named_file.hpp"

#include "experiments/models/readable_file.hpp"

namespace impetus::inline settings {
namespace {

namespace fs = std::filesystem;

/// The folder above the file's own, unless that is the root of all files.
fs::path widest_folder(const fs::path& file) {
  const fs::path own = fs::absolute(file).lexically_normal().parent_path();
  const fs::path above = own.parent_path();
  return above == above.root_path() ? own : above;
}

}  // namespace

fs::path named_file(const JsonDocument& document, const fs::path& path, const std::string& pointer,
                    const std::string& what) {
  const nlohmann::json& name = document.value.at(nlohmann::json::json_pointer(pointer));
  const fs::path given = name.get<std::string>();
  fs::path file = (path.parent_path() / given).lexically_normal();
  const fs::path widest = widest_folder(path);
  const std::string outside = "expected " + what + " within " + widest.string() +
                              ", seen from this one, got " + name.dump();
  if (given.is_absolute() || !is_named_within(fs::absolute(file), widest)) {
    refuse(document, pointer, outside);
  }
  if (is_there(file) && !is_really_within(file, widest)) {
    refuse(document, pointer, outside + ", which is a link out of it");
  }
  if (const std::string problem = reading_problem(file); !problem.empty()) {
    refuse(document, pointer,
           "expected " + what + ", seen from this one, got " + name.dump() + ", but " +
               file.string() + ": " + problem);
  }
  return file;
}

}  // namespace impetus::inline settings
