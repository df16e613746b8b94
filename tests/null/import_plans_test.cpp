// Tests plans of graphs that read an import in two layouts, on one to three queues. The program also reads
// the import before and after the frame, in the layout of its entry and exit state.
#include <gtest/gtest.h>

#include "null/null_executor.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "tests/graph/samples/random_rest.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class ImportPlans : public ResolveTest {
 protected:
    ImportPlans() {
        shaders = rest_shaders();
        ResourceDecl& noise = imports.imports["noise"].resource;
        noise.format = Format::rgba16f;
        noise.import->entry = {stage::kComputeShader, access::kSampledRead, Layout::shader_read_only};
        noise.import->exit = noise.import->entry;
        noise.import->concurrent = true;
    }

    // Compiles a graph with the passes `text` for one to three queues, and runs the plans.
    void expect_sound(const std::string& text) {
        const ResolvedGraph graph = good(
            R"("imports": {"noise": "image"}, "resources": {"x": "rgba16f", "y": "rgba16f", "z": "rgba16f"},
            "passes": {)" +
            text + R"(, "see": {"type": "readback", "in": ["y"]}})");
        for (uint32_t queues = 1; queues <= 3; ++queues) {
            CompileOptions options;
            options.queues = logical_queues({}, queues);
            options.keep_all_passes = true;
            const FramePlan plan = compile(graph, content_needs(graph), options);
            EXPECT_TRUE(check_plan(plan).empty()) << queues << " queues\n" << to_text(check_plan(plan));
            const NullRun wanted = run_reference(plan.graph, plan.live);
            for (uint64_t seed = 0; seed < 8; ++seed)
                EXPECT_TRUE(
                    differences(plan.graph, wanted, run_null(plan, {3, seed, NullOrder::shuffled})).empty());
        }
    }
};

// The last pass brings the import back to the exit layout, but only for the fragment stage. The program reads
// it in the compute stage.
TEST_F(ImportPlans, TheProgramSeesALayoutThatChangedAndChangedBack) {
    expect_sound(
        R"("load": {"type": "compute", "shader": "i1.comp", "in": {"a": "noise"}, "out": {"dst": "x"}},
        "draw": {"type": "fullscreen", "shader": "s2.frag", "in": {"a": "noise", "b": "x"}, "out": {"dst": "y"}})");
}

// The first pass needs no barrier. The layout change before the second one must still wait for the program.
TEST_F(ImportPlans, ALayoutChangeAfterAReadWaitsForTheProgram) {
    expect_sound(
        R"("draw": {"type": "fullscreen", "shader": "s1.frag", "in": {"a": "noise"}, "out": {"dst": "x"}},
        "load": {"type": "compute", "shader": "i2.comp", "in": {"a": "noise", "b": "x"}, "out": {"dst": "y"}},
        "other": {"type": "compute", "shader": "s1.comp", "in": {"a": "noise"}, "out": {"dst": "z"}, "queue": "async"})");
}

}  // namespace
}  // namespace weft::test
