// Purpose: what the documentation says about each diagnostic code, for those who read it as data.
#pragma once

#include <map>
#include <string>

namespace weft::viewer {

struct DiagnosticPage {
    std::string what;     // what is wrong, without markup
    std::string remedy;   // may be empty
    std::string section;  // of the page, that it stands in
};

// By code, from the rows of the shipped docs/diagnostics.md; empty where it isn't shipped.
[[nodiscard]] std::map<std::string, DiagnosticPage> diagnostic_pages();

}  // namespace weft::viewer
