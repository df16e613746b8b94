// Purpose: makes random graphs as JSON texts, to test all stages from JSON to a plan. resolve() must accept
// each RandomText. The texts contain:
// - repeats: over the mips of an image, nested, backwards, without iterations, and spread over frames;
// - conditions that depend on random parameters, inputs with `else`, and optional inputs;
// - passes that write a part of a resource, or modify a resource in place;
// - history, kept content, `after` lists and queue hints;
// - passes that sample a table of textures;
// - passes that draw all views of a list, into layers or rectangles; the lists come from the program, a
//   buffer or a cube, or are mirrors;
// - arrays of mips or layers, indirect dispatches and draws, samplers, and resources with files;
// - every type of pass except C++ passes.
//
// The order of the passes in a text has no meaning, so a text lists its passes in random order. The generator
// makes passes one after another, and each pass reads versions that exist already. Pins ("image@pass") and
// `after` lists in the text state this order.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "weft/declaration.h"
#include "weft/graph_request.h"
#include "weft/result.h"

namespace weft::test {

struct RandomText {
    std::string text;
    // The same graph after the generator has evaluated all conditions. Passes with a false `if` are removed
    // (exception: TextPass::stays). Inputs without content are removed, or replaced with their `else` inputs.
    // The bounds of repeats contain no parameters. A pass that draws all views of a list is a repeat with one
    // view.
    std::string plain;
    // Values of some parameters, by name, for `text` and for `plain`. The other parameters keep their
    // defaults.
    std::map<std::string, double> params;
    // True if a false `if` has removed a pass or an iteration of a repeat, or has changed an input.
    bool omitted = false;
};

// The text uses only optional features that the device supports, such as anisotropic filtering.
[[nodiscard]] RandomText random_text(uint32_t seed, const DeviceProfile& profile);

// A random text with one fault. resolve() must report this fault and no other.
struct FaultyText {
    std::string text;
    std::map<std::string, double> params;
    // Code of the expected diagnostic, such as "W110".
    std::string code;
    // Description of the fault, shown if the test fails.
    std::string how;
};
[[nodiscard]] FaultyText random_faulty_text(uint32_t seed, const DeviceProfile& profile);

// Resolves the text with the shaders, imports and files that the random texts use. `output_px` is the side of
// the output.
[[nodiscard]] Result<ResolvedGraph> resolve_text(const std::string& text,
                                                 const std::map<std::string, double>& params,
                                                 const DeviceProfile& profile, uint32_t output_px = 64,
                                                 const std::map<std::string, ExportUse>& exports = {});
// Resolves a graph that contains only an instance of the text as a module named "m". So all names of the text
// begin with "m::".
[[nodiscard]] Result<ResolvedGraph> resolve_as_module(const std::string& text,
                                                      const std::map<std::string, double>& params,
                                                      const DeviceProfile& profile);

}  // namespace weft::test
