#include <ctime>

#include "tests/graph/samples/full_graph.h"
#include "tests/graph/samples/marked_graph.h"

namespace weft::test {
namespace {

GraphDesc full_graph() {
    Result<GraphDesc> graph = parse_text(kFullGraph);
    EXPECT_TRUE(graph.ok()) << (graph.ok() ? "" : to_text(graph.errors()));
    return graph.ok() ? std::move(graph).value() : GraphDesc{};
}

TEST(Parse, ValuesAndResources) {
    const GraphDesc graph = full_graph();
    EXPECT_EQ(graph.name, "full");
    EXPECT_EQ(number_of(graph.frames), 4);
    EXPECT_EQ(graph.jitter, 8u);
    EXPECT_EQ(graph.imports.at("opaque").kind, "drawlist");
    EXPECT_EQ(number_of(graph.consts.at("tile")), 16);
    EXPECT_EQ(graph.params.at("scale").default_value, 0.5);
    EXPECT_EQ(graph.params.at("scale").allowed, (std::vector<double>{0.5, 1}));
    EXPECT_TRUE(graph.params.at("on").is_bool);
    EXPECT_EQ(graph.sizes.at("fixed").postfix.back().op, ExprOp::make_size);
    EXPECT_EQ(graph.resources.at("normal").formats, (std::vector<std::string>{"rg16_snorm", "rgba16f"}));
    const ResourceDesc& hdr = graph.resources.at("hdr");
    EXPECT_TRUE(hdr.full_mips && hdr.pre_exposed && hdr.mips.empty());
    EXPECT_EQ(number_of(hdr.clear->channels[3]), 1);
    EXPECT_TRUE(graph.resources.at("lights").is_buffer);
    EXPECT_EQ(graph.resources.at("lights").count.text, "tile * tile");
    EXPECT_EQ(number_of(graph.resources.at("acc").history), 2);
    EXPECT_EQ(number_of(graph.resources.at("acc").first_frame->channels[3]), 1);
    EXPECT_EQ(graph.resources.at("acc").on_resize, OnResize::resample);
    EXPECT_EQ(graph.resources.at("probes").keep, KeepMode::shared);
    EXPECT_EQ(graph.sources.files.size(), 1u);
    EXPECT_EQ(graph.sources.describe(hdr.loc), "graph.json:10:5");
}

TEST(Parse, RasterState) {
    const GraphDesc graph = full_graph();
    const PassDesc& pass = graph.passes.at("gbuffer");
    EXPECT_EQ(pass.out.at(0).port, "normal") << "outputs keep the author's order";
    EXPECT_EQ(pass.state.cull, CullMode::material);
    EXPECT_EQ(pass.state.front_face, FrontFace::clockwise);
    EXPECT_EQ(pass.state.topology, Topology::lines);
    EXPECT_TRUE(pass.state.depth_test && !pass.state.depth_write && pass.state.depth_clamp);
    EXPECT_EQ(pass.state.depth_compare, CompareOp::less_equal);
    EXPECT_EQ(pass.state.depth_bias_slope, 2.0f);
    EXPECT_EQ(pass.state.scissor->height, 30u);
    EXPECT_EQ(pass.state.stencil_back.reference, 7);
    EXPECT_EQ(pass.state.stencil_front, pass.state.stencil_back);
    EXPECT_TRUE(pass.blend.at("albedo").enabled);
    EXPECT_EQ(pass.blend.at("albedo").write_mask, 0xF);
    EXPECT_FALSE(pass.blend.at("normal").enabled);
    EXPECT_EQ(pass.blend.at("normal").write_mask, 3);
    EXPECT_EQ(pass.clear_ports.count("depth"), 1u);
    const BlendState& blend = graph.passes.at("show").blend.at("");
    EXPECT_EQ(blend.src_color, BlendFactor::src_alpha);
    EXPECT_EQ(blend.alpha_op, BlendOp::max);
    EXPECT_EQ(blend.write_mask, 7);
}

TEST(Parse, ComputeAndCustomPasses) {
    const GraphDesc graph = full_graph();
    const PassDesc& light = graph.passes.at("light");
    EXPECT_EQ(light.queue, QueueKind::compute);
    EXPECT_EQ(light.groups.size(), 3u);
    EXPECT_EQ(light.in.at(0).ref.pass, "gbuffer");
    EXPECT_EQ(light.in.at(0).sampler->compare, CompareOp::greater_equal);
    EXPECT_EQ(light.in.at(0).sampler->filter, SamplerFilter::nearest);
    EXPECT_EQ(light.out.at(0).ref.layer_last->text, "5");
    EXPECT_EQ(light.params.at(1).components.size(), 3u);
    EXPECT_EQ(light.params.at(2).components.at(0).postfix.at(0).number, 1);
    EXPECT_EQ(light.after, (std::vector<std::string>{"gbuffer"}));
    EXPECT_FALSE(light.flops.empty());
    EXPECT_EQ(graph.passes.at("lines").resolves.at(0).output, "hdrMs");
    EXPECT_EQ(graph.passes.at("lines").resolves.at(0).target.ref.layer_first->text, "0");
    EXPECT_EQ(graph.passes.at("indirect").indirect->ref.name, "args");
    EXPECT_EQ(graph.passes.at("culled").indirect->ref.name, "args");
    EXPECT_EQ(graph.passes.at("culled").draws, (std::vector<std::string>{"opaque"}));
    EXPECT_EQ(graph.resources.at("sky").image_kind, ImageKind::cube);
    EXPECT_EQ(graph.resources.at("fog").image_kind, ImageKind::d3);
    EXPECT_EQ(number_of(graph.resources.at("hdrMs").samples), 4);
    EXPECT_EQ(light.condition.text, "on");
    EXPECT_EQ(light.switch_param, "on");
    EXPECT_TRUE(light.switch_inverted);
    ASSERT_EQ(light.repeat.size(), 2u);
    EXPECT_EQ(light.repeat[0].index, "i");
    EXPECT_TRUE(light.repeat[0].step.empty());
    EXPECT_EQ(light.repeat[1].first.text, "tile-1");
    EXPECT_EQ(light.repeat[1].last.text, "0");
    EXPECT_EQ(light.repeat[1].step.text, "-1");
    EXPECT_EQ(light.constants.at(1).components.at(0).postfix.at(0).number, 1);
    EXPECT_TRUE(light.in.at(0).optional);
    EXPECT_EQ(light.in.at(0).otherwise->name, "hdr");
    EXPECT_EQ(graph.passes.at("upload").type, "light_upload");
    EXPECT_EQ(number_of(graph.passes.at("wipe").clear->channels[2]), 1);
}

TEST(Parse, ADepthAttachmentTestsReversedByDefault) {
    const Result<GraphDesc> graph = parse_text(
        R"({"version": 1, "passes": {"g": {"type": "raster", "shader": "g", "draws": ["a"], "depth": "d"}}})");
    ASSERT_TRUE(graph.ok()) << to_text(graph.errors());
    EXPECT_EQ(graph->name, "graph") << "a graph without a name is called like its file";
    const RasterState& state = graph->passes.at("g").state;
    EXPECT_TRUE(state.depth_test && state.depth_write);
    EXPECT_EQ(state.depth_compare, CompareOp::greater);
}

TEST(Parse, PointersNameTheValue) {
    const Result<GraphDesc> graph = parse_text(R"json({"version": 1, "passes": {
        "p": {"type": "compute", "shader": "a.comp", "in": {"a": "b.mpi(0)"}, "state~/": 1}}})json");
    ASSERT_FALSE(graph.ok());
    ASSERT_EQ(graph.errors().size(), 2u);
    EXPECT_EQ(graph.errors()[0].pointer, "/passes/p/in/a/ref");
    EXPECT_EQ(graph.errors()[1].pointer, "/passes/p/state~0~1");
}

TEST(Parse, ATakenNamePointsAtTheFirst) {
    const Result<GraphDesc> graph =
        parse_text("{\"version\": 1, \"passes\": {}, \"consts\": {\"a\": 1},\n \"params\": {\"a\": 1}}");
    ASSERT_FALSE(graph.ok());
    ASSERT_EQ(graph.errors().front().notes.size(), 1u);
    EXPECT_EQ(graph.errors().front().notes[0].line, 1u);
    EXPECT_EQ(graph.errors().front().notes[0].column, 41u);
}

TEST(Parse, ManyErrorsAreCutOffAndSaySo) {
    std::string text = "{\"version\": 1, \"passes\": {}";
    for (int i = 0; i < 300; ++i) text += ", \"k" + std::to_string(i) + "\": 1";
    const Result<GraphDesc> graph = parse_text(text + "}");
    ASSERT_FALSE(graph.ok());
    EXPECT_EQ(graph.errors().size(), 100u);
}

// Parses files with 60,000 faults on one line. The time must not grow with the square of the number of
// faults.
TEST(Parse, HostileFilesAreAnsweredSoon) {
    const auto many = [](const std::string& before, const std::string& item, const std::string& after) {
        std::string text = before;
        for (int i = 0; i < 60'000; ++i)
            text.append("\"k").append(std::to_string(i)).append("\":").append(item).append(",");
        return text + after;
    };
    // std::clock() counts processor time, so other programs do not disturb the measurement.
    const std::clock_t begin = std::clock();
    EXPECT_FALSE(parse_text(many("{\"version\":1,\"passes\":{},\"sizes\":{", "\"1+\"", "}}")).ok());
    EXPECT_FALSE(parse_text(many("{\"version\":1,\"passes\":{},", "1", "}")).ok());
    EXPECT_FALSE(parse_text(many("{\"version\":1,\"passes\":{", "{\"in\":[\"x.\"]}", "}}")).ok());
    EXPECT_LT(std::clock() - begin, 4 * CLOCKS_PER_SEC);
}

}  // namespace
}  // namespace weft::test
