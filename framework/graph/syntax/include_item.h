// Purpose: reads the items of the list "include" and the section "ports" of a graph file.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft {

// The help of the error that "with" gives a number for a port.
inline constexpr const char* kNumberHelp =
    "name a parameter or constant that has this value; or leave the port out of \"with\" and, if the module "
    "declares "
    "it as a parameter, set it: \"params\": { \"module::port\": 0.5 }";

// One item of "include": "fog.json", or { "file": "fog.json", "as": "near", "with": { "depth": "depth" } }.
struct IncludeItem {
    std::string file;
    SourceLoc loc;   // Place of the name of the file.
    std::string as;  // Empty: the parts of the file keep their names.
    SourceLoc as_loc;
    std::map<std::string, PortTarget> with;
};

// Returns the keys that an item of the list "include" may have if the item is an object.
[[nodiscard]] const std::vector<std::string>& include_keys();

// Returns nullopt after an error. Errors: W101 unknown key, W102 wrong type, W108 "file" or "as" is missing,
// W126 the name of the file is not allowed, W239 "as" is not a name.
[[nodiscard]] std::optional<IncludeItem> read_include_item(const JsonNode& item, const SourceMap& sources,
                                                           Diagnostics& errors);

// Returns the ports that a file lists: ["depth"], or { "depth": "a description" }. Errors: W102 wrong type,
// W109 a port is not a name.
[[nodiscard]] std::map<std::string, ModulePort> read_module_ports(const JsonNode& root,
                                                                  const SourceMap& sources,
                                                                  Diagnostics& errors);

}  // namespace weft
