// Purpose: tests indirect dispatches and draws that read their numbers from ranges of buffers, draws without
// a list from a buffer of commands, and numbers of draws in a buffer. The results are compared with those
// that the CPU computes.
#include "tests/vulkan/executor_fixture.h"
#include "tests/vulkan/triangle_source.h"
#include "weft/check/check_plan.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr uint32_t kColumnsSide = 8;

constexpr SubresourceRange piece_range(uint32_t first, uint32_t count) {
    return {0, 1, first, count, aspect::kColor};
}

class ExecutorIndirectRangesVk : public ExecutorTest {
 protected:
    static void add_frame(PassDecl& pass) {
        ParamWrite frame;
        frame.member = "frame";
        frame.scalar = ScalarType::u32;
        frame.builtin = Builtin::frame_index;
        pass.params = {frame};
    }

    std::vector<ReadbackData> run(const GraphBuilder& builder, uint32_t frames,
                                  const DrawSource* source = nullptr) {
        FramePlan plan = compile_plan(builder);
        const Diagnostics faults = check_plan(plan);
        EXPECT_TRUE(faults.empty()) << to_text(faults);
        ImportDecl list = TriangleSource::draw_list("opaque");
        list.variants.resize(1);
        ImportCatalog imports;
        imports.imports.emplace("opaque", std::move(list));
        ExecutorInput input = input_for(std::move(plan));
        input.imports = &imports;
        input.draws = source;
        const auto executor = executor_for(std::move(input));
        if (executor == nullptr) return {};
        std::vector<ReadbackData> read = run_frames(*executor, frames);
        EXPECT_EQ(device().messages().count(), 0u);
        return read;
    }
};

// One buffer has the sizes of three dispatches. Dispatch d runs d + frame + 1 workgroups, and each adds its
// own power of ten to its word.
TEST_F(ExecutorIndirectRangesVk, one_buffer_has_the_sizes_of_several_dispatches) {
    write_shader("sizes.comp", R"(
        layout(local_size_x = 3) in;
        writeonly buffer Args { uint words[]; } args;
        layout(push_constant) uniform Params { uint frame; } params;
        void main() {
            const uint d = gl_LocalInvocationIndex;
            args.words[3u * d] = d + params.frame + 1u;
            args.words[3u * d + 1u] = 1u;
            args.words[3u * d + 2u] = 1u;
        })");
    uint32_t power = 1;
    for (uint32_t d = 0; d < 3; ++d, power *= 10)
        write_shader("work" + std::to_string(d) + ".comp", R"(
            layout(local_size_x = 1) in;
            buffer Words { uint words[]; } dst;
            void main() { dst.words[gl_WorkGroupID.x] += )" + std::to_string(power) +
                                                               "u; }");
    GraphBuilder builder;
    const ResourceId args = builder.buffer("args", 36), words = builder.buffer("words", 32);
    builder.cut(args, {12, 24});
    PassDecl& sizes = builder.compute("sizes", {{"args", args, Access::storage_write, {}, kNoId}});
    use_shader(sizes, "sizes.comp", ProgramKind::compute);
    add_frame(sizes);
    builder.pass("clear", PassKind::clear, {{"dst", words, Access::clear_write, {}, kNoId}});
    for (uint32_t d = 0; d < 3; ++d) {
        PassDecl& work = builder.compute("work" + std::to_string(d),
                                         {{"indirect", args, Access::indirect_read, piece_range(d, 1), kNoId},
                                          {"dst", words, Access::storage_read_write, {}, kNoId}});
        work.indirect_use = 0;
        use_shader(work, "work" + std::to_string(d) + ".comp", ProgramKind::compute);
    }
    builder.pass("read", PassKind::readback, {{"src", words, Access::copy_read, {}, kNoId}});
    const std::vector<ReadbackData> read = run(builder, 3);
    ASSERT_EQ(read.size(), 3u);
    for (const ReadbackData& data : read) {
        std::vector<uint32_t> wanted(8, 0);
        uint32_t worth = 1;
        for (uint32_t d = 0; d < 3; ++d, worth *= 10)
            for (uint32_t group = 0; group < d + data.frame_index + 1; ++group) wanted[group] += worth;
        EXPECT_EQ(values_of<uint32_t>(data), wanted) << data.frame_index;
    }
}

class ExecutorIndirectVerticesVk : public ExecutorIndirectRangesVk {
 protected:
    // Command i of 16 draws column i % 8 of the image with the colour i + 1. Every third command has no
    // instance. The commands are in the second half of the buffer, and the number of draws in its own buffer.
    void add_passes(GraphBuilder& builder, bool counted) {
        write_shader("write.comp", R"(
            layout(local_size_x = 16) in;
            writeonly buffer Commands { uvec4 commands[]; } commands;
            writeonly buffer Number { uint draws; } number;
            layout(push_constant) uniform Params { uint frame; } params;
            void main() {
                const uint i = gl_LocalInvocationIndex;
                commands.commands[i] = uvec4(6u, i % 3u == 2u ? 0u : 1u, 6u * i, 0u);
                if (i == 0u) number.draws = params.frame * 5u;
            })");
        write_shader("column/column.vert", R"(
            layout(location = 0) flat out uint shade;
            void main() {
                const int draw = gl_VertexIndex / 6, corner = gl_VertexIndex % 6;
                const vec2 at = vec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner >= 4);
                gl_Position = vec4((float(draw % 8) + at.x) / 4.0 - 1.0, at.y * 2.0 - 1.0, 0.5, 1.0);
                shade = uint(draw) + 1u;
            })");
        write_shader("column/column.frag", R"(
            layout(location = 0) flat in uint shade;
            layout(location = 0) out uint color;
            void main() { color = shade; })");
        const ResourceId commands = builder.buffer("commands", 512), number = builder.buffer("number", 512);
        for (const ResourceId buffer : {commands, number}) builder.cut(buffer, {256});
        const ResourceId target = builder.image("target", Format::r32u, kColumnsSide);
        PassDecl& write =
            builder.compute("write", {{"commands", commands, Access::storage_write, piece_range(1, 1), kNoId},
                                      {"number", number, Access::storage_write, piece_range(1, 1), kNoId}});
        use_shader(write, "write.comp", ProgramKind::compute);
        add_frame(write);
        std::vector<test::BuilderUse> uses{
            {"color", target, Access::color_write, {}, kNoId},
            {"indirect", commands, Access::indirect_read, piece_range(1, 1), kNoId}};
        if (counted) uses.push_back({"count", number, Access::indirect_read, piece_range(1, 1), kNoId});
        PassDecl& draw = builder.pass("draw", PassKind::raster, uses);
        draw.draw_commands_use = 1;
        if (counted) draw.draw_count_use = 2;
        draw.most_draws = 16;
        use_shader(draw, "column", ProgramKind::raster);
        builder.pass("read", PassKind::readback, {{"src", target, Access::copy_read, {}, kNoId}});
    }

    static void expect_columns(const ReadbackData& data, uint32_t draws) {
        const std::vector<uint32_t> texels = values_of<uint32_t>(data);
        ASSERT_EQ(texels.size(), kColumnsSide * kColumnsSide);
        for (uint32_t x = 0; x < kColumnsSide; ++x) {
            uint32_t wanted = 0;
            for (uint32_t i = x; i < draws; i += kColumnsSide)
                if (i % 3 != 2) wanted = i + 1;
            for (uint32_t y = 0; y < kColumnsSide; ++y)
                ASSERT_EQ(texels[y * kColumnsSide + x], wanted) << x << ", " << y << " of " << draws;
        }
    }
};

TEST_F(ExecutorIndirectVerticesVk, every_command_of_the_range_is_drawn_in_order) {
    GraphBuilder builder;
    add_passes(builder, false);
    const std::vector<ReadbackData> read = run(builder, 2);
    ASSERT_EQ(read.size(), 2u);
    for (const ReadbackData& data : read) expect_columns(data, 16);
}

// The frames ask for 0, 5, 10, 15 and 20 draws. The buffer has only 16 commands.
TEST_F(ExecutorIndirectVerticesVk, a_buffer_has_the_number_of_draws) {
    if (!device().optional().draw_indirect_count) GTEST_SKIP() << "the device lacks drawIndirectCount";
    GraphBuilder builder;
    add_passes(builder, true);
    const std::vector<ReadbackData> read = run(builder, 5);
    ASSERT_EQ(read.size(), 5u);
    for (const ReadbackData& data : read)
        expect_columns(data, std::min(16u, static_cast<uint32_t>(data.frame_index) * 5));
}

// The commands of the two triangles of a list are in the order 1, 0. Frame f draws f of them.
TEST_F(ExecutorIndirectRangesVk, a_buffer_has_the_number_of_draws_of_a_list) {
    if (!device().optional().draw_indirect_count) GTEST_SKIP() << "the device lacks drawIndirectCount";
    write_shader("write.comp", R"(
        layout(local_size_x = 2) in;
        writeonly buffer Commands { uint words[]; } commands;
        writeonly buffer Number { uint draws; } number;
        layout(push_constant) uniform Params { uint frame; } params;
        void main() {
            const uint i = gl_LocalInvocationID.x, at = i * 5u;
            commands.words[at] = 3u;
            commands.words[at + 1u] = 1u;
            commands.words[at + 2u] = (1u - i) * 3u;
            commands.words[at + 3u] = uint(commands.words.length()) - 10u;
            commands.words[at + 4u] = 0u;
            if (i == 0u) number.draws = params.frame;
        })");
    write_shader("flat/flat.vert", R"(
        layout(location = 0) in vec2 position;
        void main() { gl_Position = vec4(position, 0.5, 1.0); })");
    write_shader("flat/flat.frag", "layout(location = 0) out uint color; void main() { color = 5u; }");
    GraphBuilder builder;
    const ResourceId commands = builder.buffer("commands", 296), number = builder.buffer("number", 260);
    for (const ResourceId buffer : {commands, number}) builder.cut(buffer, {256});
    const ResourceId target = builder.image("target", Format::r32u, kColumnsSide);
    PassDecl& write =
        builder.compute("write", {{"commands", commands, Access::storage_write, piece_range(1, 1), kNoId},
                                  {"number", number, Access::storage_write, piece_range(1, 1), kNoId}});
    use_shader(write, "write.comp", ProgramKind::compute);
    add_frame(write);
    PassDecl& draw = builder.pass("draw", PassKind::raster,
                                  {{"color", target, Access::color_write, {}, kNoId},
                                   {"indirect", commands, Access::indirect_read, piece_range(1, 1), kNoId},
                                   {"count", number, Access::indirect_read, piece_range(1, 1), kNoId}});
    draw.draw_lists = {"opaque"};
    draw.draw_commands_use = 1;
    draw.draw_count_use = 2;
    draw.most_draws = 2;
    use_shader(draw, "flat", ProgramKind::raster);
    builder.pass("read", PassKind::readback, {{"src", target, Access::copy_read, {}, kNoId}});
    const TriangleSource source(device());
    const std::vector<ReadbackData> read = run(builder, 4, &source);
    ASSERT_EQ(read.size(), 4u);
    for (const ReadbackData& data : read) {
        const std::vector<uint32_t> texels = values_of<uint32_t>(data);
        ASSERT_EQ(texels.size(), kColumnsSide * kColumnsSide);
        for (uint32_t y = 0; y < kColumnsSide; ++y)
            for (uint32_t x = 0; x < kColumnsSide; ++x) {
                // Texels whose centre is exactly on the edge between the triangles are skipped.
                if (x + y == kColumnsSide - 1) continue;
                const uint32_t turn =
                    x + y < kColumnsSide - 1 ? 1 : 0;  // The place of the triangle's command.
                ASSERT_EQ(texels[y * kColumnsSide + x], turn < data.frame_index ? 5u : 0u)
                    << x << ", " << y << " in frame " << data.frame_index;
            }
    }
}

}  // namespace
}  // namespace weft::vk
