// Reads an HTML page with the strict rules of XML, so that tests can examine its elements. The text in
// <style> and <script> is ignored. Reading ends at the first error.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace weft::test {

struct ReadElement {
    std::string tag;
    // Values of the attributes by name. Escapes such as "&amp;" are not decoded.
    std::map<std::string, std::string> attributes;
    // Text directly inside the element, without the text of child elements. Escapes such as "&amp;" are not
    // decoded.
    std::string text;
};

struct ReadPage {
    // Elements in the order of their start tags.
    std::vector<ReadElement> elements;
    // Description of the error; empty if the page is well-formed.
    std::string fault;
};

[[nodiscard]] ReadPage read_markup(const std::string& text);

}  // namespace weft::test
