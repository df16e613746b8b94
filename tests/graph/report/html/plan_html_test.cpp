// Tests that the HTML page of a plan contains the whole plan, shows each part in the right section, and loads
// no external files.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "graph/compile/bench_graph.h"
#include "graph/report/html/plan_page.h"
#include "tests/graph/compile/plan_expectations.h"
#include "tests/graph/report/html/markup_reader.h"
#include "tests/graph/samples/random_plan.h"

namespace weft::test {
namespace {

// Two plans of these seeds have a barrier at the end of the frame, which is rare.
constexpr uint32_t kFirstSeed = 40, kSeeds = 24;

FramePlan bench_plan(BenchShape shape, uint32_t passes) {
    const ResolvedGraph graph = make_bench_graph({passes, shape, 1});
    CompileOptions options;
    options.keep_all_passes = true;
    return compile(graph, bench_needs(graph), options);
}

size_t count_of(const std::string& text, const std::string& part) {
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

std::set<std::string> ids(const ReadPage& page, const std::string& tag) {
    std::set<std::string> found;
    for (const ReadElement& e : page.elements)
        if (e.tag == tag && e.attributes.count("id") > 0) {
            EXPECT_TRUE(found.insert(e.attributes.at("id")).second);
        }
    return found;
}

// Returns the keys of all links of the page that have the CSS class `style`. The key is the first word of the
// attribute data-k; for example, pass_key() makes the key of a pass.
std::multiset<std::string> items(const ReadPage& page, const std::string& style) {
    std::multiset<std::string> found;
    for (const ReadElement& e : page.elements)
        if (e.tag == "a" && e.attributes.count("data-k") > 0 &&
            (" " + e.attributes.at("class") + " ").find(" " + style + " ") != std::string::npos)
            found.insert(e.attributes.at("data-k").substr(0, e.attributes.at("data-k").find(' ')));
    return found;
}

void expect_all_of(const FramePlan& plan, const ReadPage& page) {
    const PlanPage data = make_page(plan, {});
    const std::set<std::string> articles = ids(page, "article");
    const std::multiset<std::string> passes = items(page, "pass"), barriers = items(page, "barrier"),
                                     waits = items(page, "wait"), edges = items(page, "edge");
    for (PassId pass(0); pass < plan.graph.passes.size(); ++pass) {
        EXPECT_EQ(articles.count(pass_key(pass)), 1u);
        EXPECT_EQ(passes.count(pass_key(pass)), plan.live.live_passes[pass] ? 2u : 1u) << "graph, timeline";
        EXPECT_EQ(items(page, "cellname").count(pass_key(pass)), plan.live.live_passes[pass] ? 0u : 1u);
    }
    const std::multiset<std::string> rows = items(page, "row"), blocks = items(page, "block"),
                                     names = items(page, "cellname");
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id) {
        EXPECT_EQ(articles.count(resource_key(id)), 1u);
        const bool transient = plan.graph.resources[id].lifetime == ResourceLifetime::transient;
        EXPECT_EQ(rows.count(resource_key(id)), plan.live.live_resources[id] ? 1u : 0u)
            << plan.graph.resources[id].name;
        EXPECT_EQ(blocks.count(resource_key(id)), transient && plan.live.live_resources[id] ? 1u : 0u);
        EXPECT_EQ(names.count(resource_key(id)), transient && plan.live.live_resources[id] ? 0u : 1u);
    }
    EXPECT_EQ(barriers.size(), data.barriers.size());
    EXPECT_EQ(waits.size(), data.waits.size());
    EXPECT_EQ(edges.size(), data.edges.size());
    for (size_t b = 0; b < data.barriers.size(); ++b)
        EXPECT_EQ(barriers.count(barrier_key(b)) * articles.count(barrier_key(b)), 1u);
    for (size_t w = 0; w < data.waits.size(); ++w)
        EXPECT_EQ(waits.count(wait_key(w)) * articles.count(wait_key(w)), 1u);
    for (size_t e = 0; e < data.edges.size(); ++e)
        EXPECT_EQ(edges.count(edge_key(e)) * articles.count(edge_key(e)), 1u);
    for (size_t s = 0; s < plan.submissions.batches.size(); ++s)
        EXPECT_EQ(items(page, "batch").count(batch_key(s)) * articles.count(batch_key(s)), 1u);
}

// Expects that every link leads to an element of the page, and that the page loads no external resource.
void expect_self_contained(const std::string& text, const ReadPage& page) {
    for (const char* part :
         {"http://", "https://", "src=", "@import", "url(h", "//cdn", "fetch(", "<link", "<img"})
        EXPECT_EQ(text.find(part), std::string::npos) << part;
    std::set<std::string> known;
    for (const ReadElement& e : page.elements)
        if (e.attributes.count("id") > 0) known.insert(e.attributes.at("id"));
    for (const ReadElement& e : page.elements)
        if (e.attributes.count("href") > 0) {
            EXPECT_EQ(known.count(e.attributes.at("href").substr(1)), 1u) << e.attributes.at("href");
        }
}

TEST(PlanHtml, HoldsAllOfRandomPlansAndIsWellFormed) {
    size_t waits = 0, culled = 0, histories = 0, epilogues = 0;
    for (uint32_t seed = kFirstSeed; seed < kFirstSeed + kSeeds; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const FramePlan plan = random_plan(seed, 40);
        const std::string text = plan_to_html(plan, {"random.json", "", "lavapipe"});
        const ReadPage page = read_markup(text);
        ASSERT_EQ(page.fault, "");
        expect_all_of(plan, page);
        expect_self_contained(text, page);
        waits += items(page, "wait").size();
        histories += items(page, "history").size();
        culled += plan.graph.passes.size() - plan.schedule.order.size();
        epilogues += plan.barriers.epilogue.size();
    }
    EXPECT_GT(waits, 20u);
    EXPECT_GT(culled, 5u);
    EXPECT_GT(histories, 5u);
    EXPECT_GT(epilogues, 0u);
}

TEST(PlanHtml, TheSamePlanGivesTheSameBytes) {
    for (uint32_t seed = 1; seed <= 4; ++seed)
        EXPECT_EQ(plan_to_html(random_plan(seed, 40), {"a", "b", "c"}),
                  plan_to_html(random_plan(seed, 40), {"a", "b", "c"}));
}

TEST(PlanHtml, CulledPassesSayWhy) {
    GraphBuilder b;
    const ResourceId used = b.image("used"), unused = b.image("unused");
    b.compute("make", {{"dst", used, Access::storage_write, {}, kNoId}});
    b.compute("waste", {{"src", used, Access::sampled_read, {}, kNoId},
                        {"dst", unused, Access::storage_write, {}, kNoId}});
    read_back(b, "out", used);
    const std::string text = plan_to_html(compiled(b), {});
    EXPECT_NE(text.find("<td>no pass reads &quot;unused&quot;</td>"), std::string::npos) << text;
    EXPECT_NE(text.find("class=\"i pass dead\""), std::string::npos);
    EXPECT_NE(text.find("unused: no running pass uses it"), std::string::npos);
}

// The page must explain a barrier as `weft explain barrier` does: with the reason, the ports and the states.
TEST(PlanHtml, BarriersAreExplained) {
    GraphBuilder b;
    const ResourceId image = b.image("picture");
    b.pass("draw", PassKind::fullscreen, {{"color", image, Access::color_write, {}, kNoId}});
    read_back(b, "out", image);
    const std::string text = plan_to_html(compiled(b), {});
    for (const char* part :
         {"Reason: a read after a write.", "port &quot;color&quot; writes &quot;picture&quot;",
          "<th scope=\"row\">layout</th><td>color attachment</td><td>transfer src</td>",
          "aria-label=\"barrier on picture before out: raw\""})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nis missing in\n" << text;
}

TEST(PlanHtml, WhoSharesMemorySaysWithWhomAndWhatSeparatesThem) {
    GraphBuilder b;
    const ResourceId first = b.image("early"), middle = b.image("middle"), last = b.image("late");
    b.compute("a", {{"dst", first, Access::storage_write, {}, kNoId}});
    b.compute("b", {{"src", first, Access::sampled_read, {}, kNoId},
                    {"dst", middle, Access::storage_write, {}, kNoId}});
    b.compute("c", {{"src", middle, Access::sampled_read, {}, kNoId},
                    {"dst", last, Access::storage_write, {}, kNoId}});
    read_back(b, "out", last);
    const std::string text = plan_to_html(compiled(b), {});
    EXPECT_NE(text.find("It shares memory with &quot;late&quot;"), std::string::npos) << text;
    EXPECT_NE(text.find("&quot;late&quot; takes over the memory from &quot;early&quot;, at 2 &quot;c&quot;"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("33.3 %"), std::string::npos) << "two thirds of the sum are enough";
}

TEST(PlanHtml, WhateverAFileIsCalledThePageStaysWhole) {
    GraphBuilder b;
    const ResourceId image = b.image("picture");
    b.pass("draw", PassKind::fullscreen, {{"color", image, Access::color_write, {}, kNoId}});
    read_back(b, "out", image);
    FramePlan plan = compiled(b);
    plan.graph.name = "</title><script>alert('1')</script>";
    plan.graph.sources.files.push_back({"a\"b&c<d>.json", ""});
    plan.graph.passes[0].loc = {0, 1, 2, 1};
    plan.graph.resources[0].loc = {0, 3, 4, 1};
    const std::string text = plan_to_html(plan, {"x\" onload=\"y' & \x01\xff</script>", "<low>", "\"p\""});
    const ReadPage page = read_markup(text);
    EXPECT_EQ(page.fault, "");
    EXPECT_EQ(count_of(text, "<script"), 1u);
    EXPECT_NE(text.find("x&quot; onload=&quot;y&#39; &amp; \xEF\xBF\xBD\xEF\xBF\xBD&lt;/script&gt;"),
              std::string::npos);
    EXPECT_NE(text.find("(a&quot;b&amp;c&lt;d&gt;.json:3:4)"), std::string::npos);
}

TEST(PlanHtml, FramesOfNothingHavePagesToo) {
    const FramePlan nothing = compile({}, {}, {});
    const ReadPage page = read_markup(plan_to_html(nothing, {}));
    EXPECT_EQ(page.fault, "");
    GraphBuilder b;
    const ResourceId kept = b.image("kept");
    b.ring(kept, 0);
    b.compute("change", {{"dst", kept, Access::storage_read_write, {}, kNoId}}).side_effect = true;
    const FramePlan plan = compiled(b);
    const std::string text = plan_to_html(plan, {});
    EXPECT_EQ(read_markup(text).fault, "");
    EXPECT_NE(text.find("The frame has no transient resources."), std::string::npos);
    EXPECT_EQ(text.find("No pass runs on"), std::string::npos) << "the panel says that none runs";
    expect_all_of(plan, read_markup(text));
}

TEST(PlanHtml, ManyPassesStayLegible) {
    for (const BenchShape shape : {BenchShape::chain, BenchShape::window32, BenchShape::random}) {
        SCOPED_TRACE(bench_shape_name(shape));
        const FramePlan plan = bench_plan(shape, 500);
        const std::string text = plan_to_html(plan, {});
        EXPECT_LT(text.size(), 8u << 20);
        const PlanPage page = make_page(plan, {});
        EXPECT_TRUE(page.columns.rotated_labels);
        for (size_t p = 1; p < page.columns.passes.size(); ++p) {
            const PageColumn &before = page.columns.passes[p - 1], &column = page.columns.passes[p];
            EXPECT_GE(column.left_px, before.left_px + before.width_px);
            EXPECT_GE(column.box_width_px, 24);
            EXPECT_LE(column.box_left_px + column.box_width_px, column.left_px + column.width_px);
        }
    }
}

}  // namespace
}  // namespace weft::test
