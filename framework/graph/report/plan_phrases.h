// Purpose: returns texts that name the parts of a plan in messages. The names of passes, resources and ports
// are followed by the place of their definition: "lighting" (deferred.json:29:5). Parts that a program
// created have no place.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "weft/plan.h"
#include "weft/result.h"

namespace weft {

[[nodiscard]] std::string describe_pass(const FramePlan& plan, PassId pass);
[[nodiscard]] std::string describe_resource(const FramePlan& plan, ResourceId resource);
// Returns the name of the resource. A range that is not the whole resource is appended:
// "bloom.mip(2).layer(0)".
[[nodiscard]] std::string describe_part(const FramePlan& plan, ResourceId resource,
                                        const SubresourceRange& range);
// Returns a text such as: port "hdr" (deferred.json:31:9) reads and writes "hdr".
[[nodiscard]] std::string describe_use(const FramePlan& plan, const UseDecl& use);
[[nodiscard]] const char* access_verb(Access access);  // Returns "reads", "writes" or "reads and writes".
// Returns the position in the schedule and the name of the pass there, such as: 2 "lighting".
[[nodiscard]] std::string describe_position(const FramePlan& plan, Position position);
// Returns stages, accesses and, for an image, the layout, such as: color_output color_write color_attachment.
[[nodiscard]] std::string describe_state(const AccessState& state, bool image);

// Finds a pass or resource by name. Errors: W104 (pass), W103 (resource). The error suggests similar names.
// If `name` belongs to a pass with `repeat`, the error lists the names of its iterations instead, such as
// "down#1". The `file` of the error is the graph file.
[[nodiscard]] Result<PassId> named_pass(const FramePlan& plan, const std::string& name);
[[nodiscard]] Result<ResourceId> named_resource(const FramePlan& plan, const std::string& name);
// Like named_pass() and named_resource(), but the name of a pass with `repeat` gives all iterations: "down"
// gives "down#1", "down#2" and so on.
[[nodiscard]] Result<std::vector<PassId>> named_passes(const FramePlan& plan, const std::string& name);
[[nodiscard]] Result<std::vector<ResourceId>> named_resources(const FramePlan& plan, const std::string& name);
// Returns the texts of `describe` for all passes that named_passes() finds, one after the other.
[[nodiscard]] Result<std::string> describe_passes(const FramePlan& plan, const std::string& name,
                                                  std::string (*describe)(const FramePlan&, PassId));

// Returns the ids of two names, or the errors of both.
template <class Id>
[[nodiscard]] Result<std::pair<Id, Id>> both(const Result<Id>& first, const Result<Id>& second) {
    if (first && second) return std::pair{*first, *second};
    Diagnostics errors = first.errors();
    errors.insert(errors.end(), second.errors().begin(), second.errors().end());
    return errors;
}

}  // namespace weft
