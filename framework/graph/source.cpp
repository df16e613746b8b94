#include "weft/source.h"

#include <algorithm>

#include "graph/json_doc.h"

namespace weft {
namespace {

std::string line_of(const std::string& text, uint32_t line) {
    size_t start = 0;
    for (uint32_t i = 1; i < line; ++i) {
        start = text.find('\n', start);
        if (start == std::string::npos) return "";
        ++start;
    }
    const size_t length = std::min(text.find('\n', start), text.size()) - start;
    // A minified file is one line, and every diagnostic would carry a copy of it.
    if (length > kMaxExcerptBytes) return "";
    std::string found = text.substr(start, length);
    if (!found.empty() && found.back() == '\r') found.pop_back();
    return found;
}

bool stands_in(const SourceLoc& loc, const SourceLoc& token) {
    return loc.file == token.file && loc.line == token.line && token.column <= loc.column &&
           loc.column < token.column + token.length;
}

Note note_at(const SourceMap& sources, const SourceLoc& loc, std::string message) {
    return {sources.files[loc.file].path, loc.line, loc.column, std::move(message)};
}

}  // namespace

Diagnostic SourceMap::error(SourceLoc loc, std::string code, std::string message) const {
    Diagnostic d;
    d.code = std::move(code);
    d.message = std::move(message);
    if (loc.file < files.size()) {
        d.file = files[loc.file].path;
        d.line = loc.line;
        d.column = loc.column;
        d.length = loc.length;
        d.source_line = line_of(files[loc.file].text, loc.line);
        for (const Replacement& r : replacements)
            if (stands_in(loc, r.by)) d.notes.push_back(note_at(*this, r.what, "in place of what is here"));
        const SourceLoc& includer = files[loc.file].included_at;
        if (includer.file < files.size()) d.notes.push_back(note_at(*this, includer, "included here"));
    }
    return d;
}

std::string SourceMap::describe(SourceLoc loc) const {
    if (loc.file >= files.size()) return "<memory>";
    return files[loc.file].path + ":" + std::to_string(loc.line) + ":" + std::to_string(loc.column);
}

}  // namespace weft
