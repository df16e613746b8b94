#include "check/structure/check_indirect.h"

namespace weft::check {
namespace {

constexpr uint64_t kWordBytes = 4;

class IndirectCheck {
 public:
    IndirectCheck(const FramePlan& plan, const PassDecl& pass, FaultList& faults)
        : plan_(plan), pass_(pass), faults_(faults) {}

    void run() const {
        // Sizes that Vulkan defines, in bytes.
        constexpr uint64_t kDispatchBytes = 12, kDrawBytes = 16, kIndexedDrawBytes = 20;
        if (pass_.indirect_use != kNoId) check(pass_.indirect_use, kDispatchBytes);
        if (pass_.draw_count_use != kNoId) check(pass_.draw_count_use, kWordBytes);
        if (pass_.draw_commands_use == kNoId) return;
        const bool list = !pass_.draw_lists.empty();
        const bool numbered = !list || pass_.draw_count_use != kNoId;
        check(pass_.draw_commands_use,
              (numbered ? pass_.most_draws : 1) * (list ? kIndexedDrawBytes : kDrawBytes));
        if (numbered && pass_.most_draws == 0) fault("executes no draw command");
    }

 private:
    void fault(const std::string& what) const {
        faults_.add("C345", pass_.loc, "pass \"" + pass_.name + "\" " + what,
                    "this is an error of Weft, not of the graph: please report it");
    }

    // Checks that the GPU may read the first `wanted_bytes` of a use.
    void check(uint32_t index, uint64_t wanted_bytes) const {
        if (index >= pass_.uses.size())
            return fault("reads indirect numbers from a port that it does not have");
        const UseDecl& use = pass_.uses[index];
        const ResourceDecl& resource = plan_.graph.resources[use.resource];
        const uint64_t offset = use.bytes ? use.bytes->offset_bytes : 0;
        const uint64_t size = use.bytes ? use.bytes->size_bytes : resource.size_bytes;
        const bool visible =
            (use.state.stages & stage::kDrawIndirect) != 0 && (use.state.access & access::kIndirectRead) != 0;
        if (resource.kind == ResourceKind::buffer && visible && offset % kWordBytes == 0 &&
            size >= wanted_bytes)
            return;
        fault("reads " + std::to_string(wanted_bytes) + " bytes of indirect numbers from " +
              faults_.part_name(use.resource, use.range) + ", which the plan does not allow");
    }

    const FramePlan& plan_;
    const PassDecl& pass_;
    FaultList& faults_;
};

}  // namespace

void check_indirect(const FramePlan& plan, FaultList& faults) {
    for (const PassDecl& pass : plan.graph.passes) IndirectCheck(plan, pass, faults).run();
}

}  // namespace weft::check
