// Purpose: computes the values that passes write in the null executor. Every value is a hash of all inputs of
// the pass, the port that writes, and the cell.
#pragma once

#include <cstdint>
#include <string_view>

#include "null/null_executor.h"

namespace weft::null {

class ValueHash {
 public:
    ValueHash& add(uint64_t word);
    ValueHash& add(std::string_view text);
    ValueHash& add(double number);
    ValueHash& add(const SubresourceRange& range);
    // Returns the hash. It is never kUndefinedValue (0), because that value marks undefined content.
    [[nodiscard]] CellValue value() const { return state_ == kUndefinedValue ? 1 : state_; }

 private:
    uint64_t state_ = 0x9E3779B97F4A7C15ull;
};

// Returns the value of a cell that the import's owner wrote before the first frame.
[[nodiscard]] CellValue import_value(const ResourceDecl& import, const SubresourceRange& cell);
// Returns the initial value of every cell of a persistent resource.
[[nodiscard]] CellValue first_frame_value(const ResourceDecl& resource);
// A frame, and the switches that are on in it.
struct FrameChoice {
    uint32_t frame = 0;
    Combination switches = kAllSwitchesOn;
};

// Returns the hash of the inputs of a pass in one frame: the name of the pass, its number in `inputs`, its
// parameters, specialisation values, clear value and builtins. The content of resources that the pass reads
// is not included. The builtin `valid` of a resource of age a (the content of a frames ago) is 1 from frame a
// on if a live pass writes the resource, otherwise 0. The builtins unit_valid and unit_bits are 0. The value
// of all other builtins is the frame number.
[[nodiscard]] ValueHash pass_values(const ResolvedGraph& graph, const LiveGraph& live, PassId pass,
                                    const FrameChoice& choice, const InputChoice& inputs);
// Returns the value that the pass writes to one cell. The hash `inputs` must already include pass_values()
// and all values that the pass read, use by use.
[[nodiscard]] CellValue written_value(const ValueHash& inputs, const UseDecl& use,
                                      const SubresourceRange& cell);

}  // namespace weft::null
