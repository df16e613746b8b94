// Purpose: finds the value that the author of a graph gives to a member of a shader's block `Params`. The key
// "params" of the pass may give the value. Otherwise the value comes from the parameter, constant, index of
// the pass's repeat or number of draws that has the same name as the member.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graph/resolve/declared.h"

namespace weft {

struct MemberValue {
    // The entry of "params" that gives the value. Null if the value comes from a parameter, a constant,
    // an index of the pass's repeat, or a number of draws.
    const ParamValueDesc* param = nullptr;
    // The components of the value. Empty if the value has an error, which was reported.
    std::vector<double> components = {};
};

// Returns nullopt if neither the pass nor the graph has a value for the name `member`. `evaluator` must
// know the indices of the pass's repeat.
[[nodiscard]] std::optional<MemberValue> member_value(const Declared& declared, const PassDraft& draft,
                                                      const Evaluator& evaluator, const std::string& member);

// Returns true if a member of this type can store the value. A 32-bit word may be given as a signed or as an
// unsigned integer; for example, -1 sets all bits.
[[nodiscard]] bool fits_member(ScalarType scalar, double value);

}  // namespace weft
