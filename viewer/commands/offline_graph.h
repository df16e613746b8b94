// Purpose: compiles and checks a graph without a device. A device profile (properties of a device as data)
// replaces the device and gives the memory requirements of resources. Errors: those of the graph, of the
// profile (W140, W141) and of the plan checker. Warning W142: the plan needs more memory than the device of
// the profile has.
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
    ShaderCatalog shaders;
    DeviceProfile profile;
    // Errors in the "debug" section. They are separate, because a view may show a resource that only another
    // tier has.
    Diagnostics view_faults;
};

// Data that all tiers of one document share, so that they are computed only once. compile_offline() fills the
// fields.
struct SharedByTiers {
    ShaderMemory shaders;
    // The result of common_formats(); absent before the first compilation, or if the request sets parameters.
    std::optional<SkippedFormats> formats;
};

[[nodiscard]] Result<JsonDoc> read_offline(const std::string& file, const OfflineOptions& options);
[[nodiscard]] Result<OfflinePlan> compile_offline(const JsonDoc& document, const OfflineOptions& options,
                                                  Diagnostics& warnings, SharedByTiers* shared = nullptr);
[[nodiscard]] Result<OfflinePlan> compile_offline(const std::string& file, const OfflineOptions& options,
                                                  Diagnostics& warnings);

}  // namespace weft::viewer
