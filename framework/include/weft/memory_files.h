// Purpose: keeps texts of files in memory, for example graphs that a GraphBuilder made. A reader made by
// reader() returns these texts for their paths. For all other paths, it calls another reader. Shaders cannot
// be in memory: the shader compiler reads them from disk.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "weft/file_reader.h"

namespace weft {

// The object must live longer than all its readers, and longer than all sessions that have such a reader. All
// threads may call its functions and its readers at the same time.
class MemoryFiles {
 public:
    MemoryFiles() = default;
    MemoryFiles(const MemoryFiles&) = delete;
    MemoryFiles& operator=(const MemoryFiles&) = delete;

    // Adds a file, or replaces its text. Its shaders and included files are searched in the folder of `path`.
    void put(const std::string& path, std::string text);
    // Returns a reader for LoadSettings::reader. It calls `others` for all paths that are not in memory.
    // LoadSettings::reads_disk must be false, so that a session reads changed texts again.
    [[nodiscard]] FileReader reader(FileReader others) const;

 private:
    mutable std::mutex mutex_;
    std::map<std::string, std::string> texts_;  // Key: normalised path.
};

}  // namespace weft
