#include "marked_graph.h"

namespace weft::test {
namespace {

class ParseFaultTest : public ::testing::TestWithParam<FaultCase> {};
TEST_P(ParseFaultTest, IsAtItsValueWithARemedy) {
    check_parse_fault(GetParam());
}

std::string top(const std::string& rest) {
    return "{\"version\": 1, \"passes\": {},\n " + rest + "}";
}
std::string resource(const std::string& body) {
    return top("\"resources\": {\"r\": " + body + "}");
}
std::string marked_resource(const std::string& body) {
    return top("\"resources\": {$$\"r\": " + body + "}");
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
    Top, ParseFaultTest,
    ::testing::Values(
        FaultCase{"NotAnObject", "$$[]", {"W102"}, "found array, wanted object"},
        FaultCase{"NoVersion", "$${\"passes\": {}}", {"W108"}, "needs the key \"version\""},
        FaultCase{"NoPasses", "$${\"version\": 1}", {"W108"}, "needs the key \"passes\""},
        FaultCase{
            "LaterVersion", "{\"version\": $$2, \"passes\": {}}", {"W109"}, "version 2", "reads version 1"},
        FaultCase{"VersionString",
                  "{\"version\": $$\"1\", \"passes\": {}}",
                  {"W102"},
                  "found string, wanted number",
                  "without quotes"},
        FaultCase{"UnknownKey",
                  top("$$\"resorces\": {}"),
                  {"W101"},
                  "unknown key \"resorces\"",
                  "did you mean \"resources\"?"},
        FaultCase{"Null", top("\"sizes\": $$null"), {"W102"}, "found null, wanted object"},
        FaultCase{
            "BadName", top("\"consts\": {$$\"2d\": 1}"), {"W109"}, "\"2d\" cannot be the name", "letters"},
        FaultCase{"ConstBoolean", top("\"consts\": {\"a\": $$true}"), {"W102"}, "wanted a number"},
        FaultCase{"ReservedSize", top("\"sizes\": {$$\"output\": 1}"), {"W109"}, "\"output\" has a meaning"},
        FaultCase{"ReservedParam", top("\"params\": {$$\"max\": 1}"), {"W109"}, "\"max\" has a meaning"},
        FaultCase{
            "NameTwice", top("\"consts\": {\"a\": 1}, \"sizes\": {$$\"a\": 2}"), {"W109"}, "\"a\" is taken"},
        FaultCase{"ImportAndResource",
                  top("\"imports\": {\"a\": \"buffer\"}, \"resources\": {$$\"a\": \"r8\"}"),
                  {"W109"},
                  "\"a\" is taken"},
        FaultCase{"ImportKind",
                  top("\"imports\": {\"a\": $$\"drawlst\"}"),
                  {"W118"},
                  "\"drawlst\"",
                  "did you mean \"drawlist\"?"},
        FaultCase{"ImportNoKind", top("\"imports\": {$$\"a\": {}}"), {"W108"}, "\"kind\""},
        FaultCase{"SizeExpression", top("\"sizes\": {\"a\": \"output $$^ 2\"}"), {"W106"}, "found '^'"},
        FaultCase{
            "SizeThree", top("\"sizes\": {\"a\": $$[1, 2, 3]}"), {"W109"}, "found 3 values, wanted two"},
        FaultCase{
            "SizeBool", top("\"sizes\": {\"a\": $$true}"), {"W102"}, "wanted a number or an expression"},
        FaultCase{"Frames", top("\"frames\": $$0"), {"W109"}, "found 0, wanted a whole number"},
        FaultCase{"Jitter", top("\"jitter\": $$65"), {"W109"}, "found 65, wanted a whole number"},
        FaultCase{"JitterPart", top("\"jitter\": $$0.5"), {"W109"}, "found 0.5, wanted a whole number"},
        FaultCase{"JitterText", top("\"jitter\": $$\"8\""), {"W102"}, "wanted number"},
        FaultCase{
            "ParamNoDefault", top("\"params\": {$$\"a\": {\"unit\": \"EV\"}}"), {"W108"}, "\"default\""},
        FaultCase{"ParamOutside",
                  top("\"params\": {\"a\": {\"default\": $$9, \"range\": [0, 1]}}"),
                  {"W109"},
                  "outside the range"},
        FaultCase{"ParamUnlisted",
                  top("\"params\": {\"a\": {\"default\": $$9, \"enum\": [0, 1]}}"),
                  {"W109"},
                  "not listed"},
        FaultCase{"ParamRange",
                  top("\"params\": {\"a\": {\"default\": 0, \"range\": $$[1, 0]}}"),
                  {"W109"},
                  "range ends"},
        FaultCase{"ParamBoolRange",
                  top("\"params\": {\"a\": {\"default\": true, \"range\": $$[0, 1]}}"),
                  {"W109"},
                  "true or false has no \"range\""},
        FaultCase{
            "ParamStep", top("\"params\": {\"a\": {\"default\": 0, \"step\": $$0}}"), {"W109"}, "above zero"},
        FaultCase{"ParamString", top("\"params\": {\"a\": $$\"1\"}"), {"W102"}, "wanted object"},
        FaultCase{"AllAtOnce",
                  top("\"frames\": $$true, \"name\": $$7, \"sizes\": {\"a\": \"1 +$$\", $$\"b-\": 1}"),
                  {"W102", "W102", "W106", "W109"},
                  "wanted a number or an expression"}),
    case_name);

INSTANTIATE_TEST_SUITE_P(
    Resources, ParseFaultTest,
    ::testing::Values(
        FaultCase{"UnknownFormat",
                  resource("\"rgba16f|$$rgba61f\""),
                  {"W116"},
                  "unknown format \"rgba61f\"",
                  "did you mean"},
        FaultCase{"EmptyFormat", resource("$$\"\""), {"W109"}, "empty"},
        FaultCase{"UnknownKeyR",
                  resource("{\"format\": \"r8\", $$\"mip\": 1}"),
                  {"W101"},
                  "unknown key \"mip\"",
                  "did you mean \"mips\"?"},
        FaultCase{"HistoryTooLong",
                  resource("{\"format\": \"r8\", \"history\": $$17}"),
                  {"W109"},
                  "wanted a whole number",
                  "0 to 16"},
        FaultCase{"HistoryAndKeep",
                  resource("{\"format\": \"r8\", \"history\": 1, \"keep\": $$true}"),
                  {"W109"},
                  "not both",
                  "remove one"},
        FaultCase{"KeepWhat",
                  resource("{\"format\": \"r8\", \"keep\": $$\"shard\"}"),
                  {"W109"},
                  "\"shard\" is not among",
                  "did you mean \"shared\"?"},
        FaultCase{"KeepNumber", resource("{\"format\": \"r8\", \"keep\": $$1}"), {"W102"}, "found number"},
        FaultCase{"FirstFrameOfATransient",
                  resource("{\"format\": \"r8\", \"firstFrame\": $$0, \"onResize\": $$\"clear\"}"),
                  {"W109", "W109"},
                  "lives within one frame",
                  "\"history\": 1"},
        FaultCase{"FirstFrameOfThree",
                  resource("{\"format\": \"r8\", \"keep\": true, \"firstFrame\": $$[0, 0, 0]}"),
                  {"W109"},
                  "wanted 4"},
        FaultCase{"OnResizeHow",
                  resource("{\"format\": \"r8\", \"history\": 1, \"onResize\": $$\"resmaple\"}"),
                  {"W109"},
                  "not among",
                  "did you mean \"resample\"?"},
        FaultCase{"ResampledBuffer",
                  resource("{\"buffer\": \"u32\", \"count\": 1, \"keep\": true, "
                           "\"onResize\": $$\"resample\"}"),
                  {"W109"},
                  "can't be resampled",
                  "\"refill\""},
        FaultCase{"Samples",
                  resource("{\"format\": \"r8\", \"samples\": $$3}"),
                  {"W109"},
                  "3 samples",
                  "1, 2, 4 or 8"},
        FaultCase{"SamplesAndMips",
                  resource("{\"format\": \"r8\", \"samples\": 4, \"mips\": $$2}"),
                  {"W109"},
                  "one mip"},
        FaultCase{"SamplesOfACube",
                  resource("{\"format\": \"r8\", \"cube\": 64, \"samples\": $$4}"),
                  {"W109"},
                  "can't be multisampled"},
        FaultCase{"Kind",
                  resource("{\"format\": \"r8\", \"kind\": $$\"cubearray\"}"),
                  {"W109"},
                  "not among",
                  "did you mean \"cubeArray\"?"},
        FaultCase{"LayersOf2D",
                  resource("{\"format\": \"r8\", \"kind\": \"2d\", \"layers\": $$2}"),
                  {"W109"},
                  "no layers",
                  "\"array\""},
        FaultCase{"LayersOfACube",
                  resource("{\"format\": \"r8\", \"cube\": 64, \"layers\": $$2}"),
                  {"W109"},
                  "no layers",
                  "\"cubeArray\""},
        FaultCase{"LayersOf3D",
                  resource("{\"format\": \"r8\", \"kind\": \"3d\", \"layers\": $$2}"),
                  {"W109"},
                  "no layers",
                  "\"depth\""},
        FaultCase{"DepthOf2D",
                  resource("{\"format\": \"r8\", \"depth\": $$2}"),
                  {"W109"},
                  "only 3D images",
                  "\"3d\""},
        FaultCase{"CubeAndSize",
                  resource("{\"format\": \"r8\", \"cube\": 64, \"size\": $$64, \"kind\": $$\"cube\"}"),
                  {"W109", "W109"},
                  "already says the size"},
        FaultCase{"NoFormat", marked_resource("{\"size\": 1}"), {"W108"}, "\"format\""},
        FaultCase{"NoCount", marked_resource("{\"buffer\": \"u32\"}"), {"W108"}, "\"count\""},
        FaultCase{"BufferWithMips",
                  resource("{\"buffer\": \"u32\", \"count\": 1, $$\"mips\": 2}"),
                  {"W101"},
                  "a buffer has no \"mips\""},
        FaultCase{"ImageWithCount",
                  resource("{\"format\": \"r8\", $$\"count\": 1}"),
                  {"W101"},
                  "an image has no \"count\""},
        FaultCase{"ClearThree",
                  resource("{\"format\": \"r8\", \"clear\": $$[0, 0, 0]}"),
                  {"W109"},
                  "found 3 values, wanted 4"},
        FaultCase{"ClearBoolean",
                  resource("{\"format\": \"r8\", \"clear\": [0, 0, $$false, 0]}"),
                  {"W102"},
                  "wanted a number or an expression"},
        FaultCase{
            "ClearHuge", resource("{\"format\": \"r8\", \"clear\": $$1e300}"), {"W109"}, "out of range"},
        FaultCase{"PreExposed",
                  resource("{\"format\": \"r8\", \"preExposed\": $$\"true\"}"),
                  {"W102"},
                  "wanted true or false",
                  "without quotes"},
        FaultCase{"Mips", resource("{\"format\": \"r8\", \"mips\": \"3 $$full\"}"), {"W106"}, "found 'f'"},
        FaultCase{"ResourceNumber", resource("$$3"), {"W102"}, "found number, wanted object"}),
    case_name);

INSTANTIATE_TEST_SUITE_P(
    Passes, ParseFaultTest,
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
        FaultCase{"RepeatOfNothing", compute("\"repeat\": $${}"), {"W109"}, "without an index", "\"0..3\""},
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
                  "already a word",
                  "another name"},
        FaultCase{"ResolveWhat",
                  raster("\"resolve\": {\"x\": $$\"cc\"}"),
                  {"W109"},
                  "\"cc\" is not among",
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
                  "no use for \"resolve\"",
                  "\"raster\""},
        FaultCase{"IndirectTypo",
                  compute("\"groups\": {$$\"inderect\": \"a\"}"),
                  {"W101"},
                  "\"inderect\"",
                  "did you mean \"indirect\"?"},
        FaultCase{"IndirectTwice",
                  compute("\"in\": {$$\"indirect\": \"b\"}, \"groups\": {\"indirect\": \"a\"}"),
                  {"W109"},
                  "a port called \"indirect\"",
                  "another name"},
        FaultCase{"DrawsTypo",
                  draws("{\"list\": \"a\", $$\"indirekt\": \"b\"}"),
                  {"W101"},
                  "\"indirekt\"",
                  "did you mean \"indirect\"?"},
        FaultCase{
            "DrawsOfNoList", draws("$${\"indirect\": \"b\"}"), {"W108"}, "\"list\"", "name the draw list"},
        FaultCase{"DrawsByNothing",
                  draws("$${\"list\": \"a\"}"),
                  {"W108"},
                  "\"indirect\"",
                  "\"draws\": [\"opaque\"]"},
        FaultCase{"IfString", compute("\"if\": $$[]"), {"W102"}, "a number or an expression"},
        FaultCase{"IfSyntax", compute("\"if\": \"a +$$\""), {"W106"}, "ends where"},
        FaultCase{"ConstantVector", compute("\"constants\": {$$\"N\": [1, 2]}"), {"W109"}, "one number"},
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
                  "a \"raster\" pass has no use for \"groups\"",
                  "type \"compute\""},
        FaultCase{
            "DrawsOnCompute", compute("$$\"draws\": []"), {"W101"}, "no use for \"draws\"", "\"raster\""},
        FaultCase{"StateOnCompute", compute("$$\"state\": {\"bad\": 1}"), {"W101"}, "no use for \"state\""},
        FaultCase{"ClearWithIn",
                  pass("\"type\": \"clear\", \"out\": [\"a\"], $$\"in\": [\"b\"]"),
                  {"W101"},
                  "no use for \"in\""},
        FaultCase{
            "Queue", compute("\"queue\": $$\"asinc\""), {"W109"}, "\"asinc\"", "did you mean \"async\"?"},
        FaultCase{"BothDispatches", compute("\"groups\": 1, \"threads\": $$1"), {"W109"}, "not both"},
        FaultCase{"GroupsFour", compute("\"groups\": $$[1, 1, 1, 1]"), {"W109"}, "wanted 1 to 3"},
        FaultCase{"BadReference", compute("\"in\": [\"a\", \"b.$$mpi(0)\"]"), {"W106"}, "unknown selector"},
        FaultCase{"EmptyReference", compute("\"in\": [\"$$\"]"), {"W106"}, "name of a resource"},
        FaultCase{"MipExpression", compute("\"in\": {\"x\": \"a.mip(1 +$$)\"}"), {"W106"}, "found ')'"},
        FaultCase{"NumberInList", compute("\"in\": [\"a\", $$3]"), {"W102"}, "found number, wanted string"},
        FaultCase{"PortNumber", compute("\"out\": {\"a\": $$3}"), {"W102"}, "wanted a reference"},
        FaultCase{"InNumber", compute("\"in\": $$3"), {"W102"}, "wanted a list"},
        FaultCase{
            "PortName", compute("\"in\": {$$\"a-b\": \"a\"}"), {"W109"}, "cannot be the name of a port"},
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
    States, ParseFaultTest,
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
