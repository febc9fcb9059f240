// `impetus mesh check`: whether a mesh file can be simulated, and the solid's mass properties.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/files/mesh_file.hpp"
#include "experiments/models/mesh_report.hpp"

namespace impetus::inline commands {
namespace {

int refuse(const std::string& file, const std::string& reason) {
  std::fflush(stdout);
  std::fprintf(stderr, "impetus: %s: %s; Blender, MeshLab or admesh can mend it\n", file.c_str(),
               reason.c_str());
  return kFound;
}

int check_one(const std::string& file) {
  try {
    const MeshReport report = report_mesh(load_mesh(file));
    std::printf("%s\n%s", file.c_str(), describe(report).c_str());
    return report.usable() ? kDone : refuse(file, refusal(report));
  } catch (const std::runtime_error& unreadable) {
    std::fflush(stdout);
    std::fprintf(stderr, "impetus: %s\n", unreadable.what());
    return kCouldNotRun;
  }
}

/// Of all files; the worst status.
int check(const std::vector<std::string>& files) {
  int status = kDone;
  for (const std::string& file : files) {
    status = std::max(status, check_one(file));
  }
  return status;
}

}  // namespace

void add_mesh(CLI::App& app, Command& chosen) {
  CLI::App* mesh = app.add_subcommand("mesh", "Look at triangle meshes");
  mesh->require_subcommand(1);
  const auto [command, files] = add_command<std::vector<std::string>>(
      *mesh, chosen, check, "check",
      "Can it be simulated? Its defects, volume and inertia; 1 when it cannot");
  command->add_option("files", *files, "OBJ, PLY, STL, OFF or glTF")->required();
}

}  // namespace impetus::inline commands
