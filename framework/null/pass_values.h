// Purpose: what passes do to values. Every value is a hash of how it was made, and nothing else is known of
// it.
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
    // Never kUndefinedValue.
    [[nodiscard]] CellValue value() const { return state_ == kUndefinedValue ? 1 : state_; }

 private:
    uint64_t state_ = 0x9E3779B97F4A7C15ull;
};

// What the owner of an import has put there before the first frame.
[[nodiscard]] CellValue import_value(const ResourceDecl& import, const SubresourceRange& cell);
// What every copy of a persistent resource holds before anybody wrote it.
[[nodiscard]] CellValue first_frame_value(const ResourceDecl& resource);
// Everything about a pass in one frame but what it reads: name, parameters, builtins of that frame. `valid`
// of a role is 1 once its content has been written: `age` frames after a live pass first wrote its ring.
[[nodiscard]] ValueHash pass_values(const ResolvedGraph& graph, const LiveGraph& live, PassId pass,
                                    uint32_t frame);
// What the pass puts into one cell; `inputs` has hashed pass_values() and all cells read, use by use.
[[nodiscard]] CellValue written_value(const ValueHash& inputs, const UseDecl& use,
                                      const SubresourceRange& cell);

}  // namespace weft::null
