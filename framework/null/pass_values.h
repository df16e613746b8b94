// Purpose: computes the values that passes write. Every value is a hash of all its inputs.
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
    // Never returns kUndefinedValue.
    [[nodiscard]] CellValue value() const { return state_ == kUndefinedValue ? 1 : state_; }

 private:
    uint64_t state_ = 0x9E3779B97F4A7C15ull;
};

// The content that an import's owner wrote before the first frame.
[[nodiscard]] CellValue import_value(const ResourceDecl& import, const SubresourceRange& cell);
// The initial content of every copy of a persistent resource.
[[nodiscard]] CellValue first_frame_value(const ResourceDecl& resource);
// Hash of all inputs of a pass in one frame except its reads: name, parameters, builtins of that frame. The
// builtin `valid` of a past resource is 1 once its content has been written, `age` frames after a live pass
// first wrote its ring.
[[nodiscard]] ValueHash pass_values(const ResolvedGraph& graph, const LiveGraph& live, PassId pass,
                                    uint32_t frame);
// The value that the pass writes to one cell. `inputs` must have hashed pass_values() and all values read,
// use by use.
[[nodiscard]] CellValue written_value(const ValueHash& inputs, const UseDecl& use,
                                      const SubresourceRange& cell);

}  // namespace weft::null
