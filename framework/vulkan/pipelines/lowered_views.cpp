#include "vulkan/pipelines/lowered_views.h"

#include <algorithm>
#include <map>
#include <set>

#include "vulkan/pipelines/pass_layout.h"
#include "vulkan/pipelines/spirv_module.h"

namespace weft::vk {
namespace {

// Numbers of SPIR-V capabilities and built-in variables.
constexpr uint32_t kShaderLayerCapability = 69, kMultiViewCapability = 4439;
constexpr uint32_t kLayerBuiltIn = 9, kViewIndexBuiltIn = 4440;

// Facts about a module that a rewriter needs before it changes the module.
struct Survey {
    explicit Survey(std::span<const uint32_t> module) {
        using namespace spirv;
        std::map<uint32_t, uint32_t> sets, bindings;
        for_each_instruction(module, [&](const Instruction& at) {
            if (at.opcode == kOpEntryPoint) entry = at.words[2];
            if (at.opcode == kOpDecorate && at.words[2] == kDescriptorSet) sets[at.words[1]] = at.words[3];
            if (at.opcode == kOpDecorate && at.words[2] == kBinding) bindings[at.words[1]] = at.words[3];
            if (at.opcode == kOpTypeInt && at.words[2] == 32 && at.words[3] == 0) uint = at.words[1];
            if (at.opcode == kOpTypePointer) pointees[at.words[1]] = at.words[3];
            if (at.opcode != kOpVariable || at.words[3] != kUniform) return;
            const uint32_t variable = at.words[2];
            if (!sets.contains(variable) || sets[variable] != kFrameSet || bindings[variable] != kViewBinding)
                return;
            views.insert(variable);
            blocks.insert(pointees[at.words[1]]);
        });
    }

    uint32_t entry = 0;  // The id of the function main().
    uint32_t uint = 0;   // The id of the type uint; 0: the module does not declare it.
    std::map<uint32_t, uint32_t> pointees;
    // `views`: the ids of the variables that contain the constants of the view (set 0, binding 1). `blocks`:
    // the ids of the types of these variables.
    std::set<uint32_t> views, blocks;
};

// The base class of the two rewriters below. It makes new ids, and finds the place in the module at which new
// declarations must stand.
class ViewRewriter {
 public:
    ViewRewriter(std::span<const uint32_t> module, uint32_t capability)
        : module_(module), survey_(module), bound_(module[spirv::kBoundWord]), capability_(capability) {
        uint_ = survey_.uint != 0 ? survey_.uint : new_id();
    }
    virtual ~ViewRewriter() = default;
    ViewRewriter(const ViewRewriter&) = delete;
    ViewRewriter& operator=(const ViewRewriter&) = delete;

    std::vector<uint32_t> run() {
        out_.assign(module_.begin(), module_.begin() + spirv::kHeaderWords);
        emit(spirv::kOpCapability, {capability_});
        spirv::for_each_instruction(module_, [&](const spirv::Instruction& at) { add(at); });
        out_[spirv::kBoundWord] = bound_;
        return std::move(out_);
    }

 protected:
    uint32_t new_id() { return bound_++; }
    void emit(uint32_t opcode, std::initializer_list<uint32_t> operands) {
        spirv::emit(out_, opcode, operands);
    }
    void copy(const spirv::Instruction& at) { out_.insert(out_.end(), at.words.begin(), at.words.end()); }

    // Adds the new variables to the list of variables of the entry point.
    virtual void list_variables(std::vector<uint32_t>& variables) const = 0;
    // Emits the decorations of the new declarations, then the declarations.
    virtual void declare() = 0;
    virtual void rewrite(const spirv::Instruction& at) = 0;

    std::span<const uint32_t> module_;
    Survey survey_;
    uint32_t bound_;
    uint32_t capability_;
    uint32_t uint_;
    std::vector<uint32_t> out_;

 private:
    void add(const spirv::Instruction& at) {
        if (!declared_ && spirv::ends_decorations(at.opcode)) {
            declared_ = true;
            declare();
        }
        // declare() has already declared this type, and a module must not declare it twice.
        if (at.opcode == spirv::kOpTypeInt && at.words[1] == uint_) return;
        if (at.opcode != spirv::kOpEntryPoint) return rewrite(at);
        std::vector<uint32_t> variables;
        list_variables(variables);
        const size_t start = out_.size();
        copy(at);
        out_.insert(out_.end(), variables.begin(), variables.end());
        out_[start] += static_cast<uint32_t>(variables.size()) << 16;
    }

    bool declared_ = false;
};

class MultiviewRewriter final : public ViewRewriter {
 public:
    MultiviewRewriter(std::span<const uint32_t> module, ShaderStage stage, uint32_t views)
        : ViewRewriter(module, kMultiViewCapability), stage_(stage), views_(views) {}

 private:
    void list_variables(std::vector<uint32_t>& variables) const override { variables.push_back(index_); }

    void declare() override {
        using namespace spirv;
        emit(kOpDecorate, {index_, kBuiltIn, kViewIndexBuiltIn});
        if (stage_ == ShaderStage::fragment) emit(kOpDecorate, {index_, kFlat});
        for (const uint32_t block : survey_.blocks) {
            const Array& array = arrays_[block] = {new_id(), new_id(), new_id()};
            emit(kOpDecorate, {array.type, kArrayStride, kViewStrideBytes});
            emit(kOpDecorate, {array.wrapper, kBlock});
            emit(kOpMemberDecorate, {array.wrapper, 0, kOffset, 0});
        }
        const uint32_t pointer = new_id();
        emit(kOpTypeInt, {uint_, 32, 0});
        emit(kOpConstant, {uint_, zero_, 0});
        emit(kOpConstant, {uint_, count_, views_});
        emit(kOpTypePointer, {pointer, kInput, uint_});
        emit(kOpVariable, {pointer, index_, kInput});
    }

    void rewrite(const spirv::Instruction& at) override {
        using namespace spirv;
        // The old block becomes an element of an array in a new block, so it loses its decoration Block.
        const bool is_old_block =
            at.opcode == kOpDecorate && at.words[2] == kBlock && survey_.blocks.contains(at.words[1]);
        if (is_old_block) return;
        if (at.opcode == kOpVariable && survey_.views.contains(at.words[2])) return rewrite_variable(at);
        if (is_access_chain(at.opcode) && survey_.views.contains(at.words[3])) return rewrite_access(at);
        copy(at);
    }

    void rewrite_variable(const spirv::Instruction& at) {
        using namespace spirv;
        const uint32_t block = survey_.pointees.at(at.words[1]);
        Array& array = arrays_.at(block);
        if (!array.declared) {
            emit(kOpTypeArray, {array.type, block, count_});
            emit(kOpTypeStruct, {array.wrapper, array.type});
            emit(kOpTypePointer, {array.pointer, kUniform, array.wrapper});
            array.declared = true;
        }
        emit(kOpVariable, {array.pointer, at.words[2], kUniform});
    }

    // The operands of the instruction are: type, result, variable, indices.
    void rewrite_access(const spirv::Instruction& at) {
        const uint32_t view = new_id();
        emit(spirv::kOpLoad, {uint_, view, index_});
        const std::span<const uint32_t> rest = at.words.subspan(4);
        const size_t start = out_.size();
        emit(at.opcode, {at.words[1], at.words[2], at.words[3], zero_, view});
        out_.insert(out_.end(), rest.begin(), rest.end());
        out_[start] += static_cast<uint32_t>(rest.size()) << 16;
    }

    // The new types for a block: the array of blocks, the block that contains the array, a pointer to it.
    struct Array {
        uint32_t type = 0, wrapper = 0, pointer = 0;
        bool declared = false;
    };
    ShaderStage stage_;
    uint32_t views_;
    std::map<uint32_t, Array> arrays_;
    const uint32_t index_ = new_id(), zero_ = new_id(), count_ = new_id();
};

class LayerRewriter final : public ViewRewriter {
 public:
    LayerRewriter(std::span<const uint32_t> module, uint32_t first)
        : ViewRewriter(module, kShaderLayerCapability), first_(first) {}

 private:
    void list_variables(std::vector<uint32_t>& variables) const override {
        variables.insert(variables.end(), {layer_, block_});
    }

    void declare() override {
        using namespace spirv;
        const uint32_t block_type = new_id(), block_pointer = new_id(), layer_pointer = new_id();
        emit(kOpDecorate, {layer_, kBuiltIn, kLayerBuiltIn});
        emit(kOpDecorate, {block_, kDescriptorSet, kFrameSet});
        emit(kOpDecorate, {block_, kBinding, kViewBinding});
        emit(kOpDecorate, {block_type, kBlock});
        emit(kOpMemberDecorate, {block_type, 0, kOffset, kViewNumberOffsetBytes});
        emit(kOpTypeInt, {uint_, 32, 0});
        emit(kOpConstant, {uint_, zero_, 0});
        emit(kOpConstant, {uint_, first_id_, first_});
        emit(kOpTypeStruct, {block_type, uint_});
        emit(kOpTypePointer, {block_pointer, kUniform, block_type});
        emit(kOpTypePointer, {number_pointer_, kUniform, uint_});
        emit(kOpTypePointer, {layer_pointer, kOutput, uint_});
        emit(kOpVariable, {block_pointer, block_, kUniform});
        emit(kOpVariable, {layer_pointer, layer_, kOutput});
    }

    // Writes the layer at the beginning of main(), after the variables of its first block.
    void rewrite(const spirv::Instruction& at) override {
        using namespace spirv;
        if (at.opcode == kOpFunction && at.words[2] == survey_.entry) is_in_main_ = true;
        const bool is_variable = at.opcode == kOpVariable || at.opcode == kOpLine || at.opcode == kOpNoLine;
        if (is_in_main_ && is_in_block_ && !is_variable) {
            write_layer();
            is_in_main_ = false;
        }
        if (is_in_main_ && at.opcode == kOpLabel) is_in_block_ = true;
        copy(at);
    }

    void write_layer() {
        using namespace spirv;
        const uint32_t place = new_id(), number = new_id(), layer = new_id();
        emit(kOpAccessChain, {number_pointer_, place, block_, zero_});
        emit(kOpLoad, {uint_, number, place});
        emit(kOpISub, {uint_, layer, number, first_id_});
        emit(kOpStore, {layer_, layer});
    }

    uint32_t first_;
    const uint32_t layer_ = new_id(), block_ = new_id(), number_pointer_ = new_id();
    const uint32_t zero_ = new_id(), first_id_ = new_id();
    bool is_in_main_ = false, is_in_block_ = false;
};

// Returns true if the module reads the constants of the view. A module can also declare the block with these
// constants without reading it.
bool reads_view(std::span<const uint32_t> spirv) {
    const Survey survey(spirv);
    bool reads = false;
    spirv::for_each_instruction(spirv, [&](const spirv::Instruction& at) {
        reads = reads || (spirv::is_access_chain(at.opcode) && survey.views.contains(at.words[3]));
    });
    return reads;
}

}  // namespace

bool can_select_view(std::span<const uint32_t> spirv) {
    const Survey survey(spirv);
    bool can = true;
    spirv::for_each_instruction(spirv, [&](const spirv::Instruction& at) {
        const bool takes_pointers = at.opcode == spirv::kOpLoad || at.opcode == spirv::kOpCopyMemory ||
                                    at.opcode == spirv::kOpFunctionCall || at.opcode == spirv::kOpCopyObject;
        if (!takes_pointers) return;
        can = can && std::ranges::none_of(at.words.subspan(1),
                                          [&](uint32_t id) { return survey.views.contains(id); });
    });
    return can;
}

std::vector<uint32_t> with_multiview(std::span<const uint32_t> spirv, ShaderStage stage, uint32_t views) {
    if (!reads_view(spirv)) return {spirv.begin(), spirv.end()};
    return MultiviewRewriter(spirv, stage, views).run();
}

std::vector<uint32_t> with_layer_output(std::span<const uint32_t> spirv, uint32_t first) {
    return LayerRewriter(spirv, first).run();
}

}  // namespace weft::vk
