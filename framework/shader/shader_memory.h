// Purpose: keeps the programs of a graph between its loads, each with the places that its compilation looked
// at, so that only changed shaders are compiled again. It also lists the places that the last load looked at,
// found or not, so that a program can wait for them to change. For one thread at a time.
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
    // Call before a load.
    void begin();
    // Call after a successful load: forgets the programs that it did not use.
    void forget_unused();

    // Null if the program is unknown, or if a place has another text now.
    [[nodiscard]] const ShaderProgram* find(const std::string& reference, ProgramKind kind,
                                            const ShaderRoots& roots);
    void remember(const ShaderProgram& program, ProgramKind kind, const ShaderRoots& roots,
                  const shader::SourceReader& reader);

    void add_files_of(const shader::SourceReader& reader);
    // The places of the load since begin(), absolute.
    [[nodiscard]] const std::set<std::filesystem::path>& files() const { return files_; }
    // How many programs were requested in total, and how many of them find() did not have.
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
