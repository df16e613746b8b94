#include "weft/syntax/json_doc.h"

namespace weft {
namespace {

bool covers(const SourceLoc& token, uint32_t line, uint32_t column) {
    return token.line == line && token.column <= column && column < token.column + token.length;
}

std::string escaped(const std::string& key) {
    std::string text;
    for (const char c : key) text += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return text;
}

// Searches for the value or key whose token covers the given line and column, and appends its JSON pointer to
// `pointer`. Returns false if there is none. The recursion is not too deep, because the JSON reader limits
// the nesting.
bool find_at(const JsonNode& node, uint32_t line, uint32_t column, std::string& pointer) {
    if (covers(node.loc, line, column)) return true;
    const size_t length = pointer.size();
    for (const JsonMember& member : node.members) {
        pointer += "/" + escaped(member.key);
        if (covers(member.key_loc, line, column) || find_at(member.value, line, column, pointer)) return true;
        pointer.resize(length);
    }
    for (size_t i = 0; i < node.items.size(); ++i) {
        pointer += "/" + std::to_string(i);
        if (find_at(node.items[i], line, column, pointer)) return true;
        pointer.resize(length);
    }
    return false;
}

}  // namespace

std::string pointer_at(const JsonDoc& document, const std::string& file, uint32_t line, uint32_t column) {
    std::string pointer;
    const std::vector<SourceFile>& files = document.sources.files;
    if (!files.empty() && files.front().path == file) find_at(document.root, line, column, pointer);
    // If a file belongs to several modules, the list contains it several times, with the same values. The
    // first match is enough.
    for (const IncludedJson& included : document.included)
        if (pointer.empty() && files[included.file].path == file)
            find_at(included.root, line, column, pointer);
    return pointer;
}

}  // namespace weft
