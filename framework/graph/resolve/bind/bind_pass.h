// Purpose: binds the ports of one pass once their references are known. Private to bind().
#pragma once

#include <string>

#include "graph/resolve/bind.h"

namespace weft {

inline constexpr uint32_t kPortSet = 1;  // the descriptor set of a pass's ports

// The arguments of the functions below.
struct PassBinding {
    const Declared& declared;
    PassId id;
    const PassDraft& draft;
    Evaluator evaluator;  // contains the indices of the pass
    BoundPass& bound;
    Suspects& suspects;
    PassReporter& report;
    Reporter& reporter;  // for warnings

    Diagnostic& error(SourceLoc loc, std::string code, std::string message) {
        return report.error(id, loc, std::move(code), std::move(message));
    }
};

// Ports meet the shader's bindings and fragment outputs by name; both directions are checked. The shader's
// use of a binding decides the port's access. Errors: W112, W165, W170, W171, W173, W182.
void bind_shader_ports(PassBinding& pass);
// Clear, copy and readback, whose ports have fixed meanings. Errors: W175.
void bind_fixed_ports(PassBinding& pass);
// C++ passes, whose type declares the ports. Errors: W176.
void bind_custom_ports(PassBinding& pass);
// Specialisation constants. Errors: W113.
void bind_constants(PassBinding& pass);
// The draw lists of a raster pass, or the number of vertices. Errors: W114, W118, W167.
void bind_draws(PassBinding& pass);
// One of the views that the program offers. Errors: W109, W118.
void bind_view(PassBinding& pass);
// A shader's needs beyond ports and parameters: descriptors that the program binds, a size for points, a
// local size. Errors: W185, W186. Warnings: W137.
void check_shader_fit(PassBinding& pass);

}  // namespace weft
