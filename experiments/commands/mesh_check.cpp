// `impetus mesh check`: whether a mesh file encloses a solid, and that solid's mass properties.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/models/mesh_file.hpp"
#include "experiments/models/mesh_report.hpp"

namespace impetus {
namespace {

int mesh_check(const std::vector<std::string>& files) {
  int status = kDone;
  for (const std::string& file : files) {
    const TriangleMesh mesh = load_mesh(file);
    std::printf("%s\n%s", file.c_str(), describe_mesh(mesh).c_str());
    status = report_mesh(mesh).usable() ? status : kFound;
  }
  return status;
}

}  // namespace

void add_mesh(CLI::App& app, Command& chosen) {
  auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* mesh = app.add_subcommand("mesh", "Look at triangle meshes");
  mesh->require_subcommand(1);
  CLI::App* command =
      mesh->add_subcommand("check", "Is it a closed solid? Its defects, volume and inertia");
  command->add_option("files", *files, "OBJ, PLY, STL, OFF or glTF")->required();
  command->callback([files, &chosen] { chosen = [files] { return mesh_check(*files); }; });
}

}  // namespace impetus
