// SPDX-License-Identifier: MIT
#include "experiments/workers/worker_pool.hpp"

#include <stdexcept>
#include <utility>

namespace impetus::inline workers {
namespace {

/// How often a thread looks for the next round before it falls asleep: some twenty microseconds,
/// longer than what a step does between two searches, shorter than between two steps.
constexpr int kLooks = 500;

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

}  // namespace

WorkerPool::WorkerPool(int count) {
  if (count < 1) {
    throw std::invalid_argument("worker pool: expected 1 worker or more");
  }
  try {
    for (int worker = 1; worker < count; ++worker) {
      threads_.emplace_back([this, worker] { serve(worker); });
    }
  } catch (...) {
    end();
    throw;
  }
}

WorkerPool::~WorkerPool() { end(); }

void WorkerPool::end() {
  ends_ = true;
  ++round_;
  round_.notify_all();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

void WorkerPool::run(const std::function<void(int worker)>& job) {
  const std::unique_lock asked(asked_, std::try_to_lock);
  if (asked) {
    share(job);
    return;
  }
  for (int worker = 0; worker < count(); ++worker) {
    job(worker);
  }
}

void WorkerPool::share(const std::function<void(int worker)>& job) {
  job_ = &job;
  busy_ = static_cast<int>(threads_.size());
  ++round_;
  round_.notify_all();
  std::exception_ptr own_failure;
  try {
    job(0);
  } catch (...) {
    own_failure = std::current_exception();
  }
  for (int looks = 0; busy_ > 0; ++looks) {
    if (looks < kLooks) {
      pause();
    } else {
      std::this_thread::yield();
    }
  }
  const std::exception_ptr failure = std::exchange(failure_, nullptr);
  if (own_failure || failure) {
    std::rethrow_exception(own_failure ? own_failure : failure);
  }
}

void WorkerPool::serve(int worker) {
  for (std::uint32_t round = 0;; ++round) {
    wait_for_round_after(round);
    if (ends_) {
      return;
    }
    try {
      (*job_)(worker);
    } catch (...) {
      const std::lock_guard guard(failure_guard_);
      failure_ = failure_ ? failure_ : std::current_exception();
    }
    --busy_;
  }
}

void WorkerPool::wait_for_round_after(std::uint32_t round) const {
  for (int looks = 0; round_ == round; ++looks) {
    if (looks < kLooks) {
      pause();
    } else {
      round_.wait(round);
    }
  }
}

}  // namespace impetus::inline workers
