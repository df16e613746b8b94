#include "shader/reflect/used_ranges.h"

#include <spirv.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "shader/gate/spirv_words.h"

namespace weft::shader {
namespace {

// Lists the functions that the entry point calls, directly or indirectly.
class CallGraph {
 public:
    explicit CallGraph(std::span<const uint32_t> spirv) {
        SpirvReader reader(spirv);
        uint32_t function = 0;
        for (SpirvInstruction i; reader.next(i);) {
            if (i.opcode == SpvOpEntryPoint) entries_.push_back(i.operand(1));
            if (i.opcode == SpvOpFunction) function = i.operand(1);
            if (i.opcode == SpvOpFunctionCall) calls_[function].push_back(i.operand(2));
        }
        while (!entries_.empty()) {
            const uint32_t next = entries_.back();
            entries_.pop_back();
            if (!reached_.insert(next).second) continue;
            entries_.insert(entries_.end(), calls_[next].begin(), calls_[next].end());
        }
    }
    [[nodiscard]] bool runs(uint32_t function) const { return reached_.contains(function); }

 private:
    std::vector<uint32_t> entries_;  // Functions whose calls are not followed yet.
    std::map<uint32_t, std::vector<uint32_t>> calls_;
    std::set<uint32_t> reached_;
};

// Follows the indices of an access chain through structs, as long as the indices are constants. Returns the
// range of the member that is reached in this way; `whole` if no member is reached.
FrameRange member_range(const SpirvInstruction& chain, const std::map<uint32_t, uint32_t>& constants,
                        const std::vector<BlockMember>& members, const FrameRange& whole) {
    FrameRange range = whole;
    const std::vector<BlockMember>* level = &members;
    for (size_t i = 3; i < chain.operands.size() && !level->empty(); ++i) {
        const auto index = constants.find(chain.operands[i]);
        if (index == constants.end() || index->second >= level->size()) return range;
        const BlockMember& member = (*level)[index->second];
        range.offset_bytes = member.offset_bytes + (level == &members ? 0 : range.offset_bytes);
        range.size_bytes = member.size_bytes;
        if (member.array_count != 0 || member.is_runtime_array) return range;
        level = &member.members;
    }
    return range;
}

}  // namespace

std::vector<FrameRange> used_ranges(std::span<const uint32_t> spirv, uint32_t variable,
                                    const std::vector<BlockMember>& members, uint32_t block_bytes) {
    const FrameRange whole{0, 0, block_bytes};
    const CallGraph calls(spirv);
    std::map<uint32_t, uint32_t> constants;
    std::vector<FrameRange> ranges;
    SpirvReader reader(spirv);
    uint32_t function = 0;
    for (SpirvInstruction i; reader.next(i);) {
        if (i.opcode == SpvOpConstant && i.operands.size() == 3) constants[i.operand(1)] = i.operand(2);
        if (i.opcode == SpvOpFunction) function = i.operand(1);
        if (function == 0 || !calls.runs(function) || i.opcode == SpvOpLine) continue;
        const bool chain = i.opcode == SpvOpAccessChain || i.opcode == SpvOpInBoundsAccessChain;
        if (chain && i.operand(2) == variable)
            ranges.push_back(member_range(i, constants, members, whole));
        else if (std::ranges::find(i.operands, variable) != i.operands.end())
            // Any other instruction that uses the variable, or that has a number equal to its id, counts as a
            // use of the whole block.
            ranges.push_back(whole);
    }
    merge_ranges(ranges);
    return ranges;
}

void merge_ranges(std::vector<FrameRange>& ranges) {
    std::ranges::sort(ranges, {}, [](const FrameRange& r) { return std::tuple(r.binding, r.offset_bytes); });
    std::vector<FrameRange> merged;
    for (const FrameRange& range : ranges) {
        const bool touches = !merged.empty() && merged.back().binding == range.binding &&
                             range.offset_bytes <= merged.back().offset_bytes + merged.back().size_bytes;
        if (!touches) {
            merged.push_back(range);
            continue;
        }
        FrameRange& last = merged.back();
        last.size_bytes =
            std::max(last.offset_bytes + last.size_bytes, range.offset_bytes + range.size_bytes) -
            last.offset_bytes;
    }
    ranges = std::move(merged);
}

}  // namespace weft::shader
