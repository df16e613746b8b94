// Purpose: the documentation of each diagnostic code as data.
#pragma once

#include <map>
#include <string>

namespace weft::viewer {

struct DiagnosticPage {
    std::string what;     // description of the fault, without markup
    std::string remedy;   // may be empty
    std::string section;  // heading of the section on the page
};

// By code, from the tables of the installed docs/diagnostics.md; empty if the file is not installed.
[[nodiscard]] std::map<std::string, DiagnosticPage> diagnostic_pages();

}  // namespace weft::viewer
