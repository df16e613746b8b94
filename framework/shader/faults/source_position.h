// Purpose: places in shader sources, for diagnostics. SPIR-V keeps names but no places, so a declaration is
// found by searching the text for its name. Units: lines and columns count from 1; 0 means unknown.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weft/result.h"

namespace weft::shader {

struct SourceText {
    std::string name;  // name used by the compiler: the path below its root, unique in a program
    std::string path;  // path shown to users
    std::string text;
    size_t root = 0;           // index into the reader's roots
    std::string relative;      // path below that root
    std::string included_by;   // name of the first file that included this one; empty for a stage's own file
    std::string include_text;  // the text between the quotes of that include
};

struct SourcePosition {
    const SourceText* source = nullptr;
    uint32_t line = 0;
    uint32_t column = 0;
};

// The place where a name is declared, found by a text search: the first whole word outside comments that is
// followed by a character that can end a declarator. Searches `first`, then the others. If not found:
// `first`, with an unknown line.
[[nodiscard]] SourcePosition find_declaration(const std::string& name, const SourceText* first,
                                              const std::vector<const SourceText*>& others);

// The earliest place of any of the words outside comments. Searches `first`, then the others. `words` are
// separated by spaces; a word that ends in "*" is a prefix.
struct FoundWord {
    SourcePosition position;
    uint32_t length = 0;
};
[[nodiscard]] FoundWord find_words(const std::string& words, const SourceText* first,
                                   const std::vector<const SourceText*>& others);

// The same text with comments replaced by spaces, so that offsets stay the same.
[[nodiscard]] std::string without_comments(std::string text);

// Line `line` (from 1) of a text, without its newline.
[[nodiscard]] std::string line_of(const std::string& text, uint32_t line);

// A diagnostic with file, line, column and excerpt; a null source leaves these fields empty.
[[nodiscard]] Diagnostic diagnostic_at(const SourcePosition& position, std::string code, std::string message);

}  // namespace weft::shader
