// Purpose: the stage of resolve() that makes the passes of the graph from their descriptions. A description
// results in one pass, in several passes (`repeat`), or in none (`if`). Each reference in
// GraphRequest::observed becomes a separate pass that reads the resource back. Each pass gets its kind,
// shader, fixed-function state and switch. Each group gets its rounds. Errors: W106, W107, W109, W115, W125,
// W177, W187, W199, W233, W235, and those of references.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "graph/resolve/evaluator.h"

namespace weft {

// A pass whose ports are not yet bound.
struct PassDraft {
    // The parts that do not depend on ports: name, kind, state, and the frames in which the pass runs.
    PassDecl decl;
    const PassDesc* desc = nullptr;
    // The values of the indices of the pass's repeat, by name.
    std::map<std::string, double> indices = {};
    // Number of this pass within its repeat, from 0.
    uint32_t instance = 0;
    // Number of views that the pass draws, if it draws several (see PassDecl::views); the index "view" of the
    // pass is then 0. For all other passes: 0.
    uint32_t views = 0;
    // For a pass of a group: the index of the group in Expansion::groups, and the number of the round.
    uint32_t group = kNoId;
    uint32_t round = 0;
    // The interface of the shader. Null if the pass has no shader, or if an error about the shader was
    // reported.
    const ShaderInterface* shader = nullptr;
    const PassType* custom = nullptr;  // The C++ pass type. Null if the type is built in or unknown.
    bool is_observer = false;          // True if the pass reads back an observed resource.
};

// Returns true if both passes belong to one group, but to different rounds of it.
[[nodiscard]] inline bool in_other_round(const PassDraft& a, const PassDraft& b) {
    return a.group != kNoId && a.group == b.group && a.round != b.round;
}

struct Expansion {
    // All passes, sorted by name. The index is the PassId.
    std::vector<PassDraft> passes;
    // For each pass description, by its name in the graph file: the passes that were made from it. The passes
    // of a repeat are in the order of the repeat.
    std::map<std::string, std::vector<PassId>, std::less<>> instances = {};
    // The descriptions with a false `if` or an empty repeat, by their names in the graph file. Some of them
    // still result in passes: the `if` may be false for only a part of the repeat.
    std::map<std::string, const PassDesc*, std::less<>> dropped = {};
    // Names of the descriptions whose `repeat` or `if` has an error, so that it is unknown whether the passes
    // run. The error was reported.
    std::set<std::string, std::less<>> faulty = {};
    // The switches of the passes, sorted by the name of the parameter.
    std::vector<SwitchDecl> switches = {};
    // The groups, sorted by name. A later stage sets GroupDecl::first_unit, which is 0 here.
    std::vector<GroupDecl> groups = {};
    // The descriptions of the passes that read back observed resources. PassDraft::desc points to them.
    std::map<std::string, PassDesc> observers = {};
    // The descriptions of the passes that copy content of the last frame, for resources with `history` and
    // `keep`.
    std::map<std::string, PassDesc> carries = {};
    // Number of ports of all passes, including passes that `if` removes.
    uint64_t tried_ports = 0;
    // True if the graph has too many passes or ports. The error was reported.
    bool too_large = false;
    Suspects suspects;
};
// For some passes, each view must be drawn by a pass of its own. The key is the name of such a pass in the
// graph file. The value is the reason.
using SeparateViews = std::map<std::string, std::string, std::less<>>;
[[nodiscard]] Expansion expand(const ResolveInput& input, const Values& values, const Shapes& shapes,
                               Reporter& reporter, const SeparateViews& separate = {});

}  // namespace weft
