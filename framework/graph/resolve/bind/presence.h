// Purpose: references where `if` leaves passes out. Private to bind().
// Leaving out a pass that changes a resource in place passes the preceding version on. Where no remaining
// pass writes the resource that a port reads, the port takes its "else", or nothing if it is optional, or is
// an error (W123).
#pragma once

#include <vector>

#include "graph/resolve/bind.h"

namespace weft {

struct BoundPort {
    UseDecl use;
    PortDraft draft;
    bool pin_is_gone = false;  // the pinned pass is left out, and it is unknown which version it would be
};

using BoundPorts = std::vector<std::vector<BoundPort>>;  // by pass

class Presence {
 public:
    // `outputs` are those of all passes. It borrows all that it is given.
    Presence(const Declared& declared, const BoundPorts& outputs, const Suspects& suspects,
             PassReporter& report, Reporter& reporter)
        : declared_(declared), outputs_(outputs), suspects_(suspects), report_(report), reporter_(reporter) {}

    // Finds the passes behind `ref`'s '@', which is known to name a pass. Where `if` left that out they are
    // those whose version it would have passed on.
    void find_pins(PassId pass, const RefDesc& ref, BoundPort& port) const;
    // False: only passes that are left out write the resource that the input reads.
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
