// Purpose: reads the JSON of a graph file and of all files that it includes.
#pragma once

#include <string>

#include "weft/limits.h"
#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

struct GraphReading {
    std::string include_root = {};  // second folder in which included files are searched; empty: none
    GraphLimits limits = {};
};
// Errors: those of read_json(); W126 an included file that is missing or lies outside the folder, W127 files
// that include each other.
[[nodiscard]] Result<JsonDoc> read_graph(const std::string& path, const FileReader& reader,
                                         const GraphReading& reading = {});

}  // namespace weft
