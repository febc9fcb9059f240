// The files that come with the program: protocols, scenes, observers. A name is looked up where the
// command is run first, then where the program's data lies, so that nothing depends on the folder.
//
//   installed     PREFIX/bin/impetus     PREFIX/share/impetus/protocols/causality.json
//   in a clone    build/impetus          protocols/causality.json
//
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace impetus::inline commands {

/// `given`, unless there is no such file and the program has one of that name in its data folder:
/// then that one.
std::string shipped_file(const std::string& given);

/// The same, with the program's own place given (for tests).
std::string shipped_file(const std::string& given, const std::filesystem::path& program);

}  // namespace impetus::inline commands
