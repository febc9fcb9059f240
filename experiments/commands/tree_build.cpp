// `impetus tree build`: a volume tree of a mesh file or a shape, into a file, with what each level
// is worth.
// SPDX-License-Identifier: MIT
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/new_file.hpp"
#include "experiments/commands/progress_line.hpp"
#include "experiments/commands/sentences.hpp"
#include "experiments/files/mesh_file.hpp"
#include "experiments/models/mesh_report.hpp"
#include "experiments/models/named_shape.hpp"
#include "experiments/models/readable_file.hpp"
#include "experiments/models/tree_file.hpp"
#include "experiments/settings/input_error.hpp"

namespace impetus::inline commands {
namespace {

/// What `impetus tree build` was asked for.
struct BuildOptions {
  std::string what;
  std::string kind{"octree"};
  int depth{TreeSettings().depth};
  int branching{TreeSettings().branching};
  std::optional<int> resolution;
  std::string out;
  bool force{false};
};

TreeSettings settings_of(const BuildOptions& options) {
  const TreeSettings settings{tree_kind(options.kind), options.depth, options.branching};
  const std::string problem = problem_of(settings);
  if (!problem.empty()) {
    throw InputError(problem);
  }
  return settings;
}

/// A file that is there wins over a shape of its name.
TriangleMesh mesh_of(const BuildOptions& options) {
  if (!is_there(options.what)) {
    return shape_named(options.what, options.resolution);
  }
  if (options.resolution) {
    throw InputError("--resolution: expected none for the mesh file " + options.what + ", got " +
                     std::to_string(*options.resolution));
  }
  return load_mesh(options.what);
}

/// Protrusion as a share of the bounding box's diagonal, volume as a share of the mesh's.
void print_levels(const StoredTree& stored) {
  const double percent = 100.0 / bounds_of(stored.mesh).sides().norm();
  std::printf(
      "level     nodes  worst protrusion     mean  outside/mesh  largest node      memory\n");
  for (std::size_t level = 0; level < stored.quality.size(); ++level) {
    const LevelQuality& quality = stored.quality[level];
    std::printf("%5zu  %8d  %14.3f %%  %5.3f %%  %12.4f  %10.4g m  %7.1f kB\n", level,
                quality.nodes, percent * quality.worst_protrusion_m,
                percent * quality.mean_protrusion_m, quality.outside_ratio, quality.largest_node_m,
                static_cast<double>(quality.bytes) / 1000.0);
    if (quality.uncovered_area_m2 > 0.0) {
      std::printf("       of the surface %.3g m^2 are not covered\n", quality.uncovered_area_m2);
    }
  }
}

int build(const BuildOptions& options) {
  const TreeSettings settings = settings_of(options);
  require_new_file(options.out, options.force);
  const TriangleMesh given = mesh_of(options);
  const std::string problem = refusal(report_mesh(given));
  if (!problem.empty()) {
    std::fprintf(stderr, "impetus: %s: %s\n", options.what.c_str(), problem.c_str());
    return kFound;
  }
  const TriangleMesh mesh = about_centre_of_mass(given);
  const auto start = std::chrono::steady_clock::now();
  VolumeTree tree = [&] {
    ProgressLine line("building");
    return build_tree(mesh, settings, [&](double share) { line.tell(share); });
  }();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  StoredTree stored{std::filesystem::path(options.what).filename(), settings, mesh,
                    std::move(tree)};
  {
    ProgressLine line("measuring");
    stored.quality = measure_levels(mesh, stored.tree, [&](double share) { line.tell(share); });
  }
  save_tree(stored, options.out, options.force);
  std::printf("%s: %s of %zu triangles, depth %d, branching %d, built in %.2f s\n",
              stored.name.c_str(), options.kind.c_str(), mesh.triangles.size(), settings.depth,
              settings.branching, took.count());
  print_levels(stored);
  std::printf("written to %s, %.1f kB\n", options.out.c_str(),
              static_cast<double>(std::filesystem::file_size(options.out)) / 1000.0);
  return kDone;
}

}  // namespace

void add_tree_build(CLI::App& tree, Command& chosen) {
  const auto [command, options] = add_command<BuildOptions>(
      tree, chosen, build, "build", "Build a tree and tell how good each level is");
  command
      ->add_option("what", options->what,
                   "A mesh file (OBJ, PLY, STL, OFF, glTF), or one of " + listed(shape_names()))
      ->required();
  command->add_option("--kind", options->kind, "One of " + listed(tree_kind_names()))
      ->capture_default_str();
  command->add_option("--depth", options->depth, "Levels beyond the root, at most")
      ->capture_default_str();
  command->add_option("--branching", options->branching, "Children of a node, at most")
      ->capture_default_str();
  command->add_option("--resolution", options->resolution,
                      "Fineness of a sphere, torus, knot or creature, 4 to 12");
  command->add_option("-o,--out", options->out, "The tree file to write")->required();
  command->add_flag("--force", options->force, "Overwrite an existing file");
}

}  // namespace impetus::inline commands
