// Purpose: formats parts of messages that several stages of resolve() use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "weft/declaration.h"
#include "weft/result.h"

namespace weft {

[[nodiscard]] std::string quote(std::string_view name);
// Returns the names in quotes with commas between them: "a", "b", "c". Lists at most 64 names, then the
// number of the others.
[[nodiscard]] std::string quote_all(const std::vector<std::string>& names);
// Returns a range in the syntax of graphs, such as "hiz.mip(0..2)" or "args.range(0..2)". Mips, layers or
// elements are left out if the range includes all of them.
[[nodiscard]] std::string range_of(const ResourceDecl& resource, const SubresourceRange& range);
[[nodiscard]] std::string extent_text(const Extent3D& extent);
// Returns the help for a missing port. `direction` is "in" or "out".
[[nodiscard]] std::string add_port_text(std::string_view direction, std::string_view port);
// Adds a help text to a diagnostic, unless the text is empty.
void add_help(Diagnostic& diagnostic, std::string help);
// Adds a note at a location in a file. Adds nothing if the location is in no file. For example, a part of the
// graph that a program made has no file.
void add_note(Diagnostic& diagnostic, const SourceMap& sources, SourceLoc loc, std::string message);

}  // namespace weft
