#include "check/structure/check_pieces.h"

#include <algorithm>

namespace weft::check {
namespace {

constexpr const char* kHelp = "this is an error of Weft, not of the graph: please report it";

// Returns true if the offsets at which the pieces begin ascend and lie inside the buffer. An image must have
// no such offsets.
bool are_cuts_sound(const ResourceDecl& resource) {
    uint64_t last = 0;
    for (const uint64_t cut : resource.cuts_bytes) {
        if (resource.kind != ResourceKind::buffer || cut <= last || cut >= resource.size_bytes) return false;
        last = cut;
    }
    return true;
}

// Returns true if the pieces of the use are exactly the bytes that its port names. The function
// compares every piece itself. It does not call the code that the compiler and the executor share, because
// that code may be wrong.
bool is_use_sound(const ResourceDecl& buffer, const UseDecl& use) {
    std::vector<uint64_t> borders{0};
    borders.insert(borders.end(), buffer.cuts_bytes.begin(), buffer.cuts_bytes.end());
    borders.push_back(buffer.size_bytes);
    const uint64_t begin = use.bytes ? use.bytes->offset_bytes : 0;
    const uint64_t end = use.bytes ? begin + use.bytes->size_bytes : buffer.size_bytes;
    for (size_t piece = 0; piece + 1 < borders.size(); ++piece) {
        const bool tracked = piece >= use.range.layer && piece < uint64_t{use.range.layer} + use.range.layers;
        const bool inside = borders[piece] >= begin && borders[piece + 1] <= end;
        const bool outside = borders[piece + 1] <= begin || borders[piece] >= end;
        if (tracked ? !inside : !outside) return false;
    }
    return end <= buffer.size_bytes && begin < end && use.range.mip == 0 && use.range.mips == 1;
}

}  // namespace

void check_pieces(const FramePlan& plan, FaultList& faults) {
    for (ResourceId id(0); id < plan.graph.resources.size(); ++id) {
        const ResourceDecl& resource = plan.graph.resources[id];
        if (!are_cuts_sound(resource))
            faults.add("C344", resource.loc,
                       "the pieces of " + faults.resource_name(id) + " do not divide it in ascending order",
                       kHelp);
    }
    for (const PassDecl& pass : plan.graph.passes)
        for (const UseDecl& use : pass.uses) {
            const ResourceDecl& resource = plan.graph.resources[use.resource];
            const bool image = resource.kind == ResourceKind::image;
            if (image ? !use.bytes : is_use_sound(resource, use)) continue;
            faults.add("C344", use.loc,
                       "port \"" + use.port + "\" of pass \"" + pass.name + "\" uses other bytes of " +
                           faults.resource_name(use.resource) +
                           " than the pieces that the plan tracks for it",
                       kHelp);
        }
}

}  // namespace weft::check
