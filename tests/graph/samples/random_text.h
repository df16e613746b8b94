// Purpose: random graphs as JSON texts, to test all stages from JSON to a plan: repeats (mip chains down and
// up, nested, backwards, empty, spread over frames), partial writes, conditions with random parameters,
// `else` and optional ports, conditional in-place writers, history, kept content, parts of images, `after`,
// queue hints, and every type of pass except C++ ones. resolve() must accept all of them.
//
// The order in a text has no meaning, so passes and resources are written in random order. The generator
// makes passes one after another, and each reads existing versions; the pins and `after` in the text express
// this order.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "weft/declaration.h"
#include "weft/result.h"

namespace weft::test {

struct RandomText {
    std::string text;
    // The same graph with all conditions evaluated by the generator: passes with a false `if` are removed,
    // `else` replaces its input, unconnected optional ports are removed, and repeats have numeric bounds.
    std::string plain;
    std::map<std::string, double> params;  // parameter values for both texts
    bool left_out = false;                 // some `if` is false and this removed a pass or changed an input
};

[[nodiscard]] RandomText random_text(uint32_t seed);

// The same text with one fault, which must be the only one that resolve() reports.
struct FaultyText {
    std::string text;
    std::map<std::string, double> params;
    std::string code;  // code of the diagnostic: "W110"
    std::string how;   // description of the fault
};
[[nodiscard]] FaultyText random_faulty_text(uint32_t seed);

// Resolves with shaders and imports made by the generator.
[[nodiscard]] Result<ResolvedGraph> resolve_text(const std::string& text,
                                                 const std::map<std::string, double>& params,
                                                 const DeviceProfile& profile);

}  // namespace weft::test
