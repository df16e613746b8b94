#include "graph/resolve/fill_blocks.h"

#include <algorithm>
#include <array>

#include "graph/diagnostics/quantity_text.h"
#include "graph/live/live_frame.h"

#include "graph/resolve/fault_text.h"
#include "graph/resolve/fill/member_value.h"
#include "graph/resolve/pass_ports.h"
#include "graph/resolve/pass_stage.h"

namespace weft {
namespace {

struct BuiltinName {
    std::string_view name;
    Builtin builtin;
};
constexpr std::array kBuiltins{
    BuiltinName{"deltaTime", Builtin::delta_time_s},
    BuiltinName{"frameIndex", Builtin::frame_index},
    BuiltinName{"preExposure", Builtin::pre_exposure},
    BuiltinName{"prevPreExposure", Builtin::prev_pre_exposure},
    BuiltinName{"time", Builtin::time_s},
};
constexpr std::string_view kSizeSuffix = "Size";
constexpr std::string_view kUvSuffix = "Uv";
constexpr std::string_view kUvMostSuffix = "UvMost";
constexpr std::string_view kValidSuffix = "Valid";
constexpr std::string_view kBitsSuffix = "ValidBits";
constexpr std::string_view kCountSuffix = "Count";
constexpr uint32_t kLayersPerWord = 32;

class BlockFiller : PassStage<Blocks> {
 public:
    // Fills the block with the values that apply in the given combination of switch values.
    BlockFiller(const Declared& declared, const VersionedGraph& graph, PassId pass, Combination combination,
                Blocks& blocks, Reporter& reporter)
        : PassStage(declared, graph, pass, blocks, reporter), combination_(combination) {}

    void run() {
        report_params_without_member();
        if (!draft_.shader->has_params) return;
        const ParamsBlock& block = draft_.shader->params;
        result_.bytes = block.size_bytes;
        result_.push_constants = block.push_constants;
        const uint32_t limit = declared_.input.profile.max_push_constants_bytes;
        if (block.push_constants && block.size_bytes > limit) {
            Diagnostic& d =
                report(shader_loc(), "W178",
                       "Params of shader " + quote(draft_.desc->shader) + " has " +
                           std::to_string(block.size_bytes) +
                           " bytes; the device allows push constants of at most " + std::to_string(limit));
            add_help(d, "declare the block as a uniform block: `uniform Params { … };`");
        }
        for (const BlockMember& member : block.members) write_member(member);
    }

 private:
    SourceLoc shader_loc() const {
        return draft_.desc->shader_loc.line != 0 ? draft_.desc->shader_loc : draft_.desc->loc;
    }

    void error(SourceLoc loc, const std::string& message, const std::vector<std::string>& help) {
        Diagnostic& d = report(loc, "W113", message);
        for (const std::string& line : help) add_help(d, line);
    }

    void report_params_without_member() {
        std::vector<std::string> members;
        for (const BlockMember& member : draft_.shader->params.members) members.push_back(member.name);
        for (const ParamValueDesc& param : draft_.desc->params) {
            if (std::ranges::find(members, param.name) != members.end()) continue;
            const std::string known = members.empty() ? "the shader has no block named Params"
                                                      : std::string("the block Params has the ") +
                                                            (members.size() == 1 ? "member " : "members ") +
                                                            quote_all(members);
            error(param.loc,
                  "Params of shader " + quote(draft_.desc->shader) + " has no member " + quote(param.name),
                  {did_you_mean_text(param.name, members), known});
        }
    }

    void write_member(const BlockMember& member) {
        if (member.columns != 1 || member.array_count != 0 || member.is_runtime_array ||
            !member.struct_name.empty()) {
            error(shader_loc(),
                  "Params." + member.name + " of shader " + quote(draft_.desc->shader) +
                      " is not a number or a vector",
                  {"pass arrays, matrices and structs in a buffer"});
            return;
        }
        ParamWrite write;
        write.member = member.name;
        write.offset_bytes = member.offset_bytes;
        write.scalar = member.scalar;
        write.components = member.rows;
        if (from_author(member, write) || from_builtin(member, write)) return;
        report_unknown(member);
    }

    // Gives the member the value that the author states. Returns false if the author states no value. Returns
    // true for a known name even if its value has an error, which is reported.
    bool from_author(const BlockMember& member, ParamWrite& write) {
        const std::optional<MemberValue> value = member_value(declared_, draft_, evaluator_, member.name);
        if (!value) return false;
        if (!value->components.empty())
            store(member, write, value->components, value->param ? value->param->loc : shader_loc());
        return true;
    }

    bool from_builtin(const BlockMember& member, ParamWrite& write) {
        const auto* builtin = std::ranges::find(kBuiltins, std::string_view(member.name), &BuiltinName::name);
        if (builtin != kBuiltins.end()) {
            write.builtin = builtin->builtin;
            store(member, write, {0}, shader_loc());
            return true;
        }
        return from_port_size(member, write) || from_port_uv(member, write) ||
               from_port_valid(member, write) || from_port_bits(member, write) ||
               from_port_count(member, write);
    }

    // Returns the use of the port whose name and `suffix` form `name`, for example port "hdr" for "hdrSize".
    // Null if there is no such port.
    const UseDecl* port_before(std::string_view name, std::string_view suffix) const {
        if (!name.ends_with(suffix)) return nullptr;
        name.remove_suffix(suffix.size());
        const auto use = std::ranges::find_if(bound_.uses, [&](const UseDecl& u) {
            return u.port == name && has_combination(u.used_in, combination_);
        });
        return use == bound_.uses.end() ? nullptr : &*use;
    }

    // Returns true if the name belongs to an optional port that has no resource. The block still contains the
    // member, so the member gets the value 0. The shader does not use this value.
    bool stands_for_absent(std::string_view name, std::string_view suffix) const {
        if (!name.ends_with(suffix)) return false;
        name.remove_suffix(suffix.size());
        if (std::ranges::find(bound_.absent, name) != bound_.absent.end()) return true;
        const auto is_port = [&](const UseDecl& u) { return u.port == name; };
        const auto is_used = [&](const UseDecl& u) {
            return is_port(u) && has_combination(u.used_in, combination_);
        };
        if (std::ranges::none_of(bound_.uses, is_port)) return may_omit(name);
        return std::ranges::none_of(bound_.uses, is_used);
    }

    // Returns true if the shader has the constant HAS_<port>, so that a pass may omit the port.
    bool may_omit(std::string_view port) const {
        return std::ranges::any_of(draft_.shader->spec_constants, [&](const SpecConstant& constant) {
            return constant.type == ScalarType::boolean && constant.name == "HAS_" + std::string(port);
        });
    }

    // Fills a member such as "colorValid". It is 1 if a frame has written the content that the port "color"
    // reads. It is 0 in three cases: the port reads content of an earlier frame that no frame has written
    // yet, or the pass that writes the content is switched off, or the port is optional and has no resource.
    bool from_port_valid(const BlockMember& member, ParamWrite& write) {
        if (stands_for_absent(member.name, kValidSuffix)) {
            store(member, write, {0}, shader_loc());
            return true;
        }
        const UseDecl* use = port_before(member.name, kValidSuffix);
        if (!use) return suspects_.passes[pass_] && member.name.ends_with(kValidSuffix);
        const auto index = static_cast<size_t>(use - bound_.uses.data());
        if (!has_combination(bound_.ports[index].valid_in, combination_)) {
            store(member, write, {0}, shader_loc());
            return true;
        }
        if (use->history > 0) {
            write.builtin = Builtin::valid;
            write.resource = use->resource;
        } else if (is_written_by_units(*use)) {
            write.builtin = Builtin::unit_valid;
            write.use = static_cast<uint32_t>(use - bound_.uses.data());
        }
        store(member, write, {write.builtin != Builtin::none ? 0.0 : 1.0}, shader_loc());
        return true;
    }

    // Returns true if a pass with "rest", or a pass of a group, writes a part of the range that the port
    // reads.
    bool is_written_by_units(const UseDecl& use) const {
        for (PassId pass(0); pass < graph_.rest_units.size(); ++pass)
            for (const UseDecl& other : graph_.passes[pass].uses)
                if (graph_.rest_units[pass] != kNoId && writes(other.access) &&
                    other.resource == use.resource && overlaps(other.range, use.range))
                    return true;
        return false;
    }

    // Fills a member such as "probesValidBits": one bit for each layer of the port "probes". If passes with
    // "rest" or passes of a group write a layer, its bit is 1 only if all these passes have run since the
    // resource was made or cleared. If no such pass writes the layer, its bit is always 1.
    bool from_port_bits(const BlockMember& member, ParamWrite& write) {
        const std::vector<double> none(member.rows, 0);
        if (stands_for_absent(member.name, kBitsSuffix)) {
            store(member, write, none, shader_loc());
            return true;
        }
        const UseDecl* use = port_before(member.name, kBitsSuffix);
        if (!use) return suspects_.passes[pass_] && member.name.ends_with(kBitsSuffix);
        const uint32_t layers = use->range.layers;
        if (member.scalar != ScalarType::u32 || layers > kLayersPerWord * member.rows) {
            const uint32_t words = (layers + kLayersPerWord - 1) / kLayersPerWord;
            error(shader_loc(),
                  "Params." + member.name + " of shader " + quote(draft_.desc->shader) +
                      " must have one bit for each of the " +
                      count_text(layers, graph_.resources[use->resource].kind == ResourceKind::image
                                             ? "layer"
                                             : "piece") +
                      " of port " + quote(use->port),
                  {words > 4 ? "select at most 128 layers or pieces in the reference of the port"
                             : "declare it as `" + (words == 1 ? "uint" : "uvec" + std::to_string(words)) +
                                   " " + member.name + ";`"});
            return true;
        }
        write.builtin = Builtin::unit_bits;
        write.use = static_cast<uint32_t>(use - bound_.uses.data());
        store(member, write, none, shader_loc());
        return true;
    }

    // Returns the number of textures of a table; 0 if the port is no table.
    uint32_t table_size(const UseDecl& use) const { return graph_.resources[use.resource].textures; }

    // Fills a member such as "levelsCount": how many elements of the array "levels" the port fills.
    bool from_port_count(const BlockMember& member, ParamWrite& write) {
        if (stands_for_absent(member.name, kCountSuffix)) {
            store(member, write, {0}, shader_loc());
            return true;
        }
        const UseDecl* use = port_before(member.name, kCountSuffix);
        if (use && table_size(*use) > 0) {
            store(member, write, {double(table_size(*use))}, shader_loc());
            return true;
        }
        if (!use || use->each == EachPart::none)
            return suspects_.passes[pass_] && member.name.ends_with(kCountSuffix);
        store(member, write, {double(element_count(*use))}, shader_loc());
        return true;
    }

    bool from_port_size(const BlockMember& member, ParamWrite& write) {
        if (!member.name.ends_with(kSizeSuffix)) return false;
        if (stands_for_absent(member.name, kSizeSuffix)) {
            store(member, write, {0, 0}, shader_loc());
            return true;
        }
        const UseDecl* use = port_before(member.name, kSizeSuffix);
        if (!use || graph_.resources[use->resource].kind == ResourceKind::buffer || table_size(*use) > 0) {
            // In a pass with an error, the port may be missing because of that error, so a second message
            // about the member would not help.
            return suspects_.passes[pass_];
        }
        const Extent3D extent = use_extent(graph_.resources, *use);
        store(member, write, {double(extent.width), double(extent.height)}, shader_loc());
        return true;
    }

    // Fills a member such as "colorUv" or "colorUvMost" for an image in which the used area is the whole
    // image. For an image with a live size (a size that is multiplied by a scale), follow_areas() replaces
    // the value later.
    bool from_port_uv(const BlockMember& member, ParamWrite& write) {
        for (const std::string_view suffix : {kUvSuffix, kUvMostSuffix}) {
            if (!member.name.ends_with(suffix)) continue;
            if (stands_for_absent(member.name, suffix)) {
                store(member, write, {1, 1}, shader_loc());
                return true;
            }
            const UseDecl* use = port_before(member.name, suffix);
            if (!use || graph_.resources[use->resource].kind == ResourceKind::buffer)
                return suspects_.passes[pass_];
            const Extent3D extent = use_extent(graph_.resources, *use);
            const double edge = suffix == kUvSuffix ? 0 : kFilterMargin_px;
            store(member, write,
                  {(extent.width - edge) / extent.width, (extent.height - edge) / extent.height},
                  shader_loc());
            return true;
        }
        return false;
    }

    void store(const BlockMember& member, ParamWrite& write, const std::vector<double>& values,
               SourceLoc loc) {
        if (values.size() != member.rows) {
            error(loc,
                  "Params." + member.name + " of shader " + quote(draft_.desc->shader) + " has " +
                      count_text(member.rows, "component") + ", but its value has " +
                      std::to_string(values.size()),
                  {member.rows == 1
                       ? "write one number in \"params\""
                       : "write an array of " + std::to_string(member.rows) + " numbers in \"params\""});
            return;
        }
        const bool fits =
            std::ranges::all_of(values, [&](double v) { return fits_member(member.scalar, v); });
        if (!fits) {
            error(loc,
                  "Params." + member.name + " of shader " + quote(draft_.desc->shader) +
                      " cannot contain this value",
                  {member.scalar == ScalarType::f32
                       ? "use a magnitude of at most 3.4e38, the limit of single precision"
                       : "use a whole number from -2147483648 to 4294967295"});
            return;
        }
        std::ranges::copy(values, write.value.begin());
        result_.params.push_back(write);
    }

    // If the name of a member ends like the name of a value of a port, for example "pictureUv", but the pass
    // has no such port, returns a help text. Else returns an empty text.
    std::string port_help(const std::string& member) const {
        for (const std::string_view suffix :
             {kUvMostSuffix, kUvSuffix, kSizeSuffix, kBitsSuffix, kValidSuffix, kCountSuffix}) {
            if (!member.ends_with(suffix) || member.size() == suffix.size()) continue;
            const std::string port = member.substr(0, member.size() - suffix.size());
            std::vector<std::string> ports;
            for (const UseDecl& use : bound_.uses)
                if (std::ranges::find(ports, use.port) == ports.end()) ports.push_back(use.port);
            if (ports.empty() || std::ranges::find(ports, port) != ports.end()) return {};
            return "Weft sets " + member + " if the pass has a port " + quote(port) + "; its ports are " +
                   quote_all(ports);
        }
        return {};
    }

    void report_unknown(const BlockMember& member) {
        std::vector<std::string> known;
        for (const auto& [name, unused] : declared_.input.graph.params) known.push_back(name);
        for (const auto& [name, unused] : declared_.input.graph.consts) known.push_back(name);
        for (const auto& [name, unused] : draft_.indices) known.push_back(name);
        for (const BuiltinName& builtin : kBuiltins) known.emplace_back(builtin.name);
        for (const UseDecl& use : bound_.uses) {
            if (graph_.resources[use.resource].kind == ResourceKind::image && table_size(use) == 0)
                for (const std::string_view suffix : {kSizeSuffix, kUvSuffix, kUvMostSuffix})
                    known.push_back(use.port + std::string(suffix));
            known.push_back(use.port + "Valid");
            known.push_back(use.port + "ValidBits");
            if (use.each != EachPart::none || table_size(use) > 0) known.push_back(use.port + "Count");
        }
        std::string zeros = "0";
        for (uint32_t row = 1; row < member.rows; ++row) zeros += ", 0";
        if (member.rows > 1) zeros = "[" + zeros + "]";
        error(shader_loc(),
              "pass " + quote(draft_.decl.name) + " gives no value to Params." + member.name + " of shader " +
                  quote(draft_.desc->shader),
              {did_you_mean_text(member.name, known), port_help(member.name),
               "set the value in the pass: \"params\": { " + quote(member.name) + ": " + zeros + " }"});
    }

    Combination combination_;
};

}  // namespace

Blocks fill_blocks(const Declared& declared, const VersionedGraph& graph, Suspects suspects,
                   Reporter& reporter) {
    Blocks blocks{.passes = std::vector<PassBlock>(graph.passes.size()), .suspects = std::move(suspects)};
    for (PassId pass(0); pass < graph.passes.size(); ++pass) {
        if (declared.expansion.passes[pass].shader)
            BlockFiller(declared, graph, pass, kAllSwitchesOn, blocks, reporter).run();
    }
    return blocks;
}

std::vector<ParamWrite> fill_block(const Declared& declared, const VersionedGraph& graph, PassId pass,
                                   Combination combination, Reporter& reporter) {
    Blocks blocks{.passes = std::vector<PassBlock>(graph.passes.size()), .suspects = graph.suspects};
    BlockFiller(declared, graph, pass, combination, blocks, reporter).run();
    return std::move(blocks.passes[pass].params);
}

}  // namespace weft
