// A graph's text through all stages: read, merge, parse, resolve, compile, prove. A plan that the checker
// refuses is as much a find as a crash: the compiler promises sound plans for whatever resolve() lets
// through.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

#include "check/check_plan.h"
#include "fitting_shaders.h"
#include "graph/stages.h"
#include "weft/compile.h"
#include "weft/registry.h"

namespace weft::fuzz {
namespace {

// The compiler takes more than linear time; what larger graphs cost is the benches' concern.
constexpr size_t kMostPasses = 200;

DeviceProfile read_profile(const char* name) {
    const std::string path = std::string(WEFT_SOURCE_DIR "/framework/profiles/") + name + ".json";
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    Result<DeviceProfile> profile = parse_profile(text.str(), path);
    if (!profile) std::abort();
    return std::move(*profile);
}

const std::vector<DeviceProfile>& profiles() {
    static const std::vector<DeviceProfile> all{read_profile("lavapipe"), read_profile("tiler"),
                                                read_profile("hostile")};
    return all;
}

// The names that shipped graphs and the seeds of the corpus import.
ImportCatalog make_imports() {
    ImportCatalog catalog;
    catalog.views = {"camera", "sun"};
    catalog.strides = {{"Light", 64}, {"DrawCommand", 20}};
    const auto add = [&](const char* name, ImportKind kind) -> ResourceDecl& {
        ImportDecl& import = catalog.imports[name];
        import.name = import.resource.name = name;
        import.kind = kind;
        import.resource.lifetime = ResourceLifetime::imported;
        import.resource.import = ImportState{};
        return import.resource;
    };
    for (const char* list : {"opaque", "masked", "transparent"}) {
        add(list, ImportKind::draw_list);
        ResourceDecl& commands = add((std::string(list) + "Commands").c_str(), ImportKind::buffer);
        commands.kind = ResourceKind::buffer;
        commands.stride_bytes = 20;
        commands.size_bytes = 20;
        commands.usage = usage::kStorage | usage::kIndirect | usage::kTransferDst | usage::kTransferSrc;
    }
    ResourceDecl& output = add("backbuffer", ImportKind::output);
    output.format = Format::rgba8;
    output.extent = {320, 180, 1};
    const AccessState copied{stage::kCopy, access::kTransferRead, Layout::transfer_src};
    output.import = ImportState{{stage::kCopy, access::kTransferRead, Layout::undefined}, copied, 0};
    return catalog;
}

uint64_t hash_of(const std::string& text) {
    return std::hash<std::string>{}(text);
}

void prove(const ResolvedGraph& graph, const DeviceProfile& profile, uint32_t queues) {
    CompileOptions options;
    options.queues = logical_queues(profile, queues);
    options.granularity_bytes = profile.buffer_image_granularity_bytes;
    const Diagnostics faults = check_plan(compile(graph, profile_needs(graph, profile), options));
    if (faults.empty()) return;
    std::fputs(to_text(faults).c_str(), stderr);
    std::abort();
}

void run(const std::string& text) {
    const FileReader reader = [&](const std::string&) { return std::optional<std::string>(text); };
    Result<JsonDoc> document = read_json("graph.json", reader);
    if (!document) return;
    Result<JsonDoc> merged = merge(std::move(*document));
    if (!merged) return;
    const Result<GraphDesc> graph = parse(*merged);
    if (!graph) return;
    const uint64_t choices = hash_of(text);
    const DeviceProfile& profile = profiles()[choices % profiles().size()];
    static const ImportCatalog imports = make_imports();
    static const PassCatalog passes = registered_passes();
    const ShaderCatalog shaders = fitting_shaders(*graph, choices);
    Diagnostics warnings;
    const Result<ResolvedGraph> resolved =
        resolve({*graph, passes, shaders, imports, profile, {}, {320, 180, 1}, {}}, warnings);
    if (!resolved) {
        if (std::getenv("WEFT_FUZZ_SAY") != nullptr) std::fputs(to_text(resolved.errors()).c_str(), stderr);
        return;
    }
    if (resolved->passes.size() <= kMostPasses)
        prove(*resolved, profile, static_cast<uint32_t>(1 + choices / 8 % 4));
}

}  // namespace
}  // namespace weft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    weft::fuzz::run({reinterpret_cast<const char*>(data), size});
    return 0;
}
