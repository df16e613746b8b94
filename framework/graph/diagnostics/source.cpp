#include "weft/source.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace weft {
namespace {

constexpr size_t kBlockBytes = 4096;

std::vector<uint32_t> count_newlines(std::string_view text) {
    std::vector<uint32_t> before;
    before.reserve(text.size() / kBlockBytes + 1);
    uint32_t count = 0;
    for (size_t begin = 0; begin < text.size(); begin += kBlockBytes) {
        before.push_back(count);
        count += static_cast<uint32_t>(std::ranges::count(text.substr(begin, kBlockBytes), '\n'));
    }
    return before;
}

// Returns the offset of the first byte of a line, or npos if the text has fewer lines.
size_t offset_of_line(const SourceFile& file, uint32_t line) {
    if (line <= 1) return 0;
    const uint32_t newlines = line - 1;
    // newlines_before has one number per block: the newlines before this block. `block` is the first block
    // whose number is at least `newlines`. So the newline that ends the previous line is in the block before
    // `block`, and the search begins there.
    const auto block = std::ranges::lower_bound(file.newlines_before, newlines);
    const auto blocks_before = block - file.newlines_before.begin();
    size_t at = blocks_before > 0 ? static_cast<size_t>(blocks_before - 1) * kBlockBytes : 0;
    uint32_t seen = blocks_before > 0 ? *(block - 1) : 0;
    while (seen < newlines) {
        at = file.text.find('\n', at);
        if (at == std::string::npos) return at;
        ++at;
        ++seen;
    }
    return at;
}

std::string line_of(const SourceFile& file, uint32_t line) {
    const size_t start = offset_of_line(file, line);
    if (start == std::string::npos) return "";
    // A line longer than kMaxExcerptBytes is not shown. A minified file is a single line, so otherwise each
    // diagnostic would copy the whole file.
    const std::string_view text = std::string_view(file.text).substr(start, kMaxExcerptBytes + 1);
    const size_t length = std::min(text.find('\n'), text.size());
    if (length > kMaxExcerptBytes) return "";
    std::string found(text.substr(0, length));
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

// If the value at `loc` replaced another value during merging, adds a note with the place of the replaced
// value. Tokens do not overlap, so only the last token that begins at or before `loc` can contain `loc`.
void add_replaced(const SourceMap& sources, const SourceLoc& loc, std::vector<Note>& notes) {
    const auto behind = sources.replacements.upper_bound({loc.file, loc.line, loc.column});
    if (behind == sources.replacements.begin()) return;
    const auto [first, last] = sources.replacements.equal_range(std::prev(behind)->first);
    for (auto it = first; it != last; ++it)
        if (stands_in(loc, it->second.by))
            notes.push_back(note_at(sources, it->second.what, "the marked value replaces the value here"));
}

}  // namespace

uint32_t SourceMap::add_file(std::string path, std::string text, SourceLoc included_at) {
    std::vector<uint32_t> newlines = count_newlines(text);
    files.push_back({std::move(path), std::move(text), included_at, std::move(newlines)});
    return static_cast<uint32_t>(files.size() - 1);
}

void SourceMap::add_replacement(const Replacement& replacement) {
    const SourceLoc& by = replacement.by;
    replacements.insert({{by.file, by.line, by.column}, replacement});
}

Diagnostic SourceMap::error(SourceLoc loc, std::string code, std::string message) const {
    Diagnostic d;
    d.code = std::move(code);
    d.message = std::move(message);
    if (loc.file < files.size()) {
        d.file = files[loc.file].path;
        d.line = loc.line;
        d.column = loc.column;
        d.length = loc.length;
        d.source_line = line_of(files[loc.file], loc.line);
        add_replaced(*this, loc, d.notes);
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
