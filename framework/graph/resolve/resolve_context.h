// Purpose: what the steps of resolve() share while one graph is being resolved. Private to resolve_*.cpp.
// A step reports every fault it meets and goes on. What a fault makes unknowable is marked suspect, and later
// steps keep quiet about suspects: one cause, one message.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "graph/diagnostics/quantity_text.h"
#include "graph/parse/expression.h"
#include "graph/resolve/resolve.h"

namespace weft {

// How a write treats what was there before.
enum class WriteRank : uint8_t {
    fresh,     // makes a new version: nothing of the old content is seen
    resumes,   // goes on with a preceding version if this frame has one (a loaded attachment, a read-write
               // buffer)
    in_place,  // changes the preceding version
};

// What resolve() knows about a use beyond its UseDecl. Parallel to PassDecl::uses.
struct PortWork {
    const PortDesc* desc = nullptr;
    const ShaderBinding* binding = nullptr;       // in set 1
    const StageVariable* color_output = nullptr;  // colour attachments
    std::vector<PassId> pins;  // `@pass`: all passes of that name, in the order of their repeat
    WriteRank rank = WriteRank::fresh;
    bool is_depth_port = false;
    bool is_resolve = false;      // gets the averages of a multisampled attachment
    bool is_indirect = false;     // holds the size of the dispatch
    bool reads_own_port = false;  // "in" and "out" both name this port: one binding, in place
    bool is_reported = false;     // what it reads is wrong in itself

    [[nodiscard]] bool pinned() const { return !pins.empty(); }
};

struct PassWork {
    const PassDesc* desc = nullptr;
    std::map<std::string, double> indices = {};  // of its repeat
    uint32_t instance = 0;                       // which one of its repeat, in order
    const ShaderInterface* shader = nullptr;
    const PassType* custom = nullptr;
    std::vector<PortWork> ports = {};
    std::vector<std::string> absent = {};  // optional ports that are bound to nothing
    bool faulty = false;                   // reported already; some of its uses may be missing
};

struct ResourceWork {
    const ResourceDesc* desc = nullptr;  // null for imports
    bool has_content = false;            // something was there before the frame: imports, history, keep
    bool suspect_shape = false;          // extent, mips or format are unknown because of a fault
    bool suspect_writers = false;        // a faulty pass may write it
};

// Parameters, constants, sizes and the mip counts found so far.
class ResolveNames final : public ExprNames {
 public:
    std::map<std::string, ExprValue> values;
    std::map<std::string, uint32_t> mip_counts;
    const std::map<std::string, double>* indices = nullptr;  // of the pass at hand; see IndexScope

    [[nodiscard]] std::optional<ExprValue> value(const std::string& name) const override;
    [[nodiscard]] std::optional<uint32_t> mips(const std::string& resource) const override;
    [[nodiscard]] std::vector<std::string> known_names() const override;
    [[nodiscard]] std::vector<std::string> known_resources() const override;
};

// Thrown where going on would say nothing more; resolve() catches both. So that no graph, however large and
// faulty, keeps a step busy for long.
struct TooManyErrors {};
struct StepsUsedUp {
    SourceLoc loc;
};

struct ResolveState {
    static constexpr size_t kMostErrors = 100;
    static constexpr size_t kMostWarnings = 100;

    const ResolveInput& input;
    Diagnostics& warnings;
    Diagnostics errors = {};
    ResolvedGraph graph = {};
    ResolveNames names = {};
    std::set<std::string, std::less<>> faulty_values = {};  // params and sizes already reported
    std::map<std::string, uint32_t> histories = {};         // of resources that keep earlier frames, by name
    std::set<std::string> suspect_histories = {};           // reported
    std::vector<ResourceWork> resources = {};               // by ResourceId
    std::vector<PassWork> passes = {};                      // by PassId
    std::map<std::string, PassDesc> observers = {};
    uint64_t repeat_steps = 0;  // of all passes so far
    uint64_t tried_passes = 0;  // those that `if` leaves out are counted too
    uint64_t tried_ports = 0;
    bool over_limit = false;  // reported already
    size_t hidden_warnings = 0;
    mutable uint64_t steps = 0;                                // see spend()
    std::map<std::string, bool, std::less<>> is_written = {};  // written_by_any_pass() so far
    // By the name that the author gave: a repeat makes several passes, or none.
    std::map<std::string, std::vector<PassId>, std::less<>> instances = {};
    std::map<std::string, const PassDesc*, std::less<>> dropped = {};  // left out by `if` or an empty repeat
    std::set<std::string, std::less<>> faulty_passes = {};             // reported: nobody knows if they run
    bool repeats_itself = false;  // a pass that is no repeat's first: its first one found the same faults
    Diagnostic muted = {};

    // Throws TooManyErrors beyond the most.
    Diagnostic& error(SourceLoc loc, std::string code, std::string message);
    // The same for a fault that was found elsewhere.
    Diagnostic& add_error(Diagnostic fault);
    // Work whose amount the file decides is counted before it is done: a step is about 100 ns or 32 bytes.
    // Throws StepsUsedUp beyond graph.steps.
    void spend(uint64_t count, SourceLoc loc) const;
    // The part of graph.steps that this tier may use.
    [[nodiscard]] uint64_t most_steps() const;
    // The same, and the pass is faulty from now on.
    Diagnostic& pass_error(PassId pass, SourceLoc loc, std::string code, std::string message);
    // The same fault at the same place was reported.
    [[nodiscard]] bool is_known(const Diagnostic& fault) const;
    // In a file that another one includes: it may offer what this graph has no use for.
    [[nodiscard]] bool is_included(SourceLoc loc) const;
    void warn(SourceLoc loc, std::string code, std::string message, std::string help);
    // Reports and returns nullopt when the expression is wrong; quiet when it only names what was reported
    // already.
    std::optional<ExprValue> evaluate_here(const Expr& expression);

    // A number within bounds; nullopt: reported. `what` names it: "the history of \"color\"".
    std::optional<double> number_here(const Expr& expression, const std::string& what, double least,
                                      double most, bool whole = true);
    // What is wrong with it is reported, and 0.
    std::array<float, 4> color_here(const ColorDesc& color);

    [[nodiscard]] ResourceId resource_id(std::string_view name) const;  // kNoId: none
    [[nodiscard]] std::vector<std::string> resource_names() const;
    [[nodiscard]] std::vector<std::string> pass_names() const;  // without observers
    [[nodiscard]] const std::string& author_name(PassId pass) const { return passes[pass].desc->name; }
    [[nodiscard]] const std::string& pass_name(PassId pass) const { return graph.passes[pass].name; }
    [[nodiscard]] const std::string& resource_name(ResourceId r) const { return graph.resources[r].name; }
};

// While it lives, expressions know the indices of a pass's repeat.
class IndexScope {
 public:
    IndexScope(ResolveState& state, PassId pass) : state_(state) {
        state.names.indices = &state.passes[pass].indices;
        state.repeats_itself = state.passes[pass].instance > 0;
    }
    ~IndexScope() {
        state_.names.indices = nullptr;
        state_.repeats_itself = false;
    }
    IndexScope(const IndexScope&) = delete;
    IndexScope& operator=(const IndexScope&) = delete;

 private:
    ResolveState& state_;
};

// A range as its author would write it: only what is less than the whole resource.
[[nodiscard]] std::string range_of(const ResourceDecl& resource, const SubresourceRange& range);
[[nodiscard]] std::string quoted(std::string_view name);
// "a", "b", "c"; of a long list the first ones
[[nodiscard]] std::string joined(const std::vector<std::string>& names);
[[nodiscard]] std::string extent_text(const Extent3D& extent);
[[nodiscard]] Extent3D use_extent(const ResolveState& state, const UseDecl& use);
// "" holds for every output that has no state of its own.
[[nodiscard]] BlendState blend_of(const PassDesc& desc, const std::string& port);
[[nodiscard]] bool has_shader(PassKind kind);
// Outputs, depth attachment and resolve targets.
[[nodiscard]] std::vector<const PortDesc*> written_ports(const PassDesc& desc);
void add_help(Diagnostic& diagnostic, std::string help);  // unless empty

// --- the steps, in order
// ---------------------------------------------------------------------------------------
void resolve_values(ResolveState& state);
void resolve_resources(ResolveState& state);  // imports too
// Adds one resource; both kinds go through the name table in the order of their names.
void resolve_import(ResolveState& state, const ImportDesc& desc, ResourceDecl& decl, ResourceWork& work);
void check_draw_list_imports(ResolveState& state);
// All roles of a ring get what its role of age 0 has: shape, format, usage.
void spread_over_rings(ResolveState& state);
[[nodiscard]] std::string role_name(const std::string& name, uint32_t age);
// The role that a reference to `resource` means; kNoId: reported.
[[nodiscard]] ResourceId find_role(ResolveState& state, PassId pass, const RefDesc& ref, ResourceId resource,
                                   bool is_output);
void declare_passes(ResolveState& state);
void set_state(ResolveState& state, PassId pass);    // the fixed-function one
void check_state(ResolveState& state, PassId pass);  // against what the device can do
// The passes that one description stands for: none when `if` is false.
struct PassInstance {
    std::string name;
    std::map<std::string, double> indices;
};
[[nodiscard]] std::vector<PassInstance> pass_instances(ResolveState& state, const PassDesc& desc);
void bind_ports(ResolveState& state);
// Those of the pins whose versions a pass may see: of its own repeat only the earlier ones.
[[nodiscard]] std::span<const PassId> visible_pins(const PortWork& port, PassId pass);
// What a port means to the shader or pass type behind it; false: reported.
void bind_shader_pass(ResolveState& state, PassId pass);
void bind_fixed_pass(ResolveState& state, PassId pass);  // clear, copy, readback
void bind_custom_pass(ResolveState& state, PassId pass);
void set_constants(ResolveState& state, PassId pass);  // specialisation constants
void check_draws(ResolveState& state, PassId pass);
// What a shader needs of the pass beyond ports and parameters: bound descriptor sets, sizes of points.
void check_shader_fits(ResolveState& state, PassId pass);
void resolve_view(ResolveState& state, PassId pass);
void choose_formats(ResolveState& state);
void check_interfaces(ResolveState& state);
void resolve_versions(ResolveState& state);
void resolve_attachments(ResolveState& state);
void check_clear_values(ResolveState& state);  // against the formats of what they clear
void check_output(ResolveState& state);        // somebody writes it
void resolve_dispatches(ResolveState& state);
void resolve_blocks(ResolveState& state);
void check_custom_passes(ResolveState& state);
void weigh_plan(ResolveState& state);   // what compiling and proving will cost is within graph.steps
void check_turns(ResolveState& state);  // of passes spread over frames
void warn_unused(ResolveState& state);
// Those that debug views show and tests look at, by name.
[[nodiscard]] std::set<std::string, std::less<>> watched_resources(const GraphDesc& graph);
void weigh_params(ResolveState& state);  // what it costs to change them
void warn_useless(ResolveState& state);  // of what is done for nothing; the passes' sources are known

}  // namespace weft
