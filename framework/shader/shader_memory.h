// Purpose: keeps data between repeated loads of a graph. It keeps the graph's programs, each with the places
// examined by its compilation, so that only changed programs are compiled. It also keeps all places examined
// by the last load, existing or not and successful or not, so that a caller can watch them for changes. Not
// thread-safe.
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
    // Call this before a load.
    void begin();
    // Call this after a successful load: discards programs that the load did not use.
    void forget_unused();

    // Null if the program is not stored, or if its sources have changed.
    [[nodiscard]] const ShaderProgram* find(const std::string& reference, ProgramKind kind,
                                            const ShaderRoots& roots);
    void remember(const ShaderProgram& program, ProgramKind kind, const ShaderRoots& roots,
                  const shader::SourceReader& reader);

    void add_file(std::filesystem::path file) { files_.insert(std::move(file)); }
    void add_files_of(const shader::SourceReader& reader);
    // Absolute paths examined since begin().
    [[nodiscard]] const std::set<std::filesystem::path>& files() const { return files_; }
    // Total number of calls of find(), and number of calls without a result.
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
