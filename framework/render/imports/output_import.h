// Purpose: the import "backbuffer" for an output image of another format or final layout than the default.
// Errors: V424 the output cannot have this format or final layout, V425 a pass uses the output in a way that
// the format does not support.
#pragma once

#include "weft/device_profile.h"
#include "weft/graph_request.h"
#include "weft/imports.h"
#include "weft/plan.h"
#include "weft/result.h"

namespace weft::render {

[[nodiscard]] Status check_output(const OutputFormat& output, const DeviceProfile& profile);
// Gives the import "backbuffer" of the catalogue the size and the format of the output.
void set_output(ImportCatalog& catalog, const GraphRequest& request, const DeviceProfile& profile);
// Returns an error for each pass that uses the output in a way that its image does not allow.
[[nodiscard]] Diagnostics find_output_faults(const FramePlan& plan, const OutputFormat& output,
                                             const DeviceProfile& profile);

}  // namespace weft::render
