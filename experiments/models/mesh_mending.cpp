// SPDX-License-Identifier: MIT
#include "experiments/models/mesh_mending.hpp"

#include <stdexcept>

#include "experiments/models/mesh_file.hpp"
#include "experiments/models/mesh_report.hpp"
#include "experiments/models/mesh_writer.hpp"

namespace impetus::inline models {
namespace {

void refuse_before_work(const std::filesystem::path& out) {
  if (!can_write_mesh(out)) {
    throw std::runtime_error(out.string() + ": expected a name that ends in .obj, .ply or .stl");
  }
  if (std::filesystem::exists(out)) {
    throw std::runtime_error(out.string() + ": exists already and is not overwritten");
  }
}

std::string obstacle_in_words(const MeshRepair& repair) {
  switch (repair.obstacle) {
    case RepairObstacle::kNone:
      return "";
    case RepairObstacle::kNothingLeft:
      return "no triangle has an area";
    case RepairObstacle::kCrowdedEdges:
      return counted(repair.obstacles, "edge has", "edges have") +
             " more than two triangles, and which of them belong together is not known";
    case RepairObstacle::kOneSided:
      return "the surface has one side only, like a Moebius strip";
    case RepairObstacle::kLargeHoles:
      return counted(repair.obstacles, "hole has", "holes have") + " more than " +
             std::to_string(kLargestHole) + " edges";
    case RepairObstacle::kStuckHoles:
      return counted(repair.obstacles, "hole", "holes") + " cannot be closed without a new defect";
  }
  return "";
}

}  // namespace

std::string describe_changes(const MeshRepair& repair) {
  std::string text;
  const auto add = [&text](std::int64_t count, const std::string& one, const std::string& many) {
    if (count > 0) {
      text += "changed       " + counted(count, one, many) + "\n";
    }
  };
  add(repair.vertices_welded, "vertex welded to another", "vertices welded to others");
  add(repair.degenerate_dropped, "triangle without area dropped", "triangles without area dropped");
  add(repair.duplicate_dropped, "duplicate triangle dropped", "duplicate triangles dropped");
  add(repair.triangles_turned, "triangle turned to agree with its neighbours",
      "triangles turned to agree with their neighbours");
  const std::string with = " of " + counted(repair.filling.edges, "edge", "edges") +
                           " filled with " +
                           counted(repair.filling.triangles, "triangle", "triangles");
  add(repair.filling.holes, "hole" + with, "holes" + with);
  add(repair.components_turned, "component turned outside out", "components turned outside out");
  return text.empty() ? "changed       nothing\n" : text;
}

Mending mend(const std::filesystem::path& file, const std::filesystem::path& out) {
  refuse_before_work(out);
  Mending mending;
  mending.repair = repair(load_mesh(file));
  if (mending.repair.obstacle != RepairObstacle::kNone) {
    mending.refusal = "cannot be repaired: " + obstacle_in_words(mending.repair);
    return mending;
  }
  mending.refusal = refusal(report_mesh(mending.repair.mesh));
  if (!mending.refusal.empty()) {
    return mending;
  }
  write_mesh(mending.repair.mesh, out);
  mending.refusal = refusal(report_mesh(load_mesh(out)));
  if (!mending.refusal.empty()) {
    std::filesystem::remove(out);
  }
  return mending;
}

}  // namespace impetus::inline models
