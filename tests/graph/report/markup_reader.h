// Reads an HTML page as an XML parser would, except for the text in <style> and <script>, which is ignored,
// so that tests can examine its elements. Reading ends at the first fault.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace weft::test {

struct ReadElement {
    std::string tag;
    std::map<std::string, std::string> attributes;  // with escapes not decoded
    std::string text;                               // direct text of the element, with escapes not decoded
};

struct ReadPage {
    std::vector<ReadElement> elements;  // in the order of the start tags
    std::string fault;                  // empty if the page is well-formed
};

[[nodiscard]] ReadPage read_markup(const std::string& text);

}  // namespace weft::test
