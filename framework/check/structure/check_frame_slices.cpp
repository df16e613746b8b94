#include "check/structure/check_frame_slices.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace weft::check {
namespace {

bool is_sliced(const PassDecl& pass) {
    return pass.frame_slices > 1;
}

// Returns true if both passes always run in the same frames.
bool run_together(const PassDecl& a, const PassDecl& b) {
    if (is_sliced(a) != is_sliced(b)) return false;
    return !is_sliced(a) || (a.frame_slices == b.frame_slices && a.frame_slice == b.frame_slice);
}

// Finds the direct and indirect successors of each pass in the graph.
class Followers {
 public:
    explicit Followers(const ResolvedGraph& graph) : next_(graph.passes.size()) {
        for (const EdgeDecl& edge : graph.edges) next_[edge.from].push_back(edge.to);
    }

    bool follows(PassId first, PassId second) {
        std::vector<uint8_t>& known = known_[first];
        if (known.empty()) fill(first, known);
        return known[second] != 0;
    }

 private:
    void fill(PassId first, std::vector<uint8_t>& reached) {
        reached.assign(next_.size(), 0);
        std::vector<PassId> open{first};
        while (!open.empty()) {
            const PassId pass = open.back();
            open.pop_back();
            for (const PassId to : next_[pass]) {
                if (reached[to]) continue;
                reached[to] = 1;
                open.push_back(to);
            }
        }
    }

    std::vector<std::vector<PassId>> next_;
    std::map<PassId, std::vector<uint8_t>> known_;
};

// Checks one resource that is written by at least one pass with frame slices (a pass that runs only in some
// frames). For each subresource it collects all passes that write the subresource.
class SlicedResource {
 public:
    SlicedResource(const FramePlan& plan, ResourceId resource, Followers& followers, FaultList& faults)
        : plan_(plan),
          decl_(plan.graph.resources[resource]),
          resource_(resource),
          whole_(decl_.whole()),
          followers_(followers),
          faults_(faults),
          parts_(size_t{whole_.mips} * whole_.layers * kAspects) {}

    void check() {
        const bool stays = decl_.lifetime == ResourceLifetime::persistent && decl_.history == 0;
        for (PassId id(0); id < plan_.graph.passes.size(); ++id) {
            for (const UseDecl& use : plan_.graph.passes[id].uses) {
                if (use.resource != resource_ || !writes(use.access)) continue;
                add_writer(id, use);
                if (!stays && is_sliced(plan_.graph.passes[id]) && plan_.live.live_passes[id])
                    report_lost(id, use);
            }
        }
        for (PassId id(0); id < plan_.graph.passes.size(); ++id) {
            if (!plan_.live.live_passes[id]) continue;
            for (const UseDecl& use : plan_.graph.passes[id].uses) {
                if (use.resource != resource_) continue;
                for (const VersionSource& source : use.sources) check_read(id, use, source);
            }
        }
    }

 private:
    static constexpr size_t kAspects = 3;

    struct Part {
        std::vector<PassId> writers;
        bool overwritten = false;  // True if a writer of this part discards the part's old content.
        bool sliced = false;       // True if a writer of this part runs only in some frames.
    };

    template <class Visit>
    void for_each_part(const SubresourceRange& range, Visit visit) {
        for (size_t a = 0; a < kAspects; ++a) {
            if (!(range.aspects & (1u << a))) continue;
            for (uint32_t l = range.layer; l < std::min(range.layer + range.layers, whole_.layers); ++l)
                for (uint32_t m = range.mip; m < std::min(range.mip + range.mips, whole_.mips); ++m)
                    visit(parts_[(a * whole_.layers + l) * whole_.mips + m],
                          SubresourceRange{m, 1, l, 1, static_cast<AspectMask>(1u << a)});
        }
    }

    void add_writer(PassId id, const UseDecl& use) {
        for_each_part(use.range, [&](Part& part, const SubresourceRange& cell) {
            const bool keeps_previous =
                std::any_of(use.sources.begin(), use.sources.end(),
                            [&](const VersionSource& s) { return contains(s.range, cell); });
            if (part.writers.empty() || part.writers.back() != id) part.writers.push_back(id);
            part.overwritten = part.overwritten || !keeps_previous;
            part.sliced = part.sliced || is_sliced(plan_.graph.passes[id]);
        });
    }

    void check_read(PassId reader, const UseDecl& use, const VersionSource& source) {
        for_each_part(source.range, [&](const Part& part, const SubresourceRange& cell) {
            // A read can see a wrong version only if one writer of the part runs only in some frames (is
            // sliced), and a writer (the same or another) discards the previous content.
            if (!part.sliced || !part.overwritten) return;
            const bool before = source.producer == kNoId;
            const PassId named = before ? last_of(part) : source.producer;
            const PassDecl& maker = plan_.graph.passes[named];
            if (!is_sliced(maker) || (!before && run_together(maker, plan_.graph.passes[reader]))) return;
            for (const PassId other : part.writers) {
                if (other == named) continue;
                if (run_together(maker, plan_.graph.passes[other]) && !followers_.follows(named, other))
                    continue;
                return report(reader, use, cell, named, other);
            }
        });
    }

    PassId last_of(const Part& part) {
        PassId last = part.writers.front();
        for (const PassId pass : part.writers)
            if (followers_.follows(last, pass)) last = pass;
        return last;
    }

    void report_lost(PassId writer, const UseDecl& use) {
        faults_.add("C332", use.loc,
                    "pass " + faults_.pass_name(writer) + " runs in some frames only (perFrame) and writes " +
                        faults_.resource_name(resource_) +
                        ", but this resource does not keep its content until the next frame",
                    "a pass with perFrame may only write resources that keep their content");
    }

    void report(PassId reader, const UseDecl& use, const SubresourceRange& cell, PassId named, PassId other) {
        faults_.add(
            "C332", use.loc,
            "pass " + faults_.pass_name(reader) + " reads " + faults_.part_name(resource_, cell) +
                " as pass " + faults_.pass_name(named) +
                " leaves it, but in frames without that pass, pass " + faults_.pass_name(other) +
                " has overwritten this content",
            "a pass must not overwrite content of a pass with perFrame that a later frame still reads");
    }

    const FramePlan& plan_;
    const ResourceDecl& decl_;
    ResourceId resource_;
    SubresourceRange whole_;
    Followers& followers_;
    FaultList& faults_;
    std::vector<Part> parts_;
};

// Checks that no barrier before a pass with frame slices discards the content of an image, unless the image
// is transient. The barrier runs in every frame, but the pass does not, so in some frames nothing would write
// new content.
void check_dropped_content(const FramePlan& plan, FaultList& faults) {
    for (const PassStep& step : plan.barriers.steps) {
        const PassDecl& pass = plan.graph.passes[step.pass];
        if (!is_sliced(pass)) continue;
        for (const BarrierDecl& barrier : step.barriers) {
            const ResourceDecl& resource = plan.graph.resources[barrier.resource];
            const bool image = resource.kind == ResourceKind::image;
            if (!image || resource.lifetime == ResourceLifetime::transient ||
                barrier.src.layout != Layout::undefined)
                continue;
            faults.add("C331", pass.loc,
                       "the barrier before pass " + faults.pass_name(step.pass) +
                           " discards the content of " + faults.part_name(barrier.resource, barrier.range) +
                           ", also in frames in which the pass does not run",
                       "the old layout of the barrier must be the real layout");
        }
    }
}

}  // namespace

void check_frame_slices(const FramePlan& plan, FaultList& faults) {
    std::vector<uint8_t> sliced(plan.graph.resources.size(), 0);
    for (const PassDecl& pass : plan.graph.passes)
        for (const UseDecl& use : pass.uses)
            if (is_sliced(pass) && writes(use.access)) sliced[use.resource] = 1;
    if (std::find(sliced.begin(), sliced.end(), 1) == sliced.end()) return;
    Followers followers(plan.graph);
    for (ResourceId id(0); id < sliced.size(); ++id)
        if (sliced[id]) SlicedResource(plan, id, followers, faults).check();
    check_dropped_content(plan, faults);
}

}  // namespace weft::check
