// Tests indirect dispatches and draws that read their numbers from ranges of buffers, draws without a list
// from a buffer, and numbers of draws in a buffer.
#include <algorithm>

#include "graph/report/plan_summary.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

class ResolveIndirect : public ResolveTest {
 protected:
    ResolveIndirect() {
        shaders["make.comp"] = compute({image_out("dst")});
        shaders["star"] = fragment({"color"});
        imports.imports.at("opaque").draws = 3;
        imports.imports.at("opaque").variants.resize(1);
        imports.strides["DrawCommand"] = 20;
        imports.strides["DrawVerticesCommand"] = 16;
        profile.draw_indirect_count = true;
    }

    // A graph whose pass "d" has the given keys. Clears write all buffers before.
    static std::string graph(const std::string& keys) {
        return R"j("imports": {"opaque": "drawlist"}, "resources": {"x": "rgba16f",
"args": {"buffer": "u32", "count": 9}, "floats": {"buffer": "f32", "count": 9},
"list": {"buffer": "DrawCommand", "count": 8}, "cmds": {"buffer": "DrawVerticesCommand", "count": 8}}, "passes": {
"a": {"type": "clear", "out": ["args"]}, "f": {"type": "clear", "out": ["floats"]},
"l": {"type": "clear", "out": ["list"]}, "c": {"type": "clear", "out": ["cmds"]},
"d": {)j" + keys +
               "}}";
    }
    static std::string dispatch(const std::string& args) {
        return graph(
            R"j("type": "compute", "shader": "make.comp", "out": {"dst": "x"}, "groups": {"indirect": ")j" +
            args + "\"}");
    }
    static std::string draw(const std::string& draws, const std::string& more = "") {
        return graph(R"j("type": "raster", "shader": "star", "out": {"color": "x"}, "draws": )j" + draws +
                     more);
    }
    PassDecl drawn(const std::string& draws, const std::string& more = "") {
        return pass_in(good(draw(draws, more)), "d");
    }
};

TEST_F(ResolveIndirect, dispatches_read_the_start_of_a_range) {
    const PassDecl d = pass_in(good(dispatch("args.range(3..5)")), "d");
    ASSERT_NE(d.indirect_use, kNoId);
    EXPECT_EQ(d.uses[d.indirect_use].bytes, (ByteRange{12, 12}));
    good(dispatch("args.range(6..8)"));
    for (const char* wrong : {"args.range(3..4)", "args.range(8)", "floats.range(0..2)"})
        EXPECT_EQ(bad(dispatch(wrong)).code, "W114") << wrong;
    EXPECT_NE(bad(dispatch("args.range(3..4)")).message.find("args.range(3..4)"), std::string::npos);
}

TEST_F(ResolveIndirect, lists_read_a_range_with_a_command_for_each_draw) {
    const PassDecl d = drawn(R"j({"list": "opaque", "indirect": "list.range(4..6)"})j");
    EXPECT_EQ(d.uses[d.draw_commands_use].bytes, (ByteRange{80, 60}));
    EXPECT_EQ(d.most_draws, 0u);
    EXPECT_FALSE(d.draws_without_list());
    const Diagnostic small = bad(draw(R"j({"list": "opaque", "indirect": "list.range(4..5)"})j"));
    EXPECT_EQ(small.code, "W114");
    EXPECT_NE(small.message.find("has 40 bytes, but the 3 draws of \"opaque\" need 60"), std::string::npos)
        << small.message;
}

TEST_F(ResolveIndirect, draws_without_a_list_execute_every_command_of_the_range) {
    const PassDecl all = drawn(R"j({"indirect": "cmds"})j");
    EXPECT_TRUE(all.draws_without_list());
    EXPECT_EQ(all.most_draws, 8u);
    EXPECT_EQ(all.vertices, 0u);
    EXPECT_EQ(all.draw_count_use, kNoId);
    EXPECT_EQ(all.uses[all.draw_commands_use].access, Access::indirect_read);
    EXPECT_EQ(drawn(R"j({"indirect": "cmds.range(2..4)"})j").most_draws, 3u);
    EXPECT_EQ(drawn(R"j({"indirect": "args"})j").most_draws, 2u) << "36 bytes have room for two commands";
    EXPECT_EQ(bad(draw(R"j({"indirect": "args.range(0..2)"})j")).code, "W114");
    EXPECT_EQ(bad(draw(R"j({"indirect": "floats"})j")).code, "W114");
    EXPECT_EQ(bad(draw(R"j({"indirect": "cmds"})j", R"j(, "state": {"cull": "material"})j")).code, "W109");
}

TEST_F(ResolveIndirect, the_shader_of_draws_without_a_list_reads_no_list) {
    StageVariable position;
    position.name = "position";
    shaders["star"].interface.vertex_inputs = {position};
    EXPECT_EQ(bad(draw(R"j({"indirect": "cmds"})j")).code, "W167");
}

TEST_F(ResolveIndirect, a_buffer_has_the_number_of_draws) {
    const PassDecl d = drawn(R"j({"indirect": "cmds.range(1..5)", "count": "args.range(7)"})j");
    ASSERT_NE(d.draw_count_use, kNoId);
    EXPECT_EQ(d.uses[d.draw_count_use].access, Access::indirect_read);
    EXPECT_EQ(d.uses[d.draw_count_use].bytes, (ByteRange{28, 4}));
    EXPECT_EQ(d.most_draws, 5u);
    EXPECT_EQ(bad(draw(R"j({"indirect": "cmds", "count": "floats"})j")).code, "W114");
    profile.max_draw_indirect_count = 7;
    EXPECT_EQ(bad(draw(R"j({"indirect": "cmds", "count": "args"})j")).code, "W114");
    good(draw(R"j({"indirect": "cmds.range(0..6)", "count": "args"})j"));
    good(draw(R"j({"indirect": "cmds"})j"));
    profile.draw_indirect_count = false;
    const Diagnostic missing = bad(draw(R"j({"indirect": "cmds.range(0..6)", "count": "args"})j"));
    EXPECT_EQ(missing.code, "W187");
    EXPECT_EQ(missing.line, 6u);
}

TEST_F(ResolveIndirect, a_list_with_a_number_of_draws_has_one_state) {
    const std::string counted = R"j({"list": "opaque", "indirect": "list.range(0..1)", "count": "args"})j";
    const PassDecl d = drawn(counted);
    EXPECT_EQ(d.most_draws, 2u) << "fewer commands than draws are allowed";
    EXPECT_FALSE(d.draws_without_list());
    EXPECT_EQ(bad(draw(counted, R"j(, "state": {"cull": "back"})j")).code, "W195");
    EXPECT_EQ(bad(draw(counted, R"j(, "state": {"cull": "material"})j")).code, "W195");
    imports.imports.at("opaque").variants.resize(2);
    EXPECT_EQ(bad(draw(counted)).code, "W195");
    imports.imports.at("opaque").variants.resize(1);
    ShaderBinding material = buffer("material", true, false);
    material.set = 2;
    shaders["star"].interface.bindings.push_back(material);
    EXPECT_EQ(bad(draw(counted)).code, "W195");
}

TEST_F(ResolveIndirect, a_parse_error_names_the_missing_commands) {
    for (const char* draws : {R"j({"list": "opaque"})j", R"j({"count": "args"})j", "{}"}) {
        const Result<GraphDesc> parsed_graph = parsed(draw(draws));
        ASSERT_FALSE(parsed_graph.ok()) << draws;
        EXPECT_EQ(parsed_graph.errors().size(), 1u);
        EXPECT_NE(parsed_graph.errors().front().message.find("indirect"), std::string::npos);
    }
}

TEST_F(ResolveIndirect, the_plan_waits_for_the_numbers_and_the_checker_knows_their_sizes) {
    const ResolvedGraph g = good(draw(R"j({"indirect": "cmds.range(1..5)", "count": "args.range(7)"})j"));
    CompileOptions options;
    options.keep_all_passes = true;
    FramePlan plan = compile(g, content_needs(g), options);
    EXPECT_TRUE(check_plan(plan).empty()) << to_text(check_plan(plan));
    const PassId id = find_pass(plan.graph, "d");
    const std::vector<std::string> facts = summarize_pass(plan, id);
    EXPECT_NE(std::ranges::find(facts, "executes up to 5 draw commands"), facts.end());
    uint32_t waits = 0;
    for (const BarrierDecl& barrier : plan.barriers.steps[plan.schedule.position[id]].barriers)
        waits += barrier.dst.stages == stage::kDrawIndirect ? 1 : 0;
    EXPECT_EQ(waits, 2u);
    const auto has_fault = [&] {
        const Diagnostics faults = check_plan(plan);
        return std::ranges::any_of(faults, [](const Diagnostic& d) { return d.code == "C345"; });
    };
    PassDecl& pass = plan.graph.passes[id];
    pass.most_draws = 6;
    EXPECT_TRUE(has_fault());
    pass.most_draws = 0;
    EXPECT_TRUE(has_fault());
    pass.most_draws = 5;
    EXPECT_FALSE(has_fault());
    pass.draw_count_use = 77;
    EXPECT_TRUE(has_fault());
}

}  // namespace
}  // namespace weft::test
