// Purpose: reads shader files below the given roots only, and records every place that it examined, so that a
// cache can check whether another look gives the same texts. The limits of the roots apply: bytes per file,
// files and bytes per program.
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

// The result of examining one place: the hash of the text there, or that no file exists.
struct SourceProbe {
    size_t root = 0;
    std::string relative;
    bool present = false;
    uint64_t text_hash = 0;
};

// A source, or the reason why there is none.
struct SourceLookup {
    const SourceText* source = nullptr;
    bool refused = false;  // the file exists or may exist, but must not be read
    std::string reason;
};

class SourceReader {
 public:
    explicit SourceReader(const ShaderRoots& roots);

    // Reads from the first root that contains the file.
    [[nodiscard]] SourceLookup read_reference(const std::string& relative);
    // Reads from the include root only.
    [[nodiscard]] SourceLookup read_shared(const std::string& relative);
    // "x.glsl": searched beside the including file, then in the include root. <x.glsl>: in the include root
    // only.
    [[nodiscard]] SourceLookup read_include(const std::string& requested, const std::string& includer,
                                            bool beside);
    // Examines the place again; true when the result is the same.
    [[nodiscard]] bool still_so(const SourceProbe& probe);

    [[nodiscard]] const std::vector<SourceProbe>& probes() const { return probes_; }
    // Absolute paths of all files that were searched, existing or not; for a symbolic link also its target.
    [[nodiscard]] const std::vector<std::filesystem::path>& places() const { return places_; }
    [[nodiscard]] std::vector<const SourceText*> sources() const;
    [[nodiscard]] const SourceText* find(std::string_view name) const;
    // References with this extension below the searched roots, for suggestions in messages.
    [[nodiscard]] std::vector<std::string> known_references(const std::string& extension) const;

 private:
    struct Root {
        std::filesystem::path shown;
        std::filesystem::path canonical;  // empty when the folder does not exist
    };

    SourceLookup look(size_t root, const std::filesystem::path& relative);
    SourceLookup load(size_t root, const std::filesystem::path& relative, const std::filesystem::path& file);

    ShaderLimits limits_;
    std::vector<Root> roots_;                     // the searched roots, then the include root
    std::vector<std::filesystem::path> folders_;  // their real paths: a symbolic link must lead into one of
                                                  // them
    std::map<std::pair<size_t, std::string>, SourceText> texts_;
    std::vector<SourceProbe> probes_;
    std::vector<std::filesystem::path> places_;
    size_t total_bytes_ = 0;
};

}  // namespace weft::shader
