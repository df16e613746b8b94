// Purpose: places in shader sources, for diagnostics. SPIR-V keeps names but no places, so a declaration is
// found again by looking for its name in the text. Units: lines and columns count from 1; 0 is "unknown".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "weft/result.h"

namespace weft::shader {

struct SourceText {
    std::string name;  // what the compiler calls it: the path below its root, unique in a program
    std::string path;  // what users are shown
    std::string text;
    size_t root = 0;           // index into the reader's roots
    std::string relative;      // path below that root
    std::string included_by;   // name of the file that asked first; empty for the stages themselves
    std::string include_text;  // what that file wrote between the quotes
};

struct SourcePosition {
    const SourceText* source = nullptr;
    uint32_t line = 0;
    uint32_t column = 0;
};

// Where a name is declared, as far as text can tell: the first whole word outside comments that something a
// declaration ends with follows. Looks in `first`, then in the others; unknown in `first` when it is nowhere.
[[nodiscard]] SourcePosition find_declaration(const std::string& name, const SourceText* first,
                                              const std::vector<const SourceText*>& others);

// Where the first of some words stands outside comments, whichever it is; looks in `first`, then in the
// others. `words` are separated by spaces; one that ends in "*" is the beginning of a word.
struct FoundWord {
    SourcePosition position;
    uint32_t length = 0;
};
[[nodiscard]] FoundWord find_words(const std::string& words, const SourceText* first,
                                   const std::vector<const SourceText*>& others);

// The same text with comments turned to spaces, so that offsets stay.
[[nodiscard]] std::string without_comments(std::string text);

// Line `line` (from 1) of a text, without its end.
[[nodiscard]] std::string line_of(const std::string& text, uint32_t line);

// File, line, column and excerpt filled in; a null source leaves them empty.
[[nodiscard]] Diagnostic diagnostic_at(const SourcePosition& position, std::string code, std::string message);

}  // namespace weft::shader
