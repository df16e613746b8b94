// Reads a page as an XML parser would, but for <style> and <script>, whose text is left alone: so that tests
// can say what a page holds. The first fault ends it.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace weft::test {

struct ReadElement {
    std::string tag;
    std::map<std::string, std::string> attributes;  // still escaped
    std::string text;                               // right inside it, still escaped
};

struct ReadPage {
    std::vector<ReadElement> elements;  // in the order of their opening tags
    std::string fault;                  // empty: well-formed
};

[[nodiscard]] ReadPage read_markup(const std::string& text);

}  // namespace weft::test
