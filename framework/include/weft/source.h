// Purpose: where a thing was written. Every node of a graph file carries a SourceLoc, and the compiler hands
// it on as provenance; it never enters a plan's hash.
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

// A diagnostic quotes no source line that is longer than this: in a minified file one line can be the whole file.
inline constexpr size_t kMaxExcerptBytes = 4096;

inline constexpr uint32_t kNoFile = UINT32_MAX;

struct SourceLoc {
    uint32_t file = kNoFile;  // index into SourceMap::files
    uint32_t line = 0;
    uint32_t column = 0;
    uint32_t length = 1;
};

struct SourceFile {
    std::string path;  // as the user named it
    std::string text;
    SourceLoc included_at = {};  // of the file's name in the one that includes it; kNoFile: in none
    // The number of newlines before each 4 KiB block of the text, so that a line is found without reading all
    // lines before it. Made by SourceMap::add_file(); without it a line is searched from the first byte.
    std::vector<uint32_t> newlines_before = {};
};

// A value that stands for another: of an including file, or of a tier.
struct Replacement {
    SourceLoc by;
    SourceLoc what;
};

struct SourceMap {
    std::vector<SourceFile> files;
    // By file, line and column of `by`.
    std::multimap<std::array<uint32_t, 3>, Replacement> replacements;

    // Returns its index.
    uint32_t add_file(std::string path, std::string text, SourceLoc included_at = {});
    void add_replacement(const Replacement& replacement);
    // A diagnostic with file, line, column and the excerpt filled in from `loc`. Notes say where the file was
    // included, and what the value there replaced.
    [[nodiscard]] Diagnostic error(SourceLoc loc, std::string code, std::string message) const;
    // "deferred.json:40:73", or "<memory>" for things made by a program.
    [[nodiscard]] std::string describe(SourceLoc loc) const;
};

// Reads a file, or nullopt when there is none. All graph files come through one of these.
using FileReader = std::function<std::optional<std::string>(const std::string& path)>;

}  // namespace weft
