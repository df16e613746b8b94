#include "offline_graph.h"

#include "check/check_plan.h"
#include "files.h"
#include "render/import_catalog.h"
#include "shader/load_graph.h"
#include "weft/compile.h"
#include "weft/registry.h"

namespace weft::viewer {

Result<FramePlan> compile_offline(const std::string& file, const DeviceProfile& profile, Extent3D size,
                                  const std::map<std::string, double>& params, Diagnostics& warnings) {
    const PassCatalog passes = registered_passes();
    const ImportCatalog imports = render::scene_imports(size);
    Result<LoadedGraph> loaded = load_graph({file,
                                             read_file,
                                             shipped_root() / "shaders",
                                             shader_cache(),
                                             passes,
                                             imports,
                                             profile,
                                             size,
                                             params,
                                             {}},
                                            warnings);
    if (!loaded) return loaded.take_errors();
    CompileOptions options;
    options.granularity_bytes = profile.buffer_image_granularity_bytes;
    FramePlan plan = compile(loaded->graph, content_needs(loaded->graph), options);
    Diagnostics faults = check_plan(plan);
    if (!faults.empty()) return faults;
    return plan;
}

}  // namespace weft::viewer
