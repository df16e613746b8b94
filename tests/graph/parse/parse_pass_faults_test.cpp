// Tests the errors for faults in passes and in their pipeline states. "$$" marks the place of each expected
// error; the tests remove the marks before they parse the text.
#include "tests/graph/samples/marked_graph.h"

namespace weft::test {
namespace {

class ParsePassFaultTest : public ::testing::TestWithParam<FaultCase> {};
TEST_P(ParsePassFaultTest, IsAtItsValueWithARemedy) {
    check_parse_fault(GetParam());
}

std::string pass(const std::string& body) {
    return "{\"version\": 1, \"passes\": {\n \"p\": {" + body + "}}}";
}
std::string marked_pass(const std::string& body) {
    return "{\"version\": 1, \"passes\": {\n $$\"p\": {" + body + "}}}";
}
std::string compute(const std::string& body) {
    return pass("\"type\": \"compute\", \"shader\": \"a.comp\", " + body);
}
std::string raster(const std::string& body) {
    return pass("\"type\": \"raster\", \"shader\": \"a\", \"draws\": [\"d\"], \"out\": [\"c\"], " + body);
}
std::string draws(const std::string& value) {
    return pass("\"type\": \"raster\", \"shader\": \"a\", \"out\": [\"c\"], \"draws\": " + value);
}
std::string state(const std::string& body) {
    return raster("\"depth\": \"z\", \"state\": {" + body + "}");
}

INSTANTIATE_TEST_SUITE_P(
    Passes, ParsePassFaultTest,
    ::testing::Values(
        FaultCase{"NoType", marked_pass("\"shader\": \"a.comp\""), {"W108"}, "\"type\""},
        FaultCase{"TypeSlip",
                  pass("\"type\": $$\"computee\", \"shader\": \"a.comp\""),
                  {"W115"},
                  "unknown pass type \"computee\"",
                  "did you mean \"compute\"?"},
        FaultCase{"NoShader", marked_pass("\"type\": \"compute\""), {"W108"}, "\"shader\""},
        FaultCase{"NoDraws", marked_pass("\"type\": \"raster\", \"shader\": \"a\""), {"W108"}, "\"draws\""},
        FaultCase{"CopyNeedsIn", marked_pass("\"type\": \"copy\", \"out\": [\"a\"]"), {"W108"}, "\"in\""},
        FaultCase{
            "UnknownPassKey", compute("$$\"shaders\": 1"), {"W101"}, "unknown key \"shaders\"", "\"shader\""},
        FaultCase{"PerFrameList", compute("\"perFrame\": $$[1]"), {"W102"}, "a number or an expression"},
        FaultCase{"RepeatOfNothing", compute("\"repeat\": $${}"), {"W109"}, "has no index", "\"0..3\""},
        FaultCase{"RepeatNumber", compute("\"repeat\": {\"i\": $$4}"), {"W102"}, "a range in a string"},
        FaultCase{
            "RepeatOfOne", compute("\"repeat\": {\"i\": \"4$$\"}"), {"W106"}, "ends where \"..\"", "a..b"},
        FaultCase{
            "RepeatToNowhere", compute("\"repeat\": {\"i\": \"4..$$\"}"), {"W106"}, "the expression ends"},
        FaultCase{
            "RepeatByWhat", compute("\"repeat\": {\"i\": \"4..0 $$down\"}"), {"W106"}, "\"by\"", "by -1"},
        FaultCase{"RepeatTail", compute("\"repeat\": {\"i\": \"4..0 by -1 $$x\"}"), {"W106"}, "the end"},
        FaultCase{"RepeatReserved",
                  compute("\"repeat\": {$$\"min\": \"0..1\"}"),
                  {"W109"},
                  "already a reserved word",
                  "another name"},
        FaultCase{"ResolveWhat",
                  raster("\"resolve\": {\"x\": $$\"cc\"}"),
                  {"W109"},
                  "\"cc\" is not an allowed value",
                  "did you mean \"c\"?"},
        FaultCase{"ResolveOfDepth",
                  raster("\"depth\": \"z\", \"resolve\": {\"x\": $$\"depth\"}"),
                  {"W109"},
                  "depth can't be resolved",
                  "sampler2DMS"},
        FaultCase{"ResolveWhere", raster("\"resolve\": {\"x$$!\": \"c\"}"), {"W106"}, "found '!'"},
        FaultCase{"ResolveOfACompute",
                  compute("$$\"resolve\": {}"),
                  {"W101"},
                  "does not use the key \"resolve\"",
                  "\"raster\""},
        FaultCase{"IndirectTypo",
                  compute("\"groups\": {$$\"inderect\": \"a\"}"),
                  {"W101"},
                  "\"inderect\"",
                  "did you mean \"indirect\"?"},
        FaultCase{"IndirectTwice",
                  compute("\"in\": {$$\"indirect\": \"b\"}, \"groups\": {\"indirect\": \"a\"}"),
                  {"W109"},
                  "\"indirect\" is reserved for the indirect commands",
                  "another name"},
        FaultCase{"DrawsTypo",
                  draws("{\"list\": \"a\", $$\"indirekt\": \"b\"}"),
                  {"W101"},
                  "\"indirekt\"",
                  "did you mean \"indirect\"?"},
        FaultCase{
            "DrawsOfNoCommands", draws("$${\"count\": \"b\"}"), {"W108"}, "\"indirect\"", "name the buffer"},
        FaultCase{"DrawsByNothing",
                  draws("$${\"list\": \"a\"}"),
                  {"W108"},
                  "\"indirect\"",
                  "\"draws\": [\"opaque\"]"},
        FaultCase{"IfString", compute("\"if\": $$[]"), {"W102"}, "a number or an expression"},
        FaultCase{"IfSyntax", compute("\"if\": \"a +$$\""), {"W106"}, "ends where"},
        FaultCase{
            "ConstantVector", compute("\"constants\": {$$\"N\": [1, 2]}"), {"W109"}, "must be one value"},
        FaultCase{"OptionalNumber",
                  compute("\"in\": {\"a\": {\"ref\": \"x\", \"optional\": $$1}}"),
                  {"W102"},
                  "found number"},
        FaultCase{"ElseReference",
                  compute("\"in\": {\"a\": {\"ref\": \"x\", \"else\": \"y$$!\"}}"),
                  {"W106"},
                  "found '!'"},
        FaultCase{"OptionalOutput",
                  compute("\"out\": {\"a\": {\"ref\": \"x\", $$\"optional\": true}}"),
                  {"W101"},
                  "in an output"},
        FaultCase{"GroupsOnRaster",
                  raster("$$\"groups\": 1"),
                  {"W101"},
                  "a \"raster\" pass does not use the key \"groups\"",
                  "type \"compute\""},
        FaultCase{"DrawsOnCompute",
                  compute("$$\"draws\": []"),
                  {"W101"},
                  "does not use the key \"draws\"",
                  "\"raster\""},
        FaultCase{"StateOnCompute",
                  compute("$$\"state\": {\"bad\": 1}"),
                  {"W101"},
                  "does not use the key \"state\""},
        FaultCase{"ClearWithIn",
                  pass("\"type\": \"clear\", \"out\": [\"a\"], $$\"in\": [\"b\"]"),
                  {"W101"},
                  "does not use the key \"in\""},
        FaultCase{
            "Queue", compute("\"queue\": $$\"asinc\""), {"W109"}, "\"asinc\"", "did you mean \"async\"?"},
        FaultCase{"BothDispatches", compute("\"groups\": 1, \"threads\": $$1"), {"W109"}, "cannot have both"},
        FaultCase{"GroupsFour", compute("\"groups\": $$[1, 1, 1, 1]"), {"W109"}, "wanted 1 to 3"},
        FaultCase{"BadReference", compute("\"in\": [\"a\", \"b.$$mpi(0)\"]"), {"W106"}, "unknown selector"},
        FaultCase{"EmptyReference", compute("\"in\": [\"$$\"]"), {"W106"}, "name of a resource"},
        FaultCase{"MipExpression", compute("\"in\": {\"x\": \"a.mip(1 +$$)\"}"), {"W106"}, "found ')'"},
        FaultCase{"NumberInList", compute("\"in\": [\"a\", $$3]"), {"W102"}, "found number, wanted string"},
        FaultCase{"PortNumber", compute("\"out\": {\"a\": $$3}"), {"W102"}, "wanted a reference"},
        FaultCase{"InNumber", compute("\"in\": $$3"), {"W102"}, "wanted a list"},
        FaultCase{
            "PortName", compute("\"in\": {$$\"a-b\": \"a\"}"), {"W109"}, "is not a valid name for a port"},
        FaultCase{"NoRef", compute("\"in\": {$$\"a\": {}}"), {"W108"}, "\"ref\""},
        FaultCase{"SamplerOnOutput",
                  compute("\"out\": {\"a\": {\"ref\": \"a\", $$\"sampler\": {}}}"),
                  {"W101"},
                  "\"sampler\""},
        FaultCase{"Filter",
                  compute("\"in\": {\"a\": {\"ref\": \"a\", \"sampler\": {\"filter\": $$\"liner\"}}}"),
                  {"W109"},
                  "\"liner\"",
                  "did you mean \"linear\"?"},
        FaultCase{"ParamFive", compute("\"params\": {\"a\": $$[1, 2, 3, 4, 5]}"), {"W109"}, "wanted 1 to 4"},
        FaultCase{"ParamNull", compute("\"params\": {\"a\": $$null}"), {"W102"}, "found null"},
        FaultCase{"After", compute("\"after\": [\"a\", $$1]"), {"W102"}, "wanted string"},
        FaultCase{"AfterString", compute("\"after\": $$\"a\""), {"W102"}, "wanted array"},
        FaultCase{
            "Cost", compute("\"cost\": {$$\"flop\": 1}"), {"W101"}, "\"flop\"", "did you mean \"flops\"?"},
        FaultCase{
            "PassString", "{\"version\": 1, \"passes\": {\"p\": $$\"compute\"}}", {"W102"}, "wanted object"}),
    case_name);

INSTANTIATE_TEST_SUITE_P(
    States, ParsePassFaultTest,
    ::testing::Values(
        FaultCase{"UnknownState",
                  state("$$\"depthClmp\": true"),
                  {"W101"},
                  "\"depthClmp\"",
                  "did you mean \"depthClamp\"?"},
        FaultCase{"Cull", state("\"cull\": $$\"bakc\""), {"W109"}, "\"bakc\"", "did you mean \"back\"?"},
        FaultCase{"Depth",
                  state("\"depth\": $$\"greater_wirte\""),
                  {"W109"},
                  "\"greater_wirte\"",
                  "\"greater_write\""},
        FaultCase{
            "DepthWithout", raster("\"state\": {\"depth\": $$\"less\"}"), {"W109"}, "no depth attachment"},
        FaultCase{
            "Bias", state("\"depthBias\": {$$\"slop\": 1}"), {"W101"}, "\"slop\"", "did you mean \"slope\"?"},
        FaultCase{
            "StencilByte", state("\"stencil\": {\"reference\": $$256}"), {"W109"}, "found 256", "0 to 255"},
        FaultCase{
            "StencilFace", state("\"stencil\": {\"front\": {}, $$\"pass\": \"keep\"}"), {"W101"}, "\"pass\""},
        FaultCase{"Scissor", state("\"scissor\": [0, 0, $$0, 1]"), {"W109"}, "found 0"},
        FaultCase{"ScissorOutside", state("\"scissor\": [$$-1, 0, 1, 1]"), {"W109"}, "found -1", "0 to"},
        FaultCase{"Blend", state("\"blend\": $$\"ad\""), {"W109"}, "\"ad\"", "did you mean \"add\"?"},
        FaultCase{"BlendPort",
                  state("\"blend\": {$$\"cc\": \"add\"}"),
                  {"W101"},
                  "no output \"cc\"",
                  "did you mean \"c\"?"},
        FaultCase{"BlendFactor",
                  state("\"blend\": {\"color\": [\"one\", \"add\", $$\"two\"]}"),
                  {"W109"},
                  "\"two\""},
        FaultCase{
            "BlendCount", state("\"blend\": {\"color\": $$[\"one\", \"add\"]}"), {"W109"}, "wanted three"},
        FaultCase{"Mask", state("\"writeMask\": $$\"rgx\""), {"W109"}, "not a set of channels"},
        FaultCase{"MaskTwice", state("\"writeMask\": {\"c\": $$\"rr\"}"), {"W109"}, "not a set of channels"},
        FaultCase{"FullscreenDepth",
                  marked_pass(
                      "\"type\": \"fullscreen\", \"shader\": \"a.frag\", \"out\": [\"c\"], \"depth\": \"z\""),
                  {"W108"},
                  "needs the key \"depth\""},
        FaultCase{"DepthTwice",
                  pass("\"type\": \"raster\", \"shader\": \"a\", \"draws\": [\"d\"], \"depth\": \"z\", "
                       "\"out\": [$$\"depth\"]"),
                  {"W109"},
                  "an output called \"depth\""}),
    case_name);

}  // namespace
}  // namespace weft::test
