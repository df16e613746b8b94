#include "check/structure/check_tables.h"

#include <string>

namespace weft::check {
namespace {

constexpr const char* kTableHelp = "this is an error of Weft, not of the graph: please report it";

class TableCheck {
 public:
    TableCheck(const FramePlan& plan, FaultList& faults) : plan_(plan), faults_(faults) {}

    void run() const {
        for (ResourceId id(0); id < plan_.graph.resources.size(); ++id)
            if (is_table(id)) check_shape(id);
        for (const PassDecl& pass : plan_.graph.passes)
            for (const UseDecl& use : pass.uses)
                if (is_table(use.resource)) check_use(pass, use);
        for (const PassStep& step : plan_.barriers.steps) {
            check_barriers(step.barriers);
            check_barriers(step.after);
        }
        check_barriers(plan_.barriers.epilogue);
        check_barriers(plan_.barriers.prologue.before);
        check_barriers(plan_.barriers.prologue.after);
    }

 private:
    bool is_table(ResourceId id) const { return plan_.graph.resources[id].textures > 0; }

    void fault(ResourceId id, SourceLoc loc, const std::string& what) const {
        faults_.add("C348", loc, "the table " + faults_.resource_name(id) + " " + what, kTableHelp);
    }

    static bool is_sampled(const AccessState& state) {
        return state.access == access::kSampledRead && state.layout == Layout::shader_read_only;
    }

    void check_shape(ResourceId id) const {
        const ResourceDecl& table = plan_.graph.resources[id];
        const bool plain = table.kind == ResourceKind::image && table.mips == 1 && table.layers == 1 &&
                           table.samples == 1 && table.history == 0 && table.aspects == aspect::kColor;
        const bool kept = table.lifetime == ResourceLifetime::imported && table.import &&
                          is_sampled(table.import->entry) && is_sampled(table.import->exit);
        const bool files = table.texture_files.empty() || table.texture_files.size() == table.textures;
        if (!plain || !kept || !files) fault(id, table.loc, "is not an import that is only sampled");
    }

    void check_use(const PassDecl& pass, const UseDecl& use) const {
        const bool shader = pass.kind == PassKind::compute || pass.kind == PassKind::fullscreen ||
                            pass.kind == PassKind::raster;
        if (shader && !use.is_output && use.access == Access::sampled_read && is_sampled(use.state) &&
            use.binding != kNoId && use.each == EachPart::none)
            return;
        fault(use.resource, use.loc, "is used by pass \"" + pass.name + "\" in another way than by sampling");
    }

    void check_barriers(const std::vector<BarrierDecl>& barriers) const {
        for (const BarrierDecl& barrier : barriers)
            if (is_table(barrier.resource))
                fault(barrier.resource, plan_.graph.resources[barrier.resource].loc,
                      "is a table of textures and has a barrier, but the plan does not know its images");
    }

    const FramePlan& plan_;
    FaultList& faults_;
};

}  // namespace

void check_tables(const FramePlan& plan, FaultList& faults) {
    TableCheck(plan, faults).run();
}

}  // namespace weft::check
