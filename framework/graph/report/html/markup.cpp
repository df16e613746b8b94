#include "graph/report/html/markup.h"

#include <cassert>
#include <utility>

#include "graph/diagnostics/utf8.h"

namespace weft {
namespace {

constexpr const char* kReplacement = "\xEF\xBF\xBD";

std::string escaped_code_point(std::string_view text, const Utf8& next) {
    switch (next.code_point) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\'':
            return "&#39;";
        default:
            break;
    }
    const uint32_t c = next.code_point;
    const bool control =
        (c < 0x20 && c != '\n' && c != '\t') || (c >= 0x7F && c < 0xA0) || c == 0xFFFE || c == 0xFFFF;
    return control ? kReplacement : std::string(text.substr(0, next.length));
}

}  // namespace

std::string escaped(std::string_view text) {
    return rewrite(text, [](const Utf8& next, std::string_view bytes) {
        return next.length > 0 ? escaped_code_point(bytes, next) : kReplacement;
    });
}

void Markup::tag(const char* name, const Attributes& attributes, const char* end) {
    text_.append("<").append(name);
    for (const Attribute& a : attributes)
        text_.append(" ").append(a.name).append("=\"").append(escaped(a.value)).append("\"");
    text_ += end;
}

void Markup::open(const char* name, const Attributes& attributes) {
    tag(name, attributes, ">");
    open_.push_back(name);
}

void Markup::close() {
    assert(!open_.empty());
    text_.append("</").append(open_.back()).append(">");
    open_.pop_back();
}

void Markup::empty(const char* name, const Attributes& attributes) {
    tag(name, attributes, " />");
}

void Markup::leaf(const char* name, const Attributes& attributes, std::string_view text) {
    open(name, attributes);
    text_ += escaped(text);
    close();
}

std::string Markup::take() {
    assert(open_.empty());
    return std::exchange(text_, {});
}

}  // namespace weft
