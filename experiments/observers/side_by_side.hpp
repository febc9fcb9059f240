// Work shared among threads: pieces that do not depend on each other, or workers that take their
// work themselves.
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>

namespace impetus::inline observers {

/// How many cores the machine has, at least one.
std::int64_t core_count();

/// Does the pieces 0 … count − 1, `jobs` at a time at most. Once one has thrown none is begun, and
/// what the first threw is thrown when those that were begun are done.
void do_side_by_side(std::size_t count, const std::function<void(std::size_t)>& piece,
                     std::int64_t jobs = core_count());

/// Runs work(0) here and work(1) … work(jobs − 1) on threads beside, until all have returned. Once
/// one has thrown, `stops`, false until then, is true, for the others to look at; what the first
/// threw is thrown.
void run_workers(std::int64_t jobs, std::atomic<bool>& stops,
                 const std::function<void(std::int64_t job)>& work);

}  // namespace impetus::inline observers
