// Simulates frames in which switches have turned passes off: finds the content that the readers of these
// passes see instead.
#include <algorithm>

#include "check/replay.h"

namespace weft::check {

std::string Replay::switches_text() const {
    std::string text;
    for (uint32_t s = 0; s < plan_.graph.switches.size(); ++s)
        if ((combination() >> s & 1u) == 0)
            text +=
                (text.empty() ? " in frames in which \"" : " and \"") + plan_.graph.switches[s].param + "\"";
    return text.empty() ? text : text + (text.find(" and ") == std::string::npos ? " is off" : " are off");
}

std::optional<PassId> Replay::version_left(PassId wanted, ResourceId resource,
                                           const SubresourceRange& cell) const {
    // Each step goes from a writer to an earlier writer, so there are at most as many steps as passes.
    for (size_t steps = 0; wanted != kNoId && steps <= plan_.graph.passes.size(); ++steps) {
        const PassDecl& writer = plan_.graph.passes[wanted];
        if (has_combination(writer.runs_in, combination())) return wanted;
        const VersionSource* before = nullptr;
        for (const UseDecl& use : writer.uses)
            for (const VersionSource& source : use.passes_on)
                if (use.resource == resource && contains(source.range, cell)) before = &source;
        if (before == nullptr) return std::nullopt;
        wanted = before->producer;
    }
    return wanted;
}

// Checks an import whose old content is dropped and which a pass with a switch writes. The import must also
// have content after a frame in which this pass is off, because the program reads the import in every frame.
void Replay::expect_written_output(ResourceId id, const Cell& cell) {
    if (cell.content.kind != Content::Kind::undefined) return;
    for (const PassId pass : plan_.schedule.order) {
        const PassDecl& writer = plan_.graph.passes[pass];
        if (writer.switch_id == kNoId || has_combination(writer.runs_in, combination())) continue;
        for (const UseDecl& use : writer.uses) {
            if (use.resource != id || !writes(use.access) || !overlaps(use.range, cell.range)) continue;
            faults_.add("C349", use.loc,
                        "the program reads " + faults_.part_name(id, cell.range) + " after the frame, but" +
                            switches_text() + " no pass has written it",
                        "a pass that always runs must write the resource before the pass with the switch");
        }
    }
}

}  // namespace weft::check
