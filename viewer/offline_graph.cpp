#include "offline_graph.h"

#include "check/check_plan.h"
#include "files.h"
#include "graph/memory_report.h"
#include "render/import_catalog.h"
#include "shader/load_graph.h"
#include "weft/compile.h"
#include "weft/registry.h"

namespace weft::viewer {

Result<OfflinePlan> compile_offline(const std::string& file, const OfflineOptions& options,
                                    Diagnostics& warnings) {
    Result<DeviceProfile> profile = load_profile(options.profile);
    if (!profile) return profile.take_errors();
    const PassCatalog passes = registered_passes();
    const ImportCatalog imports = render::scene_imports(options.size);
    Result<LoadedGraph> loaded = load_graph({file,
                                             reader_up_to(options.limits.graph.json_bytes),
                                             shipped_root() / "shaders",
                                             shader_cache(),
                                             passes,
                                             imports,
                                             *profile,
                                             options.size,
                                             options.params,
                                             {},
                                             find_shader_worker(),
                                             options.limits},
                                            warnings);
    if (!loaded) return loaded.take_errors();
    CompileOptions compile_options;
    compile_options.granularity_bytes = profile->buffer_image_granularity_bytes;
    compile_options.queues = logical_queues(*profile, options.queues);
    OfflinePlan made{compile(loaded->graph, profile_needs(loaded->graph, *profile), compile_options),
                     std::move(*profile)};
    Diagnostics faults = budget_faults(made.plan, options.limits.graph, file);
    if (faults.empty()) faults = check_plan(made.plan);
    if (!faults.empty()) return faults;
    const Diagnostics tight = memory_faults(made.plan, made.profile, file);
    warnings.insert(warnings.end(), tight.begin(), tight.end());
    return made;
}

}  // namespace weft::viewer
