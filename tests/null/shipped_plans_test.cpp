// Tests that the plans of the shipped graphs give the expected results on one to three queues. Also tests the
// checker with mutants of these plans (see mutant_judge.h), and prints how many removed parts were redundant.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "null/null_executor.h"
#include "tests/null/mutant_judge.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"
#include "weft/load/load_graph.h"
#include "weft/registry.h"
#include "weft/render/import_catalog.h"

namespace weft::test {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> read_text(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) return std::nullopt;
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<std::string> shipped_graphs() {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(WEFT_SOURCE_DIR) / "graphs"))
        if (entry.path().extension() == ".json" &&
            entry.path().string().find(".schema.") == std::string::npos)
            found.push_back(entry.path().string());
    std::sort(found.begin(), found.end());
    return found;
}

// `probes`: the light probes of the scene; null: one of each kind.
Result<LoadedGraph> load(const std::string& file, const scene::Probes* probes) {
    const std::string profile_file = WEFT_SOURCE_DIR "/framework/profiles/lavapipe.json";
    Result<DeviceProfile> profile = parse_profile(read_text(profile_file).value_or(""), profile_file);
    if (!profile) return profile.take_errors();
    const PassCatalog passes = registered_passes();
    const ImportCatalog imports = render::scene_imports({1280, 720, 1}, nullptr, probes);
    Diagnostics warnings;
    LoadSettings settings;
    settings.reader = read_text;
    settings.graph_root = WEFT_SOURCE_DIR "/graphs";
    settings.shader_root = WEFT_SOURCE_DIR "/shaders";
    const GraphRequest request{.path = file};
    const Result<ParsedGraph> parsed = parse_graph(request, settings);
    if (!parsed) return parsed.errors();
    return load_graph(
        *parsed,
        {.request = request, .settings = settings, .passes = passes, .imports = imports, .profile = *profile},
        warnings);
}

CompileOptions on_queues(uint32_t count) {
    DeviceProfile profile;
    profile.queue_families = {{QueueKind::graphics, 1}, {QueueKind::compute, 2}, {QueueKind::transfer, 1}};
    CompileOptions options;
    options.queues = logical_queues(profile, count);
    return options;
}

// Runs the plans for one to three queues, and judges every seventh of their mutants, or all with
// WEFT_EXTENDED. The null executor runs every `stride`th of the mutants that the checker rejects.
void expect_sound(const std::string& file, const LoadedGraph& loaded, uint32_t stride) {
    for (const uint32_t queues : {1u, 2u, 3u}) {
        SCOPED_TRACE(file + " on " + std::to_string(queues) + " queues");
        const FramePlan plan = compile(loaded.graph, content_needs(loaded.graph), on_queues(queues));
        const NullRun wanted = run_reference(plan.graph, plan.live);
        ASSERT_FALSE(wanted.observed.empty());
        const NullRun found = run_null(plan);
        EXPECT_TRUE(found.faults.empty()) << found.faults.front();
        const std::vector<std::string> different = differences(plan.graph, wanted, found);
        EXPECT_TRUE(different.empty()) << different.front();
        Tallies tallies;
        judge_mutants(plan, stride, tallies, std::getenv("WEFT_EXTENDED") != nullptr ? 1 : 7);
        std::cout << fs::path(file).filename().string() << " on " << queues << " queues\n";
        print(tallies);
    }
}

TEST(ShippedPlans, GiveWhatTheyMeanAndNeedWhatTheyWaitFor) {
    const std::vector<std::string> files = shipped_graphs();
    ASSERT_FALSE(files.empty());
    const scene::Probes none;
    for (const std::string& file : files) {
        const Result<LoadedGraph> loaded = load(file, &none);
        ASSERT_TRUE(loaded.ok()) << to_text(loaded.errors());
        expect_sound(file, *loaded, 1);
    }
}

// All graphs that light surfaces have the same passes for probes, so one of them stands for all.
TEST(ShippedPlans, OfAGraphWithProbesToo) {
    const std::string file = WEFT_SOURCE_DIR "/graphs/deferred.json";
    const Result<LoadedGraph> loaded = load(file, nullptr);
    ASSERT_TRUE(loaded.ok()) << to_text(loaded.errors());
    EXPECT_NE(loaded->graph.groups.size(), 0u);
    expect_sound(file, *loaded, 64);
}

}  // namespace
}  // namespace weft::test
