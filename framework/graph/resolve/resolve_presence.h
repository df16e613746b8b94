// Purpose: what is left of references when `if` leaves passes out. Private to resolve_*.cpp.
// Leaving out a pass that changes something in place passes the preceding version on. Where nobody is left
// who writes what a port reads, the port takes its "else", or nothing if it is optional, or is an error
// (W123).
#pragma once

#include <vector>

#include "graph/resolve/resolve_context.h"

namespace weft {

struct BoundPort {
    UseDecl use;
    PortWork work;
    bool pin_is_gone = false;  // the pinned pass is left out, and nobody can say which version it would be
};

using BoundPorts = std::vector<std::vector<BoundPort>>;  // by pass

// The passes behind `ref`'s '@', which is known to name a pass, or where `if` left that out those whose
// version it would have passed on. `outputs` are those of all passes.
void resolve_pins(const ResolveState& state, PassId pass, const RefDesc& ref, const BoundPorts& outputs,
                  BoundPort& port);
// False: only passes that are left out write what the input reads.
[[nodiscard]] bool is_present(const ResolveState& state, PassId pass, const BoundPort& input,
                              const BoundPorts& outputs);
// A pass that is left out and would write the resource; null: none.
[[nodiscard]] const PassDesc* dropped_writer(const ResolveState& state, const std::string& name);
void report_absent(ResolveState& state, PassId pass, const PortDesc& port);

}  // namespace weft
