#include "shader/reflect/local_size.h"

#include <algorithm>
#include <string_view>

namespace weft::shader {
namespace {

// All declarations of the local size begin with this text. Examples: local_size_x = 8, local_size_x_id = 0.
constexpr std::string_view kWord = "local_size_";

// Returns the end of the comment that begins at offset `at`, or `at` itself if no comment begins there.
size_t end_of_comment(std::string_view text, size_t at) {
    if (text.substr(at, 2) == "//") return std::min(text.find('\n', at), text.size());
    if (text.substr(at, 2) != "/*") return at;
    const size_t end = text.find("*/", at + 2);
    return end == std::string_view::npos ? text.size() : end + 2;
}

bool says_it(std::string_view text) {
    for (size_t at = 0; at < text.size();) {
        const size_t end = end_of_comment(text, at);
        if (end == at && text.substr(at, kWord.size()) == kWord) return true;
        at = std::max(end, at + 1);
    }
    return false;
}

}  // namespace

bool states_local_size(std::span<const SourceText* const> sources) {
    return std::ranges::any_of(sources, [](const SourceText* source) { return says_it(source->text); });
}

}  // namespace weft::shader
