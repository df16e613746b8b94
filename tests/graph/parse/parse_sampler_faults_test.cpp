// Tests the errors for faults in the object "sampler" of an input. "$$" marks the place of each expected
// error; the tests remove the marks before they parse the text.
#include "tests/graph/samples/marked_graph.h"

namespace weft::test {
namespace {

class ParseSamplerFaultTest : public ::testing::TestWithParam<FaultCase> {};
TEST_P(ParseSamplerFaultTest, IsAtItsValueWithARemedy) {
    check_parse_fault(GetParam());
}

std::string sampler(const std::string& body) {
    return "{\"version\": 1, \"passes\": {\n \"p\": {\"type\": \"compute\", \"shader\": \"a.comp\", "
           "\"in\": {\"src\": {\"ref\": \"x\", \"sampler\": {" +
           body + "}}}}}}";
}

INSTANTIATE_TEST_SUITE_P(
    Samplers, ParseSamplerFaultTest,
    ::testing::Values(
        FaultCase{"Key", sampler("$$\"aniso\": 2"), {"W101"}, "unknown key \"aniso\"", "anisotropy"},
        FaultCase{
            "Compare", sampler("\"compare\": $$\"less_eq\""), {"W109"}, "\"less_eq\"", "\"less_equal\""},
        FaultCase{"Reduction", sampler("\"reduction\": $$\"mean\""), {"W109"}, "\"mean\"", "\"average\""},
        FaultCase{"AnisotropyLow", sampler("\"anisotropy\": $$0.5"), {"W109"}, "found 0.5", "from 1 to 16"},
        FaultCase{"AnisotropyHigh", sampler("\"anisotropy\": $$17"), {"W109"}, "found 17", "from 1 to 16"},
        FaultCase{"AnisotropyText", sampler("\"anisotropy\": $$\"4\""), {"W102"}, "wanted number"},
        FaultCase{"Bias", sampler("\"lodBias\": $$-33"), {"W109"}, "found -33", "from -32 to 32"},
        FaultCase{"Huge", sampler("\"lodBias\": $$1e300"), {"W109"}, "out of range"},
        FaultCase{"MinLod", sampler("\"minLod\": $$-1"), {"W109"}, "found -1", "from 0 to 32"},
        FaultCase{"MaxLod", sampler("\"maxLod\": $$33"), {"W109"}, "found 33", "from 0 to 32"},
        FaultCase{"LodOrder",
                  sampler("\"maxLod\": $$1, \"minLod\": 2"),
                  {"W109"},
                  "\"maxLod\" is less than \"minLod\"",
                  "exchange"},
        FaultCase{"NearestAnisotropy",
                  sampler("\"filter\": \"nearest\", \"anisotropy\": $$2"),
                  {"W109"},
                  "takes the nearest texel",
                  "\"filter\": \"linear\""},
        FaultCase{"ReducedComparison",
                  sampler("\"compare\": \"less\", \"reduction\": $$\"min\""),
                  {"W109"},
                  "cannot also",
                  "remove"},
        FaultCase{"ReductionOfOneTexel",
                  sampler("\"reduction\": $$\"max\", \"filter\": \"nearest\", \"mipFilter\": \"nearest\""),
                  {"W109"},
                  "only one texel",
                  "\"filter\": \"linear\""}),
    case_name);

}  // namespace
}  // namespace weft::test
