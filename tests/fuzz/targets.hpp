// What a fuzzer feeds: each takes any bytes and returns, or something is wrong.
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace impetus {

/// The first letter chooses the format; the rest is a file of it.
void fuzz_mesh_file(std::string_view bytes);

/// A tree file without its checksum, which is put right first.
void fuzz_tree_file(std::string_view bytes);

/// A protocol, kPartSeparator, and its scene: checked, and planned for a participant.
inline constexpr char kPartSeparator = '\x1e';
void fuzz_protocol(std::string_view bytes);

/// A scene: checked, built, and stepped a few times.
void fuzz_scene(std::string_view bytes);

/// Lines of a session that came back from a page of small_published_study(): read and proved.
inline constexpr const char* kFuzzedSession = "P01_2026";
void fuzz_lines(std::string_view bytes);

/// What a tracker sends: after kPupilMessage a message of Pupil's; else lines of a Gazepoint, in
/// pieces of as many bytes as the first letter says, and one.
inline constexpr unsigned char kPupilMessage = 0;
void fuzz_tracker(std::string_view bytes);

/// A study: read and replayed for a few steps. The first letter chooses one of small studies, into
/// which the rest, statements of SQL that change rows, is put first; or the rest is the file
/// itself.
inline constexpr char kWholeFile = 'f';
void fuzz_study(std::string_view bytes);

}  // namespace impetus
