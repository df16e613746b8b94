// Tests the resources that the program uses between frames: their states, and which exports are refused.
#include "graph/resolve/cull.h"
#include "tests/graph/resolve/resolve_fixture.h"

namespace weft::test {
namespace {

class ResolveExports : public ResolveTest {
 protected:
    ResolveExports() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["read.comp"] = compute({sampled("a"), image_out("dst")});
        shaders["load.comp"] = compute({image_in("a"), image_out("dst")});
    }

    static std::string graph(const std::string& passes) {
        return R"j("resources": {"k": {"format": "rgba16f", "keep": true}, "t": "rgba16f", "u": "rgba16f",
            "h": {"format": "rgba16f", "history": 2}}, "passes": {)j" +
               passes + "}";
    }
    static std::string make(const std::string& out, const std::string& more = "") {
        return R"("make": {"type": "compute", "shader": "make.comp", "out": {"dst": ")" + out + "\"}" + more +
               "}";
    }
    static std::string use_of(const std::string& shader, const std::string& in) {
        return R"(, "use": {"type": "compute", "shader": ")" + shader + R"(.comp", "in": {"a": ")" + in +
               R"("}, "out": {"dst": "u"}}, "see": {"type": "readback", "in": ["u"]})";
    }
};

TEST_F(ResolveExports, OnlyTheNewestCopyIsInTheStateOfTheProgram) {
    exports = {{"h", {Access::sampled_read, stage_bit(ShaderStage::vertex)}}, {"k", {Access::copy_read}}};
    const ResolvedGraph made = good(graph(make("h") + R"(, "more": {"type": "compute", "shader": "make.comp",
        "out": {"dst": "k"}})"));
    const AccessState sampled{stage::kVertexShader, access::kSampledRead, Layout::shader_read_only};
    const AccessState copied{stage::kCopy, access::kTransferRead, Layout::transfer_src};
    EXPECT_EQ(resource_in(made, "h").between, sampled);
    EXPECT_EQ(resource_in(made, "h[-1]").between, std::nullopt);
    EXPECT_EQ(resource_in(made, "k").between, copied);
    EXPECT_EQ(resource_in(made, "k").lifetime, ResourceLifetime::persistent);
    for (const char* copy : {"h", "h[-1]", "h[-2]"})
        EXPECT_NE(resource_in(made, copy).usage & usage::kSampled, 0u) << copy;
    EXPECT_FALSE(pass_in(made, "make").side_effect) << "a pass with side effects cannot rest";
    EXPECT_TRUE(cull(made, false).live_passes[find_pass(made, "make")]);
    exports.clear();
    EXPECT_FALSE(cull(good(graph(make("h"))), false).live_passes[0]);
}

TEST_F(ResolveExports, APassAtRestLeavesOneLayoutForAllReaders) {
    const std::string rests = make("k", R"(, "rest": true)");
    exports = {{"k", {Access::sampled_read}}};
    const ResolvedGraph alike = good(graph(rests + use_of("read", "k")));
    EXPECT_EQ(resource_in(alike, "k").between->layout, Layout::shader_read_only);
    EXPECT_EQ(use(alike, "use", "a").state.layout, Layout::shader_read_only);
    exports = {{"k", {Access::copy_read}}};
    const ResolvedGraph different = good(graph(rests + use_of("read", "k")));
    EXPECT_EQ(resource_in(different, "k").between->layout, Layout::general);
    EXPECT_EQ(use(different, "use", "a").state.layout, Layout::general);
    const ResolvedGraph restless = good(graph(make("k") + use_of("read", "k")));
    EXPECT_EQ(resource_in(restless, "k").between->layout, Layout::transfer_src);
    EXPECT_EQ(use(restless, "use", "a").state.layout, Layout::shader_read_only);
}

TEST_F(ResolveExports, TheProgramOnlyReadsWhatIsKept) {
    for (const Access access : {Access::storage_read_write, Access::color_write, Access::present}) {
        exports = {{"k", {access}}};
        const Diagnostic error = bad(graph(make("k")));
        EXPECT_EQ(error.code, "W243");
        EXPECT_NE(error.message.find("does not only read"), std::string::npos) << error.message;
        expect_help(error, "Access::sampled_read");
    }
    exports = {{"t", {Access::color_write}}};
    EXPECT_EQ(resource_in(good(graph(make("t"))), "t").lifetime, ResourceLifetime::imported);
}

TEST_F(ResolveExports, WhatAPassAtRestWritesMustKeepItsContent) {
    exports = {{"t", {Access::copy_read}}};
    const Diagnostic error = bad(graph(make("t", R"(, "rest": true)")));
    EXPECT_EQ(error.code, "W188");
    EXPECT_NE(error.message.find("which the program uses between frames"), std::string::npos)
        << error.message;
    expect_help(error, "\"keep\": true");
    exports = {{"k", {Access::copy_read}}};
    EXPECT_EQ(good(graph(make("k", R"(, "rest": true)"))).rest_unit_count, 1u);
}

TEST_F(ResolveExports, AnExportOfAGroupIsKept) {
    exports = {{"g::t", {Access::copy_read}}};
    const ResolvedGraph made = good(R"j("resources": {"k": {"format": "rgba16f", "layers": 2, "keep": true}},
        "groups": {"g": {"repeat": {"i": "0..1"}, "resources": {"t": "rgba16f"}, "passes": {
            "make": {"type": "compute", "shader": "make.comp", "out": {"dst": "t"}},
            "use": {"type": "compute", "shader": "read.comp", "in": {"a": "t"}, "out": {"dst": "k.layer(i)"}}}}},
        "passes": {"see": {"type": "readback", "in": ["k.layer(0)"]}})j");
    EXPECT_EQ(resource_in(made, "g::t").lifetime, ResourceLifetime::persistent);
    ASSERT_TRUE(resource_in(made, "g::t").between);
    // The program and the pass of the group need different layouts, and a round may follow in any frame.
    EXPECT_EQ(resource_in(made, "g::t").between->layout, Layout::general);
}

}  // namespace
}  // namespace weft::test
