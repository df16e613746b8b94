// Purpose: keeps the compiled programs of a graph in memory, so that a reload compiles only changed shaders.
// Each program is stored with the files that its compilation searched for. The class also lists all paths at
// which the last load searched for files, even if no file exists there. An application can watch these paths
// for changes. One thread at a time may use an object.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "shader/compile/shader_sources.h"
#include "weft/shader/compile_shader.h"

namespace weft {

class ShaderMemory {
 public:
    // Starts a load: clears the list of searched paths, and marks all programs as unused. The caller must
    // call this before each load.
    void begin();
    // Removes all programs that the last load did not use. The caller calls this after a successful load.
    void forget_unused();

    // Returns the stored program. Returns null if the program is not stored, or if one of its source files
    // has changed.
    [[nodiscard]] const ShaderProgram* find(const std::string& reference, ProgramKind kind,
                                            const ShaderRoots& roots);
    void remember(const ShaderProgram& program, ProgramKind kind, const ShaderRoots& roots,
                  const shader::SourceReader& reader);

    void add_files_of(const shader::SourceReader& reader);
    // Returns the absolute paths that were searched since the last call of begin().
    [[nodiscard]] const std::set<std::filesystem::path>& files() const { return files_; }
    // Returns the number of calls of find(). misses() returns the number of calls that returned null.
    [[nodiscard]] uint64_t requests() const { return requests_; }
    [[nodiscard]] uint64_t misses() const { return misses_; }

 private:
    struct Entry {
        std::vector<shader::SourceProbe> probes;
        ShaderProgram program;
        bool used = true;
    };
    std::map<std::string, Entry> entries_;
    std::set<std::filesystem::path> files_;
    uint64_t requests_ = 0;
    uint64_t misses_ = 0;
};

}  // namespace weft
