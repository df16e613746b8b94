#include "null/pass_values.h"

#include <algorithm>
#include <bit>

namespace weft::null {
namespace {

// The finaliser of splitmix64 (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
uint64_t mixed(uint64_t x) {
    x ^= x >> 30;
    x *= 0xBF58476D1CE4E5B9ull;
    x ^= x >> 27;
    x *= 0x94D049BB133111EBull;
    return x ^ (x >> 31);
}

bool ring_is_written(const ResolvedGraph& graph, const LiveGraph& live, ResourceId ring) {
    for (PassId id(0); id < graph.passes.size(); ++id) {
        if (!live.live_passes[id] || graph.passes[id].carries) continue;
        for (const UseDecl& use : graph.passes[id].uses)
            if (use.resource == ring && writes(use.access)) return true;
    }
    return false;
}

double builtin_value(const ResolvedGraph& graph, const LiveGraph& live, const ParamWrite& param,
                     uint32_t frame) {
    if (param.builtin == Builtin::unit_valid || param.builtin == Builtin::unit_bits) return 0;
    if (param.builtin != Builtin::valid) return frame;
    const ResourceDecl& role = graph.resources[param.resource];
    return frame >= role.age && ring_is_written(graph, live, role.ring) ? 1 : 0;
}

}  // namespace

ValueHash& ValueHash::add(uint64_t word) {
    state_ = mixed(state_ + 0x9E3779B97F4A7C15ull + mixed(word));
    return *this;
}

ValueHash& ValueHash::add(std::string_view text) {
    add(uint64_t{text.size()});
    for (const char c : text) add(uint64_t{static_cast<unsigned char>(c)});
    return *this;
}

ValueHash& ValueHash::add(double number) {
    return add(std::bit_cast<uint64_t>(number));
}

ValueHash& ValueHash::add(const SubresourceRange& range) {
    return add(uint64_t{range.mip} << 40 | uint64_t{range.layer} << 8 | range.aspects);
}

CellValue import_value(const ResourceDecl& import, const SubresourceRange& cell) {
    return ValueHash().add("import").add(import.name).add(cell).value();
}

CellValue first_frame_value(const ResourceDecl& resource) {
    ValueHash hash;
    hash.add("first frame");
    for (const float component : resource.first_frame) hash.add(double{component});
    return hash.value();
}

ValueHash pass_values(const ResolvedGraph& graph, const LiveGraph& live, PassId id, const FrameChoice& choice,
                      const InputChoice& inputs) {
    const uint32_t frame = choice.frame;
    const PassDecl& pass = graph.passes[id];
    const PassVariant* variant =
        pass.variants.empty() ? nullptr : &pass.variants[variant_in(pass, choice.switches)];
    ValueHash hash;
    hash.add(pass.name);
    if (frame < inputs.size() && id < inputs[frame].size()) hash.add(uint64_t{inputs[frame][id]});
    for (const ParamWrite& param : variant != nullptr ? variant->params : pass.params) {
        if (param.builtin != Builtin::none) {
            hash.add(builtin_value(graph, live, param, frame));
            continue;
        }
        for (const double component : param.value) hash.add(component);
    }
    for (const NamedValue& param : pass.custom_params) hash.add(param.name).add(param.value);
    for (const SpecValue& value : variant != nullptr ? variant->spec_values : pass.spec_values)
        hash.add(uint64_t{value.id} << 32 | value.bits);
    for (const float component : pass.clear) hash.add(double{component});
    return hash;
}

CellValue written_value(const ValueHash& inputs, const UseDecl& use, const SubresourceRange& cell) {
    return ValueHash(inputs).add(use.port).add(cell).value();
}

}  // namespace weft::null
