// Purpose: reads shader files, only from under the given roots, and remembers every place it looked at, so
// that a cache can tell whether looking again would give the same texts. What it reads has the limits of the
// roots: bytes of a file, files and bytes of a program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shader/faults/source_position.h"
#include "weft/shader/compile_shader.h"

namespace weft::shader {

// One look at one place: what was there, or that nothing was.
struct SourceProbe {
    size_t root = 0;
    std::string relative;
    bool present = false;
    uint64_t text_hash = 0;
};

// A source, or why there is none.
struct SourceLookup {
    const SourceText* source = nullptr;
    bool refused = false;  // it was there, or might have been, but must not be read
    std::string reason;
};

class SourceReader {
 public:
    explicit SourceReader(const ShaderRoots& roots);

    // The first root that has it.
    [[nodiscard]] SourceLookup read_reference(const std::string& relative);
    // Only the include root.
    [[nodiscard]] SourceLookup read_shared(const std::string& relative);
    // "x.glsl": beside the file that includes it, then the include root. <x.glsl>: the include root.
    [[nodiscard]] SourceLookup read_include(const std::string& requested, const std::string& includer,
                                            bool beside);
    // Looks again; true when it would find the same.
    [[nodiscard]] bool still_so(const SourceProbe& probe);

    [[nodiscard]] const std::vector<SourceProbe>& probes() const { return probes_; }
    // Every file it looked for, absolute, there or not; of a link also what it leads to.
    [[nodiscard]] const std::vector<std::filesystem::path>& places() const { return places_; }
    [[nodiscard]] std::vector<const SourceText*> sources() const;
    [[nodiscard]] const SourceText* find(std::string_view name) const;
    // References with this extension below the searched roots, for suggestions.
    [[nodiscard]] std::vector<std::string> known_references(const std::string& extension) const;

 private:
    struct Root {
        std::filesystem::path shown;
        std::filesystem::path canonical;  // empty when the folder does not exist
    };

    SourceLookup look(size_t root, const std::filesystem::path& relative);
    SourceLookup load(size_t root, const std::filesystem::path& relative, const std::filesystem::path& file);

    ShaderLimits limits_;
    std::vector<Root> roots_;                     // the searched ones, then the include root
    std::vector<std::filesystem::path> folders_;  // their real paths: links must not lead out of all of them
    std::map<std::pair<size_t, std::string>, SourceText> texts_;
    std::vector<SourceProbe> probes_;
    std::vector<std::filesystem::path> places_;
    size_t total_bytes_ = 0;
};

}  // namespace weft::shader
