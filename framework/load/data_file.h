// Purpose: finds and reads the files that resources of a graph name. Files are searched like those of
// shaders: in the folder of the graph file that names them, then in the shipped folders graphs/ and shaders/.
// Symbolic links must not lead out of these folders.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "weft/graph_desc.h"
#include "weft/load/load_graph.h"

namespace weft {

struct DataFile {
    std::string path;
    std::string bytes;        // The content, or its first bytes.
    uint64_t size_bytes = 0;  // Size of the whole file.
    // Reason why the file cannot be used, and a remedy; empty: there is none.
    std::string fault, help;
};

// Searches the file and reads at most `most_bytes` of its bytes. Files of a custom LoadSettings::reader are
// read as a whole. Adds all searched paths to `searched`, if it is not null.
[[nodiscard]] DataFile find_data_file(const std::string& folder, const std::string& name, uint64_t most_bytes,
                                      const LoadSettings& settings,
                                      std::set<std::filesystem::path>* searched);

// Reads a file that find_data_file() found, as a whole.
[[nodiscard]] DataFile read_data_file(const std::string& path, const LoadSettings& settings);

// Returns the error W145 for the file `name` of the resource `resource`, which stands at `loc` in the graph.
[[nodiscard]] Diagnostic unusable_file(const SourceMap& sources, SourceLoc loc, const std::string& name,
                                       const std::string& resource, const std::string& fault,
                                       const std::string& help);

}  // namespace weft
