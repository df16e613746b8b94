// Random expressions with live sizes: the values of a frame must equal those of the expressions, evaluated
// with the areas of the frame.
#include <cmath>
#include <random>

#include "graph/live/live_frame.h"
#include "graph/parse/expression.h"
#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/check/check_plan.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

constexpr uint32_t kSeeds = 150;

// The names of a frame, and their values.
class FrameNames final : public ExprNames {
 public:
    explicit FrameNames(std::map<std::string, ExprValue> values) : values_(std::move(values)) {}
    [[nodiscard]] std::optional<ExprValue> value(const std::string& name) const override {
        const auto found = values_.find(name);
        return found == values_.end() ? std::nullopt : std::optional(found->second);
    }
    [[nodiscard]] std::optional<uint32_t> mips(const std::string&) const override { return std::nullopt; }
    [[nodiscard]] std::vector<std::string> known_names() const override { return {}; }
    [[nodiscard]] std::vector<std::string> known_resources() const override { return {}; }

 private:
    std::map<std::string, ExprValue> values_;
};

class RandomLive : public ResolveTest {
 protected:
    RandomLive() {
        shaders["make"] = with_params(compute({image_out("dst")}), {member("v", 2), member("zoom")});
    }
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
    double number() { return static_cast<double>(below(64)) / 4; }

    // Returns a random expression whose value is a number.
    std::string expression(uint32_t depth) {
        static const std::vector<std::string> kNames{"render.x", "render.y", "half.x", "gain",
                                                     "zoom",     "output.y", "k"};
        if (depth == 0) return below(2) == 0 ? kNames[below(kNames.size())] : text(number());
        const std::string a = expression(depth - 1), b = expression(depth - 1);
        switch (below(7)) {
            case 0:
                return "(" + a + " + " + b + ")";
            case 1:
                return "(" + a + " - " + b + ")";
            case 2:
                return "(" + a + " * " + b + ")";
            case 3:
                return "(" + a + " / max(1, " + b + "))";
            case 4:
                return "min(" + a + ", " + b + ")";
            case 5:
                return "ceil(-" + a + ")";
            default:
                return "(floor(" + a + ") % 7)";
        }
    }
    static std::string text(double value) { return std::to_string(value); }

    std::mt19937 random_;
};

double expected(const std::string& text, const FrameNames& names) {
    const SourceMap sources;
    const Result<Expr> parsed = parse_expression({.text = text, .literal = {}}, sources);
    EXPECT_TRUE(parsed) << text;
    const Result<ExprValue> value = evaluate(*parsed, names, sources);
    EXPECT_TRUE(value) << text;
    return value ? value->x : 0;
}

ExprValue live_size(const ExprValue& size, double scale) {
    const auto side = [&](double px) { return std::max(1.0, std::ceil(px * scale - 1e-3)); };
    return size_value(side(size.x), side(size.y));
}

TEST_F(RandomLive, ValuesOfAFrameAreThoseOfTheExpressions) {
    for (uint32_t seed = 1; seed <= kSeeds; ++seed) {
        random_.seed(seed);
        output_extent = {1 + below(300), 1 + below(200), 1};
        const std::string first = expression(3), second = expression(2), k = "gain * half.y - 3";
        const ResolvedGraph graph = good(
            R"j("params": {"zoom": {"default": 1, "range": [0.1, 1]}, "gain": )j" + text(number()) + R"j(},
"consts": {"k": ")j" +
            k + R"j("}, "sizes": {"render": {"size": "output", "scale": "zoom"}, "half": "ceil(render / 2)"},
"resources": {"x": "rgba16f", "y": {"format": "rgba16f", "size": "half"}},
"passes": {"a": {"type": "compute", "shader": "make", "out": {"dst": "x"}, "params": {"v": [")j" +
            first + "\", \"" + second + R"j("]}},
           "b": {"type": "compute", "shader": "make", "out": {"dst": "y"}, "params": {"v": [0, "render.x"]},
                 "threads": "half"}},
"tests": [{"size": [8, 8], "frames": 1, "expect": {"finite": ["x", "y"]}}])j");
        const Diagnostics faults = check_plan(compile(graph, content_needs(graph), {}));
        ASSERT_TRUE(faults.empty()) << to_text(faults);
        for (uint32_t frame = 0; frame < 4; ++frame) {
            const double zoom = 0.1 + 0.3 * frame;
            std::vector<LiveNumber> values;
            evaluate_live(graph, {{"zoom", zoom}}, values);
            const ExprValue output = size_value(output_extent.width, output_extent.height);
            const ExprValue render = live_size(output, zoom);
            const ExprValue half = size_value(std::ceil(render.x / 2), std::ceil(render.y / 2));
            std::map<std::string, ExprValue> named{{"output", output},
                                                   {"render", render},
                                                   {"half", half},
                                                   {"zoom", number_value(zoom)},
                                                   {"gain", number_value(graph.params[0].value)}};
            named["k"] = number_value(graph.params[0].value * half.y - 3);
            const ParamWrite& v = pass_in(graph, "a").params[0];
            if (v.builtin == Builtin::live) {
                const FrameNames names(named);
                EXPECT_NEAR(values[v.live[0]].x, expected(first, names), 1e-6) << seed << ": " << first;
                EXPECT_NEAR(values[v.live[1]].x, expected(second, names), 1e-6) << seed << ": " << second;
            }
            const Extent3D area = live_area(resource_in(graph, "y"), values);
            EXPECT_EQ(area.width, half.x) << seed;
            EXPECT_EQ(area.height, half.y) << seed;
            EXPECT_EQ(live_groups(pass_in(graph, "b"), values)[0], std::ceil(half.x / 8)) << seed;
        }
    }
}

}  // namespace
}  // namespace weft::test
