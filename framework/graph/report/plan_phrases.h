// Purpose: the parts of a plan as a sentence names them, with the place in the file where each was written:
// "lighting" (deferred.json:29:5). Things made by a program have no place.
#pragma once

#include <string>
#include <vector>

#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

[[nodiscard]] std::string describe_pass(const FramePlan& plan, PassId pass);
[[nodiscard]] std::string describe_resource(const FramePlan& plan, ResourceId resource);
// Its range too, where it is not the whole resource: "bloom.mip(2).layer(0)".
[[nodiscard]] std::string describe_part(const FramePlan& plan, ResourceId resource,
                                        const SubresourceRange& range);
// port "hdr" (place) reads and writes "hdr"
[[nodiscard]] std::string describe_use(const FramePlan& plan, const UseDecl& use);
[[nodiscard]] const char* access_verb(Access access);  // "reads", "writes", "reads and writes"
// 2 "lighting"
[[nodiscard]] std::string describe_position(const FramePlan& plan, uint32_t position);
// color_output color_write color_attachment
[[nodiscard]] std::string describe_state(const AccessState& state, bool image);

// Errors: W104 and W103, with near names, or the names of all rounds where `name` is that of a repeat; `file`
// of the error is the graph's.
[[nodiscard]] Result<PassId> named_pass(const FramePlan& plan, const std::string& name);
[[nodiscard]] Result<ResourceId> named_resource(const FramePlan& plan, const std::string& name);
// The one of that name, or all rounds of the repeat of that name: "down" stands for "down#1", "down#2" and
// so on. Errors: as above.
[[nodiscard]] Result<std::vector<PassId>> named_passes(const FramePlan& plan, const std::string& name);
[[nodiscard]] Result<std::vector<ResourceId>> named_resources(const FramePlan& plan, const std::string& name);

}  // namespace weft
