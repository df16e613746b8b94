// Purpose: the stage of resolve() that binds the ports of passes. A reference of a port becomes a resource, a
// range of the resource, and the passes that `@pass` names. Most ports are matched by name with a binding or
// a fragment output of the shader, or with a port that the C++ pass type declares. This counterpart
// determines the kind of access. The role of the port determines it for all other ports: depth attachments,
// resolve targets, indirect buffers, and the ports of clear, copy, blit and readback passes. Draw lists,
// views and specialisation constants are bound too.
// Errors: W103 to W107, W109, W110, W112 to W114, W118, W121 to W123, W165, W167, W168, W170, W171, W173,
// W175, W176, W182, W185, W186, W196, W197, W230 to W232. Warnings: W137.
#pragma once

#include <string>
#include <vector>

#include "graph/resolve/declared.h"

namespace weft {

// Says how a write treats the earlier content of the resource.
enum class WriteRank : uint8_t {
    // The write replaces all content: nothing of the earlier content is seen afterwards.
    fresh,
    // The write continues an earlier version if this frame has one, for example an attachment that is loaded
    // or a buffer that is read and written. Without an earlier version, it starts from cleared or undefined
    // content.
    resumes,
    // The write changes a part of the previous version, and the rest of that version stays visible.
    in_place,
};

// Information about the use of a port that later stages need but UseDecl does not contain.
struct PortDraft {
    const PortDesc* desc = nullptr;
    // The shader's binding in descriptor set 1 that the port is bound to. Null if the port has no binding, as
    // for attachments, indirect buffers and passes without a shader.
    const ShaderBinding* binding = nullptr;
    // If the port is a colour attachment: the fragment output of the shader. Otherwise null.
    const StageVariable* color_output = nullptr;
    // The passes that `@pass` in the reference names. The port uses the version of the resource after these
    // passes. If the named pass has a repeat, `pins` contains all passes of the repeat, in their order. If
    // the reference contains no `@pass`, `pins` is empty.
    std::vector<PassId> pins;
    WriteRank rank = WriteRank::fresh;
    bool is_depth_port = false;
    // True if the port receives the averaged samples of a multisampled attachment.
    bool is_resolve = false;
    // True if the port is the buffer with the group counts of an indirect dispatch or with indirect draw
    // commands.
    bool is_indirect = false;
    // True if the port is the buffer with the number of indirect draws.
    bool is_draw_count = false;
    // True if the port selects one element of a buffer, and this element contains the constants of the view.
    bool is_view = false;
    // The combinations of switch values in which the content that the port reads is valid. Content is valid
    // if a pass of this frame has written it, or if the reference asks for content from before this frame.
    CombinationSet valid_in = kEveryCombination;
    // True if "in" and "out" both name this port. The port then has one binding, and the shader reads and
    // writes the resource in place.
    bool reads_own_port = false;

    [[nodiscard]] bool pinned() const { return !pins.empty(); }
};

struct BoundPass {
    // The bound ports: inputs first, then outputs, each group sorted by name.
    std::vector<UseDecl> uses;
    // Further information about each use; ports[i] belongs to uses[i].
    std::vector<PortDraft> ports = {};
    // Names of the optional ports that have no resource.
    std::vector<std::string> absent = {};
    std::vector<SpecValue> spec_values = {};
    std::vector<std::string> draw_lists = {};
    // Number of vertices per instance, for raster passes without draw lists. Otherwise 0.
    uint32_t vertices = 0;
    uint32_t instances = 0;
    std::string view = PassDecl{}.view;
    std::vector<std::string> views = {};  // As PassDecl::views.
    std::array<float, 4> clear{0, 0, 0, 0};
};

struct BoundPasses {
    // The bound ports of each pass, indexed by PassId.
    std::vector<BoundPass> passes;
    Suspects suspects;
    // ResourceDecl::cuts_bytes of each resource, indexed by ResourceId. Empty: no buffer is divided.
    std::vector<std::vector<uint64_t>> cuts_bytes = {};
};
[[nodiscard]] BoundPasses bind(const Declared& declared, Reporter& reporter);

}  // namespace weft
