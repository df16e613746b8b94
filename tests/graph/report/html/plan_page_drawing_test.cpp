// Tests the drawings of the HTML page. Examples: memory blocks are to scale, texts fit into their boxes, and
// the name on an edge of the graph touches no box and no other name.
#include <gtest/gtest.h>

#include <cstdlib>

#include "graph/report/html/plan_html_edges.h"
#include "graph/report/html/plan_page.h"
#include "graph/report/html/plan_page_bytes.h"
#include "graph/report/html/plan_page_sizes.h"
#include "tests/graph/compile/plan_expectations.h"
#include "tests/graph/report/html/markup_reader.h"
#include "tests/graph/samples/random_plan.h"

namespace weft::test {
namespace {

// Returns a plan in which two images (256 and 128 px wide) and five buffers of 16 bytes live at the same
// time.
FramePlan uneven_plan() {
    GraphBuilder b;
    const ResourceId large = b.image("large", Format::r32u, 256), small = b.image("small", Format::r32u, 128);
    std::vector<BuilderUse> made{{"a", large, Access::storage_write, {}, kNoId},
                                 {"b", small, Access::storage_write, {}, kNoId}};
    std::vector<BuilderUse> used{{"a", large, Access::sampled_read, {}, kNoId},
                                 {"b", small, Access::sampled_read, {}, kNoId}};
    for (int i = 0; i < 5; ++i) {
        const std::string name = "tiny" + std::to_string(i);
        const ResourceId tiny = b.buffer(name, 16);
        made.push_back({name, tiny, Access::storage_write, {}, kNoId});
        used.push_back({name, tiny, Access::storage_read, {}, kNoId});
    }
    const ResourceId result = b.image("result");
    used.push_back({"dst", result, Access::storage_write, {}, kNoId});
    b.compute("make", made);
    b.compute("use", used);
    read_back(b, "out", result);
    return compiled(b);
}

// Calls visit(block, scale) for each memory block in a heap that is not persistent. `scale` is the scale, in
// pixels and bytes, in which the page draws this heap.
template <class Visit>
void for_blocks(const FramePlan& plan, const Visit& visit) {
    std::vector<uint32_t> heaps;
    for (uint32_t h = 0; h < plan.memory.heaps.size(); ++h)
        if (!plan.memory.heaps[h].persistent) heaps.push_back(h);
    const std::vector<ByteScale> scales = make_byte_scales(plan.memory, heaps);
    for (size_t h = 0; h < heaps.size(); ++h)
        for (const BlockPlace& block : place_blocks(plan, heaps[h], scales[h])) visit(block, scales[h]);
}

void expect_to_scale(const FramePlan& plan) {
    for_blocks(plan, [](const BlockPlace& block, const ByteScale& scale) {
        const double px_per_byte = static_cast<double>(scale.height_px) / static_cast<double>(scale.bytes);
        const double true_px = static_cast<double>(block.placement->size_bytes) * px_per_byte;
        EXPECT_GE(block.top_px, 0);
        EXPECT_LE(block.top_px + block.height_px, scale.height_px);
        if (block.enlarged) {
            EXPECT_GT(block.height_px, true_px - 1);
            return;
        }
        EXPECT_NEAR(block.height_px, true_px, 1.01);
        EXPECT_NEAR(block.top_px, static_cast<double>(block.placement->offset_bytes) * px_per_byte, 0.51);
    });
}

TEST(PlanPageDrawing, BytesAreToScaleOrSaidToBeEnlarged) {
    expect_to_scale(uneven_plan());
    for (uint32_t seed = 1; seed <= 24; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        expect_to_scale(random_plan(seed, 40));
    }
}

TEST(PlanPageDrawing, TinyBlocksAreEnlargedSideBySideAndSaySo) {
    const FramePlan plan = uneven_plan();
    std::vector<int32_t> tops_px;
    for_blocks(plan, [&](const BlockPlace& block, const ByteScale&) {
        if (plan.graph.resources[block.placement->resource].name.starts_with("tiny")) {
            EXPECT_TRUE(block.enlarged);
            for (const int32_t other_px : tops_px) EXPECT_GE(std::abs(other_px - block.top_px), 6);
            tops_px.push_back(block.top_px);
        }
    });
    EXPECT_EQ(tops_px.size(), 5u);
    const std::string text = plan_to_html(plan, {});
    EXPECT_NE(text.find("tiny0: 16 B at"), std::string::npos);
    EXPECT_NE(text.find("to use, drawn larger than its real size\""), std::string::npos);
    EXPECT_NE(text.find("too small to see: drawn larger than its real size"), std::string::npos);
}

TEST(PlanPageDrawing, AxesHaveOneUnitAndEndWithTheHeap) {
    const std::vector<ByteTick> ticks = byte_ticks({29'000'000, 320});
    const std::vector<std::string> wanted{"0",      "4 MiB",  "8 MiB",  "12 MiB",
                                          "16 MiB", "20 MiB", "24 MiB", "27.7 MiB"};
    ASSERT_EQ(ticks.size(), wanted.size());
    for (size_t i = 0; i < ticks.size(); ++i) EXPECT_EQ(ticks[i].text, wanted[i]);
    for (size_t i = 1; i < ticks.size(); ++i) EXPECT_GE(ticks[i].y_px - ticks[i - 1].y_px, 14);
    EXPECT_EQ(byte_ticks({1, 96}).back().text, "1 B");
}

TEST(PlanPageDrawing, WhatIsWrittenAndNeverReadSaysSo) {
    GraphBuilder b;
    const ResourceId color = b.image("color"), velocity = b.image("velocity");
    b.pass("draw", PassKind::fullscreen,
           {{"color", color, Access::color_write, {}, kNoId},
            {"velocity", velocity, Access::color_write, {}, kNoId}});
    read_back(b, "out", color);
    const FramePlan plan = compiled(b);
    const PlanPage page = make_page(plan, {});
    EXPECT_TRUE(has_no_reader(page, velocity));
    EXPECT_FALSE(has_no_reader(page, color));
    const std::string text = plan_to_html(plan, {});
    EXPECT_NE(text.find("<small>no reader</small>"), std::string::npos);
    EXPECT_NE(text.find("velocity: alive from draw to draw, no reader: no running pass reads it"),
              std::string::npos);
    EXPECT_NE(text.find("written, but never read"), std::string::npos);
}

TEST(PlanPageDrawing, WhatTheNextFrameReadsHasAReader) {
    GraphBuilder b;
    const ResourceId steady = b.image("steady"), result = b.image("result");
    const std::vector<ResourceId> roles = b.ring(steady, 1);
    b.compute("mix", {{"before", roles[1], Access::sampled_read, {}, kNoId},
                      {"steady", steady, Access::storage_write, {}, kNoId},
                      {"dst", result, Access::storage_write, {}, kNoId}});
    read_back(b, "out", result);
    const FramePlan plan = compiled(b);
    EXPECT_FALSE(has_no_reader(make_page(plan, {}), steady));
}

struct Area {
    int32_t x, y, width, height;
};

bool touch(const Area& a, const Area& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

int32_t number(const ReadElement& e, const char* attribute) {
    return std::stoi(e.attributes.at(attribute));
}

TEST(PlanPageDrawing, NamesOnEdgesTouchNoBoxAndNoOtherName) {
    size_t named = 0;
    for (uint32_t seed = 1; seed <= 24; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const ReadPage page = read_markup(plan_to_html(random_plan(seed, 40), {}));
        ASSERT_EQ(page.fault, "");
        // Number of drawings seen so far. Only the first drawing, which shows the graph, is tested.
        size_t drawings = 0;
        std::vector<Area> boxes, names;
        for (const ReadElement& e : page.elements) {
            drawings += e.tag == "svg" ? 1 : 0;
            if (drawings != 1) continue;
            if (e.tag == "rect" && e.attributes.at("class") == "box")
                boxes.push_back({number(e, "x"), number(e, "y"), number(e, "width"), number(e, "height")});
            if (e.tag != "text" || e.attributes.at("class") != "edgename mid") continue;
            const auto width = static_cast<int32_t>(e.text.size()) * 7;
            names.push_back({number(e, "x") - width / 2, number(e, "y") - 10, width, 13});
        }
        ASSERT_FALSE(boxes.empty());
        for (size_t i = 0; i < names.size(); ++i) {
            for (const Area& box : boxes) EXPECT_FALSE(touch(names[i], box));
            for (size_t k = 0; k < i; ++k) EXPECT_FALSE(touch(names[i], names[k]));
        }
        named += names.size();
    }
    EXPECT_GT(named, 24u * 5);
}

TEST(PlanPageDrawing, ANameLiesOnItsWayAndOnNoOther) {
    EdgePath way, near, across, shared;
    way.move({50, 50});
    way.line({250, 50});
    const std::vector<EdgeName> free = place_edge_names({way}, {{"hdr"}}, {}, {300, 100});
    EXPECT_EQ(free[0].text, "hdr");
    EXPECT_NEAR(free[0].at.y - 4, 50, 2) << "the middle of its letters is on the line";
    EXPECT_NEAR(free[0].at.x, 150, 4);
    const std::vector<AreaPx> boxes{{0, 0, 300, 46}, {0, 54, 300, 46}};
    EXPECT_EQ(place_edge_names({way}, {{"hdr"}}, boxes, {300, 100})[0].text, "");
    const std::vector<EdgeName> shorter =
        place_edge_names({way}, {{std::string(60, 'x'), "hdr +7"}}, {}, {300, 100});
    EXPECT_EQ(shorter[0].text, "hdr +7");
    near.move({50, 54});
    near.line({250, 54});
    EXPECT_EQ(place_edge_names({way, near}, {{"hdr"}, {"depth"}}, {}, {300, 100})[0].text, "")
        << "one could take it for the other's";
    across.move({150, 0});
    across.line({150, 100});
    EXPECT_GT(std::abs(place_edge_names({way, across}, {{"hdr"}, {"x"}}, {}, {300, 100})[0].at.x - 150), 10);
    shared.move({50, 50});
    shared.line({150, 50});
    shared.line({250, 90});
    EXPECT_EQ(place_edge_names({way, shared}, {{"hdr"}, {"hdr"}}, {}, {300, 100})[0].text, "hdr");
}

// Returns a plan with the repeated pass "step", which has `rounds` iterations. Each iteration reads one of
// the two layers of the kept image "cells" and writes the other layer. If `rounds` is even, the first
// iteration reads the result of the previous frame. With `other_between`, the pass "other" runs between the
// first and the second iteration.
FramePlan rounds_plan(int rounds, bool other_between = false) {
    GraphBuilder b;
    const ResourceId cells = b.image("cells", Format::r32u, 16, 1, 2), side = b.image("side");
    (void)b.ring(cells, 0);
    for (int i = 1; i <= rounds; ++i) {
        const uint32_t from = static_cast<uint32_t>(i - 1) % 2, to = static_cast<uint32_t>(i) % 2;
        b.compute("step#" + std::to_string(i),
                  {{"before", cells, Access::sampled_read, one_cell(0, from), kNoId},
                   {"after", cells, Access::storage_write, one_cell(0, to), kNoId}});
        if (other_between && i == 1)
            b.compute("other", {{"src", cells, Access::sampled_read, one_cell(0, to), kNoId},
                                {"dst", side, Access::storage_write, {}, kNoId}});
    }
    if (other_between) b.after("other", "step#2");
    read_back(b, "out", cells);
    if (other_between) read_back(b, "outSide", side);
    return compiled(b);
}

TEST(PlanPageDrawing, APastIsReadFromTheLastWriterOnly) {
    const FramePlan plan = rounds_plan(10);
    const PlanPage page = make_page(plan, {});
    std::vector<std::string> history;
    for (const EdgeItem& edge : page.edges)
        if (edge.history)
            history.push_back(plan.graph.passes[edge.from].name + " to " + plan.graph.passes[edge.to].name);
    EXPECT_EQ(history, std::vector<std::string>{"step#10 to step#1"}) << "each earlier round was overwritten";
    EXPECT_NE(plan_to_html(plan, {}).find("left in an earlier frame"), std::string::npos);
}

TEST(PlanPageDrawing, RepeatsOfManyRoundsAreOneBoxThatOpens) {
    const std::string many = plan_to_html(rounds_plan(12), {}), few = plan_to_html(rounds_plan(4), {});
    EXPECT_EQ(read_markup(many).fault, "");
    EXPECT_NE(many.find("12 \xC3\x97 compute</text>"), std::string::npos);
    EXPECT_NE(many.find("aria-label=\"Draw every iteration of step\""), std::string::npos);
    EXPECT_NE(many.find("<summary>Every iteration: 13 passes</summary>"), std::string::npos);
    EXPECT_NE(many.find("step#12: 11  compute"), std::string::npos) << "the open drawing has them all";
    EXPECT_EQ(few.find("<summary>Every iteration"), std::string::npos) << "few are legible";
    // The iterations cannot be drawn as a single box, because pass `other` runs after the first iteration and
    // before the second one.
    EXPECT_EQ(plan_to_html(rounds_plan(12, true), {}).find("<summary>Every iteration"), std::string::npos);
}

TEST(PlanPageDrawing, QueuesWithoutWorkHaveNoRow) {
    GraphBuilder b;
    const ResourceId image = b.image("image");
    b.compute("make", {{"dst", image, Access::storage_write, {}, kNoId}});
    read_back(b, "out", image);
    const ResolvedGraph graph = b.build();
    CompileOptions options;
    options.queues.resize(3);
    const std::string text = plan_to_html(compile(graph, content_needs(graph, 1), options), {});
    EXPECT_NE(text.find("<b class=\"q0\">"), std::string::npos);
    EXPECT_EQ(text.find("<b class=\"q1\">"), std::string::npos);
    EXPECT_NE(text.find("No pass runs on queues 1 (graphics), 2 (graphics)."), std::string::npos);
}

TEST(PlanPageDrawing, SmallTextIsCutToItsRoomOrLeftOut) {
    EXPECT_EQ(small_text_in("fullscreen", 80), "fullscreen");
    EXPECT_EQ(small_text_in("fullscreen", 50), "fulls\xE2\x80\xA6");
    EXPECT_EQ(small_text_in("fullscreen", 20), "");
    EXPECT_EQ(small_text_in("12", 20), "12");
}

}  // namespace
}  // namespace weft::test
