// Purpose: keeps texts of files in memory, for example graphs that a GraphBuilder made. A reader made by
// reader() finds these texts at their paths, and all other files elsewhere. Shaders cannot be in memory: the
// shader compiler reads them from disk.
#pragma once

#include <memory>
#include <string>

#include "weft/file_reader.h"

namespace weft {

// All copies of an object and all its readers share the same files. Every thread may use them at any time.
class MemoryFiles {
 public:
    MemoryFiles();
    // Adds a file, or replaces its text. Its shaders and included files are searched in the folder of `path`.
    void put(const std::string& path, std::string text);
    // Returns a reader for LoadSettings::reader. It calls `others` for all paths that are not in memory.
    // LoadSettings::reads_disk must be false, so that a session reads changed texts again.
    [[nodiscard]] FileReader reader(FileReader others) const;

 private:
    struct Texts;
    std::shared_ptr<Texts> texts_;
};

}  // namespace weft
