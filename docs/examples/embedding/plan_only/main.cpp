// An example of Weft without a GPU: loads a graph, compiles it for a device profile, checks the plan and
// prints the order of its passes. An executor of your own can run such a plan. Usage: plan_only
#include <weft/check/check_plan.h>
#include <weft/load/plan_graph.h>
#include <weft/registry.h>
#include <weft/render/import_catalog.h>

#include <cstdio>

#include "sample.h"

namespace {

void print_plan() {
    const std::filesystem::path data = WEFT_DATA_DIR;
    const std::string profile_path = data / "profiles" / "tiler.json";
    const std::optional<std::string> profile_text = read_file(profile_path);
    if (!profile_text) throw std::runtime_error("cannot read " + profile_path);
    const weft::DeviceProfile profile = take(weft::parse_profile(*profile_text, profile_path));

    const weft::PassCatalog passes = weft::registered_passes();
    const weft::render::SessionInput settings = session_input("deferred.json", passes);
    const weft::ImportCatalog imports = weft::render::scene_imports(kSize_px);
    const weft::JsonDoc document = take(weft::read_graph(settings.request.path, settings.load));
    weft::Diagnostics warnings;
    constexpr uint32_t kQueues = 1;
    const weft::PlannedGraph planned = take(weft::plan_graph(document,
                                                             {.request = settings.request,
                                                              .settings = settings.load,
                                                              .passes = passes,
                                                              .imports = imports,
                                                              .profile = profile},
                                                             kQueues, warnings));
    const weft::Diagnostics faults = weft::check_plan(planned.plan);
    if (!faults.empty()) throw std::runtime_error(weft::to_text(faults));

    // A menu can show this: the quality tiers of the graph, and its parameters.
    for (const weft::TierDesc& tier : planned.loaded.desc.tiers) std::printf("tier %s\n", tier.name.c_str());
    for (const auto& [name, param] : planned.loaded.desc.params)
        std::printf("parameter %s, default %g %s\n", name.c_str(), param.default_value, param.unit.c_str());

    const weft::FramePlan& plan = planned.plan;
    for (const weft::PassId pass : plan.schedule.order)
        std::printf("%s\n", plan.graph.passes[pass].name.c_str());
    std::printf("%llu bytes of transient memory, %zu barriers at the end of the frame\n",
                static_cast<unsigned long long>(plan.memory.heap_bytes), plan.barriers.epilogue.size());
}

}  // namespace

int main() {
    try {
        print_plan();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "plan_only: %s\n", error.what());
        return 1;
    }
}
