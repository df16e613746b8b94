// Purpose: makes random graphs as JSON texts, to test all stages from JSON to a plan. The texts contain
// repeats (mip chains downwards and upwards, nested, backwards, empty, spread over frames), partial writes,
// conditions with random parameters, `else` inputs and optional ports, conditional in-place writers, history,
// kept content, parts of images, `after`, queue hints, and every type of pass except C++ passes. resolve()
// must accept all texts.
//
// The order of declarations in a graph has no meaning, so a text lists passes and resources in random order.
// The generator makes passes one after another, and each pass reads versions that exist already. Pins
// ("image@pass") and `after` lists in the text tell resolve() this order.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "weft/declaration.h"
#include "weft/result.h"

namespace weft::test {

struct RandomText {
    std::string text;
    // The same graph after the generator has evaluated all conditions. Passes with a false `if` are removed.
    // Inputs without content are removed, or replaced with their `else` inputs. Repeats have numeric bounds.
    std::string plain;
    // Values of the parameters by name, for `text` and for `plain`.
    std::map<std::string, double> params;
    // True if a false `if` has removed a pass or changed an input.
    bool omitted = false;
};

[[nodiscard]] RandomText random_text(uint32_t seed);

// A random text with one fault. resolve() must report this fault and no other.
struct FaultyText {
    std::string text;
    std::map<std::string, double> params;
    // Code of the expected diagnostic, such as "W110".
    std::string code;
    // Description of the fault, shown if the test fails.
    std::string how;
};
[[nodiscard]] FaultyText random_faulty_text(uint32_t seed);

// Resolves the text with the shaders and imports that the random texts use.
[[nodiscard]] Result<ResolvedGraph> resolve_text(const std::string& text,
                                                 const std::map<std::string, double>& params,
                                                 const DeviceProfile& profile);

}  // namespace weft::test
