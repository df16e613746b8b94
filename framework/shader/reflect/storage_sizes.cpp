// Checks the memory of a module's variables, the nesting depth of its types and calls, and the size of its
// inlined code. Examples of rejected modules: an array `float s[1 << 28]`, a chain of 50,000 function calls.
// Private memory is counted for one invocation. A function counts once for each call, because drivers inline
// calls. Sums that exceed 64 bits become UINT64_MAX.
#include <spirv.h>

#include <algorithm>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "graph/diagnostics/quantity_text.h"
#include "shader/gate/spirv_gate.h"
#include "shader/gate/spirv_words.h"

namespace weft::shader {
namespace {

constexpr uint64_t kMost = UINT64_MAX;
constexpr uint32_t kMostTypeDepth = 32;
constexpr uint32_t kMostCallDepth = 256;

uint64_t plus(uint64_t a, uint64_t b) {
    return a > kMost - b ? kMost : a + b;
}
uint64_t times(uint64_t a, uint64_t b) {
    return a != 0 && b > kMost / a ? kMost : a * b;
}

struct TypeSize {
    uint64_t bytes = 0;
    uint32_t depth = 0;        // Nesting levels of vectors, matrices, arrays and structs; 0 for a scalar.
    bool specialised = false;  // True if the length of an array in the type is a specialisation constant.
};

struct Variable {
    uint32_t id = 0;
    TypeSize size;
    uint32_t storage = 0;
};

struct Function {
    uint64_t own_bytes = 0, own_code_bytes = 0;
    std::vector<uint32_t> calls;
    // Sums over the function and all functions that it calls. A function that is called twice counts twice.
    uint64_t bytes = 0, code_bytes = 0;
    uint32_t depth = 0;  // Number of calls in the longest call chain that begins here; 0 without calls.
    enum class State : uint8_t { unseen, open, done } state = State::unseen;
};

class StorageCheck {
 public:
    StorageCheck(ShaderStage stage, const GateRules& rules, InterfaceFaults& faults)
        : stage_(stage), rules_(rules), faults_(faults) {}

    void run(std::span<const uint32_t> spirv) {
        SpirvReader reader(spirv);
        for (SpirvInstruction instruction; reader.next(instruction);) read(instruction);
        if (report_depths()) return;
        report_specialised();
        report(SpvStorageClassWorkgroup, "shared memory", shared_limit(), shared_help(),
               total(SpvStorageClassWorkgroup));
        report(SpvStorageClassPushConstant, "push constants", rules_.limits.push_constant_bytes,
               "declare the block as a uniform block, " + raise_limit_text("shader.pushConstantBytes"),
               total(SpvStorageClassPushConstant));
        const std::string fewer =
            "pass fewer variables between stages, " + raise_limit_text("shader.interfaceBytes");
        report(SpvStorageClassInput, "inputs", rules_.limits.interface_bytes, fewer,
               total(SpvStorageClassInput));
        report(SpvStorageClassOutput, "outputs", rules_.limits.interface_bytes, fewer,
               total(SpvStorageClassOutput));
        report(SpvStorageClassFunction, "private memory", rules_.limits.private_bytes,
               "make the variables smaller, store the data in a storage buffer, " +
                   raise_limit_text("shader.privateBytes"),
               plus(total(SpvStorageClassPrivate), functions_[entry_].bytes));
    }

 private:
    void read(const SpirvInstruction& i) {
        switch (i.opcode) {
            case SpvOpName:
                names_[i.operand(0)] =
                    spirv_string(i.operands.subspan(std::min<size_t>(1, i.operands.size())));
                break;
            case SpvOpConstant:
                constants_[i.operand(1)] = i.operands.size() > 3 ? kMost : i.operand(2);
                break;
            case SpvOpTypeBool:
            case SpvOpTypeInt:
            case SpvOpTypeFloat:
            case SpvOpTypeVector:
            case SpvOpTypeMatrix:
            case SpvOpTypeArray:
            case SpvOpTypeStruct:
                types_[i.operand(0)] = type_of(i);
                break;
            case SpvOpTypePointer:
                types_[i.operand(0)] = type(i.operand(2));
                break;
            case SpvOpVariable:
                variable(i);
                break;
            case SpvOpLoad:
                value(type(i.operand(0)));
                break;
            case SpvOpEntryPoint:
                entry_ = i.operand(1);
                break;
            case SpvOpFunction:
                function_ = i.operand(1);
                functions_.try_emplace(function_);
                break;
            case SpvOpFunctionCall:
                functions_[function_].calls.push_back(i.operand(2));
                break;
            default:
                break;
        }
        if (function_ != 0)
            functions_[function_].own_code_bytes += sizeof(uint32_t) * (i.operands.size() + 1);
    }

    [[nodiscard]] TypeSize type(uint32_t id) const {
        const auto found = types_.find(id);
        return found == types_.end() ? TypeSize{} : found->second;
    }

    [[nodiscard]] TypeSize type_of(const SpirvInstruction& i) {
        TypeSize size;
        switch (i.opcode) {
            case SpvOpTypeBool:
                return {4, 0, false};
            case SpvOpTypeInt:
            case SpvOpTypeFloat:
                return {std::max(i.operand(1) / 8u, 1u), 0, false};
            case SpvOpTypeVector:
            case SpvOpTypeMatrix:
                size = type(i.operand(1));
                size.bytes = times(size.bytes, i.operand(2));
                break;
            case SpvOpTypeArray: {
                size = type(i.operand(1));
                const auto length = constants_.find(i.operand(2));
                if (length == constants_.end())
                    size.specialised = true;
                else
                    size.bytes = times(size.bytes, length->second);
                break;
            }
            default:
                for (size_t member = 1; member < i.operands.size(); ++member) {
                    const TypeSize of_member = type(i.operand(member));
                    size.bytes = plus(size.bytes, of_member.bytes);
                    size.depth = std::max(size.depth, of_member.depth);
                    size.specialised = size.specialised || of_member.specialised;
                }
        }
        ++size.depth;
        deepest_type_ = std::max(deepest_type_, size.depth);
        return size;
    }

    void variable(const SpirvInstruction& i) {
        variables_.push_back({i.operand(1), type(i.operand(0)), i.operand(2)});
        if (i.operand(2) == SpvStorageClassFunction) {
            uint64_t& own = functions_[function_].own_bytes;
            own = plus(own, variables_.back().size.bytes);
        }
    }

    // Counts a large loaded value as private memory: the shader needs a temporary copy of the whole array or
    // struct.
    void value(const TypeSize& size) {
        constexpr uint64_t kMostInRegisters = 64;  // Size of a mat4, in bytes.
        if (size.bytes <= kMostInRegisters) return;
        uint64_t& own = functions_[function_].own_bytes;
        own = plus(own, size.bytes);
    }

    // Adds up the memory and code size of all functions that the entry point calls, directly or indirectly.
    // The traversal uses its own stack instead of recursion, because the call chain of a module can have any
    // length.
    void add_up_calls() {
        std::vector<std::pair<uint32_t, size_t>> open{{entry_, 0}};
        while (!open.empty()) {
            auto& [id, next] = open.back();
            Function& function = functions_[id];
            if (next == 0) {
                function.state = Function::State::open;
                function.bytes = function.own_bytes;
                function.code_bytes = function.own_code_bytes;
            }
            if (next < function.calls.size()) {
                const uint32_t callee = function.calls[next];
                const Function& called = functions_[callee];
                if (called.state == Function::State::unseen) {
                    open.emplace_back(callee, 0);
                    continue;
                }
                ++next;
                function.bytes = plus(function.bytes, called.bytes);
                function.code_bytes = plus(function.code_bytes, called.code_bytes);
                function.depth = std::max(function.depth, called.depth + 1);
                continue;
            }
            function.state = Function::State::done;
            open.pop_back();
        }
    }

    [[nodiscard]] bool report_depths() {
        add_up_calls();
        const size_t before = faults_.size();
        if (deepest_type_ > kMostTypeDepth)
            fault({},
                  "the stage nests types " + std::to_string(deepest_type_) + " levels deep, the limit is " +
                      std::to_string(kMostTypeDepth),
                  "use fewer dimensions of arrays and fewer structs within structs");
        if (functions_[entry_].depth > kMostCallDepth)
            fault({},
                  "the stage calls functions " + std::to_string(functions_[entry_].depth) +
                      " levels deep, the limit is " + std::to_string(kMostCallDepth),
                  "replace nested calls by a loop");
        if (functions_[entry_].code_bytes > rules_.limits.inlined_bytes)
            fault({},
                  "the stage has more than " + limit_bytes_text(rules_.limits.inlined_bytes) +
                      " of SPIR-V after a driver has inlined all calls",
                  "call each long function at only one place, in a loop, " +
                      raise_limit_text("shader.inlinedBytes"));
        return faults_.size() > before;
    }

    void report_specialised() {
        constexpr uint32_t kSized[] = {SpvStorageClassWorkgroup, SpvStorageClassPrivate,
                                       SpvStorageClassFunction,  SpvStorageClassPushConstant,
                                       SpvStorageClassInput,     SpvStorageClassOutput};
        for (const Variable& variable : variables_) {
            if (!variable.size.specialised || std::ranges::find(kSized, variable.storage) == std::end(kSized))
                continue;
            const std::string name = names_[variable.id];
            fault(name,
                  "the size of the array \"" + name +
                      "\" depends on a specialisation constant; wanted a number",
                  "write the largest size as a number, and use the constant as the bound of the loop over "
                  "the array");
        }
    }

    [[nodiscard]] uint64_t total(uint32_t storage) const {
        uint64_t bytes = 0;
        for (const Variable& variable : variables_)
            if (variable.storage == storage) bytes = plus(bytes, variable.size.bytes);
        return bytes;
    }

    [[nodiscard]] uint64_t shared_limit() const {
        return std::min(rules_.limits.shared_bytes, rules_.target.max_shared_bytes);
    }
    [[nodiscard]] std::string shared_help() const {
        const bool by_device = rules_.target.max_shared_bytes <= rules_.limits.shared_bytes;
        return by_device ? "make the variables smaller, or store the data in a storage buffer; the limit is "
                           "that of the device"
                         : "make the variables smaller, store the data in a storage buffer, " +
                               raise_limit_text("shader.sharedBytes");
    }

    // Reports an error if `bytes`, the memory of a storage class, exceeds `limit`. The error names the
    // largest variable. The memory of class Function includes the variables of class Private.
    void report(uint32_t storage, const std::string& what, uint64_t limit, std::string help, uint64_t bytes) {
        if (bytes <= limit) return;
        const Variable* largest = nullptr;
        for (const Variable& variable : variables_) {
            const bool counts = variable.storage == storage || (storage == SpvStorageClassFunction &&
                                                                variable.storage == SpvStorageClassPrivate);
            if (counts && (largest == nullptr || variable.size.bytes > largest->size.bytes))
                largest = &variable;
        }
        const std::string name = largest == nullptr ? "" : names_[largest->id];
        const std::string most_of_it =
            name.empty() ? "" : " (\"" + name + "\" alone has " + limit_bytes_text(largest->size.bytes) + ")";
        fault(name,
              "the stage has " + limit_bytes_text(bytes) + " of " + what + most_of_it + ", the limit is " +
                  limit_bytes_text(limit),
              std::move(help));
    }

    void fault(std::string subject, std::string message, std::string help) {
        faults_.push_back({"W209", stage_, std::move(subject), std::move(message), std::move(help)});
    }

    ShaderStage stage_;
    const GateRules& rules_;
    InterfaceFaults& faults_;
    std::unordered_map<uint32_t, std::string> names_;
    std::unordered_map<uint32_t, uint64_t> constants_;
    std::unordered_map<uint32_t, TypeSize> types_;
    std::unordered_map<uint32_t, Function> functions_;
    std::vector<Variable> variables_;
    uint32_t entry_ = 0;
    uint32_t function_ = 0;
    uint32_t deepest_type_ = 0;
};

}  // namespace

void storage_faults(ShaderStage stage, std::span<const uint32_t> spirv, const GateRules& rules,
                    InterfaceFaults& faults) {
    StorageCheck(stage, rules, faults).run(spirv);
}

}  // namespace weft::shader
