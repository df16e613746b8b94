// Takes a graph through all stages: read it with its includes, merge a tier, parse, resolve, compile and
// check. The input is the text of the graph; a line "=== NAME" begins an included file of that name. If the
// checker rejects the plan, the compiler has a bug, because it must make a correct plan for every graph that
// resolve() accepts.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

#include "graph/parse/parse.h"
#include "graph/resolve/resolve.h"
#include "graph/syntax/merge.h"
#include "graph/syntax/read_graph.h"
#include "tests/fuzz/fitting_shaders.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"
#include "weft/registry.h"

namespace weft::fuzz {
namespace {

// Larger graphs are not compiled, because the compile time grows faster than linearly. Benchmarks cover the
// cost of larger graphs.
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
                                                read_profile("hostile"), read_profile("discrete")};
    return all;
}

// Returns the imports that the shipped graphs and the seeds of the corpus use.
ImportCatalog make_imports() {
    ImportCatalog catalog;
    catalog.views = {"camera", "sun"};
    catalog.strides = {{"Light", 64}, {"DrawCommand", 20}, {"ViewConstants", 512}};
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
    catalog.imports["materialTextures"] = texture_table("materialTextures", 9);
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
    const Diagnostics faults =
        check_plan(compile(graph, profile_needs(graph, profile), compile_options(profile, queues)));
    if (faults.empty()) return;
    std::fputs(to_text(faults).c_str(), stderr);
    std::abort();
}

// Texts of the graph files by file name.
using Files = std::map<std::string, std::string>;

constexpr const char* kGraph = "graph.json";

Files split(const std::string& text) {
    Files files;
    std::string name = kGraph;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("=== "))
            name = line.substr(4);
        else
            files[name] += line + "\n";
    }
    return files;
}

void run_tier(const JsonDoc& document, const std::string& tier, uint64_t choices) {
    Result<JsonDoc> merged = merge(document, tier);
    if (!merged) return;
    const Result<GraphDesc> graph = parse(*merged);
    if (!graph) return;
    const DeviceProfile& profile = profiles()[choices % profiles().size()];
    static const ImportCatalog imports = make_imports();
    static const PassCatalog passes = registered_passes();
    const ShaderCatalog shaders = fitting_shaders(*graph, choices);
    Diagnostics warnings;
    const Result<ResolvedGraph> resolved =
        resolve({*graph, passes, shaders, imports, profile, {.size = {320, 180, 1}}}, warnings);
    if (!resolved) {
        if (std::getenv("WEFT_FUZZ_SAY") != nullptr) std::fputs(to_text(resolved.errors()).c_str(), stderr);
        return;
    }
    if (resolved->passes.size() <= kMostPasses)
        prove(*resolved, profile, static_cast<uint32_t>(1 + choices / 8 % 4));
}

void run(const std::string& text) {
    const Files files = split(text);
    const FileReader reader = [&](const std::string& path) {
        const auto file = files.find(path);
        return file == files.end() ? std::nullopt : std::optional(file->second);
    };
    const Result<JsonDoc> document = read_graph(kGraph, reader);
    if (!document) {
        if (std::getenv("WEFT_FUZZ_SAY") != nullptr) std::fputs(to_text(document.errors()).c_str(), stderr);
        return;
    }
    const uint64_t choices = hash_of(text);
    const std::vector<std::string> tiers = tier_names(*document);
    run_tier(*document, tiers.empty() ? "" : tiers[choices / 32 % tiers.size()], choices);
}

}  // namespace
}  // namespace weft::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    weft::fuzz::run({reinterpret_cast<const char*>(data), size});
    return 0;
}
