// Finds the rest units: sets of passes with "rest" that must run together. Also checks that the result of
// each unit depends only on its inputs, and that every reader sees the right content while the unit rests.
#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/version/connect_versions.h"

namespace weft {
namespace {

// Sets of passes. Each set has one pass as its representative.
class PassSets {
 public:
    explicit PassSets(size_t pass_count) : parent_(pass_count) {
        std::iota(parent_.begin(), parent_.end(), PassId(0));
    }
    [[nodiscard]] PassId find(PassId pass) {
        while (parent_[pass] != pass) pass = parent_[pass] = parent_[parent_[pass]];
        return pass;
    }
    // The pass with the lower id becomes the representative.
    void unite(PassId a, PassId b) {
        a = find(a), b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

 private:
    std::vector<PassId>
        parent_;  // Index: PassId. A pass of the same set; a representative is its own parent.
};

class RestUnitFinder {
 public:
    RestUnitFinder(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                   Reporter& reporter)
        : declared_(declared),
          cells_(cells),
          graph_(graph),
          sets_(graph.passes.size()),
          changes_(graph.resources.size(), kNoId),
          report_(declared.shapes, declared.expansion, graph.suspects, reporter),
          reporter_(reporter) {}

    void run() {
        for (const Cell& cell : cells_) note_change(cell);
        for (const Cell& cell : cells_)
            if (cell.ordered) unite(cell);
        for (PassId pass(0); pass < graph_.passes.size(); ++pass) check_keys(pass);
        for (const Cell& cell : cells_)
            if (cell.ordered) check(cell);
        agree_on_layouts();
        number_units();
    }

 private:
    [[nodiscard]] bool rests(PassId pass) const { return declared_.expansion.passes[pass].desc->rests; }
    [[nodiscard]] bool observes(PassId pass) const { return declared_.expansion.passes[pass].is_observer; }
    [[nodiscard]] const UseDecl& use(const CellUse& u) const { return graph_.passes[u.pass].uses[u.use]; }
    [[nodiscard]] const ResourceDecl& resource(const Cell& cell) const {
        return graph_.resources[cell.resource];
    }
    [[nodiscard]] bool unit_writes(const Cell& cell) const {
        return std::ranges::any_of(cell.writers, [&](const CellUse& w) { return rests(w.pass); });
    }
    [[nodiscard]] bool is_kept(const Cell& cell) const {
        return resource(cell).lifetime == ResourceLifetime::persistent && resource(cell).history == 0;
    }

    // Remembers for each resource a pass that writes it in every frame.
    void note_change(const Cell& cell) {
        const ResourceId id = resource(cell).ring == kNoId ? cell.resource : resource(cell).ring;
        for (const CellUse& writer : cell.writers)
            if (!rests(writer.pass)) changes_[id] = writer.pass;
    }

    // Unites the passes that must run together because of this cell: all its writers, and the resting readers
    // that see a version before the last one.
    void unite(const Cell& cell) {
        if (!unit_writes(cell)) return;
        const PassId first = cell.writers.front().pass;
        for (const CellUse& writer : cell.writers)
            if (rests(writer.pass) && rests(first)) sets_.unite(first, writer.pass);
        const bool local = resource(cell).lifetime == ResourceLifetime::transient;
        for (const CellUse& reader : cell.readers)
            if (rests(reader.pass) && rests(first) && (local || sees_middle(cell, reader)))
                sets_.unite(first, reader.pass);
    }

    // Returns true if the reader sees a version of this frame that a later pass overwrites.
    [[nodiscard]] bool sees_middle(const Cell& cell, const CellUse& reader) const {
        const int version = version_seen(graph_, cell, reader);
        return version >= 0 && version + 1 < static_cast<int>(cell.writers.size());
    }

    void check_keys(PassId pass) {
        const PassDraft& draft = declared_.expansion.passes[pass];
        for (const UseDecl& u : graph_.passes[pass].uses)
            if (!u.wakes && !rests(pass))
                add_help(
                    error(pass, u.loc, "has no \"rest\", but its port " + quote(u.port) + " has \"wakes\""),
                    "remove \"wakes\", or add \"rest\": true to the pass");
        if (!rests(pass) || draft.decl.frame_slices == 0) return;
        add_help(error(pass, draft.desc->rest_loc, "has both \"rest\" and \"perFrame\""),
                 "remove one of the two keys");
    }

    void check(const Cell& cell) {
        if (unit_writes(cell)) {
            for (const CellUse& writer : cell.writers) check_writer(cell, writer);
            for (const CellUse& reader : cell.readers) check_reader(cell, reader);
            return;
        }
        const ResourceId id = resource(cell).ring == kNoId ? cell.resource : resource(cell).ring;
        if (changes_[id] == kNoId) return;
        for (const CellUse& reader : cell.readers)
            if (rests(reader.pass) && use(reader).wakes) report_restless(cell, reader, changes_[id]);
    }

    void check_writer(const Cell& cell, const CellUse& writer) {
        if (!rests(writer.pass)) return report_other_writer(cell, writer);
        if (!is_kept(cell) && resource(cell).lifetime != ResourceLifetime::transient)
            return report_not_kept(cell, writer);
        const auto& sources = use(writer).sources;
        const bool own = std::ranges::any_of(sources, [&](const VersionSource& s) {
            return s.producer == kNoId && overlaps(s.range, cell.range);
        });
        if (own) report_own_content(cell, writer);
    }

    void check_reader(const Cell& cell, const CellUse& reader) {
        const CellUse& writer = cell.writers.back();
        const bool together = rests(reader.pass) && sets_.find(reader.pass) == sets_.find(writer.pass);
        if (together && version_seen(graph_, cell, reader) < 0) return report_own_content(cell, reader);
        if (together || observes(reader.pass) || !rests(writer.pass)) return;
        if (resource(cell).lifetime == ResourceLifetime::transient) return report_lost(cell, reader, writer);
        if (sees_middle(cell, reader)) report_middle(cell, reader, writer);
    }

    [[nodiscard]] std::string what(const Cell& cell) const {
        return quote(range_of(resource(cell), cell.range));
    }

    Diagnostic& error(PassId pass, SourceLoc loc, const std::string& fault) {
        return report_.error(pass, loc, "W188", "pass " + quote(declared_.author_name(pass)) + " " + fault);
    }

    // Returns true if no error about these two descriptions and this resource was reported yet. The passes of
    // a repeat have one description.
    bool is_new(const Cell& cell, PassId a, PassId b) {
        const auto desc = [&](PassId pass) { return declared_.expansion.passes[pass].desc; };
        return reported_.insert({desc(a), desc(b), cell.resource}).second;
    }

    void report_restless(const Cell& cell, const CellUse& reader, PassId writer) {
        if (!is_new(cell, reader.pass, writer)) return;
        const std::string name = quote(declared_.author_name(writer));
        Diagnostic& d = error(reader.pass, use(reader).loc,
                              "has \"rest\", but would never rest: it reads " + what(cell) + ", and pass " +
                                  name + " writes this resource in every frame");
        add_help(d,
                 "remove \"rest\" from pass " + quote(declared_.author_name(reader.pass)) +
                     ", or add \"rest\": true to pass " + name +
                     ", too; or add \"wakes\": false to the port, if the pass need not run for each change");
    }

    void report_other_writer(const Cell& cell, const CellUse& writer) {
        const auto resting = std::ranges::find_if(cell.writers, [&](const auto& w) { return rests(w.pass); });
        if (!is_new(cell, resting->pass, writer.pass)) return;
        const std::string name = quote(declared_.author_name(writer.pass));
        Diagnostic& d = error(resting->pass, use(*resting).loc,
                              "has \"rest\" and writes " + what(cell) + ", but pass " + name +
                                  " writes this part, too, and in every frame");
        add_note(d, reporter_.sources(), use(writer).loc, "the other pass writes here");
        add_help(
            d,
            "let the two passes write different resources, mips or layers; or add \"rest\": true to pass " +
                name);
    }

    void report_not_kept(const Cell& cell, const CellUse& writer) {
        if (!is_new(cell, writer.pass, writer.pass)) return;
        const bool imported = resource(cell).lifetime == ResourceLifetime::imported;
        Diagnostic& d = error(
            writer.pass, use(writer).loc,
            "has \"rest\" and writes " + what(cell) +
                (imported ? ", but the program owns this import and may change its content"
                          : ", but the content of a resource with \"history\" moves on in every frame"));
        add_help(d, imported
                        ? "write a resource with \"keep\": true, and copy it to the import in another pass"
                        : "give resource " + quote(resource(cell).name) +
                              " \"keep\": true instead of \"history\"");
    }

    void report_lost(const Cell& cell, const CellUse& reader, const CellUse& writer) {
        if (!is_new(cell, reader.pass, writer.pass)) return;
        Diagnostic& d =
            error(writer.pass, use(writer).loc,
                  "has \"rest\" and writes " + what(cell) + ", which pass " +
                      quote(declared_.author_name(reader.pass)) +
                      " reads in every frame, but this resource does not keep its content between frames");
        add_help(d, "add \"keep\": true to resource " + quote(resource(cell).name));
    }

    void report_middle(const Cell& cell, const CellUse& reader, const CellUse& writer) {
        if (!is_new(cell, reader.pass, writer.pass)) return;
        Diagnostic& d =
            error(reader.pass, use(reader).loc,
                  "reads " + what(cell) + " before pass " + quote(declared_.author_name(writer.pass)) +
                      " changes it; in frames in which that pass rests, only its result exists");
        add_help(d, "read the resource after pass " + quote(declared_.author_name(writer.pass)) +
                        ", or add \"rest\": true to pass " + quote(declared_.author_name(reader.pass)));
    }

    void report_own_content(const Cell& cell, const CellUse& u) {
        if (!is_new(cell, u.pass, u.pass)) return;
        Diagnostic& d = error(u.pass, use(u).loc,
                              "has \"rest\", but its result depends on the content that " + what(cell) +
                                  " had before: it would differ whenever the pass runs again");
        const ShaderBinding* binding = graph_.passes[u.pass].ports[u.use].binding;
        if (declared_.expansion.passes[u.pass].desc->partial)
            add_help(d, "if the pass writes all of " + what(cell) + ", remove \"partial\"");
        else if (binding != nullptr && binding->writes)
            add_help(d, "if the shader only writes " + quote(binding->name) + ", declare it as `writeonly`");
        add_help(d, "let the pass, or a pass with \"rest\" before it, write all of " + what(cell) +
                        "; or remove \"rest\"");
    }

    // Each image that units write has one layout while no unit writes it. If its readers need different
    // layouts, all of them use GENERAL.
    void agree_on_layouts() {
        std::vector<Layout> layouts(graph_.resources.size(), Layout::undefined);
        std::vector<uint8_t> general(graph_.resources.size(), 0);
        for (const Cell& cell : cells_) {
            if (!unit_writes(cell) || resource(cell).kind != ResourceKind::image) continue;
            for (const CellUse& reader : cell.readers) {
                Layout& layout = layouts[cell.resource];
                const Layout wanted = use(reader).state.layout;
                general[cell.resource] |= layout != Layout::undefined && layout != wanted ? 1 : 0;
                layout = wanted;
            }
        }
        for (BoundPass& pass : graph_.passes)
            for (UseDecl& u : pass.uses)
                if (general[u.resource] && !writes(u.access)) u.state.layout = Layout::general;
    }

    void number_units() {
        graph_.rest_units.assign(graph_.passes.size(), kNoId);
        for (PassId pass(0); pass < graph_.passes.size(); ++pass) {
            if (!rests(pass)) continue;
            const PassId first = sets_.find(pass);
            graph_.rest_units[pass] = first == pass ? graph_.rest_unit_count++ : graph_.rest_units[first];
        }
    }

    const Declared& declared_;
    const std::vector<Cell>& cells_;
    VersionedGraph& graph_;
    PassSets sets_;
    // Index: ResourceId; for a ring, its resource of age 0. A pass without "rest" that writes the resource,
    // or kNoId.
    std::vector<PassId> changes_;
    std::set<std::tuple<const PassDesc*, const PassDesc*, ResourceId>> reported_;
    PassReporter report_;
    Reporter& reporter_;
};

}  // namespace

void find_rest_units(const Declared& declared, const std::vector<Cell>& cells, VersionedGraph& graph,
                     Reporter& reporter) {
    if (!declared.input.request.rests) return;
    const auto has_key = [](const PassDraft& draft) {
        return draft.desc->rests ||
               std::ranges::any_of(draft.desc->in, [](const PortDesc& port) { return !port.wakes; });
    };
    const bool any = std::ranges::any_of(declared.expansion.passes, has_key);
    if (any) RestUnitFinder(declared, cells, graph, reporter).run();
}

}  // namespace weft
