// Purpose: places in files. Every value that is read from a graph file has a SourceLoc (file, line, column).
// The compiler copies it into the plan for messages; a plan's hash never includes it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "weft/result.h"

namespace weft {

// The longest source line that a diagnostic quotes. A longer line is not quoted, because in a minified file
// one line can be the whole file.
inline constexpr size_t kMaxExcerptBytes = 4096;

inline constexpr uint32_t kNoFile = UINT32_MAX;

struct SourceLoc {
    uint32_t file = kNoFile;  // The file: an index into SourceMap::files.
    uint32_t line = 0;
    uint32_t column = 0;
    uint32_t length = 1;
};

struct SourceFile {
    std::string path;  // Path of the file, as the user wrote it.
    std::string text;
    // Place of the "include" that names this file; SourceLoc::file is kNoFile if no other file includes it.
    SourceLoc included_at = {};
    // newlines_before[i] is the number of newlines before byte 4096 × i of the text. With this table, a line
    // is found without reading the whole text. SourceMap::add_file() fills it; if it is empty, the search
    // begins at the first byte.
    std::vector<uint32_t> newlines_before = {};
};

// Records that the value at `by` replaced the value at `what`. A tier, or a file that includes another file,
// replaces values.
struct Replacement {
    SourceLoc by;
    SourceLoc what;
};

struct SourceMap {
    std::vector<SourceFile> files;
    // The key is file, line and column of Replacement::by.
    std::multimap<std::array<uint32_t, 3>, Replacement> replacements;

    // Adds a file and returns its index in `files`.
    uint32_t add_file(std::string path, std::string text, SourceLoc included_at = {});
    void add_replacement(const Replacement& replacement);
    // Makes a diagnostic with the file, line, column and excerpt of `loc`. Notes are added if the file is
    // included by another file, or if the value at `loc` replaced another value.
    [[nodiscard]] Diagnostic error(SourceLoc loc, std::string code, std::string message) const;
    // Returns the place as text, such as "deferred.json:40:73"; "<memory>" if a program made the value.
    [[nodiscard]] std::string describe(SourceLoc loc) const;
};

}  // namespace weft
