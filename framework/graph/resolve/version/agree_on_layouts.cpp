// Gives one layout to all reads of an image if the layout must not depend on which units run, and in which
// order. A unit is a set of passes with "rest" that run together, or a round of a group.
#include "graph/resolve/version/connect_versions.h"

namespace weft {
namespace {

class LayoutAgreement {
 public:
    LayoutAgreement(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph)
        : declared_(declared), cells_(cells), graph_(graph) {}

    void run() {
        for (uint32_t group = 0; group < graph_.groups.size(); ++group) agree_in_group(group);
        agree_at_home();
    }

 private:
    // The layouts that the reads of each resource need. Index: ResourceId.
    struct Wanted {
        explicit Wanted(size_t resources) : layouts(resources, Layout::undefined), differ(resources, 0) {}
        void add(ResourceId resource, Layout wanted) {
            Layout& layout = layouts[resource];
            differ[resource] |= layout != Layout::undefined && layout != wanted ? 1 : 0;
            layout = wanted;
        }
        std::vector<Layout> layouts;
        std::vector<uint8_t> differ;  // 1: two reads need different layouts.
    };

    template <class Visit>
    void each_read(const Visit& visit) {
        for (PassId pass(0); pass < graph_.passes.size(); ++pass)
            for (UseDecl& use : graph_.passes[pass].uses)
                if (use.access != Access::none && !writes(use.access) &&
                    graph_.resources[use.resource].kind == ResourceKind::image)
                    visit(pass, use);
    }

    // The rounds of a group run in any order, so all reads of an image in the group must use the same layout.
    // If the reads need different layouts, all of them use GENERAL.
    void agree_in_group(uint32_t group) {
        Wanted wanted(graph_.resources.size());
        const auto is_member = [&](PassId pass) { return declared_.expansion.passes[pass].group == group; };
        each_read([&](PassId pass, const UseDecl& use) {
            if (is_member(pass)) wanted.add(use.resource, use.state.layout);
        });
        each_read([&](PassId pass, UseDecl& use) {
            if (is_member(pass) && wanted.differ[use.resource] != 0) use.state.layout = Layout::general;
        });
    }

    // A unit is a set of passes with "rest", or a round of a group. An image that units write has one fixed
    // layout at all times except while a unit writes it. If the readers of the image need different layouts,
    // all of them use GENERAL. The program is one of the readers if it reads the image between frames.
    void agree_at_home() {
        Wanted wanted(graph_.resources.size());
        for (const Cell& cell : cells_) {
            const ResourceDecl& image = graph_.resources[cell.resource];
            if (image.kind != ResourceKind::image) continue;
            bool by_unit = false;
            for (const CellUse& writer : cell.writers) by_unit |= graph_.rest_units[writer.pass] != kNoId;
            for (const CellUse& reader : cell.readers) {
                const UseDecl& use = graph_.passes[reader.pass].uses[reader.use];
                if (by_unit || use.latest) wanted.add(use.resource, use.state.layout);
            }
            if (by_unit && image.between) wanted.add(cell.resource, image.between->layout);
        }
        each_read([&](PassId, UseDecl& use) {
            if (wanted.differ[use.resource] != 0) use.state.layout = Layout::general;
        });
        for (ResourceId id(0); id < graph_.resources.size(); ++id)
            if (wanted.differ[id] != 0 && graph_.resources[id].between)
                graph_.resources[id].between->layout = Layout::general;
    }

    const Declared& declared_;
    const std::vector<Cell>& cells_;
    VersionedGraph& graph_;
};

}  // namespace

void agree_on_layouts(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph) {
    if (!graph.rest_units.empty()) LayoutAgreement(declared, cells, graph).run();
}

}  // namespace weft
