// Purpose: reads shader files, but only from the given root folders. Records every path that was searched, so
// that a cache can check later whether the same search finds the same texts. The limits of ShaderRoots apply:
// bytes per file, files and bytes per program.
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

// The result of a search for a file below one root folder: the hash of the file's text, or that the file does
// not exist.
struct SourceProbe {
    size_t root = 0;       // Index of the root folder.
    std::string relative;  // Path below the root folder.
    bool present = false;
    uint64_t text_hash = 0;
};

// The text that was found, or the reason why no text was found.
struct SourceLookup {
    const SourceText* source = nullptr;
    bool refused = false;  // True if the file may exist, but is not read. Example: the path contains "..".
    std::string reason;
};

class SourceReader {
 public:
    explicit SourceReader(const ShaderRoots& roots);

    // Reads the file of a shader reference, such as "bloom/up.comp", from the first root folder that contains
    // the file.
    [[nodiscard]] SourceLookup read_reference(const std::string& relative);
    // Reads a file from the include root (the folder shaders/include) only, without searching the other root
    // folders.
    [[nodiscard]] SourceLookup read_shared(const std::string& relative);
    // Reads an included file. #include "x.glsl" (`beside` is true) searches the folder of the including file,
    // then the root folder of this file, then the include root (the folder shaders/include). #include
    // <x.glsl> searches only the include root.
    [[nodiscard]] SourceLookup read_include(const std::string& requested, const std::string& includer,
                                            bool beside);
    // Repeats the earlier search whose result is `probe`. Returns true if the result is still the same.
    [[nodiscard]] bool still_so(const SourceProbe& probe);

    [[nodiscard]] const std::vector<SourceProbe>& probes() const { return probes_; }
    // Returns the absolute paths at which the reader searched for files, even if no file exists there. For a
    // symbolic link, the list also contains the target of the link.
    [[nodiscard]] const std::vector<std::filesystem::path>& places() const { return places_; }
    [[nodiscard]] std::vector<const SourceText*> sources() const;
    [[nodiscard]] const SourceText* find(std::string_view name) const;
    // Returns references to shaders with this file extension below the root folders, for "did you mean ...?".
    // The search stops at 3 levels of subfolders and at 2000 entries per root folder.
    [[nodiscard]] std::vector<std::string> known_references(const std::string& extension) const;

 private:
    struct Root {
        std::filesystem::path shown;
        std::filesystem::path canonical;  // Path without symbolic links; empty if the folder does not exist.
    };

    SourceLookup look(size_t root, const std::filesystem::path& relative);
    // Returns the folder for messages, in the form in which the user gave its root folder.
    [[nodiscard]] std::string shown_folder(size_t root, const std::filesystem::path& relative) const;
    SourceLookup load(size_t root, const std::filesystem::path& relative, const std::filesystem::path& file);

    ShaderLimits limits_;
    // The searched root folders; the last one is the include root, shaders/include.
    std::vector<Root> roots_;
    // Real paths of the root folders and of ShaderRoots::allowed. The target of a symbolic link must be below
    // one of them.
    std::vector<std::filesystem::path> folders_;
    std::map<std::pair<size_t, std::string>, SourceText> texts_;
    std::vector<SourceProbe> probes_;
    std::vector<std::filesystem::path> places_;
    size_t total_bytes_ = 0;
};

}  // namespace weft::shader
