#include "graph/resolve/views/view_lists.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "graph/resolve/fault_text.h"
#include "graph/resolve/rings.h"

namespace weft {
namespace {

constexpr double kMostViews = 1u << 16;
constexpr uint32_t kCubeFaces = 6;

std::string count_name(const std::string& list) {
    return list + "Views";
}

bool is_single(const ImportCatalog& imports, const std::string& name) {
    return std::ranges::find(imports.views, name) != imports.views.end() && !imports.imports.contains(name);
}

// Returns the list of views that the program offers under this name, if the graph imports the list or the
// list needs no import. Otherwise returns null.
const ImportDecl* find_offered(const ResolveInput& input, const std::string& name) {
    const auto offered = input.imports.imports.find(name);
    if (offered == input.imports.imports.end() || offered->second.kind != ImportKind::views) return nullptr;
    const auto import = input.graph.imports.find(name);
    const bool imported =
        import != input.graph.imports.end() && import->second.kind == import_kind_name(ImportKind::views);
    const bool always = std::ranges::find(input.imports.views, name) != input.imports.views.end();
    return imported || always ? &offered->second : nullptr;
}

std::vector<std::string> known_lists(const ResolveInput& input) {
    std::vector<std::string> names = input.imports.views;
    for (const auto& [name, import] : input.graph.imports)
        if (find_offered(input, name) != nullptr && std::ranges::find(names, name) == names.end())
            names.push_back(name);
    for (const auto& [name, unused] : input.graph.views) names.push_back(name);
    return names;
}

// True if the graph imports a list of views of this name that the program does not offer. shape_resources()
// reports this import.
bool is_faulty_import(const ResolveInput& input, const std::string& name) {
    const auto import = input.graph.imports.find(name);
    return import != input.graph.imports.end() &&
           import->second.kind == import_kind_name(ImportKind::views) && find_offered(input, name) == nullptr;
}

void add_list_help(const ResolveInput& input, const std::string& name, Diagnostic& d) {
    const auto offered = input.imports.imports.find(name);
    if (offered != input.imports.imports.end() && offered->second.kind == ImportKind::views)
        return add_help(d, "import the list: \"imports\": { " + quote(name) + ": \"views\" }");
    const std::vector<std::string> names = known_lists(input);
    const std::string near = did_you_mean_text(name, names);
    add_help(d, near.empty() ? "the views are " + quote_all(names) : near);
}

// Checks the references between the lists of the section "views": each "of" must name an existing list, and
// no list may refer to itself, directly or through other lists. Returns the names of the faulty lists.
class ReferenceCheck {
 public:
    ReferenceCheck(const ResolveInput& input, Reporter& reporter) : input_(input), reporter_(reporter) {}

    std::set<std::string> run() {
        for (const auto& [name, list] : input_.graph.views) check(list);
        return std::move(faulty_);
    }

 private:
    void check(const ViewListDesc& list) {
        std::set<std::string> path{list.name};
        const ViewListDesc* at = &list;
        while (!at->of.empty()) {
            const auto next = input_.graph.views.find(at->of);
            if (next == input_.graph.views.end()) break;
            if (!path.insert(next->first).second) return report_cycle(list, next->first);
            at = &next->second;
        }
        if (at->of.empty()) return check_mirrors(list, *at);
        if (is_single(input_.imports, at->of) || find_offered(input_, at->of) != nullptr) return;
        faulty_.insert(list.name);
        if (at != &list || is_faulty_import(input_, at->of)) return;
        Diagnostic& d = reporter_.error(
            list.of_loc, "W118",
            "the list of views " + quote(list.name) + " shows the unknown view " + quote(list.of));
        add_list_help(input_, list.of, d);
    }

    // Reports a mirror of views from a buffer: the mirrored matrices are computed on the CPU, which does not
    // know the content of the buffer. `base` is the last list of the chain of references that begins at
    // `list`.
    void check_mirrors(const ViewListDesc& list, const ViewListDesc& base) {
        if (!base.buffer) return;
        const ViewListDesc* last_mirror = nullptr;
        for (const ViewListDesc* at = &list; at != &base; at = &input_.graph.views.at(at->of))
            if (at->plane) last_mirror = at;
        if (last_mirror == nullptr) return;
        faulty_.insert(list.name);
        // Only the mirror that is nearest to the buffer is reported, not the lists that show this mirror.
        if (last_mirror != &list) return;
        Diagnostic& d = reporter_.error(list.of_loc, "W230",
                                        "the list of views " + quote(list.name) + " is a mirror of " +
                                            quote(base.name) + ", whose matrices are in a buffer");
        add_help(d, "let the pass that writes " + quote(base.buffer->ref.name) +
                        " write the mirrored matrices too, and remove \"plane\"");
    }

    void report_cycle(const ViewListDesc& list, const std::string& met) {
        faulty_.insert(list.name);
        // Each cycle is reported once, for the first of its lists in the order of names.
        if (met != list.name || reported_.contains(list.name)) return;
        std::string text = quote(list.name);
        std::string at = list.name;
        do {
            reported_.insert(at);
            at = input_.graph.views.at(at).of;
            text += " shows " + quote(at);
        } while (at != list.name);
        Diagnostic& d = reporter_.error(list.of_loc, "W191", "lists of views show each other: " + text);
        add_help(d, "let one of these lists show \"camera\", or a list that is not in this cycle");
    }

    const ResolveInput& input_;
    Reporter& reporter_;
    std::set<std::string> faulty_, reported_;
};

// Makes one list of the section "views".
class ListMaker {
 public:
    ListMaker(const ResolveInput& input, const Values& values, Reporter& reporter,
              std::map<std::string, ViewList, std::less<>>& lists)
        : input_(input), values_(values), evaluator_(values, reporter), reporter_(reporter), lists_(lists) {}

    // Returns null if the list or a list that it shows is faulty.
    const ViewList* make(const std::string& name) {
        if (const auto made = lists_.find(name); made != lists_.end()) return &made->second;
        const auto desc = input_.graph.views.find(name);
        if (desc == input_.graph.views.end() || values_.faulty.contains(count_name(name))) return nullptr;
        std::optional<ViewList> list = desc->second.buffer       ? in_buffer(desc->second)
                                       : desc->second.of.empty() ? cube(desc->second)
                                                                 : shown(desc->second);
        if (!list) return nullptr;
        list->desc = &desc->second;
        return &lists_.emplace(name, std::move(*list)).first->second;
    }

 private:
    std::optional<double> finite(const Expr& expression, const std::string& what, double least) const {
        constexpr double kMost = 1e30;
        return evaluator_.number(expression, what, least, kMost, false);
    }

    std::optional<ViewList> cube(const ViewListDesc& desc) const {
        if (!desc.at) return std::nullopt;
        ViewList list = named(desc.name, kCubeFaces);
        list.decl.source = ViewSource::cube;
        list.decl.near_m = 0.05;
        if (!desc.near_m.empty()) {
            const std::optional<double> near_m = finite(desc.near_m, "\"near\" of " + quote(desc.name), 1e-6);
            if (!near_m) return std::nullopt;
            list.decl.near_m = *near_m;
        }
        for (size_t i = 0; i < 3; ++i) {
            const std::optional<double> at = finite((*desc.at)[i], "\"at\" of " + quote(desc.name), -1e30);
            if (!at) return std::nullopt;
            list.decl.at[i] = *at;
        }
        return list;
    }

    std::optional<ViewList> in_buffer(const ViewListDesc& desc) const {
        const std::optional<double> count =
            evaluator_.number(desc.count, "\"count\" of " + quote(desc.name), 0, kMostViews);
        if (!count) return std::nullopt;
        ViewList list = named(desc.name, static_cast<uint32_t>(*count));
        const RefDesc& ref = desc.buffer->ref;
        list.decl.source = ViewSource::buffer;
        list.decl.of = role_name(ref.name, ref.history);
        return list;
    }

    static ViewList named(const std::string& name, uint32_t count) {
        ViewList list;
        list.base = list.decl.name = name;
        list.count = list.decl.count = count;
        return list;
    }

    std::optional<ViewList> shown(const ViewListDesc& desc) {
        const ViewList* other = make(desc.of);
        if (other == nullptr) return std::nullopt;
        const size_t errors = reporter_.error_count();
        std::optional<ViewList> list = part_of(*other, desc);
        if (!list) help_with_count(*other, errors, reporter_);
        return list;
    }

    std::optional<ViewList> part_of(const ViewList& other, const ViewListDesc& desc) {
        uint32_t first = 0;
        if (!desc.first.empty()) {
            const std::optional<double> asked = evaluator_.number(
                desc.first, "\"first\" of " + quote(desc.name), 0, std::max(other.count, 1u) - 1.0);
            if (!asked) return std::nullopt;
            first = static_cast<uint32_t>(*asked);
        }
        uint32_t count = other.count - std::min(first, other.count);
        if (!desc.count.empty()) {
            const std::optional<double> asked =
                evaluator_.number(desc.count, "\"count\" of " + quote(desc.name), 0, count);
            if (!asked) return std::nullopt;
            count = static_cast<uint32_t>(*asked);
        }
        if (!desc.plane) {
            ViewList part = other;
            part.first += first;
            part.count = count;
            return part;
        }
        ViewList list = named(desc.name, count);
        list.decl.source = ViewSource::mirror;
        list.decl.of = other.base;
        list.decl.first = other.first + first;
        return set_plane(desc, list) ? std::optional(list) : std::nullopt;
    }

    bool set_plane(const ViewListDesc& desc, ViewList& list) const {
        std::array<double, 4> plane{};
        for (size_t i = 0; i < 4; ++i) {
            const std::optional<double> x =
                finite((*desc.plane)[i], "\"plane\" of " + quote(desc.name), -1e30);
            if (!x) return false;
            plane[i] = *x;
        }
        const double length = std::hypot(plane[0], plane[1], plane[2]);
        if (length < 1e-30) {
            Diagnostic& d = reporter_.error((*desc.plane)[0].loc, "W109",
                                            "the plane of " + quote(desc.name) + " has no direction");
            add_help(d, "write [a, b, c, d] with a, b or c other than 0, for example [0, 1, 0, 0]");
            return false;
        }
        for (size_t i = 0; i < 4; ++i) list.decl.plane[i] = plane[i] / length;
        return true;
    }

    const ResolveInput& input_;
    const Values& values_;
    const Evaluator evaluator_;
    Reporter& reporter_;
    std::map<std::string, ViewList, std::less<>>& lists_;
};

// Returns the name before the number of a view: "sun" for "sun(1)".
std::string list_of(const std::string& view) {
    return view.substr(0, view.find('('));
}

}  // namespace

std::map<std::string, Expr> count_views(const ResolveInput& input, Values& values, Reporter& reporter) {
    const GraphDesc& graph = input.graph;
    const auto is_taken = [&](const std::string& text) {
        return graph.sizes.contains(text) || graph.consts.contains(text) || values.by_name.contains(text);
    };
    for (const auto& [list, offered] : input.imports.imports)
        if (find_offered(input, list) != nullptr && !is_taken(count_name(list)))
            values.by_name[count_name(list)] = number_value(offered.views);
    for (const auto& [list, import] : graph.imports)
        if (is_faulty_import(input, list)) values.faulty.insert(count_name(list));
    std::map<std::string, Expr> counts;
    const std::set<std::string> faulty = ReferenceCheck(input, reporter).run();
    for (const auto& [list, desc] : graph.views) {
        const std::string count = count_name(list);
        if (is_taken(count) || is_single(input.imports, list)) {
            Diagnostic& d = reporter.error(
                desc.loc, "W109",
                is_single(input.imports, list)
                    ? "the program has a view of the name " + quote(list)
                    : "the name " + quote(count) + " means the number of views of this list, but is used");
            add_help(d, "choose another name for the list");
        }
        if (faulty.contains(list)) values.faulty.insert(count);
        if (!desc.count.empty())
            counts[count] = desc.count;
        else if (desc.of.empty())
            counts[count] = number_expression(kCubeFaces, desc.loc);
        else if (is_single(input.imports, desc.of))
            counts[count] = number_expression(1, desc.loc);
        else
            counts[count] = name_expression(count_name(desc.of), desc.of_loc);
        if (!desc.first.empty() && desc.count.empty()) {
            Expr& rest = counts[count];
            rest.postfix.insert(rest.postfix.end(), desc.first.postfix.begin(), desc.first.postfix.end());
            rest.postfix.push_back({ExprOp::sub, 0, {}, desc.first.loc});
        }
    }
    return counts;
}

std::map<std::string, ViewList, std::less<>> list_views(const ResolveInput& input, Values& values,
                                                        Reporter& reporter) {
    std::map<std::string, ViewList, std::less<>> lists;
    for (const auto& [list, offered] : input.imports.imports) {
        if (find_offered(input, list) == nullptr) continue;
        ViewList& made = lists[list];
        made.base = made.decl.name = list;
        made.count = made.decl.count = static_cast<uint32_t>(std::min<double>(offered.views, kMostViews));
        made.import = &offered;
    }
    for (const std::string& view : input.imports.views) {
        if (!is_single(input.imports, view)) continue;
        ViewList& made = lists[view];
        made.base = made.decl.name = view;
        made.count = 1;
        made.single = true;
    }
    ListMaker maker(input, values, reporter, lists);
    for (const auto& [list, unused] : input.graph.views)
        if (maker.make(list) == nullptr) values.faulty.insert(count_name(list));
    return lists;
}

const ViewList* find_view_list(const ResolveInput& input, const Values& values, const PassDesc& pass,
                               Reporter& reporter) {
    const auto list = values.views.find(pass.view);
    if (list != values.views.end()) return &list->second;
    if (values.faulty.contains(count_name(pass.view)) || is_faulty_import(input, pass.view)) return nullptr;
    Diagnostic fault =
        input.graph.sources.error(pass.view_loc.line != 0 ? pass.view_loc : pass.loc, "W118",
                                  "pass " + quote(pass.name) + " uses unknown view " + quote(pass.view));
    add_list_help(input, pass.view, fault);
    reporter.add_once(std::move(fault));
    return nullptr;
}

std::string view_name(const ViewList& list, uint32_t number) {
    return list.single ? list.base : list.base + "(" + std::to_string(list.first + number) + ")";
}

void help_with_count(const ViewList& list, size_t errors, Reporter& reporter) {
    if (list.import == nullptr || !list.import->assumes_views) return;
    reporter.help_last(errors, "there is no scene, so Weft assumes that " + quote(list.base) + " has " +
                                   std::to_string(list.import->views) +
                                   " views; \"weft render\" knows their number");
}

const PortDesc* find_view_buffer(const ResolveInput& input, const ViewList& list) {
    if (list.decl.source != ViewSource::buffer) return nullptr;
    return &*input.graph.views.at(list.base).buffer;
}

std::vector<ViewListDecl> used_view_lists(const Values& values, const std::vector<PassDecl>& passes) {
    std::map<std::string, ViewListDecl> used;
    const auto add = [&](std::string list) {
        while (!used.contains(list)) {
            const auto found = values.views.find(list);
            if (found == values.views.end() || found->second.single) return;
            used[list] = found->second.decl;
            if (found->second.decl.source == ViewSource::buffer) return;
            list = found->second.decl.of;
        }
    };
    for (const PassDecl& pass : passes)
        if (pass.view != "camera") add(list_of(pass.view));
    std::vector<ViewListDecl> lists;
    for (auto& [name, list] : used) lists.push_back(std::move(list));
    return lists;
}

}  // namespace weft
