// Finds the units: sets of passes with "rest" that must run together, and the rounds of groups. Also checks
// that the result of each unit with "rest" depends only on its inputs, and that every reader sees the right
// content in frames in which a unit does not run.
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
        number_units();
    }

 private:
    [[nodiscard]] const PassDraft& draft(PassId pass) const { return declared_.expansion.passes[pass]; }
    [[nodiscard]] const GroupDecl* group_of(PassId pass) const {
        return draft(pass).group == kNoId ? nullptr : &declared_.expansion.groups[draft(pass).group];
    }
    [[nodiscard]] bool says_rest(PassId pass) const {
        // A pass with "switch" and "rest" has an error already.
        return draft(pass).desc->rests && draft(pass).desc->switch_param.empty() &&
               declared_.input.request.rests;
    }
    // Returns true if the pass belongs to a unit.
    [[nodiscard]] bool has_unit(PassId pass) const { return says_rest(pass) || group_of(pass); }
    // Returns true if the pass, or its group, has "rest".
    [[nodiscard]] bool rests(PassId pass) const {
        return group_of(pass) ? group_of(pass)->rests : says_rest(pass);
    }
    [[nodiscard]] bool in_one_unit(PassId a, PassId b) {
        if (!has_unit(a) || !has_unit(b) || draft(a).group != draft(b).group) return false;
        return group_of(a) ? draft(a).round == draft(b).round : sets_.find(a) == sets_.find(b);
    }
    [[nodiscard]] bool observes(PassId pass) const { return draft(pass).is_observer; }
    [[nodiscard]] const UseDecl& use(const CellUse& u) const { return graph_.passes[u.pass].uses[u.use]; }
    [[nodiscard]] const ResourceDecl& resource(const Cell& cell) const {
        return graph_.resources[cell.resource];
    }
    [[nodiscard]] bool unit_writes(const Cell& cell) const {
        return std::ranges::any_of(cell.writers, [&](const CellUse& w) { return has_unit(w.pass); });
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

    // Unites the passes with "rest" that must run together because of this cell (a part of a resource). These
    // passes are all writers of the cell, and the readers that see a version before the last one. If the
    // resource is transient, all readers of the cell belong to them.
    void unite(const Cell& cell) {
        if (!unit_writes(cell)) return;
        const PassId first = cell.writers.front().pass;
        const auto joins = [&](PassId pass) { return says_rest(pass) && says_rest(first); };
        for (const CellUse& writer : cell.writers)
            if (joins(writer.pass)) sets_.unite(first, writer.pass);
        const bool local = resource(cell).lifetime == ResourceLifetime::transient;
        for (const CellUse& reader : cell.readers)
            if (joins(reader.pass) && (local || sees_middle(cell, reader))) sets_.unite(first, reader.pass);
    }

    // Returns true if the reader sees a version of this frame that a later pass overwrites.
    [[nodiscard]] bool sees_middle(const Cell& cell, const CellUse& reader) const {
        const int version = version_seen(graph_, cell, reader);
        return version >= 0 && version + 1 < static_cast<int>(cell.writers.size());
    }

    void check_keys(PassId pass) {
        for (const UseDecl& u : graph_.passes[pass].uses)
            if (!u.wakes && !draft(pass).desc->rests && !group_of(pass))
                add_help(
                    error(pass, u.loc, "has no \"rest\", but its port " + quote(u.port) + " has \"wakes\""),
                    "remove \"wakes\", or add \"rest\": true to the pass");
        if (group_of(pass) && draft(pass).decl.kind == PassKind::custom)
            add_help(report_.error(pass, draft(pass).desc->loc, "W190",
                                   "pass " + quote(declared_.author_name(pass)) +
                                       " has a type in C++, which a group cannot contain"),
                     "move the pass out of the group");
        if (!says_rest(pass) || draft(pass).decl.frame_slices == 0) return;
        add_help(error(pass, draft(pass).desc->rest_loc, "has both \"rest\" and \"perFrame\""),
                 "remove one of the two keys");
    }

    void check(const Cell& cell) {
        if (graph_.suspects.writers[cell.resource]) return;
        if (unit_writes(cell)) {
            for (const CellUse& writer : cell.writers) check_writer(cell, writer);
            for (const CellUse& reader : cell.readers) check_reader(cell, reader);
            return;
        }
        const ResourceId id = resource(cell).ring == kNoId ? cell.resource : resource(cell).ring;
        for (const CellUse& reader : cell.readers) {
            if (!rests(reader.pass) || !use(reader).wakes) continue;
            if (use(reader).latest)
                report_other_rounds(cell, reader);
            else if (changes_[id] != kNoId)
                report_restless(cell, reader, changes_[id]);
        }
    }

    // Returns true if a port with "wakes": false of the pass reads the cell (a part of a resource).
    [[nodiscard]] bool declares_own_content(const Cell& cell, PassId pass) const {
        return std::ranges::any_of(graph_.passes[pass].uses, [&](const UseDecl& u) {
            return !u.wakes && u.resource == cell.resource && overlaps(u.range, cell.range);
        });
    }

    void check_writer(const Cell& cell, const CellUse& writer) {
        if (draft(writer.pass).decl.carries) return;  // report_not_kept() handles the other writers.
        if (!has_unit(writer.pass)) return report_other_writer(cell, writer);
        if (!is_kept(cell) && resource(cell).lifetime != ResourceLifetime::transient)
            return report_not_kept(cell, writer);
        const auto& sources = use(writer).sources;
        const bool own = std::ranges::any_of(sources, [&](const VersionSource& s) {
            return s.producer == kNoId && overlaps(s.range, cell.range);
        });
        if (own && rests(writer.pass) && !declares_own_content(cell, writer.pass))
            report_own_content(cell, writer);
    }

    void check_reader(const Cell& cell, const CellUse& reader) {
        const CellUse& writer = cell.writers.back();
        const bool together = in_one_unit(reader.pass, writer.pass);
        if (together && rests(reader.pass) && use(reader).wakes && version_seen(graph_, cell, reader) < 0)
            return report_own_content(cell, reader);
        if (together || observes(reader.pass) || !has_unit(writer.pass)) return;
        if (resource(cell).lifetime == ResourceLifetime::transient) return report_lost(cell, reader, writer);
        if (sees_middle(cell, reader)) return report_middle(cell, reader, writer);
        const bool restless = rests(reader.pass) && use(reader).wakes && !rests(writer.pass);
        if (restless) report_restless(cell, reader, writer.pass);
    }

    [[nodiscard]] std::string what(const Cell& cell) const {
        return quote(range_of(resource(cell), cell.range));
    }

    // Adds an error about a rule of "rest", or about the same rule of groups.
    Diagnostic& error(PassId pass, SourceLoc loc, const std::string& fault) {
        return report_.error(pass, loc, "W188", "pass " + quote(declared_.author_name(pass)) + " " + fault);
    }

    // Returns the reason why the pass does not run in every frame: `has "rest"`, or `belongs to group "g"`.
    [[nodiscard]] std::string reason(PassId pass) const {
        return group_of(pass) ? "belongs to group " + quote(group_of(pass)->name) : "has \"rest\"";
    }
    // Returns the reason why the pass may rest.
    [[nodiscard]] std::string rest_reason(PassId pass) const {
        return group_of(pass) ? reason(pass) + ", which has \"rest\"" : reason(pass);
    }
    // Returns `pass "a"` or `group "g"`: the part of the graph that has the key "rest".
    [[nodiscard]] std::string rester(PassId pass) const {
        return group_of(pass) ? "group " + quote(group_of(pass)->name)
                              : "pass " + quote(declared_.author_name(pass));
    }

    void report_other_rounds(const Cell& cell, const CellUse& reader) {
        if (!is_new(cell, reader.pass, reader.pass)) return;
        Diagnostic& d = error(reader.pass, use(reader).loc,
                              rest_reason(reader.pass) + ", but its result depends on " + what(cell) +
                                  ", which other rounds of the group overwrite");
        add_help(d,
                 "add \"wakes\": false to the port, if a round need not run again when other rounds have "
                 "run; or remove \"rest\" from the group");
    }

    // Returns true if no error about this resource and the descriptions of these two passes was reported yet.
    // The passes of a repeat have one description.
    bool is_new(const Cell& cell, PassId a, PassId b) {
        const auto desc = [&](PassId pass) { return declared_.expansion.passes[pass].desc; };
        return reported_.insert({desc(a), desc(b), cell.resource}).second;
    }

    void report_restless(const Cell& cell, const CellUse& reader, PassId writer) {
        if (!is_new(cell, reader.pass, writer)) return;
        const std::string name = quote(declared_.author_name(writer));
        Diagnostic& d = error(reader.pass, use(reader).loc,
                              rest_reason(reader.pass) + ", but would never rest: it reads " + what(cell) +
                                  ", and pass " + name + " writes this resource in every frame");
        add_help(d,
                 "remove \"rest\" from " + rester(reader.pass) + ", or add \"rest\": true to " +
                     rester(writer) +
                     ", too; or add \"wakes\": false to the port, if the pass need not run for each change");
    }

    void report_other_writer(const Cell& cell, const CellUse& writer) {
        const auto resting =
            std::ranges::find_if(cell.writers, [&](const auto& w) { return has_unit(w.pass); });
        if (!is_new(cell, resting->pass, writer.pass)) return;
        const std::string name = quote(declared_.author_name(writer.pass));
        Diagnostic& d = error(resting->pass, use(*resting).loc,
                              "has \"rest\" and writes " + what(cell) + ", but pass " + name +
                                  " writes this part, too, and in every frame");
        add_note(d, reporter_.sources(), use(writer).loc, "the other pass writes here");
        add_help(d,
                 "let the two passes write different resources, mips, layers or elements; or add \"rest\": "
                 "true to pass " +
                     name);
    }

    void report_not_kept(const Cell& cell, const CellUse& writer) {
        if (!is_new(cell, writer.pass, writer.pass)) return;
        const bool imported = resource(cell).lifetime == ResourceLifetime::imported;
        if (declared_.input.request.exports.contains(resource(cell).name) && imported)
            return report_lost_export(cell, writer);
        Diagnostic& d = error(
            writer.pass, use(writer).loc,
            reason(writer.pass) + " and writes " + what(cell) +
                (imported ? ", but the program owns this import and may change its content"
                          : ", but the content of a resource with \"history\" moves on in every frame"));
        add_help(d, imported
                        ? "write a resource with \"keep\": true, and copy it to the import in another pass"
                        : "give resource " + quote(resource(cell).name) +
                              " \"keep\": true instead of \"history\"");
    }

    void report_lost_export(const Cell& cell, const CellUse& writer) {
        Diagnostic& d = error(writer.pass, use(writer).loc,
                              reason(writer.pass) + " and writes " + what(cell) +
                                  ", which the program uses between frames, but this resource does not keep "
                                  "its content between frames");
        add_help(d, "add \"keep\": true to resource " + quote(resource(cell).name));
    }

    void report_lost(const Cell& cell, const CellUse& reader, const CellUse& writer) {
        if (!is_new(cell, reader.pass, writer.pass)) return;
        Diagnostic& d =
            error(writer.pass, use(writer).loc,
                  reason(writer.pass) + " and writes " + what(cell) + ", which pass " +
                      quote(declared_.author_name(reader.pass)) +
                      " reads in every frame, but this resource does not keep its content between frames");
        add_help(d, "add \"keep\": true to resource " + quote(resource(cell).name));
    }

    void report_middle(const Cell& cell, const CellUse& reader, const CellUse& writer) {
        if (group_of(writer.pass)) return;  // check_group_order() reports this.
        if (!is_new(cell, reader.pass, writer.pass)) return;
        Diagnostic& d =
            error(reader.pass, use(reader).loc,
                  "reads " + what(cell) + " before pass " + quote(declared_.author_name(writer.pass)) +
                      " changes it. In frames in which the second pass rests, the resource has only the "
                      "content after the change");
        add_help(d, "read the resource after pass " + quote(declared_.author_name(writer.pass)) +
                        ", or add \"rest\": true to pass " + quote(declared_.author_name(reader.pass)));
    }

    void report_own_content(const Cell& cell, const CellUse& u) {
        if (!is_new(cell, u.pass, u.pass)) return;
        Diagnostic& d =
            error(u.pass, use(u).loc,
                  rest_reason(u.pass) + ", but its result depends on the content that " + what(cell) +
                      " had before, so the result would change each time the pass runs again");
        const ShaderBinding* binding = graph_.passes[u.pass].ports[u.use].binding;
        if (declared_.expansion.passes[u.pass].desc->partial)
            add_help(d, "if the pass writes all of " + what(cell) + ", remove \"partial\"");
        else if (binding != nullptr && binding->writes)
            add_help(d, "if the shader only writes " + quote(binding->name) + ", declare it as `writeonly`");
        add_help(d, std::string("let the pass, or a pass ") +
                        (group_of(u.pass) ? "of its round" : "with \"rest\"") + " before it, write all of " +
                        what(cell) + "; or remove \"rest\" from " + rester(u.pass));
    }

    // After a resize, a group with limited rounds may need several frames until all rounds have run. The
    // outputs of the rounds must not be undefined until then, so they are cleared.
    void clear_outputs(PassId pass) {
        for (const UseDecl& u : graph_.passes[pass].uses) {
            OnResize& on_resize = graph_.resources[u.resource].on_resize;
            if (writes(u.access) && on_resize == OnResize::refill) on_resize = OnResize::clear;
        }
    }

    void number_units() {
        graph_.rest_units.assign(graph_.passes.size(), kNoId);
        for (PassId pass(0); pass < graph_.passes.size(); ++pass) {
            if (!says_rest(pass)) continue;
            const PassId first = sets_.find(pass);
            graph_.rest_units[pass] = first == pass ? graph_.rest_unit_count++ : graph_.rest_units[first];
        }
        graph_.groups = declared_.expansion.groups;
        for (GroupDecl& group : graph_.groups) {
            group.first_unit = graph_.rest_unit_count;
            graph_.rest_unit_count += group.rounds;
        }
        for (PassId pass(0); pass < graph_.passes.size(); ++pass)
            if (group_of(pass) && group_of(pass)->is_limited()) clear_outputs(pass);
        for (PassId pass(0); pass < graph_.passes.size(); ++pass)
            if (draft(pass).group != kNoId)
                graph_.rest_units[pass] = graph_.groups[draft(pass).group].first_unit + draft(pass).round;
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
    const auto has_key = [](const PassDraft& draft) {
        return draft.desc->rests || draft.group != kNoId ||
               std::ranges::any_of(draft.desc->in, [](const PortDesc& port) { return !port.wakes; });
    };
    const bool any = std::ranges::any_of(declared.expansion.passes, has_key);
    if (any && (declared.input.request.rests || !declared.expansion.groups.empty()))
        RestUnitFinder(declared, cells, graph, reporter).run();
}

}  // namespace weft
