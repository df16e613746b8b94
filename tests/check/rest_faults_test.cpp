// Each test breaks a correct plan with a rest unit in one way. The checker must report an error.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

const char* const kRestGraph = R"j("imports": {"backbuffer": "output"},
 "resources": {"local": "rgba16f", "k": {"format": "rgba16f", "keep": true}, "t": "rgba16f"},
 "passes": {
  "make":  {"type": "compute", "shader": "make.comp", "out": {"dst": "local"}, "rest": true},
  "store": {"type": "compute", "shader": "filter.comp", "in": {"src": "local"}, "out": {"dst": "k"}, "rest": true},
  "blur":  {"type": "compute", "shader": "filter.comp", "in": {"src": "k"}, "out": {"dst": "t"}},
  "show":  {"type": "fullscreen", "shader": "show.frag", "in": {"src": "t"}, "out": ["backbuffer"]}})j";

class RestFault : public ResolveTest {
 protected:
    RestFault() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["filter.comp"] = compute({sampled("src"), image_out("dst")});
        shaders["show.frag"] = fragment({"backbuffer"}, {sampled("src")});
        plan = compile(good(kRestGraph), content_needs(good(kRestGraph)), {});
    }
    void SetUp() override { ASSERT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan)); }

    PassDecl& pass(const char* name) { return plan.graph.passes[find_pass(plan.graph, name)]; }
    PassStep& step(const char* name) {
        return plan.barriers.steps[plan.schedule.position[find_pass(plan.graph, name)]];
    }
    std::string codes() const {
        std::string all;
        for (const Diagnostic& d : check_plan(plan))
            if (all.find(d.code) == std::string::npos) all += d.code + " ";
        return all;
    }

    FramePlan plan;
};

TEST_F(RestFault, AUnitThatLosesAPass) {
    pass("make").rest_unit = kNoId;
    EXPECT_NE(codes().find("C334"), std::string::npos) << codes();
}

TEST_F(RestFault, ABarrierThatIsRecordedInEveryFrame) {
    step("store").barriers.front().if_pass_runs = false;
    EXPECT_EQ(codes(), "C334 ");
}

TEST_F(RestFault, ABarrierThatAnotherPassNeedsInEveryFrame) {
    step("blur").barriers.front().if_pass_runs = true;
    EXPECT_NE(codes().find("C334"), std::string::npos) << codes();
}

TEST_F(RestFault, AStepThatLeavesAnotherLayout) {
    step("store").after.clear();
    EXPECT_NE(codes().find("C334"), std::string::npos) << codes();
}

TEST_F(RestFault, MemoryThatAnotherResourceUsesWhileTheUnitRests) {
    LifetimeSpan& span = plan.lifetimes.spans[find_resource(plan.graph, "local")];
    span.last = 1;
    EXPECT_NE(codes().find("C333"), std::string::npos) << codes();
}

TEST_F(RestFault, APassWithEffectsOutsideTheGraph) {
    pass("store").side_effect = true;
    EXPECT_EQ(codes(), "C333 ");
}

TEST_F(RestFault, AnotherWriterInEveryFrame) {
    pass("blur").uses.back().resource = find_resource(plan.graph, "k");
    EXPECT_NE(codes().find("C333"), std::string::npos) << codes();
}

TEST_F(RestFault, AUnitThatNeedsItsOwnResult) {
    UseDecl use = pass("store").uses.back();
    use.access = Access::storage_read_write;
    use.sources = {{use.range, kNoId}};
    pass("store").uses.back() = use;
    EXPECT_NE(codes().find("C333"), std::string::npos) << codes();
}

}  // namespace
}  // namespace weft::test
