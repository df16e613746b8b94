#include "tests/viewer/documentation/snippets.h"

#include <sstream>

#include "tests/viewer/program.h"

namespace weft::test {

std::map<std::string, std::string> snippets_of(const std::string& page) {
    constexpr std::string_view kBegin = "<!-- file: ", kEnd = " -->", kFence = "```";
    std::map<std::string, std::string> snippets;
    std::istringstream lines(read_text(std::string(WEFT_SOURCE_DIR "/docs/") + page));
    std::string name;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (!inside && line.starts_with(kBegin) && line.ends_with(kEnd)) {
            // "NAME needs KEY" is a graph that only some devices can run.
            name = line.substr(kBegin.size(), line.find(' ', kBegin.size()) - kBegin.size());
        } else if (!name.empty() && line.starts_with(kFence)) {
            if (inside) name.clear();
            inside = !inside;
        } else if (inside) {
            snippets[name] += line + "\n";
        }
    }
    return snippets;
}

}  // namespace weft::test
