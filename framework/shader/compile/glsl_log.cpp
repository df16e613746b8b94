#include "shader/compile/glsl_log.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <set>
#include <sstream>
#include <string_view>

namespace weft::shader {

namespace {

constexpr std::string_view kErrorPrefix = "ERROR: ";
constexpr size_t kMaxIdentifiers = 5000;

struct LogLine {
    SourcePosition position;
    std::string token;
    std::string message;
};

bool is_summary(std::string_view text) {
    return text.find("compilation terminated") != std::string_view::npos ||
           text.find("No code generated") != std::string_view::npos;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.remove_suffix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0)
        text.remove_prefix(1);
    return text;
}

// Removes the position at the start of a log line, such as "name:12: ", and returns it. Names may contain
// colons, so the function compares the line with all known names, the longest first.
SourcePosition take_position(std::string_view& text, const SourceReader& reader, const SourceText& main) {
    std::vector<const SourceText*> sources = reader.sources();
    std::ranges::sort(sources, [](const auto* a, const auto* b) { return a->name.size() > b->name.size(); });
    for (const SourceText* source : sources) {
        if (!text.starts_with(source->name + ":")) continue;
        const char* first = text.data() + source->name.size() + 1;
        uint32_t line = 0;
        const auto [end, error] = std::from_chars(first, text.data() + text.size(), line);
        if (error != std::errc()) continue;
        text.remove_prefix(static_cast<size_t>(end - text.data()));
        if (text.starts_with(":")) text.remove_prefix(1);
        text = trimmed(text);
        return {source, line, 0};
    }
    return {&main, 0, 0};
}

LogLine parse_line(std::string_view text, const SourceReader& reader, const SourceText& main) {
    LogLine line;
    line.position = take_position(text, reader, main);
    const size_t quote = text.starts_with("'") ? text.find("' : ") : std::string_view::npos;
    if (quote != std::string_view::npos) {
        line.token = text.substr(1, quote - 1);
        text.remove_prefix(quote + 4);
    }
    line.message = trimmed(text);
    return line;
}

void underline_token(Diagnostic& diagnostic, const std::string& token) {
    const size_t at = token.empty() ? std::string::npos : diagnostic.source_line.find(token);
    if (at != std::string::npos) {
        diagnostic.column = static_cast<uint32_t>(at) + 1;
        diagnostic.length = static_cast<uint32_t>(token.size());
    } else if (diagnostic.line > 0) {
        const size_t text = diagnostic.source_line.find_first_not_of(" \t");
        diagnostic.column = text == std::string::npos ? 1 : static_cast<uint32_t>(text) + 1;
    }
}

std::vector<std::string> identifiers(const SourceReader& reader, const std::string& except) {
    std::set<std::string> words;
    for (const SourceText* source : reader.sources()) {
        std::string word;
        for (const char c : without_comments(source->text) + "\n") {
            const bool part = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
            if (part) word += c;
            if (part || word.empty()) continue;
            const bool number = std::isdigit(static_cast<unsigned char>(word[0])) != 0;
            if (!number && word.size() > 1 && word != except && words.size() < kMaxIdentifiers)
                words.insert(word);
            word.clear();
        }
    }
    return {words.begin(), words.end()};
}

// Adds notes about the files that include the faulty file, from the innermost file to the file of the stage.
void note_includers(Diagnostic& diagnostic, const SourceText* source, const SourceReader& reader) {
    for (int depth = 0; source != nullptr && !source->included_by.empty() && depth < 32; ++depth) {
        const SourceText* parent = reader.find(source->included_by);
        if (parent == nullptr) return;
        std::istringstream lines(parent->text);
        uint32_t number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            if (line.find("#include") == std::string::npos ||
                line.find(source->include_text) == std::string::npos) {
                continue;
            }
            diagnostic.notes.push_back({parent->path, number, 1, "included from here"});
            break;
        }
        source = parent;
    }
}

Diagnostic to_diagnostic(const LogLine& line, const SourceReader& reader) {
    const bool include = line.token == "#include";
    std::string message = line.message;
    if (!include && !line.token.empty()) message = "'" + line.token + "': " + message;
    Diagnostic diagnostic = diagnostic_at(line.position, include ? "W203" : "W202", std::move(message));
    underline_token(diagnostic, line.token);
    if (include) {
        diagnostic.help.emplace_back(
            "use a relative path without \"..\" from the folder of this file, from the folder of the graph "
            "file, or from the folder shaders/include of Weft");
    } else if (line.message.starts_with("undeclared identifier") || line.message.starts_with("no matching")) {
        const std::string near = did_you_mean_text(line.token, identifiers(reader, line.token));
        if (!near.empty()) diagnostic.help.push_back(near);
    }
    if (diagnostic.help.empty()) {
        diagnostic.help.emplace_back("write GLSL 4.60 with the rules for Vulkan (GL_KHR_vulkan_glsl)");
    }
    note_includers(diagnostic, line.position.source, reader);
    return diagnostic;
}

}  // namespace

Diagnostics parse_glsl_log(const std::string& log, const SourceReader& reader, const SourceText& main) {
    Diagnostics diagnostics;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        const std::string_view text = trimmed(line);
        if (!text.starts_with(kErrorPrefix) || is_summary(text)) continue;
        diagnostics.push_back(
            to_diagnostic(parse_line(text.substr(kErrorPrefix.size()), reader, main), reader));
        // Stop after the first error with a line number. glslang stops reading the faulty file there, but
        // continues in the file that includes it. Later errors only follow from the first error.
        if (diagnostics.back().line > 0) break;
    }
    if (diagnostics.empty()) {
        Diagnostic diagnostic = diagnostic_at({&main, 0, 0}, "W202", "the shader does not compile");
        diagnostic.help.emplace_back("write GLSL 4.60 with the rules for Vulkan (GL_KHR_vulkan_glsl)");
        diagnostics.push_back(diagnostic);
    }
    return diagnostics;
}

}  // namespace weft::shader
