// Purpose: compiles and checks a graph without a device, for commands that do not need one. A profile
// replaces the device and gives the memory requirements of resources. Errors: those of the graph, of the
// profile (W140, W141) and of the checker. Warning W142: the plan needs more memory than the profile's device
// has.
#pragma once

#include <optional>
#include <string>

#include "shader/shader_memory.h"
#include "viewer/options/options.h"
#include "weft/device_profile.h"
#include "weft/load/load_graph.h"
#include "weft/plan.h"
#include "weft/result.h"
#include "weft/syntax/json_doc.h"

namespace weft::viewer {

struct OfflinePlan {
    FramePlan plan;
    DeviceProfile profile;
    Diagnostics view_faults;  // faults in the "debug" section; a view may show a resource that only another
                              // tier has
};

// Data that all tiers of one document share; the first compilation fills it.
struct SharedByTiers {
    ShaderMemory shaders;
    std::optional<SkippedFormats> formats;
};

[[nodiscard]] Result<JsonDoc> read_offline(const std::string& file, const OfflineOptions& options);
[[nodiscard]] Result<OfflinePlan> compile_offline(const JsonDoc& document, const OfflineOptions& options,
                                                  Diagnostics& warnings, SharedByTiers* shared = nullptr);
[[nodiscard]] Result<OfflinePlan> compile_offline(const std::string& file, const OfflineOptions& options,
                                                  Diagnostics& warnings);

}  // namespace weft::viewer
