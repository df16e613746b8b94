// Purpose: parts of messages that several stages use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "weft/declaration.h"
#include "weft/result.h"

namespace weft {

[[nodiscard]] std::string quote(std::string_view name);
// "a", "b", "c"; of a long list the first ones.
[[nodiscard]] std::string quote_all(const std::vector<std::string>& names);
// A range in the syntax of graphs, without the axes that it covers completely.
[[nodiscard]] std::string range_of(const ResourceDecl& resource, const SubresourceRange& range);
[[nodiscard]] std::string extent_text(const Extent3D& extent);
void add_help(Diagnostic& diagnostic, std::string help);  // unless empty
// A note at a place of the file; does nothing for parts that a program made.
void add_note(Diagnostic& diagnostic, const SourceMap& sources, SourceLoc loc, std::string message);

}  // namespace weft
