#include "shader/faults/source_position.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace weft::shader {

namespace {

bool is_word_char(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::optional<size_t> find_declared(const std::string& text, const std::string& name) {
    constexpr std::string_view kDeclarationEnds = ";[={";
    for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const size_t end = at + name.size();
        const size_t next = text.find_first_not_of(" \t\r\n", end);
        const bool whole =
            (at == 0 || !is_word_char(text[at - 1])) && (end >= text.size() || !is_word_char(text[end]));
        if (whole && next != std::string::npos && kDeclarationEnds.find(text[next]) != std::string_view::npos)
            return at;
    }
    return std::nullopt;
}

SourcePosition position_at(const SourceText& source, size_t offset) {
    const std::string_view before = std::string_view(source.text).substr(0, offset);
    const size_t line_start = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    return {&source, 1 + static_cast<uint32_t>(std::ranges::count(before, '\n')),
            1 + static_cast<uint32_t>(offset - line_start)};
}

std::vector<const SourceText*> searched(const SourceText* first,
                                        const std::vector<const SourceText*>& others) {
    std::vector<const SourceText*> order = others;
    if (first != nullptr) order.insert(order.begin(), first);
    return order;
}

std::vector<std::string_view> split(std::string_view words) {
    std::vector<std::string_view> parts;
    while (!words.empty()) {
        const size_t end = std::min(words.find(' '), words.size());
        if (end > 0) parts.push_back(words.substr(0, end));
        words.remove_prefix(std::min(end + 1, words.size()));
    }
    return parts;
}

bool matches(std::string_view word, std::string_view pattern) {
    if (!pattern.ends_with('*')) return word == pattern;
    return word.starts_with(pattern.substr(0, pattern.size() - 1));
}

}  // namespace

FoundWord find_words(const std::string& words, const SourceText* first,
                     const std::vector<const SourceText*>& others) {
    const std::vector<std::string_view> patterns = split(words);
    for (const SourceText* source : searched(first, others)) {
        const std::string text = without_comments(source->text);
        for (size_t at = 0; at < text.size() && !patterns.empty();) {
            size_t end = at;
            while (end < text.size() && is_word_char(text[end])) ++end;
            const std::string_view word = std::string_view(text).substr(at, end - at);
            const auto is_word = [&](std::string_view pattern) { return matches(word, pattern); };
            if (!word.empty() && std::ranges::any_of(patterns, is_word))
                return {position_at(*source, at), static_cast<uint32_t>(word.size())};
            at = std::max(end, at + 1);
        }
    }
    return {{first, 0, 0}, 0};
}

std::string without_comments(std::string text) {
    for (size_t at = 0; at + 1 < text.size(); ++at) {
        if (text[at] != '/' || (text[at + 1] != '/' && text[at + 1] != '*')) continue;
        const bool line = text[at + 1] == '/';
        const size_t end = line ? text.find('\n', at) : text.find("*/", at + 2);
        const size_t stop = end == std::string::npos ? text.size() : end + (line ? 0 : 2);
        for (; at < stop; ++at) text[at] = text[at] == '\n' ? '\n' : ' ';
    }
    return text;
}

SourcePosition find_declaration(const std::string& name, const SourceText* first,
                                const std::vector<const SourceText*>& others) {
    for (const SourceText* source : searched(first, others)) {
        const auto offset = name.empty() ? std::nullopt : find_declared(without_comments(source->text), name);
        if (offset) return position_at(*source, *offset);
    }
    return {first, 0, 0};
}

std::string line_of(const std::string& text, uint32_t line) {
    size_t start = 0;
    for (uint32_t i = 1; i < line; ++i) {
        const size_t end = text.find('\n', start);
        if (end == std::string::npos) return {};
        start = end + 1;
    }
    std::string found = text.substr(start, text.find('\n', start) - start);
    if (!found.empty() && found.back() == '\r') found.pop_back();
    return found;
}

Diagnostic diagnostic_at(const SourcePosition& position, std::string code, std::string message) {
    Diagnostic diagnostic;
    diagnostic.code = std::move(code);
    diagnostic.message = std::move(message);
    if (position.source == nullptr) return diagnostic;
    // An error that concerns the whole file has line 0. It is shown at line 1.
    diagnostic.file = position.source->path;
    diagnostic.line = std::max(position.line, 1u);
    diagnostic.column = std::max(position.column, 1u);
    diagnostic.source_line = line_of(position.source->text, diagnostic.line);
    return diagnostic;
}

}  // namespace weft::shader
