// Who is at a chunk, told to whoever asks how far a sweep is. A mark locks nothing: two machines at
// the same chunk come to the same file, and a mark that has fallen silent is told of, not trusted.
//
//   OUT/chunks/chunk-0007.running.json, told anew every few seconds, gone when the chunk is done
//                        .failed.json   what the last attempt ended with, until another begins
//
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace impetus::inline power {

/// The mark of this process at a chunk, kept fresh by a thread for as long as it lives. Marks that
/// cannot be written are missing, and nothing else.
class ChunkMark {
 public:
  ChunkMark(const std::filesystem::path& out, std::int64_t number);
  ~ChunkMark();  ///< takes the mark away
  ChunkMark(const ChunkMark&) = delete;
  ChunkMark& operator=(const ChunkMark&) = delete;

  /// `share` of the chunk is done, from 0 to 1; shown when the mark is next told.
  void tell(double share);

  /// Leaves the sentence with which the attempt ended.
  void fail(const std::string& sentence) const;

 private:
  void keep_fresh();
  void write() const;

  std::filesystem::path out_;
  std::int64_t number_;
  std::string machine_;
  double began_s_;
  double share_{0.0};
  bool ends_{false};
  std::mutex mutex_;  ///< of share_ and ends_
  std::condition_variable told_;
  std::thread thread_;
};

/// How far a chunk is.
enum class ChunkState {
  kWaiting,  ///< nobody has begun it
  kRunning,  ///< its mark was told of late
  kSilent,   ///< its mark has not been told for minutes, or its process has ended here: it was
             ///< probably killed
  kFailed,   ///< its last attempt ended with a sentence
  kDone,     ///< its file is there
};

/// A chunk's state and all that is known of it.
struct ChunkReport {
  std::int64_t number{1};
  ChunkState state{ChunkState::kWaiting};
  std::string machine;   ///< that is or was at it
  std::string sentence;  ///< of a failure
  double share{0.0};     ///< done, where it runs
  double since_s{0.0};   ///< how long ago it began, fell silent or failed
};

ChunkReport report_of_chunk(const std::filesystem::path& out, std::int64_t number);

/// How many chunks are how far, and how long the rest takes.
struct SweepSums {
  std::int64_t done{0};
  std::int64_t running{0};
  std::int64_t silent{0};
  std::int64_t failed{0};
  std::int64_t waiting{0};
  double left_s{0.0};  ///< with as many at a time as now, at least one; 0: not known yet, or done
};

/// `chunk_s`: what a chunk takes; 0: not known yet.
SweepSums sums_of(const std::vector<ChunkReport>& reports, double chunk_s);

}  // namespace impetus::inline power
