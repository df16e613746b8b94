// Tests that GraphLoader does only the work that a change needs, and that its results are always those of a
// loader that loads everything from scratch. No test needs a Vulkan device.
#include "render/graph_loader.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/render/session/live_folder.h"
#include "weft/compile.h"
#include "weft/render/import_catalog.h"

namespace weft::test {
namespace {

using render::GraphLoader;
using render::LoadedVersion;

// The result of a load, in a form that can be compared.
struct Outcome {
    // After success: the hash of the plan, the warnings, and the names of the files. After an error: the
    // errors and the warnings.
    std::string text;
    uint64_t number = 0;  // LoadedVersion::number; 0 after an error.
    std::string plan;     // The hash of the plan.
};

class GraphLoaderTest : public ::testing::Test {
 protected:
    GraphLoaderTest() { request_.path = folder_.graph(); }

    GraphLoader loader() const {
        LoadSettings settings;
        settings.reader = [](const std::string& path) -> std::optional<std::string> {
            std::ifstream in(path, std::ios::binary);
            if (!in) return std::nullopt;
            return std::string(std::istreambuf_iterator<char>(in), {});
        };
        settings.reads_disk = true;
        settings.graph_root = WEFT_SOURCE_DIR "/graphs";
        settings.shader_root = WEFT_SOURCE_DIR "/shaders";
        settings.shader_cache = WEFT_TEST_CACHE;
        return {profile_, std::move(settings), {}, render::scene_imports({64, 36, 1})};
    }

    // Loads the graph for a caller that already has the result `known`.
    Outcome load(GraphLoader& loader, const Outcome& known = {}) const {
        Diagnostics warnings;
        std::set<std::filesystem::path> files;
        const Result<LoadedVersion> loaded = loader.load(request_, nullptr, known.number, warnings, files);
        if (!loaded) return {to_text(loaded.errors()) + to_text(warnings), 0, {}};
        EXPECT_EQ(loaded->graph || loaded->values, loaded->number != known.number);
        Outcome outcome{{}, loaded->number, known.plan};
        if (loaded->graph || loaded->values) {
            const ResolvedGraph& graph = loaded->graph ? loaded->graph->graph : *loaded->values;
            outcome.plan = plan_hash(compile(graph, content_needs(graph), {}));
        }
        outcome.text = outcome.plan + to_text(warnings);
        for (const std::filesystem::path& file : files) outcome.text += "\n" + file.string();
        return outcome;
    }
    Outcome load_from_scratch() const {
        GraphLoader fresh = loader();
        return load(fresh);
    }

    // Waits long enough that the next change of a file gives it another modification time.
    static void let_files_age() { std::this_thread::sleep_for(std::chrono::milliseconds(80)); }

    LiveFolder folder_;
    GraphRequest request_{.size = {64, 36, 1}};

 private:
    const DeviceProfile profile_ = fake_profile();
};

TEST_F(GraphLoaderTest, AnUnchangedGraphIsNotReadAgain) {
    GraphLoader loader = this->loader();
    let_files_age();
    const Outcome first = load(loader);
    ASSERT_NE(first.number, 0u) << first.text;
    for (int i = 0; i < 5; ++i) {
        const Outcome again = load(loader, first);
        EXPECT_EQ(again.number, first.number);
        EXPECT_EQ(again.text, first.text);
    }
    EXPECT_EQ(loader.work().loads, 6u);
    EXPECT_EQ(loader.work().read, 1u);
    EXPECT_EQ(loader.work().resolved, 1u);
}

// A caller that has no result, or only an older one, gets the complete graph again. No file is read again.
TEST_F(GraphLoaderTest, AnUnknownGraphIsLoadedAgain) {
    GraphLoader loader = this->loader();
    let_files_age();
    const Outcome first = load(loader);
    const Outcome again = load(loader);
    EXPECT_GT(again.number, first.number);
    EXPECT_EQ(again.text, first.text);
    EXPECT_EQ(load(loader, first).text, first.text);
    EXPECT_EQ(loader.work().read, 1u);
    EXPECT_EQ(loader.work().resolved, 3u);
}

TEST_F(GraphLoaderTest, AnotherParameterOrTierReadsNoFile) {
    GraphLoader loader = this->loader();
    let_files_age();
    (void)load(loader);
    request_.params["gain"] = 2;
    EXPECT_EQ(load(loader).text, load_from_scratch().text);
    request_.tier = "low";
    EXPECT_EQ(load(loader).text, load_from_scratch().text);
    EXPECT_EQ(loader.work().read, 1u);
    EXPECT_EQ(loader.work().resolved, 3u);
}

TEST_F(GraphLoaderTest, AnotherValueResolvesNothing) {
    GraphLoader loader = this->loader();
    let_files_age();
    Outcome running = load(loader);
    for (const double gain : {2.0, 3.0, 0.5, 2.0}) {
        request_.params["gain"] = gain;
        const Outcome next = load(loader, running);
        EXPECT_GT(next.number, running.number);
        EXPECT_NE(next.text, running.text);
        EXPECT_EQ(next.text, load_from_scratch().text);
        running = next;
    }
    EXPECT_EQ(load(loader, running).number, running.number);
    EXPECT_EQ(loader.work().read, 1u);
    EXPECT_EQ(loader.work().resolved, 1u);
    EXPECT_EQ(loader.work().changed_values, 4u);
    // A value out of range is an error, as in a load from scratch. The loader keeps the last valid graph.
    request_.params["gain"] = 9;
    EXPECT_EQ(load(loader, running).text, load_from_scratch().text);
    request_.params["gain"] = 1;
    EXPECT_EQ(load(loader, running).text, load_from_scratch().text);
    EXPECT_EQ(loader.work().changed_values, 5u);
    // For another size, new values are not enough: the graph is resolved again.
    request_.size = {80, 36, 1};
    request_.params["gain"] = 3;
    EXPECT_EQ(load(loader, running).text, load_from_scratch().text);
    EXPECT_EQ(loader.work().changed_values, 5u);
}

// A file that was written shortly before it was read may change again without another modification time. So
// the loader reads such a file again.
TEST_F(GraphLoaderTest, AFreshFileIsReadAgain) {
    GraphLoader loader = this->loader();
    folder_.replace("live.json", "[0, 4]", "[0, 5]");
    (void)load(loader);
    (void)load(loader);
    EXPECT_EQ(loader.work().read, 2u);
}

TEST_F(GraphLoaderTest, EveryKindOfChangeIsNoticed) {
    GraphLoader loader = this->loader();
    const auto expect_read = [&](const char* what) {
        let_files_age();
        const uint64_t before = loader.work().read;
        const Outcome outcome = load(loader);
        EXPECT_EQ(loader.work().read, before + 1) << what;
        EXPECT_EQ(outcome.text, load_from_scratch().text) << what;
    };
    expect_read("the first load");
    folder_.replace("live.json", "0.5", "0.6", LiveFolder::Way::in_place);
    expect_read("the graph is written in place, with the same size");
    folder_.replace("count.json", "\"version\"", " \"version\"", LiveFolder::Way::rename);
    expect_read("an included file is replaced");
    folder_.replace("tint.glsl", "0.75", "0.25", LiveFolder::Way::in_place);
    expect_read("an include of a shader changes");
    folder_.remove("tint.glsl");
    expect_read("a file of a shader is removed");
    folder_.restore();
    expect_read("the file is back");
    std::filesystem::last_write_time(folder_.path("show.frag"),
                                     std::filesystem::file_time_type::clock::now());
    expect_read("a file is touched");
}

// Makes one random edit of a file or one change of the request, or changes nothing.
void edit(std::mt19937& random, LiveFolder& folder, GraphRequest& request) {
    const auto way = random() % 2 == 0 ? LiveFolder::Way::in_place : LiveFolder::Way::rename;
    const auto number = [&] { return std::to_string(1 + random() % 8); };
    const auto set_line = [&](const char* file, const std::string& key, const std::string& value) {
        std::string text = folder.text(file);
        const size_t at = text.find(key);
        if (at == std::string::npos) return;
        const size_t end = text.find('\n', at);
        folder.set(file, text.replace(at, end - at, key + value), way);
    };
    switch (random() % 10) {
        case 0:
            return set_line("live.json", "\"paint\": { \"format\"",
                            ": \"rgba16f\", \"size\": [" + number() + ", 24] },");
        case 1:
            return set_line("live.json", "\"trail\": { \"format\"",
                            ": \"rgba32f\", \"size\": [8, 8], \"history\": " + number() + " }");
        case 2:
            return set_line("paint.comp", "const float scale = ", number() + ".0;");
        case 3:
            return set_line("tint.glsl", "const vec3 kTint = ", "vec3(0." + number() + ");");
        case 4:
            return set_line("live.json", "\"params\": { \"gain\"",
                            ": { \"default\": 0." + number() + " } },");
        case 5:
            return set_line("live.json", "\"version\": ",
                            random() % 4 == 0 ? "2,\"name\": \"live\"," : "1, \"name\": \"live\",");
        case 6:
            request.tier = random() % 2 == 0 ? "low" : "";
            return;
        case 7:
            request.params = {{"gain", static_cast<double>(random() % 4)}};
            return;
        case 8:
            request.size = {64 + static_cast<uint32_t>(random() % 4), 36, 1};
            return;
        default:
            return;  // Nothing changes.
    }
}

TEST_F(GraphLoaderTest, RandomEditsGiveTheSameBytesAsFromScratch) {
    const bool extended = std::getenv("WEFT_EXTENDED") != nullptr;
    const int edits = extended ? 2000 : 150;
    uint32_t errors = 0, reused = 0;
    uint64_t values = 0;
    for (uint32_t seed = 1; seed <= 3; ++seed) {
        std::mt19937 random(seed);
        GraphLoader loader = this->loader();
        Outcome running;
        for (int i = 0; i < edits / 3; ++i) {
            edit(random, folder_, request_);
            if (random() % 3 == 0) let_files_age();
            const Outcome kept = load(loader, running), scratch = load_from_scratch();
            ASSERT_EQ(kept.text, scratch.text) << "seed " << seed << ", edit " << i;
            errors += kept.number == 0 ? 1 : 0;
            reused += kept.number != 0 && kept.number == running.number ? 1 : 0;
            if (kept.number != 0) running = kept;
        }
        const render::LoadWork& work = loader.work();
        EXPECT_LT(work.read, work.loads);
        values += work.changed_values;
        std::printf(
            "seed %u: %llu loads read the files %llu times, resolved the graph %llu times, and changed only "
            "values %llu times\n",
            seed, static_cast<unsigned long long>(work.loads), static_cast<unsigned long long>(work.read),
            static_cast<unsigned long long>(work.resolved),
            static_cast<unsigned long long>(work.changed_values));
    }
    EXPECT_GT(errors, 0u);
    EXPECT_GT(reused, 0u);
    EXPECT_GT(values, 0u);
}

}  // namespace
}  // namespace weft::test
