// Purpose: what is kept between loads of a graph that is loaded again and again: its programs, each with the
// places that compiling it looked at, so that only what changed is compiled; and the places that the last
// load looked at, whether it found something there or not and whether it succeeded or not, so that one can
// wait for them to change. For one thread at a time.
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
    // Before a load.
    void begin();
    // After one that succeeded: forgets what it had no use for.
    void forget_unused();

    // Null where nothing is known, or looking again doesn't give the same texts.
    [[nodiscard]] const ShaderProgram* find(const std::string& reference, ProgramKind kind,
                                            const ShaderRoots& roots);
    void remember(const ShaderProgram& program, ProgramKind kind, const ShaderRoots& roots,
                  const shader::SourceReader& reader);

    void add_file(std::filesystem::path file) { files_.insert(std::move(file)); }
    void add_files_of(const shader::SourceReader& reader);
    // Absolute, of the load since begin().
    [[nodiscard]] const std::set<std::filesystem::path>& files() const { return files_; }
    // How many programs were asked for, since ever, and how many of them find() didn't have.
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
