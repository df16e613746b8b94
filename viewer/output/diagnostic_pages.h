// Purpose: reads the documentation of each diagnostic code (docs/diagnostics.md) as data.
#pragma once

#include <map>
#include <string>

namespace weft::viewer {

struct DiagnosticPage {
    std::string what;     // Description of the fault, without Markdown.
    std::string remedy;   // How the user can correct the fault; may be empty.
    std::string section;  // Heading of the section in docs/diagnostics.md that describes the code.
};

// Returns the documentation of each code, such as "W103", from the tables of the installed
// docs/diagnostics.md. The map is empty if that file is not installed.
[[nodiscard]] std::map<std::string, DiagnosticPage> diagnostic_pages();

}  // namespace weft::viewer
