#include "viewer/commands/offline_graph.h"

#include "graph/parse/debug_view.h"
#include "viewer/commands/load_settings.h"
#include "viewer/files/files.h"
#include "viewer/options/import_texts.h"
#include "weft/check/check_plan.h"
#include "weft/load/plan_graph.h"
#include "weft/registry.h"
#include "weft/render/import_catalog.h"
#include "weft/report/memory_report.h"

namespace weft::viewer {
namespace {

Diagnostics of_tier(Diagnostics faults, const std::string& tier) {
    for (Diagnostic& fault : faults) fault.tier = tier;
    return faults;
}

// Some errors say that the program does not offer an import. Adds a help line that tells how to describe such
// an import.
Diagnostics with_import_help(Diagnostics faults) {
    for (Diagnostic& fault : faults) {
        const bool is_unknown =
            fault.code == "W118" && fault.message.starts_with("the program does not offer");
        if (!is_unknown || fault.help.front().starts_with("did you mean")) continue;
        const std::string name = fault.pointer.substr(fault.pointer.rfind('/') + 1);
        fault.help.emplace_back(
            "if your program offers it, describe it, for example as a draw list: --import " + name +
            "=drawlist:position,normal");
    }
    return faults;
}

Result<PlannedGraph> plan_offline(const JsonDoc& document, const OfflineOptions& options,
                                  const DeviceProfile& profile, Diagnostics& warnings,
                                  SharedByTiers* shared) {
    const PassCatalog passes = registered_passes();
    ImportCatalog imports = render::scene_imports(options.request.size);
    add_imports(options.imports, imports);
    const LoadSettings settings = load_settings(options.limits, options.graph_path);
    LoadInput input{.request = options.request,
                    .settings = settings,
                    .passes = passes,
                    .imports = imports,
                    .profile = profile};
    input.request.path = document.sources.files.front().path;
    input.compares_tiers = shared != nullptr;
    if (shared != nullptr) {
        input.memory = &shared->shaders;
        if (!shared->formats && options.request.params.empty())
            shared->formats = common_formats(document, input);
        if (shared->formats) input.common_formats = &*shared->formats;
    }
    return plan_graph(document, input, options.queues, warnings);
}

}  // namespace

Result<JsonDoc> read_offline(const std::string& file, const OfflineOptions& options) {
    return read_graph(file, load_settings(options.limits, options.graph_path));
}

Result<OfflinePlan> compile_offline(const JsonDoc& document, const OfflineOptions& options,
                                    Diagnostics& warnings, SharedByTiers* shared) {
    Result<DeviceProfile> profile = load_profile(options.profile);
    if (!profile) return profile.take_errors();
    Result<PlannedGraph> planned = plan_offline(document, options, *profile, warnings, shared);
    if (!planned) return with_import_help(planned.take_errors());
    const LoadedGraph& loaded = planned->loaded;
    OfflinePlan made{std::move(planned->plan), loaded.shaders, std::move(*profile), {}};
    // Check the debug views only if the graph has an output. A graph without an output is a module that other
    // graphs include, and those graphs may declare the resources that the views show.
    if (loaded.graph.output != kNoId)
        made.view_faults = of_tier(debug_view_faults(loaded.desc), options.request.tier);
    for (Diagnostic& d : made.view_faults) d.pointer = pointer_at(document, d.file, d.line, d.column);
    const std::string& file = document.sources.files.front().path;
    Diagnostics faults = budget_faults(made.plan, options.limits.graph, file);
    if (faults.empty()) faults = check_plan(made.plan);
    if (!faults.empty()) return of_tier(std::move(faults), options.request.tier);
    const Diagnostics tight = of_tier(memory_faults(made.plan, made.profile, file), options.request.tier);
    warnings.insert(warnings.end(), tight.begin(), tight.end());
    return made;
}

Result<OfflinePlan> compile_offline(const std::string& file, const OfflineOptions& options,
                                    Diagnostics& warnings) {
    const Result<JsonDoc> document = read_offline(file, options);
    return document ? compile_offline(*document, options, warnings) : document.errors();
}

}  // namespace weft::viewer
