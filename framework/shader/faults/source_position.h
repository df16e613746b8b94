// Purpose: positions in shader sources, for diagnostics. SPIR-V contains names but no lines, so the position
// of a declaration is found by searching the source text for the name. Lines and columns count from 1; 0
// means unknown.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weft/result.h"

namespace weft::shader {

struct SourceText {
    // Name under which glslang knows the file: its path below the root folder. If the same shader also
    // includes a file with this path from another root folder, the later one of the two gets "@" and the
    // index of its root folder, such as "noise.glsl@1".
    std::string name;
    std::string path;  // Path of the file in messages to the user.
    std::string text;
    size_t root = 0;       // Index of the root folder that contains the file.
    std::string relative;  // Path of the file below this root folder.
    // Name of the first file that includes this file; empty for the main file of a stage.
    std::string included_by;
    std::string include_text;  // The file name in that #include, without quotes.
};

struct SourcePosition {
    const SourceText* source = nullptr;
    uint32_t line = 0;
    uint32_t column = 0;
};

// Finds the position where a name is declared, by searching the text. The function takes the first occurrence
// of the name that is a whole word outside comments and is followed by ";", "[", "=" or "{". It searches
// `first`, then the other files. If it finds nothing, it returns `first` with line 0.
[[nodiscard]] SourcePosition find_declaration(const std::string& name, const SourceText* first,
                                              const std::vector<const SourceText*>& others);

// Position and length of a word that find_words() found.
struct FoundWord {
    SourcePosition position;
    uint32_t length = 0;
};
// Searches `first`, then the other files, for any of the `words` outside comments. `words` are separated by
// spaces; a word that ends in "*" is a prefix. If nothing is found, the result is `first` with line 0.
[[nodiscard]] FoundWord find_words(const std::string& words, const SourceText* first,
                                   const std::vector<const SourceText*>& others);

// Returns the text with all comments replaced by spaces, so that the offsets in the text do not change.
[[nodiscard]] std::string without_comments(std::string text);

// Returns one line of a text, without its newline. Lines count from 1.
[[nodiscard]] std::string line_of(const std::string& text, uint32_t line);

// Returns a diagnostic with file, line, column and the text of the line. If the position has no source, these
// fields are empty.
[[nodiscard]] Diagnostic diagnostic_at(const SourcePosition& position, std::string code, std::string message);

}  // namespace weft::shader
