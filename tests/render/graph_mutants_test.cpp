// Tests many mutants (damaged copies) of the shipped graphs in all tiers, without a device. Each tier of a
// mutant must either be rejected, with a code, a place and a help text in each message, or its plan must pass
// the checker. All tiers of one mutant together may take one second of CPU time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sstream>

#include "graph/syntax/merge.h"
#include "graph/syntax/read_graph.h"
#include "shader/shader_memory.h"
#include "tests/render/graph_mutants.h"
#include "weft/check/check_plan.h"
#include "weft/load/plan_graph.h"
#include "weft/registry.h"
#include "weft/render/import_catalog.h"
#include "weft/report/memory_report.h"

namespace weft::test {
namespace {

constexpr uint32_t kFirstCheckedSeed = 51000;
constexpr double kMostTime_s = 1;

std::string text_of_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

double cpu_time_s() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

// Checks that a diagnostic has a code, a message and a help text, and that its line and column exist in the
// file.
void expect_useful(const Diagnostic& d, const FileReader& reader) {
    EXPECT_EQ(d.code.size(), 4u) << to_text(d);
    EXPECT_FALSE(d.help.empty()) << to_text(d);
    EXPECT_FALSE(d.message.empty());
    ASSERT_GE(d.line, 1u) << to_text(d);
    ASSERT_GE(d.column, 1u) << to_text(d);
    std::istringstream lines(reader(d.file).value_or(""));
    std::string line;
    uint32_t count = 0;
    while (count < d.line && std::getline(lines, line)) ++count;
    // A diagnostic at the end of the file may name the line after the last newline. This line is empty.
    if (count < d.line) line.clear();
    EXPECT_LE(d.line, count + 1) << to_text(d);
    EXPECT_LE(d.column, line.size() + 1) << to_text(d);
}

struct Tally {
    uint32_t mutants = 0, good = 0, warned = 0;
    double most_time_s = 0;
    std::map<std::string, uint32_t> codes;
};

class GraphMutantsTest : public testing::Test {
 protected:
    GraphMutantsTest() {
        Result<DeviceProfile> lavapipe = parse_profile(
            text_of_file(GraphMutants::path_of("framework/profiles/lavapipe.json")), "lavapipe.json");
        EXPECT_TRUE(lavapipe);
        if (lavapipe) profile_ = std::move(*lavapipe);
    }

    static LoadSettings settings_of(const FileReader& reader) {
        LoadSettings settings;
        settings.reader = reader;
        settings.graph_root = GraphMutants::path_of("graphs");
        settings.shader_root = GraphMutants::path_of("shaders");
        return settings;
    }

    // Returns the errors of one tier of the graph. If there are no errors, also expects that the plan passes
    // the checker.
    Diagnostics check_tier(const JsonDoc& document, const LoadInput& input, uint32_t queues,
                           Diagnostics& warnings) {
        const Result<PlannedGraph> planned = plan_graph(document, input, queues, warnings);
        if (!planned) return planned.errors();
        const FramePlan& plan = planned->plan;
        Diagnostics faults = budget_faults(plan, input.settings.limits.graph, input.request.path);
        if (!faults.empty()) return faults;
        EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
        return {};
    }

    Diagnostics check(const std::string& root, const FileReader& reader, uint32_t queues,
                      Diagnostics& warnings) {
        const LoadSettings settings = settings_of(reader);
        const std::string path = GraphMutants::path_of(root);
        const Result<JsonDoc> document = read_graph(path, settings);
        if (!document) return document.errors();
        std::vector<std::string> tiers = tier_names(*document);
        tiers.insert(tiers.begin(), "");
        Diagnostics faults;
        for (const std::string& tier : tiers) {
            const LoadInput input{.request = {.path = path, .tier = tier, .size = {64, 36, 1}},
                                  .settings = settings,
                                  .passes = passes_,
                                  .imports = imports_,
                                  .profile = profile_,
                                  .memory = &memory_};
            Diagnostics of_tier = check_tier(*document, input, queues, warnings);
            faults.insert(faults.end(), of_tier.begin(), of_tier.end());
        }
        return faults;
    }

    void judge(const Mutant& mutant, Tally& tally) {
        SCOPED_TRACE("seed " + std::to_string(mutant.seed) + ", " + mutant.file + " (loaded: " + mutant.root +
                     "), " + mutant.how);
        const FileReader reader = GraphMutants::reader_of(mutant);
        memory_.begin();
        Diagnostics warnings;
        const double begin_s = cpu_time_s();
        Diagnostics faults = check(mutant.root, reader, 1 + mutant.seed % 4, warnings);
        const double time_s = cpu_time_s() - begin_s;
        EXPECT_LE(time_s, kMostTime_s);
        ++tally.mutants;
        if (faults.empty()) ++tally.good;
        for (const Diagnostic& d : faults) ++tally.codes[d.code];
        faults.insert(faults.end(), warnings.begin(), warnings.end());
        for (const Diagnostic& d : faults) expect_useful(d, reader);
        if (!warnings.empty()) ++tally.warned;
        tally.most_time_s = std::max(tally.most_time_s, time_s);
    }

    PassCatalog passes_ = registered_passes();
    ImportCatalog imports_ = render::scene_imports({64, 36, 1});
    DeviceProfile profile_;
    // Compiled shader programs, which all mutants share to save time.
    ShaderMemory memory_;
};

TEST_F(GraphMutantsTest, AreRefusedAtAPlaceOrProved) {
    const GraphMutants mutants;
    const FileReader plain = GraphMutants::reader_of({});
    for (const std::string& file : mutants.files()) {
        Diagnostics warnings;
        const Diagnostics faults = check(file, plain, 1, warnings);
        EXPECT_TRUE(faults.empty()) << file << ": " << to_text(faults);
        EXPECT_TRUE(warnings.empty()) << file << ": " << to_text(warnings);
    }
    const uint32_t count = std::getenv("WEFT_EXTENDED") != nullptr ? 10000 : 300;
    Tally tally;
    for (uint32_t i = 0; i < count && !HasFatalFailure(); ++i)
        judge(mutants.make(kFirstCheckedSeed + i), tally);
    std::printf("seeds %u to %u: %u of %u mutants are good, %u with warnings, the slowest took %.0f ms\n",
                kFirstCheckedSeed, kFirstCheckedSeed + count - 1, tally.good, tally.mutants, tally.warned,
                tally.most_time_s * 1e3);
    for (const auto& [code, times] : tally.codes) std::printf("%s %u  ", code.c_str(), times);
    std::printf("\n");
    EXPECT_GT(tally.good, count / 20) << "the mutations are too wild to prove anything";
    EXPECT_LT(tally.good, count * 3 / 4) << "the mutations are too tame to prove anything";
}

}  // namespace
}  // namespace weft::test
