// Tests that change_values() returns the same graph as resolve(). Also tests that only_values_differ()
// returns false for changes that need more than new values.
#include "graph/resolve/change_values.h"

#include <random>

#include "tests/graph/resolve/resolve_fixture.h"
#include "weft/compile.h"

namespace weft::test {
namespace {

const std::vector<std::string> kNames{"a", "b", "c", "d"};

// The check of pass type "upload". Returns an error if the parameter "limit" of the pass is 3.
Status refuse_three(const PassDecl& pass, const ResolvedGraph&) {
    if (pass.custom_params.empty() || pass.custom_params[0].value != 3) return Unit{};
    Diagnostic d;
    d.code = "P003";
    d.message = "the limit must not be 3";
    return d;
}

class ChangeValues : public ResolveTest {
 protected:
    ChangeValues() {
        shaders["scalar"] = with_params(compute({image_out("dst")}), {member("a"), member("k")});
        shaders["vector"] =
            with_params(compute({image_out("dst")}), {member("v", 3), member("dstSize", 2), member("time")});
        shaders["repeat"] =
            with_params(compute({image_out("dst")}), {member("i"), member("n", 1, ScalarType::u32)});
        shaders["constant"] = with_constants(compute({image_out("dst")}), {{"LEVEL", ScalarType::i32}});
        PassType upload;
        upload.name = "upload";
        upload.ports = {Out{"lights", Access::copy_write}};
        upload.params = {ParamDecl{"limit", 8, 0, 16, ""}};
        upload.check = &refuse_three;
        passes["upload"] = upload;
        output_extent = {64, 36, 1};
    }

    // Returns a random expression of one or two parameters.
    std::string expression() {
        const auto name = [&] { return kNames[random_() % kNames.size()]; };
        switch (random_() % 4) {
            case 0:
                return name();
            case 1:
                return name() + " + " + std::to_string(random_() % 4);
            case 2:
                return name() + " * " + name();
            default:
                return "k + " + name();
        }
    }
    // Returns `number` or, with a probability of 1/8, an expression with a parameter. The expression replaces
    // the size of a resource or the condition of a pass, so a change of the parameter needs a new resolve().
    std::string rarely(const char* number) {
        return random_() % 8 == 0 ? "\"1 + " + kNames[random_() % kNames.size()] + "\"" : number;
    }
    // Returns the text of a random graph in which parameters are used in many places.
    std::string random_body() {
        const auto quoted = [&] { return "\"" + expression() + "\""; };
        const std::string scalar = random_() % 2 == 0 ? ", \"params\": {\"a\": " + quoted() + "}" : "";
        return "\"frames\": " + quoted() + R"j(,
"params": {"a": {"default": 1, "range": [1, 8]}, "b": {"default": 2}, "d": {"default": 1},
  "c": {"default": 1, "enum": [1, 2, 3]}},
"consts": {"k": "a * )j" + std::to_string(1 + random_() % 3) + R"j("},
"resources": {"x": {"format": "rgba16f", "size": [)j" + rarely("16") + R"j(, 8]}, "y": {"format": "rgba16f"},
  "z": {"format": "rgba16f", "layers": 4}, "lights": {"buffer": "Light", "count": )j" + rarely("4") + R"j(}},
"passes": {
  "scalar": {"type": "compute", "shader": "scalar", "out": {"dst": "x"})j" + scalar + R"j(,
    "cost": {"flops": )j" + quoted() + R"j(}},
  "vector": {"type": "compute", "shader": "vector", "out": {"dst": "y"}, "if": )j" + rarely("1") + R"j(,
    "params": {"v": [)j" + quoted() + ", 1, " + quoted() + R"j(]}},
  "repeat": {"type": "compute", "shader": "repeat", "repeat": {"i": "0..3"}, "out": {"dst": "z.layer(i)"},
    "params": {"n": "i * )j" + kNames[random_() % kNames.size()] + R"j("}},
  "u": {"type": "upload", "out": ["lights"], "params": {"limit": )j" + quoted() + R"j(}}
}, "tests": [{"size": [8, 8], "frames": 1, "expect": {"finite": ["x", "y", "z", "lights"]}}])j";
    }
    void change_request(GraphRequest& request) {
        for (uint32_t i = 0; i <= random_() % 2; ++i) {
            const std::string& name = kNames[random_() % kNames.size()];
            if (random_() % 6 == 0)
                request.params.erase(name);
            else
                request.params[name] = static_cast<double>(random_() % 5) + (random_() % 8 == 0 ? 0.5 : 0.0);
        }
    }

    std::mt19937 random_{1};
};

std::string text_of(const ResolvedGraph& graph) {
    std::string text = plan_hash(compile(graph, content_needs(graph), {}));
    for (const GraphParam& param : graph.params) text += " " + std::to_string(static_cast<int>(param.cost));
    return text + " frames " + std::to_string(graph.frames);
}

struct Counts {
    uint32_t changed = 0, refused = 0, faulty = 0;
};

TEST_F(ChangeValues, RandomChangesGiveTheGraphFromScratch) {
    Counts counts;
    for (uint32_t seed = 1; seed <= 200; ++seed) {
        random_.seed(seed);
        const Result<GraphDesc> desc = parsed(random_body());
        ASSERT_TRUE(desc) << to_text(desc.errors());
        const auto input = [&](const GraphRequest& request) {
            return ResolveInput{.graph = *desc,
                                .passes = passes,
                                .shaders = shaders,
                                .imports = imports,
                                .profile = profile,
                                .request = request};
        };
        GraphRequest request{.size = output_extent};
        std::optional<ResolvedGraph> known;
        for (int step = 0; step < 10; ++step) {
            GraphRequest next = request;
            change_request(next);
            const Result<ResolvedGraph> scratch = resolve(input(next), warnings);
            std::optional<ResolvedGraph> changed;
            if (known && only_values_differ(request, next, known->params)) {
                changed = change_values(input(next), *known);
                ASSERT_EQ(changed.has_value(), static_cast<bool>(scratch)) << "seed " << seed;
                if (changed) {
                    ASSERT_EQ(text_of(*changed), text_of(*scratch)) << "seed " << seed;
                }
                ++(changed ? counts.changed : counts.faulty);
            } else {
                ++counts.refused;
            }
            if (!scratch) continue;
            known = changed ? std::move(*changed) : *scratch;
            request = next;
        }
    }
    std::printf("seeds 1 to 200: %u changes of values, %u errors in values, %u changes of more than values\n",
                counts.changed, counts.faulty, counts.refused);
    EXPECT_GT(counts.changed, 300u);
    EXPECT_GT(counts.faulty, 20u);
    EXPECT_GT(counts.refused, 300u);
}

TEST_F(ChangeValues, OnlyCheapParametersAreValues) {
    const std::vector<GraphParam> known{{"gain", 1, ParamCost::live},
                                        {"level", 1, ParamCost::pipeline},
                                        {"size", 1, ParamCost::graph},
                                        {"unused", 1, ParamCost::nothing}};
    const GraphRequest plain;
    const auto differs_in = [&](const std::map<std::string, double>& values) {
        const GraphRequest other{.params = values};
        EXPECT_EQ(only_values_differ(plain, other, known), only_values_differ(other, plain, known));
        return only_values_differ(plain, other, known);
    };
    EXPECT_TRUE(differs_in({}));
    EXPECT_TRUE(differs_in({{"gain", 2}, {"unused", 3}}));
    EXPECT_FALSE(differs_in({{"level", 2}}));
    EXPECT_FALSE(differs_in({{"gain", 2}, {"size", 2}}));
    EXPECT_FALSE(differs_in({{"unknown", 2}}));
    EXPECT_FALSE(only_values_differ(plain, {.tier = "low"}, known));
    EXPECT_FALSE(only_values_differ(plain, {.size = {8, 8, 1}}, known));
    EXPECT_FALSE(only_values_differ(plain, {.debug = "x"}, known));
}

}  // namespace
}  // namespace weft::test
