// Purpose: handles references to passes that `if` removes. Private to bind(). If a removed pass modifies a
// resource in place, a reference to the version after that pass sees the previous version instead. If no
// remaining pass writes the resource that a port reads, the port uses its "else". Without an "else", an
// optional port stays unbound, and any other port is error W123. If switches turn the writers off in some
// frames, an input has several uses: one for each reference, with the combinations of the switches in which
// this reference is read.
// Errors: W123, W234, W235.
#pragma once

#include <vector>

#include "graph/resolve/bind.h"

namespace weft {

struct BoundPort {
    UseDecl use;
    PortDraft draft;
    // True if the pass that the reference names with `@pass` was removed, and no other version can take the
    // place of its result. Either the removed pass would have replaced the whole content, or it is not clear
    // which earlier version would have stayed visible.
    bool pin_is_gone = false;
};

// The ports of all passes, indexed by PassId.
using BoundPorts = std::vector<std::vector<BoundPort>>;

class Presence {
 public:
    // `outputs` are the outputs of all passes. Keeps references to all arguments.
    Presence(const Declared& declared, const BoundPorts& outputs, const Suspects& suspects,
             PassReporter& report, Reporter& reporter);

    // Stores in `port` the passes that `@pass` in `ref` names; `ref` must contain an `@pass`. If that pass
    // was removed, stores the passes whose version stays visible in its place, or sets `port.pin_is_gone`.
    void find_pins(PassId pass, const RefDesc& ref, BoundPort& port) const;
    // Returns false if the input has nothing to read, because the passes that would write the resource are
    // removed. If the input is `optional`, content that an earlier frame may have left in a resource with
    // "keep" does not count.
    [[nodiscard]] bool is_present(PassId pass, const BoundPort& input, bool optional) const;
    void report_absent(PassId pass, const PortDesc& port) const;
    // Returns the combinations of the switches in which the input has something to read. In the other
    // combinations, the passes that would write the resource are switched off. `input` must be present.
    [[nodiscard]] CombinationSet present_in(PassId pass, const BoundPort& input) const;
    // Returns true if the port may be bound to different resources, or to none, in different combinations of
    // the switches.
    [[nodiscard]] bool can_depend(PassId pass, const PortDesc& port) const;
    // Reports that the port cannot depend on switches, or that it has nothing to read in the combinations
    // `absent`.
    void report_switched_off(PassId pass, const PortDesc& port, CombinationSet absent) const;

 private:
    // An output that writes a resource.
    struct Writer {
        PassId pass;
        const UseDecl* use = nullptr;
    };

    // Reports that neither the reference nor the "else" of the port has something to read in the combinations
    // `absent`.
    void report_replacement_off(const PassDraft& draft, PassId pass, const PortDesc& port,
                                CombinationSet absent) const;
    // Returns the names of all passes that write a resource, except the pass `except` and the other passes of
    // its repeat.
    [[nodiscard]] std::set<std::string> writers_of(const std::string& resource, PassId except) const;

    const Declared& declared_;
    const BoundPorts& outputs_;
    std::vector<std::vector<Writer>> writers_;  // Indexed by ResourceId, in the order of the passes.
    const Suspects& suspects_;
    PassReporter& report_;
    Reporter& reporter_;
};

}  // namespace weft
