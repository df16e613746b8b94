// Purpose: resolves references to passes that `if` removes. Private to bind(). Removing a pass that modifies
// a resource in place makes the previous version visible instead. If no remaining pass writes the resource
// that a port reads, the port uses its "else", or nothing if it is optional; otherwise this is an error
// (W123).
#pragma once

#include <vector>

#include "graph/resolve/bind.h"

namespace weft {

struct BoundPort {
    UseDecl use;
    PortDraft draft;
    bool pin_is_gone = false;  // the pinned pass was removed, and the version that it would have passed on is
                               // unknown
};

using BoundPorts = std::vector<std::vector<BoundPort>>;  // by pass

class Presence {
 public:
    // `outputs` are those of all passes. Keeps references to all arguments.
    Presence(const Declared& declared, const BoundPorts& outputs, const Suspects& suspects,
             PassReporter& report, Reporter& reporter)
        : declared_(declared), outputs_(outputs), suspects_(suspects), report_(report), reporter_(reporter) {}

    // Finds the passes for the '@' of `ref`, which must name a pass. For a pass removed by `if`, finds the
    // passes whose version it would have passed on.
    void find_pins(PassId pass, const RefDesc& ref, BoundPort& port) const;
    // False: only removed passes write the resource that the input reads.
    [[nodiscard]] bool is_present(PassId pass, const BoundPort& input) const;
    void report_absent(PassId pass, const PortDesc& port) const;

 private:
    // Names of the passes, but `except`, that write a resource.
    [[nodiscard]] std::set<std::string> writers_of(const std::string& resource, PassId except) const;

    const Declared& declared_;
    const BoundPorts& outputs_;
    const Suspects& suspects_;
    PassReporter& report_;
    Reporter& reporter_;
};

}  // namespace weft
