// Purpose: random graphs as texts, so that all of the way from JSON to a plan is tested: repeats (mip chains
// down and up, nested, backwards, empty, spread over frames), partial writes, conditions with parameters
// drawn at random, `else` and optional ports, writers in place that are left out, history, kept content,
// parts of images, `after`, hints at queues, and every type of pass but C++ ones. resolve() must accept each
// of them.
//
// Nothing in a text has a place in an order, so passes and resources are written in any. The generator makes
// passes one after the other, and each reads versions that are there; what a text says about order (pins,
// `after`) follows from that.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "weft/declaration.h"
#include "weft/result.h"

namespace weft::test {

struct RandomText {
    std::string text;
    // The same graph without conditions, as the generator understands them: passes whose `if` is false are
    // not there, `else` stands in the place of what it replaces, optional ports that nobody fills are gone,
    // and repeats have numbers for bounds.
    std::string plain;
    std::map<std::string, double> params;  // overrides, for both
    bool left_out = false;  // some `if` is false, and a pass is missing for it or a port reads something else
};

[[nodiscard]] RandomText random_text(uint32_t seed);

// The same with one fault in it, which resolve() must report, alone.
struct FaultyText {
    std::string text;
    std::map<std::string, double> params;
    std::string code;  // of the diagnostic: "W110"
    std::string how;   // what was done
};
[[nodiscard]] FaultyText random_faulty_text(uint32_t seed);

// Against shaders and imports of the generator's own.
[[nodiscard]] Result<ResolvedGraph> resolve_text(const std::string& text,
                                                 const std::map<std::string, double>& params,
                                                 const DeviceProfile& profile);

}  // namespace weft::test
