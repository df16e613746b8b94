#include "tests/viewer/page/page_walk.h"

#include <optional>
#include <sstream>
#include <string_view>

#include "tests/viewer/program.h"

namespace weft::test {
namespace {

// Returns the text between `begin` and the end of an HTML comment, or nullopt if the line is not such a
// comment.
std::optional<std::string> comment(const std::string& line, std::string_view begin) {
    constexpr std::string_view kEnd = " -->";
    if (!line.starts_with(begin) || !line.ends_with(kEnd)) return std::nullopt;
    return line.substr(begin.size(), line.size() - begin.size() - kEnd.size());
}

PageMistake mistake_of(const std::string& text) {
    constexpr std::string_view kFile = ": ", kArrow = " => ";
    const size_t file = text.find(kFile), arrow = text.find(kArrow);
    if (file == std::string::npos || arrow == std::string::npos) return {};
    const size_t right = file + kFile.size();
    return {text.substr(0, file), text.substr(right, arrow - right), text.substr(arrow + kArrow.size())};
}

}  // namespace

std::vector<PageEvent> events_of(const std::string& page) {
    std::istringstream lines(read_text(std::string(WEFT_SOURCE_DIR "/docs/") + page));
    std::vector<PageEvent> events;
    PageEvent next;
    bool inside = false, wanted = false;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const bool fence = line.starts_with("```");
        if (fence && inside) {
            if (wanted) events.push_back(next);
            next = {};
        } else if (fence) {
            if (line == "```sh") next.kind = PageEvent::Kind::commands;
            if (line == "```console") next.kind = PageEvent::Kind::console;
            wanted = !next.name.empty() || next.kind != PageEvent::Kind::file;
            next.line = number;
        } else if (inside) {
            next.lines.push_back(line);
        } else if (const auto name = comment(line, "<!-- file: ")) {
            next.name = *name;
        } else if (const auto mistake = comment(line, "<!-- mistake: ")) {
            next.mistake = mistake_of(*mistake);
        }
        inside = inside != fence;
    }
    return events;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

}  // namespace weft::test
