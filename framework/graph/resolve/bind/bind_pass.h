// Purpose: binds the ports of one pass after the references of all ports are bound. Private to bind().
#pragma once

#include <optional>
#include <string>

#include "graph/resolve/bind.h"

namespace weft {

// The pass that is being bound; the argument of the functions below.
struct PassBinding {
    const Declared& declared;
    PassId id;
    const PassDraft& draft;
    // Evaluates expressions with the values of the indices of this pass's repeat.
    Evaluator evaluator;
    BoundPass& bound;
    Suspects& suspects;
    PassReporter& report;
    // Used only for warnings; errors of the pass go to `report`.
    Reporter& reporter;

    Diagnostic& error(SourceLoc loc, std::string code, std::string message) {
        return report.error(id, loc, std::move(code), std::move(message));
    }
};

// Returns the parts of `bound` that belong to the pass `id`. Keeps references to all arguments.
[[nodiscard]] PassBinding pass_binding(const Declared& declared, PassId id, BoundPasses& bound,
                                       PassReporter& report, Reporter& reporter);

// Matches the ports of a pass by name with the bindings and fragment outputs of its shader, and reports ports
// and bindings without a counterpart. The way in which the shader uses a binding determines the access of the
// port. Errors: W112, W165, W170, W171, W173, W182, W196, W232.
void bind_shader_ports(PassBinding& pass);
// Binds the ports of clear, copy, blit and readback passes, whose ports have fixed meanings. Errors: W175.
void bind_fixed_ports(PassBinding& pass);
// Binds the ports of a C++ pass, which its pass type declares. Errors: W176.
void bind_custom_ports(PassBinding& pass);
// Gives the specialisation constants of the shader their values. Errors: W113.
void bind_constants(PassBinding& pass);
// Binds the draw lists of a raster pass. If the pass has no draw lists, evaluates its number of vertices and
// its number of instances. Errors: W114, W118, W167.
void bind_draws(PassBinding& pass);
// A view that the shader of a pass reads from a buffer.
struct BufferView {
    const PortDesc* port = nullptr;  // Names the buffer.
    uint32_t element = 0;
};
// Finds the view that the pass uses, and checks that the program offers it. Returns the view if the shader
// reads it from a buffer. Errors: W109, W118.
std::optional<BufferView> bind_view(PassBinding& pass);
// Selects an element of a buffer as the view of a pass. Returns false after reporting an error. Errors: W230.
[[nodiscard]] bool select_view_element(PassBinding& pass, const BufferView& view, UseDecl& use);
// Returns the block with the constants of the view; null if the shader does not read this block.
[[nodiscard]] const ShaderBinding* find_view_block(const ShaderInterface& shader);
// Checks the requirements of a shader besides ports and parameters. The shader may use only descriptors that
// the program binds, it must write gl_PointSize if the pass draws points, and it should state its local size.
// Errors: W185, W186. Warnings: W137.
void check_shader_fit(PassBinding& pass);

}  // namespace weft
