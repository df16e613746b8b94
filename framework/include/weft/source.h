// Purpose: places in files. Every node of a graph file has a SourceLoc, and the compiler copies it for
// messages; it is never part of a plan's hash.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "weft/result.h"

namespace weft {

// A diagnostic quotes no source line that is longer than this: in a minified file one line can be the whole
// file.
inline constexpr size_t kMaxExcerptBytes = 4096;

inline constexpr uint32_t kNoFile = UINT32_MAX;

struct SourceLoc {
    uint32_t file = kNoFile;  // index into SourceMap::files
    uint32_t line = 0;
    uint32_t column = 0;
    uint32_t length = 1;
};

struct SourceFile {
    std::string path;  // as written by the user
    std::string text;
    SourceLoc included_at = {};  // place of the include that names this file; kNoFile: not included
    // Number of newlines before each 4 KiB block of the text, so that finding a line need not read the whole
    // text. Filled by SourceMap::add_file(); if empty, lines are searched from the first byte.
    std::vector<uint32_t> newlines_before = {};
};

// A value that replaced another one: from an including file, or from a tier.
struct Replacement {
    SourceLoc by;
    SourceLoc what;
};

struct SourceMap {
    std::vector<SourceFile> files;
    // Key: file, line and column of `by`.
    std::multimap<std::array<uint32_t, 3>, Replacement> replacements;

    // Returns the file's index.
    uint32_t add_file(std::string path, std::string text, SourceLoc included_at = {});
    void add_replacement(const Replacement& replacement);
    // A diagnostic with file, line, column and excerpt for `loc`. Its notes tell where the file was included,
    // and which value was replaced.
    [[nodiscard]] Diagnostic error(SourceLoc loc, std::string code, std::string message) const;
    // "deferred.json:40:73"; "<memory>" for things made by a program.
    [[nodiscard]] std::string describe(SourceLoc loc) const;
};

// Reads a file; nullopt if it does not exist. All graph files are read with one of these.
using FileReader = std::function<std::optional<std::string>(const std::string& path)>;

}  // namespace weft
