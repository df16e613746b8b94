// Purpose: parses references to resources. Graphs, tests and the command line all use this grammar:
//   name [@pass] [[-N]] [.mip(e) | .mip(a..b)] [.layer(e) | .layer(a..b)] [.range(e) | .range(a..b)]
//        [.depth | .stencil]
// The name of a resource or pass of a group begins with the group, as in "relight::raw@relight::light".
// Each part in square brackets is optional; only the inner brackets of [[-N]] are written. e, a and b are
// expressions. The parts after the name come in any order, each at most once. For example, "hdr[-1].mip(2)"
// is mip level 2 of the resource "hdr" as it was at the end of the previous frame.
// Errors: W106, at the first character that does not fit the grammar.
#pragma once

#include <string>
#include <string_view>

#include "graph/diagnostics/located_text.h"
#include "graph/syntax/reference_name.h"
#include "weft/graph_desc.h"
#include "weft/result.h"

namespace weft {

inline constexpr uint32_t kMaxHistory = 16;  // The largest N of [-N].

[[nodiscard]] Result<RefDesc> parse_reference(const LocatedText& text, const SourceMap& sources);

}  // namespace weft
