// Purpose: finds out which kind of part each port of a module is. The kind follows from the declaration that
// "with" replaces, or from the passes of the module that name the port. If the target in "with" is of another
// kind, the error is reported at that target.
#pragma once

#include <map>
#include <string>

#include "graph/syntax/module_names.h"

namespace weft {

// For the modules of a document, by their index: the kinds of those ports whose kind is known.
using PortKinds = std::map<uint32_t, std::map<std::string, NameKind>>;

// Finds the kinds of the ports that "with" replaces and that a file of the module declares itself. Call this
// function before qualify_names(), which removes these declarations.
void find_declared_kinds(const JsonNode& root, const ModuleInstance& module,
                         std::map<std::string, NameKind>& kinds);
// Finds the ports that "with" replaces and that the inputs, outputs or depth attachments of passes name.
// These ports are of the kind `resource`. `merged` is the document after all files were merged.
void find_used_kinds(const JsonDoc& merged, PortKinds& kinds);
// Checks that each name in "with" is of the same kind as the port that it replaces. `names` are the names of
// `merged`. Errors: W240.
void check_port_kinds(const JsonDoc& merged, const ModuleNames& names, const PortKinds& kinds,
                      Diagnostics& errors);

}  // namespace weft
