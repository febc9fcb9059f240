// Crowds in our engine and in its peers, in the same run: Bullet, ODE and FCL.
//
//   impetus_peer_bench [--only SCENE] [--steps N] [--quick] [MESH]
//
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/bench_scenes.hpp"
#include "tests/bench/crowd_run.hpp"
#include "tests/bench/pair_poses.hpp"
#include "tests/bench/peers/peer_crowd.hpp"
#include "tests/bench/peers/peer_dantzig.hpp"
#include "tests/bench/peers/peer_pair.hpp"
#include "tests/bench/response_cost.hpp"

namespace impetus {
namespace {

/// A peer is given up when a scene has taken this long; the steps done are told.
constexpr double kLongest_s = 45.0;

struct Peer {
  const char* name;
  std::unique_ptr<PeerCrowd> (*make)(const CrowdShape&, const BenchCrowdStart&, double restitution);
};

constexpr std::array kPeers{Peer{"Bullet, hulls", bullet_of_hulls},
                            Peer{"Bullet, triangles", bullet_of_triangles},
                            Peer{"ODE, triangles", ode_of_triangles}};

double energy_J(const BodyModel& model, const std::vector<BodyState>& states) {
  double energy = 0.0;
  for (const BodyState& state : states) {
    energy += kinetic_energy(model, state);
  }
  return energy;
}

/// 0 when nothing moved at the start.
double energy_ratio(double at_end_J, double at_start_J) {
  return at_start_J > 0.0 ? at_end_J / at_start_J : 0.0;
}

void print_row(const std::string& name, const Spread& ms, double energy_ratio, int escaped,
               int steps) {
  std::printf("  %-28s %9.3f %9.3f %9.3f  %10.4g %5d %6d\n", name.c_str(), ms.median, ms.p99,
              ms.longest, energy_ratio, escaped, steps);
  std::fflush(stdout);
}

void print_peer(const Peer& peer, const CrowdShape& shape, const BenchCrowdStart& start,
                double restitution, int steps) {
  const auto crowd = peer.make(shape, start, restitution);
  std::vector<double> steps_ms;
  double took_ms = 0.0;
  while (static_cast<int>(steps_ms.size()) < steps && took_ms < 1e3 * kLongest_s) {
    const std::int64_t start_ns = thread_cpu_ns();
    crowd->step();
    steps_ms.push_back(static_cast<double>(thread_cpu_ns() - start_ns) * 1e-6);
    took_ms += steps_ms.back();
  }
  const BodyModel model = model_of(shape, shape.coarse);
  const std::vector<BodyState> states = crowd->states();
  const auto done = static_cast<int>(steps_ms.size());
  print_row(peer.name, spread_of(std::move(steps_ms)),
            energy_ratio(energy_J(model, states), energy_J(model, start.states)),
            escaped_from(start.half_edge_m, states), done);
}

void print_ours(const CrowdShape& shape, const BenchCrowdStart& start, const CrowdPlan& plan) {
  const CrowdOutcome outcome = run_crowd(shape, start, plan);
  std::string name = plan.fine ? "ours, ~500 leaves" : "ours, ~64 leaves";
  if (plan.budget_ms > 0.0) {
    name += ", " + std::to_string(static_cast<int>(plan.budget_ms)) + " ms";
  }
  print_row(name, outcome.step_ms, outcome.energy_ratio, outcome.escaped, plan.steps);
}

void print_crowd(const std::string& title, const CrowdShape& shape, const BenchCrowdStart& start,
                 CrowdPlan plan, const std::vector<double>& budgets_ms) {
  std::printf("\n%s (ms)\n  %-28s %9s %9s %9s  %10s %5s %6s\n", title.c_str(), "", "median", "p99",
              "longest", "energy", "outs", "steps");
  for (const double budget_ms : budgets_ms) {
    for (const bool fine : {false, true}) {
      plan.budget_ms = budget_ms;
      plan.fine = fine;
      print_ours(shape, start, plan);
    }
  }
  for (const Peer& peer : kPeers) {
    print_peer(peer, shape, start, plan.restitution, plan.steps);
  }
}

void print_cube(const CrowdShape& shape, const BenchOptions& options) {
  CrowdPlan plan;
  plan.steps = options.steps_of(600);
  const BenchCrowdStart start = flying(shape, 250, 0.3);
  plan.restitution = 0.5;
  print_crowd("250 bodies, closed cube, 30 % full, restitution .5", shape, start, plan, {0.0});
}

void print_elastic(const CrowdShape& shape, const BenchOptions& options) {
  CrowdPlan plan;
  plan.steps = options.steps_of(600);
  print_crowd("250 bodies, closed cube, 30 % full, restitution 1", shape, flying(shape, 250, 0.3),
              plan, {0.0});
  print_crowd("100 bodies, closed cube, 150 % full, restitution 1", shape, flying(shape, 100, 1.5),
              plan, {0.0});
}

void print_implosion(const CrowdShape& shape, const BenchOptions& options) {
  CrowdPlan plan;
  plan.steps = options.steps_of(360);
  plan.restitution = 0.5;
  print_crowd("implosion of 250 bodies, restitution .5", shape, imploding(shape, 250), plan,
              {0.0, 4.0, 1.0});
}

void print_thousand(const CrowdShape& shape, const BenchOptions& options) {
  CrowdPlan plan;
  plan.steps = options.steps_of(120);
  plan.restitution = 0.5;
  plan.most_response_passes = 20;  // as ODE's
  plan.schedule.lists = {{.share = 1.0, .least_level = 1}};
  print_crowd("1,000 bodies, closed cube, 100 % full, restitution .5", shape,
              flying(shape, 1000, 1.0), plan, {0.0, 4.0});
}

void print_pit(const CrowdShape& shape, const BenchOptions& options) {
  CrowdPlan plan;
  plan.steps = options.steps_of(600);
  plan.restitution = 0.5;
  print_crowd("250 bodies piled in a pit under gravity, restitution .5", shape, falling(shape, 250),
              plan, {0.0});
}

/// Microseconds where the surfaces cross, and how often the peer is right.
void print_pair_of(const char* name, PeerPair& pair, const std::vector<PairPose>& poses,
                   double looking_ns) {
  std::vector<double> hits_us;
  int false_hits = 0;
  int missed = 0;
  for (const PairPose& pose : poses) {
    const std::int64_t start_ns = thread_cpu_ns();
    const bool hit = pair.contacts_at(pose.b) > 0;
    const double us = (static_cast<double>(thread_cpu_ns() - start_ns) - looking_ns) * 1e-3;
    false_hits += hit && !pose.surfaces_cross ? 1 : 0;
    missed += !hit && pose.surfaces_cross ? 1 : 0;
    if (hit) {
      hits_us.push_back(us);
    }
  }
  const Spread us = spread_of(std::move(hits_us));
  std::printf("  %-28s %9.2f %9.2f %9.2f   false %d, missed %d\n", name, us.median, us.p99,
              us.longest, false_hits, missed);
  std::fflush(stdout);
}

/// Our descent, as a peer.
class OurPair final : public PeerPair {
 public:
  explicit OurPair(const VolumeTree& tree) : a_(tree), b_(tree) {}
  int contacts_at(const Pose& b) override {
    a_.move_to({});
    b_.move_to(b);
    refinement_.begin(a_, b_);
    while (!refinement_.resolved()) {
      refinement_.refine_one_block();
    }
    return static_cast<int>(refinement_.overlapping().size());
  }

 private:
  PlacedTree a_;
  PlacedTree b_;
  PairRefinement refinement_;
};

void print_pair(const CrowdShape& shape, const BenchOptions& options) {
  const auto poses = random_pair_poses(shape.mesh, options.count_of(2'000));
  const auto crossing = std::count_if(poses.begin(), poses.end(),
                                      [](const PairPose& pose) { return pose.surfaces_cross; });
  std::printf("\ntwo bodies at %zu random poses, us where they hit; surfaces cross at %zu\n",
              poses.size(), static_cast<std::size_t>(crossing));
  std::printf("  %-28s %9s %9s %9s\n", "", "median", "p99", "longest");
  const double looking_ns = clock_cost_ns();
  OurPair fine(*shape.fine);
  print_pair_of("ours, ~500 leaves", fine, poses, looking_ns);
  OurPair coarse(*shape.coarse);
  print_pair_of("ours, ~64 leaves", coarse, poses, looking_ns);
  print_pair_of("Bullet, hulls", *bullet_hull_pair(shape.mesh), poses, looking_ns);
  print_pair_of("Bullet, triangles", *bullet_triangle_pair(shape.mesh), poses, looking_ns);
  print_pair_of("ODE, triangles", *ode_triangle_pair(shape.mesh), poses, looking_ns);
  print_pair_of("FCL, triangles", *fcl_triangle_pair(shape.mesh), poses, looking_ns);
}

void print_response(const CrowdShape& shape, const BenchOptions& options) {
  std::printf("\nresponse to 64 contacts of one pair, restitution .5 (us)\n");
  for (const auto& [name, method] : {std::pair{"ours, in turn", ResponseMethod::kInTurn},
                                     std::pair{"ours, together", ResponseMethod::kTogether}}) {
    const ResponseCost cost = response_cost(shape, method, options.count_of(10'000));
    std::printf("  %-28s mean %.2f, p99 %.2f\n", name, cost.us.mean, cost.us.p99);
  }
  RandomStream random(kProblemSeed, kProblemStream);
  const double looking_ns = clock_cost_ns();
  std::vector<double> samples_us;
  int failed = 0;
  for (int i = 0; i < options.count_of(10'000); ++i) {
    const DantzigCost cost = dantzig_cost(random_contact_problem(shape, random), 0.5, looking_ns);
    samples_us.push_back(cost.solve_us);
    failed += cost.solved ? 0 : 1;
  }
  const Spread us = spread_of(std::move(samples_us));
  std::printf("  %-28s mean %.2f, p99 %.2f; failed %d (its matrix given)\n", "Bullet's Dantzig",
              us.mean, us.p99, failed);
}

constexpr std::array kScenes{
    BenchScene{"pair", print_pair},         BenchScene{"cube", print_cube},
    BenchScene{"elastic", print_elastic},   BenchScene{"implosion", print_implosion},
    BenchScene{"thousand", print_thousand}, BenchScene{"pit", print_pit},
    BenchScene{"response", print_response},
};

}  // namespace
}  // namespace impetus

int main(int count, char** arguments) {
  return impetus::run_scenes(count, arguments, impetus::kScenes);
}
