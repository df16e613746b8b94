#include "viewer/output/terminal_colors.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "graph/diagnostics/diagnostic_text.h"

namespace weft::viewer {
namespace {

std::string_view variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

bool forced(const char* name) {
    const std::string_view value = variable(name);
    return !value.empty() && value != "0";
}

std::string_view color_of(TextStyle style, Severity severity) {
    const bool error = severity == Severity::error;
    switch (style) {
        case TextStyle::plain:
            return "";
        case TextStyle::place:
        case TextStyle::code:
            return "\x1b[1m";
        case TextStyle::severity:
        case TextStyle::caret:
            return error ? "\x1b[1;31m" : "\x1b[1;33m";
        case TextStyle::gutter:
            return "\x1b[2m";
        case TextStyle::label:
            return "\x1b[36m";
    }
    return "";
}

}  // namespace

bool wants_colors(int file_descriptor) {
    if (forced("FORCE_COLOR") || forced("CLICOLOR_FORCE")) return true;
    if (!variable("NO_COLOR").empty() || variable("TERM") == "dumb") return false;
    return isatty(file_descriptor) != 0;
}

std::string colored_text(const Diagnostic& diagnostic) {
    std::string text;
    for (const TextPiece& piece : text_pieces(diagnostic)) {
        const std::string_view color = color_of(piece.style, diagnostic.severity);
        if (color.empty() || piece.text.empty())
            text += piece.text;
        else
            text.append(color).append(piece.text).append("\x1b[0m");
    }
    return text;
}

}  // namespace weft::viewer
