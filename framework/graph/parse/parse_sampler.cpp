// Parses the object "sampler" of an input.
#include <algorithm>
#include <array>

#include "graph/parse/parse_context.h"

namespace weft {
namespace {

using Compare = std::optional<CompareOp>;

constexpr std::array kFilters{Choice<SamplerFilter>{"nearest", SamplerFilter::nearest},
                              Choice<SamplerFilter>{"linear", SamplerFilter::linear}};
constexpr std::array kWraps{
    Choice<SamplerWrap>{"clamp", SamplerWrap::clamp}, Choice<SamplerWrap>{"repeat", SamplerWrap::repeat},
    Choice<SamplerWrap>{"mirror", SamplerWrap::mirror}, Choice<SamplerWrap>{"border", SamplerWrap::border}};
constexpr std::array kReductions{Choice<SamplerReduction>{"average", SamplerReduction::average},
                                 Choice<SamplerReduction>{"min", SamplerReduction::min},
                                 Choice<SamplerReduction>{"max", SamplerReduction::max}};
constexpr std::array kSamplerCompares{
    Choice<Compare>{"none", Compare()},
    Choice<Compare>{"never", CompareOp::never},
    Choice<Compare>{"less", CompareOp::less},
    Choice<Compare>{"equal", CompareOp::equal},
    Choice<Compare>{"less_equal", CompareOp::less_equal},
    Choice<Compare>{"greater", CompareOp::greater},
    Choice<Compare>{"not_equal", CompareOp::not_equal},
    Choice<Compare>{"greater_equal", CompareOp::greater_equal},
    Choice<Compare>{"always", CompareOp::always},
};

// The largest values that a file may state. Vulkan allows an anisotropy of 1 to 16. An image has fewer than
// kMaxLod mips on every device.
constexpr float kMaxAnisotropy = 16;
constexpr float kMaxLod = 32;

void read_sampler_number(ParseContext& context, const JsonNode& node, float least, float most, float& out) {
    float number = 0;
    if (!read_float(context, node, number)) return;
    if (number < least || number > most)
        return context.error(node.loc, "W109", "found " + node.string + ", wanted a number in range",
                             "write a number from " + std::to_string(static_cast<int>(least)) + " to " +
                                 std::to_string(static_cast<int>(most)));
    out = number;
}

constexpr std::array kSamplerKeys{
    KeyRule<PortDesc>{"filter", [](ParseContext& c, const JsonNode& n,
                                   PortDesc& p) { read_choice(c, n, kFilters, p.sampler->filter); }},
    KeyRule<PortDesc>{"mipFilter", [](ParseContext& c, const JsonNode& n,
                                      PortDesc& p) { read_choice(c, n, kFilters, p.sampler->mip_filter); }},
    KeyRule<PortDesc>{"wrap", [](ParseContext& c, const JsonNode& n,
                                 PortDesc& p) { read_choice(c, n, kWraps, p.sampler->wrap); }},
    KeyRule<PortDesc>{"compare",
                      [](ParseContext& c, const JsonNode& n, PortDesc& p) {
                          p.sampler_locs.compare = n.loc;
                          read_choice(c, n, kSamplerCompares, p.sampler->compare);
                      }},
    KeyRule<PortDesc>{"reduction",
                      [](ParseContext& c, const JsonNode& n, PortDesc& p) {
                          p.sampler_locs.reduction = n.loc;
                          read_choice(c, n, kReductions, p.sampler->reduction);
                      }},
    KeyRule<PortDesc>{"anisotropy",
                      [](ParseContext& c, const JsonNode& n, PortDesc& p) {
                          p.sampler_locs.anisotropy = n.loc;
                          read_sampler_number(c, n, 1, kMaxAnisotropy, p.sampler->anisotropy);
                      }},
    KeyRule<PortDesc>{"lodBias",
                      [](ParseContext& c, const JsonNode& n, PortDesc& p) {
                          p.sampler_locs.lod_bias = n.loc;
                          read_sampler_number(c, n, -kMaxLod, kMaxLod, p.sampler->lod_bias);
                      }},
    KeyRule<PortDesc>{"minLod",
                      [](ParseContext& c, const JsonNode& n, PortDesc& p) {
                          read_sampler_number(c, n, 0, kMaxLod, p.sampler->min_lod);
                      }},
    KeyRule<PortDesc>{"maxLod",
                      [](ParseContext& c, const JsonNode& n, PortDesc& p) {
                          p.sampler_locs.max_lod = n.loc;
                          read_sampler_number(c, n, 0, kMaxLod, p.sampler->max_lod);
                      }},
};

// Checks values that depend on each other, after all keys are read.
void check_sampler(ParseContext& context, SourceLoc loc, const SamplerDecl& sampler,
                   const SamplerLocs& locs) {
    const bool nearest = sampler.filter == SamplerFilter::nearest;
    if (sampler.max_lod < sampler.min_lod)
        context.error(locs.max_lod.line != 0 ? locs.max_lod : loc, "W109",
                      "\"maxLod\" is less than \"minLod\"",
                      "exchange the two numbers, or remove one of them");
    if (sampler.anisotropy > 1 && nearest)
        context.error(locs.anisotropy, "W109", "the sampler has \"anisotropy\", but takes the nearest texel",
                      "set \"filter\": \"linear\", or remove \"anisotropy\"");
    if (sampler.reduction == SamplerReduction::average) return;
    if (sampler.compare)
        context.error(locs.reduction, "W109",
                      "a sampler that compares cannot also take the least or greatest texel",
                      "remove \"reduction\" or \"compare\"");
    else if (nearest && sampler.mip_filter == SamplerFilter::nearest)
        context.error(locs.reduction, "W109",
                      "the sampler has a \"reduction\", but takes only one texel, the nearest",
                      "set \"filter\": \"linear\": the lookup then touches 2 x 2 texels");
}

}  // namespace

void parse_sampler(ParseContext& context, const JsonNode& node, PortDesc& port) {
    port.sampler.emplace();
    if (read_object(context, node, "a sampler", kSamplerKeys, port))
        check_sampler(context, node.loc, *port.sampler, port.sampler_locs);
}

void list_sampler_grammar(std::vector<GrammarTable>& lists) {
    list_keys(lists, "sampler", kSamplerKeys);
    list_choices(lists, "filter", kFilters);
    list_choices(lists, "wrap", kWraps);
    list_choices(lists, "samplerCompare", kSamplerCompares);
    list_choices(lists, "samplerReduction", kReductions);
}

}  // namespace weft
