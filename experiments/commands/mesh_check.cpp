// `impetus mesh check`: whether a mesh file can be simulated, the solid's mass properties, and a
// repaired copy.
// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/models/mesh_file.hpp"
#include "experiments/models/mesh_mending.hpp"
#include "experiments/models/mesh_report.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus mesh check` was asked for.
struct MeshArguments {
  std::vector<std::string> files;
  std::string out;
};

int refuse(const std::string& file, const std::string& reason) {
  std::fflush(stdout);
  std::fprintf(stderr, "impetus: %s: %s\n", file.c_str(), reason.c_str());
  return kFound;
}

int check(const std::vector<std::string>& files) {
  int status = kDone;
  for (const std::string& file : files) {
    const MeshReport report = report_mesh(load_mesh(file));
    std::printf("%s\n%s", file.c_str(), describe(report).c_str());
    status = report.usable() ? status : refuse(file, refusal(report));
  }
  return status;
}

int repair_into(const std::string& file, const std::string& out) {
  const Mending mending = mend(file, out);
  std::printf("%s\n", file.c_str());
  if (!mending.refusal.empty()) {
    return refuse(file, mending.refusal + "; nothing was written");
  }
  std::printf("%swritten       %s\n", describe_changes(mending.repair).c_str(), out.c_str());
  return check({out});
}

int mesh_check(const MeshArguments& arguments) {
  if (arguments.out.empty()) {
    return check(arguments.files);
  }
  if (arguments.files.size() != 1) {
    throw InputError("--repair: expected one file to repair, got " +
                     std::to_string(arguments.files.size()));
  }
  return repair_into(arguments.files.front(), arguments.out);
}

}  // namespace

void add_mesh(CLI::App& app, Command& chosen) {
  auto arguments = std::make_shared<MeshArguments>();
  CLI::App* mesh = app.add_subcommand("mesh", "Look at triangle meshes");
  mesh->require_subcommand(1);
  CLI::App* command = mesh->add_subcommand(
      "check", "Can it be simulated? Its defects, volume and inertia; 1 when it cannot");
  command->add_option("files", arguments->files, "OBJ, PLY, STL, OFF or glTF")->required();
  command->add_option("--repair", arguments->out,
                      "Write a repaired copy: a new .obj, .ply or .stl");
  command->callback(
      [arguments, &chosen] { chosen = [arguments] { return mesh_check(*arguments); }; });
}

}  // namespace impetus::inline commands
