// Purpose: parses the texts of --import. Such a text describes an import that another program offers to
// graphs, so that a graph can be checked without this program: "props=drawlist:position,normal",
// "portals=views:3", "decals=textures:8", "paint=image:rgba8:256x256" or "weights=buffer:4096" (size in
// bytes).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "weft/imports.h"

namespace weft::viewer {

// Returns a message if `text` is not a valid text of --import. Returns an empty text if it is valid.
[[nodiscard]] std::string import_fault(const std::string& text);
[[nodiscard]] std::map<std::string, ImportDecl, std::less<>> parse_imports(
    const std::vector<std::string>& texts);
// Adds the imports to a catalogue. The added imports replace imports of the same name. If one of the added
// imports is a draw list, the descriptors of the catalogue become unknown: the program that provides the list
// may bind its own descriptor sets 2 and 3.
void add_imports(const std::map<std::string, ImportDecl, std::less<>>& imports, ImportCatalog& catalog);

}  // namespace weft::viewer
