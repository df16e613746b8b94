// Purpose: reads the JSON of a graph file and of all files that it includes.
#pragma once

#include <string>
#include <vector>

#include "weft/limits.h"
#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

struct GraphReading {
    // The last folder in which included files are searched. Empty: there is no such folder.
    std::string include_root = {};
    GraphLimits limits = {};
    // Folders in which included files are searched after the folder of the including file and before
    // `include_root`: the folders of --graph-path.
    std::vector<std::string> graph_path = {};
};
// Reads a graph file and the files that it includes. Errors: those of read_json() and read_include_item().
// W004: also for too many files or tiers. W102: "include" is not a list. W126: an included file is missing or
// lies outside the folders. W127: files include each other. W238: "with" names something that is not a port.
// W239: two different modules have the same name.
[[nodiscard]] Result<JsonDoc> read_graph(const std::string& path, const FileReader& reader,
                                         const GraphReading& reading = {});

}  // namespace weft
