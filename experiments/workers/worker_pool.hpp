// Threads that are kept between steps, for a world that is lent them
// (engine/scheduling/workers.hpp).
//
//   caller   run ─> job(0) ───────────────> all have returned ─> goes on
//   threads  wait ─> job(1), job(2) … ─> wait: awake for a moment, then asleep
//
// Who asks while another does gets no help, and does all of it alone.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/scheduling/workers.hpp"

namespace impetus::inline workers {

/// So many workers: who calls run(), and threads for the others. They inherit how the thread that
/// makes the pool rounds numbers.
class WorkerPool final : public Workers {
 public:
  /// Throws std::invalid_argument unless `count` is 1 or more, and std::system_error when a thread
  /// cannot be started.
  explicit WorkerPool(int count);
  ~WorkerPool() override;
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  [[nodiscard]] int count() const override { return static_cast<int>(threads_.size()) + 1; }
  void run(const std::function<void(int worker)>& job) override;

 private:
  void share(const std::function<void(int worker)>& job);
  void serve(int worker);
  void wait_for_round_after(std::uint32_t round) const;
  void end();

  std::vector<std::thread> threads_;
  std::mutex asked_;                     ///< held by who is helped
  std::atomic<std::uint32_t> round_{0};  ///< rises with each run, and once more at the end
  std::atomic<int> busy_{0};             ///< threads that have not returned from this round's job
  std::atomic<bool> ends_{false};
  const std::function<void(int)>* job_{nullptr};
  std::mutex failure_guard_;
  std::exception_ptr failure_;  ///< of a thread's job in this round, the first
};

}  // namespace impetus::inline workers
