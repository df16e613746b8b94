#include "graph/report/html/layered_layout.h"

#include <gtest/gtest.h>

#include <random>

namespace weft::test {
namespace {

struct Drawing {
    std::vector<LayoutBox> boxes;
    std::vector<LayoutEdge> edges;
};

// Returns a random drawing of `count` boxes. Each edge leads from a box with a lower number to a box with a
// higher number.
Drawing random_drawing(uint32_t seed, uint32_t count) {
    std::mt19937 random(seed);
    Drawing drawing;
    for (uint32_t i = 0; i < count; ++i)
        drawing.boxes.push_back({static_cast<int32_t>(40 + random() % 100), 40});
    for (uint32_t to = 1; to < count; ++to)
        for (uint32_t k = random() % 3; k > 0; --k)
            drawing.edges.push_back({static_cast<uint32_t>(random() % to), to});
    return drawing;
}

bool overlap(const Drawing& d, const LayeredLayout& l, uint32_t a, uint32_t b) {
    return l.boxes[a].x < l.boxes[b].x + d.boxes[b].width_px &&
           l.boxes[b].x < l.boxes[a].x + d.boxes[a].width_px &&
           l.boxes[a].y < l.boxes[b].y + d.boxes[b].height_px &&
           l.boxes[b].y < l.boxes[a].y + d.boxes[a].height_px;
}

TEST(LayeredLayout, BoxesDoNotOverlapAndEdgesLeadToTheRight) {
    for (uint32_t seed = 0; seed < 40; ++seed) {
        const Drawing drawing = random_drawing(seed, 2 + seed * 2);
        const LayeredLayout layout = layered_layout(drawing.boxes, drawing.edges, 60);
        for (uint32_t a = 0; a < drawing.boxes.size(); ++a) {
            EXPECT_GE(layout.boxes[a].x, 0);
            EXPECT_GE(layout.boxes[a].y, 0);
            EXPECT_LE(layout.boxes[a].x + drawing.boxes[a].width_px, layout.width_px);
            EXPECT_LE(layout.boxes[a].y + drawing.boxes[a].height_px, layout.height_px + 1);
            for (uint32_t b = 0; b < a; ++b)
                EXPECT_FALSE(overlap(drawing, layout, a, b)) << a << " and " << b;
        }
        for (size_t e = 0; e < drawing.edges.size(); ++e) {
            const LayoutEdge& edge = drawing.edges[e];
            int32_t x_px = layout.boxes[edge.from].x + drawing.boxes[edge.from].width_px;
            for (const PointPx& bend : layout.bends[e]) {
                EXPECT_GE(bend.x, x_px);
                x_px = bend.x;
            }
            EXPECT_GE(layout.boxes[edge.to].x, x_px);
        }
    }
}

TEST(LayeredLayout, EdgesGoAroundBoxes) {
    for (uint32_t seed = 0; seed < 40; ++seed) {
        const Drawing drawing = random_drawing(seed, 20);
        const LayeredLayout layout = layered_layout(drawing.boxes, drawing.edges, 60);
        for (const std::vector<PointPx>& bends : layout.bends)
            for (size_t i = 0; i + 1 < bends.size(); i += 2)
                for (uint32_t box = 0; box < drawing.boxes.size(); ++box) {
                    const PointPx at = layout.boxes[box];
                    const bool beside =
                        bends[i + 1].x <= at.x || at.x + drawing.boxes[box].width_px <= bends[i].x;
                    EXPECT_TRUE(beside || bends[i].y < at.y ||
                                bends[i].y > at.y + drawing.boxes[box].height_px);
                }
    }
}

TEST(LayeredLayout, AChainIsAStraightLine) {
    const LayeredLayout layout = layered_layout({{50, 40}, {50, 40}, {50, 40}}, {{0, 1}, {1, 2}}, 60);
    EXPECT_EQ(layout.layers, 3u);
    EXPECT_EQ(layout.boxes[0].y, layout.boxes[2].y);
    EXPECT_EQ(layout.boxes[2].x, 220);
    EXPECT_EQ(layout.width_px, 270);
    EXPECT_EQ(layout.height_px, 40);
}

// The edges 0 -> 3 and 1 -> 2 cross if the boxes stay in the order of declaration. The layout must order the
// boxes so that the edges do not cross.
TEST(LayeredLayout, CrossingsThatNeedNotBeAreNot) {
    const LayeredLayout layout = layered_layout({{9, 9}, {9, 9}, {9, 9}, {9, 9}}, {{0, 3}, {1, 2}}, 60);
    EXPECT_EQ(layout.boxes[0].y < layout.boxes[1].y, layout.boxes[3].y < layout.boxes[2].y);
}

// Box 1 is between the boxes 0 and 2, and the edge 0 -> 2 passes above or below box 1. In pixels, the drawing
// needs the heights of a box (40), of a gap (20) and of an edge (6). The test allows 10 more.
TEST(LayeredLayout, IsNoLargerThanWhatItShows) {
    const LayeredLayout layout = layered_layout({{50, 40}, {50, 40}, {50, 40}}, {{0, 1}, {1, 2}, {0, 2}}, 60);
    EXPECT_LE(layout.height_px, 40 + 20 + 6 + 10) << "and a little for leaning";
}

TEST(LayeredLayout, NothingIsAPictureToo) {
    EXPECT_EQ(layered_layout({}, {}, 60).width_px, 0);
}

}  // namespace
}  // namespace weft::test
