// Purpose: reads the JSON of a graph file and of all files that it includes.
#pragma once

#include <string>

#include "weft/limits.h"
#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

struct GraphReading {
    // A second folder in which included files are searched, after the folder of the including file. Empty: no
    // second folder.
    std::string include_root = {};
    GraphLimits limits = {};
};
// Reads a graph file and the files that it includes. Errors: those of read_json(). W004: also for too many
// files or tiers. W102: "include" is not a list of strings. W126: an included file is missing or lies outside
// the folders. W127: files include each other.
[[nodiscard]] Result<JsonDoc> read_graph(const std::string& path, const FileReader& reader,
                                         const GraphReading& reading = {});

}  // namespace weft
