// Purpose: tests indirect dispatches and draws: an earlier pass of the same frame computes their sizes.
#include "tests/vulkan/executor_fixture.h"
#include "tests/vulkan/triangle_source.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;
using ExecutorIndirectVk = ExecutorTest;

constexpr uint32_t kWords = 64;

// Frame f runs f + 2 workgroups of four invocations. The pass "count" writes the number of workgroups. In
// "trace", each invocation adds this number to its own word, which is 100 before.
TEST_F(ExecutorIndirectVk, workgroups_are_counted_by_an_earlier_pass) {
    write_shader("count.comp", R"(
        layout(local_size_x = 1) in;
        layout(std430) writeonly buffer Args { uint groups[]; } args;
        layout(push_constant) uniform Params { uint frame; } params;
        void main() {
            args.groups[0] = params.frame + 2u;
            args.groups[1] = 1u;
            args.groups[2] = 1u;
        })");
    write_shader("trace.comp", R"(
        layout(local_size_x = 4) in;
        layout(std430) buffer Words { uint words[]; } dst;
        void main() { atomicAdd(dst.words[gl_GlobalInvocationID.x], gl_NumWorkGroups.x); })");
    GraphBuilder builder;
    const ResourceId args = builder.buffer("args", 12);
    const ResourceId words = builder.buffer("words", kWords * 4);
    PassDecl& count = builder.compute("count", {{"args", args, Access::storage_write, {}, kNoId}});
    use_shader(count, "count.comp", ProgramKind::compute);
    ParamWrite frame;
    frame.member = "frame";
    frame.scalar = ScalarType::u32;
    frame.builtin = Builtin::frame_index;
    count.params = {frame};
    builder.pass("clear", PassKind::clear, {{"dst", words, Access::clear_write, {}, kNoId}}).clear = {100, 0,
                                                                                                      0, 0};
    PassDecl& trace = builder.compute("trace", {{"indirect", args, Access::indirect_read, {}, kNoId},
                                                {"dst", words, Access::storage_read_write, {}, kNoId}});
    trace.groups = {0, 0, 0};
    trace.indirect_use = 0;
    use_shader(trace, "trace.comp", ProgramKind::compute);
    builder.pass("read", PassKind::readback, {{"src", words, Access::copy_read, {}, kNoId}});
    const auto executor = executor_for(input_for(compile_plan(builder)));
    ASSERT_NE(executor, nullptr);
    const std::vector<ReadbackData> read = run_frames(*executor, 5);
    ASSERT_EQ(read.size(), 5u);
    for (const ReadbackData& data : read) {
        const auto groups = static_cast<uint32_t>(data.frame_index + 2);
        const std::vector<uint32_t> found = values_of<uint32_t>(data);
        ASSERT_EQ(found.size(), kWords);
        for (uint32_t i = 0; i < kWords; ++i) ASSERT_EQ(found[i], 100 + (i < 4 * groups ? groups : 0)) << i;
    }
}

constexpr uint32_t kIndirectSide = 8;

class ExecutorIndirectDrawVk : public ExecutorTest {
 protected:
    // Adds four passes: "write" writes the commands of the draws 0 and 1. "cull" sets the instance count of
    // the draw `culled` to 0 (`culled` = 2 changes no draw). "draw" executes the commands. "read" reads the
    // image back.
    void add_passes(GraphBuilder& builder, uint32_t culled) {
        write_shader("write.comp", R"(
            layout(local_size_x = 2) in;
            layout(std430) writeonly buffer Commands { uint words[]; } commands;
            void main() {
                uint at = gl_LocalInvocationID.x * 5u;
                commands.words[at] = 3u;
                commands.words[at + 1u] = 1u;
                commands.words[at + 2u] = gl_LocalInvocationID.x * 3u;
                commands.words[at + 3u] = 0u;
                commands.words[at + 4u] = 0u;
            })");
        write_shader("cull.comp", R"(
            layout(local_size_x = 2) in;
            layout(std430) buffer Commands { uint words[]; } commands;
            void main() {
                if (gl_LocalInvocationID.x == )" +
                                      std::to_string(culled) + R"(u)
                    commands.words[gl_LocalInvocationID.x * 5u + 1u] = 0u;
            })");
        write_shader("flat/flat.vert", R"(
            layout(location = 0) in vec2 position;
            void main() { gl_Position = vec4(position, 0.5, 1.0); })");
        write_shader("flat/flat.frag", "layout(location = 0) out uint color; void main() { color = 5u; }");
        const ResourceId commands = builder.buffer("commands", 40);
        const ResourceId target = builder.image("target", Format::r32u, kIndirectSide);
        use_shader(builder.compute("write", {{"commands", commands, Access::storage_write, {}, kNoId}}),
                   "write.comp", ProgramKind::compute);
        use_shader(builder.compute("cull", {{"commands", commands, Access::storage_read_write, {}, kNoId}}),
                   "cull.comp", ProgramKind::compute);
        PassDecl& draw = builder.pass("draw", PassKind::raster,
                                      {{"color", target, Access::color_write, {}, kNoId},
                                       {"indirect", commands, Access::indirect_read, {}, kNoId}});
        draw.draw_lists = {"opaque"};
        draw.draw_commands_use = 1;
        use_shader(draw, "flat", ProgramKind::raster);
        builder.pass("read", PassKind::readback, {{"src", target, Access::copy_read, {}, kNoId}});
    }

    std::vector<uint32_t> run(uint32_t culled) {
        GraphBuilder builder;
        add_passes(builder, culled);
        const TriangleSource source(device());
        ImportDecl list = TriangleSource::draw_list("opaque");
        list.variants.resize(1);
        ImportCatalog imports;
        imports.imports.emplace("opaque", std::move(list));
        ExecutorInput input = input_for(compile_plan(builder));
        input.imports = &imports;
        input.draws = &source;
        const auto executor = executor_for(std::move(input));
        if (executor == nullptr) return {};
        const std::vector<ReadbackData> read = run_frames(*executor, 1);
        return read.empty() ? std::vector<uint32_t>{} : values_of<uint32_t>(read[0]);
    }
};

TEST_F(ExecutorIndirectDrawVk, a_draw_without_instances_is_not_drawn) {
    for (const uint32_t culled : {0u, 1u, 2u}) {
        const std::vector<uint32_t> texels = run(culled);
        ASSERT_EQ(texels.size(), kIndirectSide * kIndirectSide);
        for (uint32_t y = 0; y < kIndirectSide; ++y)
            for (uint32_t x = 0; x < kIndirectSide; ++x) {
                // Texels whose centre is exactly on the triangle's edge are skipped, because the rasteriser's
                // fill rule decides about them.
                if (x + y == kIndirectSide - 1) continue;
                const uint32_t draw = x + y < kIndirectSide - 1 ? 0 : 1;
                ASSERT_EQ(texels[y * kIndirectSide + x], draw == culled ? 0u : 5u)
                    << x << ", " << y << " without draw " << culled;
            }
    }
}

TEST_F(ExecutorIndirectDrawVk, one_buffer_is_for_one_list) {
    GraphBuilder builder;
    add_passes(builder, 0);
    FramePlan plan = compile_plan(builder);
    for (PassDecl& pass : plan.graph.passes)
        if (pass.name == "draw") pass.draw_lists = {"opaque", "masked"};
    const TriangleSource source(device());
    ExecutorInput input = input_for(std::move(plan));
    input.draws = &source;
    const Result<std::unique_ptr<Executor>> made = Executor::create(device(), std::move(input));
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.errors().front().code, "V417");
}

}  // namespace
}  // namespace weft::vk
