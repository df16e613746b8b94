// Purpose: the stage of resolve() that binds ports: references become resources, ranges and pins; each port
// meets what the shader or the pass type declares under its name, which says how it is accessed. Draw lists,
// views and specialisation constants are bound too.
// Errors: W103 to W106, W109, W110, W112 to W114, W118, W121 to W123, W165, W167, W168, W170, W171, W173,
// W175, W176, W182, W185, W186. Warnings: W137.
#pragma once

#include <string>
#include <vector>

#include "graph/resolve/declared.h"

namespace weft {

// How a write treats the content that was there before.
enum class WriteRank : uint8_t {
    fresh,     // makes a new version: nothing of the old content is seen
    resumes,   // continues a preceding version if this frame has one (a loaded attachment, a read-write
               // buffer)
    in_place,  // modifies the previous version
};

// Facts about a use beyond its UseDecl.
struct PortDraft {
    const PortDesc* desc = nullptr;
    const ShaderBinding* binding = nullptr;       // in set 1
    const StageVariable* color_output = nullptr;  // colour attachments
    std::vector<PassId> pins;  // `@pass`: all passes of that name, in the order of their repeat
    WriteRank rank = WriteRank::fresh;
    bool is_depth_port = false;
    bool is_resolve = false;      // receives the averages of a multisampled attachment
    bool is_indirect = false;     // contains the size of the dispatch
    bool reads_own_port = false;  // "in" and "out" both name this port: one binding, in place

    [[nodiscard]] bool pinned() const { return !pins.empty(); }
};

struct BoundPass {
    std::vector<UseDecl> uses;             // inputs first, then outputs, each in name order
    std::vector<PortDraft> ports = {};     // by use
    std::vector<std::string> absent = {};  // optional ports without a resource
    std::vector<SpecValue> spec_values = {};
    std::vector<std::string> draw_lists = {};
    uint32_t vertices = 0;  // instead of draw lists
    uint32_t instances = 0;
    std::string view = PassDecl{}.view;
    std::array<float, 4> clear{0, 0, 0, 0};
};

struct BoundPasses {
    std::vector<BoundPass> passes;  // by PassId
    Suspects suspects;
};
[[nodiscard]] BoundPasses bind(const Declared& declared, Reporter& reporter);

}  // namespace weft
