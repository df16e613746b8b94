// Purpose: tests the resolve of multisampled attachments at the end of a pass. Edge functions in this file
// compute which samples the triangle covers. The expected value of each pixel follows from these samples.
#include <algorithm>
#include <cmath>

#include "tests/vulkan/executor_fixture.h"
#include "tests/vulkan/triangle_source.h"

namespace weft::vk {
namespace {

using test::GraphBuilder;

constexpr uint32_t kResolveSide = 16;
constexpr uint32_t kSamples = 4;

struct Point {
    double x = 0, y = 0;
};
// Corners of the triangle in pixels. Rasterisers round corners to a grid of 1/256 pixel. These corners are on
// the grid, so rounding does not move them. No edge passes through a sample.
constexpr std::array<Point, 3> kCorners{Point{1.25, 2.0625}, Point{3.6875, 14.25}, Point{14.5625, 5.875}};
// The standard sample locations of Vulkan for four samples per pixel.
constexpr std::array<Point, kSamples> kSamplePoints{Point{0.375, 0.125}, Point{0.875, 0.375},
                                                    Point{0.125, 0.625}, Point{0.625, 0.875}};

double edge(const Point& a, const Point& b, const Point& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool covers(uint32_t x, uint32_t y, uint32_t sample) {
    const Point p{x + kSamplePoints[sample].x, y + kSamplePoints[sample].y};
    int inside = 0;
    for (size_t i = 0; i < kCorners.size(); ++i) {
        const double side = edge(kCorners[i], kCorners[(i + 1) % kCorners.size()], p);
        EXPECT_GT(std::abs(side), 1e-3) << "the fill rule would decide";
        inside += side < 0 ? 1 : -1;
    }
    return inside == static_cast<int>(kCorners.size()) || inside == -static_cast<int>(kCorners.size());
}

uint32_t samples_covered(uint32_t x, uint32_t y) {
    uint32_t count = 0;
    for (uint32_t sample = 0; sample < kSamples; ++sample) count += covers(x, y, sample) ? 1 : 0;
    return count;
}

class ExecutorResolveVk : public ExecutorTest {
 protected:
    ResourceId multisampled(GraphBuilder& builder, const std::string& name, Format format) const {
        const ResourceId id = builder.image(name, format, kResolveSide);
        builder.edit(id).samples = kSamples;
        return id;
    }

    // Adds a pass that draws the triangle to the multisampled image `many` and resolves it to the image
    // `one`, or to the subresource `part` of this image.
    PassDecl& add_draw(GraphBuilder& builder, ResourceId many, ResourceId one,
                       std::optional<SubresourceRange> part = {}) {
        const ResourceId depth = multisampled(builder, "depth", Format::d32f);
        PassDecl& draw = builder.pass("draw", PassKind::raster,
                                      {{"color", many, Access::color_write, {}, kNoId},
                                       {"depth", depth, Access::depth_write, {}, kNoId},
                                       {"one", one, Access::color_write, part, kNoId}});
        draw.colors.erase(draw.colors.begin() + 1);
        draw.colors[0].resolve_use = 2;
        draw.render_extent = {kResolveSide, kResolveSide, 1};
        draw.state.depth_test = draw.state.depth_write = true;
        draw.draw_lists = {"opaque"};
        return draw;
    }

    void use_triangle(PassDecl& draw, const std::string& type, const std::string& value) {
        std::string corners;
        for (const Point& p : kCorners)
            corners += (corners.empty() ? "" : ", ") + std::string("vec2(") + std::to_string(p.x) + ", " +
                       std::to_string(p.y) + ")";
        write_shader("tri/tri.vert", "const vec2 kCorners[3] = vec2[](" + corners + R"();
            void main() { gl_Position = vec4(kCorners[gl_VertexIndex] / 8.0 - 1.0, 0.5, 1.0); })");
        write_shader("tri/tri.frag",
                     "layout(location = 0) out " + type + " color; void main() { color = " + value + "; }");
        use_shader(draw, "tri", ProgramKind::raster);
    }

    // Makes a graph that resolves to one mip of one layer of an image with two layers. The pass "read" reads
    // this layer back, and "read_other" reads the other layer back.
    GraphBuilder draw_into(uint32_t mip, uint32_t layer) {
        GraphBuilder builder;
        const ResourceId many = multisampled(builder, "many", Format::rgba32f);
        const ResourceId one = builder.image("one", Format::rgba32f, kResolveSide << mip, mip + 1, 2);
        builder.pass("clear", PassKind::clear, {{"dst", one, Access::clear_write, {}, kNoId}}).clear = {9, 9,
                                                                                                        9, 9};
        use_triangle(add_draw(builder, many, one, test::one_cell(mip, layer)), "vec4",
                     "vec4(1.0, 0.5, 0.25, 2.0)");
        add_readback(builder, "read", one, test::one_cell(mip, layer));
        add_readback(builder, "read_other", one, test::one_cell(mip, 1 - layer));
        return builder;
    }

    static void expect_only_the_part(const std::vector<ReadbackData>& read) {
        ASSERT_EQ(read.size(), 2u);
        for (const ReadbackData& data : read)
            if (data.pass == "read")
                expect_averages(values_of<float>(data), {1, 0.5F, 0.25F, 2});
            else
                EXPECT_EQ(values_of<float>(data), std::vector<float>(kResolveSide * kResolveSide * 4, 9));
    }

    std::vector<ReadbackData> run(const GraphBuilder& builder, uint32_t frames = 1) {
        const TriangleSource source(device());
        ImportDecl list = TriangleSource::draw_list("opaque");
        list.variants.resize(1);
        ImportCatalog imports;
        imports.imports.emplace("opaque", std::move(list));
        ExecutorInput input = input_for(compile_plan(builder));
        input.imports = &imports;
        input.draws = &source;
        const auto executor = executor_for(std::move(input));
        return executor == nullptr ? std::vector<ReadbackData>{} : run_frames(*executor, frames);
    }

    static void add_readback(GraphBuilder& builder, const std::string& name, ResourceId source,
                             std::optional<SubresourceRange> part = {}) {
        builder.pass(name, PassKind::readback, {{"src", source, Access::copy_read, part, kNoId}});
    }

    static void expect_averages(const std::vector<float>& texels, const std::array<float, 4>& inside) {
        ASSERT_EQ(texels.size(), kResolveSide * kResolveSide * 4);
        std::array<uint32_t, kSamples + 1> pixels_with{};
        for (uint32_t y = 0; y < kResolveSide; ++y)
            for (uint32_t x = 0; x < kResolveSide; ++x) {
                const uint32_t count = samples_covered(x, y);
                ++pixels_with[count];
                for (uint32_t c = 0; c < 4; ++c)
                    ASSERT_EQ(texels[(y * kResolveSide + x) * 4 + c],
                              inside[c] * static_cast<float>(count) / kSamples)
                        << x << ", " << y;
            }
        // The triangle must have pixels with every number of covered samples from 0 to 4. Otherwise the test
        // would check too little.
        EXPECT_TRUE(std::ranges::all_of(pixels_with, [](uint32_t pixels) { return pixels > 0; }));
    }
};

TEST_F(ExecutorResolveVk, floats_are_averaged_over_the_covered_samples) {
    GraphBuilder builder;
    const ResourceId many = multisampled(builder, "many", Format::rgba32f);
    const ResourceId one = builder.image("one", Format::rgba32f, kResolveSide);
    use_triangle(add_draw(builder, many, one), "vec4", "vec4(1.0, 0.5, 0.25, 2.0)");
    add_readback(builder, "read", one);
    const std::vector<ReadbackData> read = run(builder, 3);
    ASSERT_EQ(read.size(), 3u);
    for (const ReadbackData& data : read) expect_averages(values_of<float>(data), {1, 0.5F, 0.25F, 2});
}

TEST_F(ExecutorResolveVk, the_target_may_be_any_mip) {
    expect_only_the_part(run(draw_into(1, 0)));
}

TEST_F(ExecutorResolveVk, the_target_may_be_any_layer) {
    const GraphBuilder builder = draw_into(1, 1);
    if (!device().info().driver.starts_with("llvmpipe")) return expect_only_the_part(run(builder));
    // llvmpipe would write to layer 0 instead of the selected layer, so the executor must refuse the plan.
    const Result<std::unique_ptr<Executor>> made =
        Executor::create(device(), input_for(compile_plan(builder)));
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.errors().front().code, "V417");
    EXPECT_NE(made.errors().front().message.find("pass \"draw\""), std::string::npos);
}

TEST_F(ExecutorResolveVk, the_samples_are_still_there_for_who_reads_them) {
    GraphBuilder builder;
    const ResourceId many = multisampled(builder, "many", Format::rgba32f);
    const ResourceId one = builder.image("one", Format::rgba32f, kResolveSide);
    const ResourceId masks = builder.image("masks", Format::r32u, kResolveSide);
    use_triangle(add_draw(builder, many, one), "vec4", "vec4(1.0, 0.5, 0.25, 2.0)");
    write_shader("masks.comp", R"(
        layout(local_size_x = 16, local_size_y = 16) in;
        uniform sampler2DMS src;
        layout(r32ui) uniform writeonly uimage2D dst;
        void main() {
            ivec2 at = ivec2(gl_GlobalInvocationID.xy);
            uint mask = 0u;
            for (int i = 0; i < 4; ++i) if (texelFetch(src, at, i).g == 0.5) mask |= 1u << i;
            imageStore(dst, at, uvec4(mask));
        })");
    use_shader(builder.compute("masks", {{"src", many, Access::sampled_read, {}, kNoId},
                                         {"dst", masks, Access::storage_write, {}, kNoId}}),
               "masks.comp", ProgramKind::compute);
    add_readback(builder, "read", masks);
    add_readback(builder, "read_one", one);
    const std::vector<ReadbackData> read = run(builder);
    ASSERT_EQ(read.size(), 2u);
    for (const ReadbackData& data : read) {
        if (data.pass == "read_one") {
            expect_averages(values_of<float>(data), {1, 0.5F, 0.25F, 2});
            continue;
        }
        const std::vector<uint32_t> found = values_of<uint32_t>(data);
        ASSERT_EQ(found.size(), kResolveSide * kResolveSide);
        for (uint32_t i = 0; i < found.size(); ++i) {
            uint32_t mask = 0;
            for (uint32_t sample = 0; sample < kSamples; ++sample)
                mask |= (covers(i % kResolveSide, i / kResolveSide, sample) ? 1u : 0u) << sample;
            ASSERT_EQ(found[i], mask) << i;
        }
    }
}

TEST_F(ExecutorResolveVk, integers_keep_their_first_sample) {
    if ((device().profile().samples(Format::r32u) & kSamples) == 0)
        GTEST_SKIP() << "the device has no multisampled integers";
    GraphBuilder builder;
    const ResourceId many = multisampled(builder, "many", Format::r32u);
    const ResourceId one = builder.image("one", Format::r32u, kResolveSide);
    PassDecl& draw = add_draw(builder, many, one);
    draw.colors[0].clear = {3, 0, 0, 0};
    use_triangle(draw, "uint", "1000000007u");
    add_readback(builder, "read", one);
    const std::vector<ReadbackData> read = run(builder);
    ASSERT_EQ(read.size(), 1u);
    const std::vector<uint32_t> texels = values_of<uint32_t>(read[0]);
    ASSERT_EQ(texels.size(), kResolveSide * kResolveSide);
    for (uint32_t i = 0; i < texels.size(); ++i) {
        const uint32_t x = i % kResolveSide, y = i / kResolveSide;
        EXPECT_EQ(texels[i], covers(x, y, 0) ? 1000000007u : 3u)
            << "pixel " << x << ", " << y << "; samples covered: " << covers(x, y, 0) << covers(x, y, 1)
            << covers(x, y, 2) << covers(x, y, 3);
    }
}

}  // namespace
}  // namespace weft::vk
