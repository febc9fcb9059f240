// What threads that share a step save: the same steps by one worker and by as many as there are
// cores.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>
#include <vector>

#include "experiments/workers/worker_pool.hpp"
#include "tests/bench/crowd_run.hpp"
#include "tests/bench/crowd_scenes.hpp"
#include "tests/bench/thread_time.hpp"

namespace impetus {
namespace {

struct SharedCrowd {
  int bodies;
  double fill;
  Tunnelling tunnelling;
};

constexpr std::array kCrowds{SharedCrowd{250, 0.3, Tunnelling::kStopAtEntry},
                             SharedCrowd{2'000, 0.3, Tunnelling::kStopAtEntry},
                             SharedCrowd{2'000, 1.0, Tunnelling::kStopAtEntry},
                             SharedCrowd{2'000, 0.3, Tunnelling::kIgnored}};

double now_ms() {
  return std::chrono::duration<double, std::milli>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// Takes one step, and notes how long it took; returns its hash.
std::uint64_t timed_step(World& world, const StepInput& input, std::vector<double>& took_ms) {
  FixedWork meter(kUnlimitedTests);
  const double began_ms = now_ms();
  const std::uint64_t hash = world.step(input, meter).state.hash;
  took_ms.push_back(now_ms() - began_ms);
  return hash;
}

}  // namespace

void print_shared(const CrowdShape& shape, const BenchOptions& options) {
  const int workers = static_cast<int>(std::max(2U, std::thread::hardware_concurrency()));
  std::printf(
      "\nsteps shared by %d threads, ~500 leaves, restitution 1; wall time   goal: 1.6 times by "
      "two\n",
      workers);
  std::printf("  %8s %6s %-14s %12s %12s %8s %10s\n", "bodies", "fill", "fast pairs", "alone ms",
              "shared ms", "times", "the same");
  const auto pool = std::make_shared<WorkerPool>(workers);
  for (const SharedCrowd& crowd : kCrowds) {
    CrowdPlan plan;
    plan.tunnelling = crowd.tunnelling;
    const BenchCrowdStart start = flying(shape, crowd.bodies, crowd.fill);
    World alone = crowd_world(shape, start, plan);
    World shared = alone;
    shared.share_work_with(pool);
    std::vector<double> alone_ms;
    std::vector<double> shared_ms;
    bool same = true;
    for (int step = options.steps_of(120); step > 0; --step) {
      const std::uint64_t hash = timed_step(alone, crowd_input(start), alone_ms);
      same = same && timed_step(shared, crowd_input(start), shared_ms) == hash;
    }
    const double of_alone = spread_of(alone_ms).median;
    const double of_shared = spread_of(shared_ms).median;
    std::printf("  %8d %6.1f %-14s %12.2f %12.2f %8.2f %10s\n", crowd.bodies, crowd.fill,
                crowd.tunnelling == Tunnelling::kIgnored ? "ignored" : "stopped", of_alone,
                of_shared, of_alone / of_shared, same ? "yes" : "NO");
    std::fflush(stdout);
  }
}

}  // namespace impetus
