#include "shader/compile/glsl_compile.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "graph/diagnostics/quantity_text.h"
#include "shader/compile/glsl_log.h"
#include "shader/faults/stage_name.h"

namespace weft::shader {

namespace {

IncludeAnswer refused(std::string why) {
    return {false, {}, std::move(why)};
}

// Returns the function that finds the text of an #include. The returned function runs in this process even if
// the worker program (a separate process) compiles the stage. So the same rules apply with and without a
// worker.
IncludeReader rooted_includes(SourceReader& reader, const ShaderLimits& limits) {
    return [&reader, limits, followed = uint64_t{0},
            refusal = std::pair<std::string, std::string>()](const IncludeRequest& request) mutable {
        if (request.depth > limits.include_depth)
            return refused("includes are nested more than " + std::to_string(limits.include_depth) +
                           " levels deep");
        if (followed >= limits.includes)
            return refused("the stage has more than " + std::to_string(limits.includes) + " includes");
        const SourceLookup lookup = reader.read_include(request.name, request.includer, request.beside);
        if (lookup.source == nullptr) {
            // If #include "x" finds no file, glslang asks a second time, as for #include <x>. The reason of
            // the first answer helps the user more, because it names all searched folders.
            if (lookup.refused || request.beside) refusal = {request.name, lookup.reason};
            return refused(refusal.first == request.name ? refusal.second : lookup.reason);
        }
        ++followed;
        return IncludeAnswer{true, lookup.source->name, lookup.source->text};
    };
}

// Converts the last message of the worker program to the result of a compilation. Returns nullopt if the
// message is malformed.
std::optional<GlslOutcome> outcome_of(Message answer) {
    if (answer.texts.empty()) return std::nullopt;
    if (answer.kind == MessageKind::failed) return GlslOutcome{false, {}, {}, std::move(answer.texts[0])};
    std::optional<std::vector<uint32_t>> words = bytes_to_words(answer.texts[0]);
    if (answer.kind != MessageKind::done || !words) return std::nullopt;
    return GlslOutcome{true, std::move(*words), {answer.texts.begin() + 1, answer.texts.end()}, {}};
}

}  // namespace

// Sends a stage to the worker program, which compiles it, and answers the include requests of the worker.
// Returns the last message of the worker; nullopt if the worker has stopped.
std::optional<Message> StageCompiler::converse(ShaderStage stage, const SourceText& source,
                                               const IncludeReader& includes) {
    const Message request{MessageKind::compile, static_cast<uint64_t>(stage), {source.name, source.text}};
    if (!worker_->send(request)) return std::nullopt;
    std::optional<Message> said = worker_->receive();
    for (; said && said->kind == MessageKind::include && said->texts.size() == 2; said = worker_->receive()) {
        // The number of the request is 2 × the nesting depth of the #include, plus 1 for #include "x".
        IncludeAnswer answer =
            includes({said->texts[0], said->texts[1], said->number / 2, said->number % 2 == 1});
        Message reply{MessageKind::no_source, 0, {answer.text}};
        if (answer.found) reply = {MessageKind::source, 0, {answer.name, std::move(answer.text)}};
        if (!worker_->send(reply)) return std::nullopt;
    }
    return said;
}

Result<GlslOutcome> StageCompiler::run_worker(ShaderStage stage, const SourceText& source,
                                              const IncludeReader& includes) {
    if (!worker_) {
        auto started = WorkerProcess::start(program_, limits_, compiler_version());
        if (!started) return started.take_errors();
        worker_ = std::move(*started);
    }
    const uint64_t left_ms = limits_.graph_ms - std::min(limits_.graph_ms, spent_ms_);
    const uint64_t time_ms = std::min(limits_.stage_ms, left_ms);
    const std::chrono::milliseconds before = worker_->used();
    worker_->allow(std::chrono::milliseconds(time_ms));
    std::optional<Message> answer = converse(stage, source, includes);
    spent_ms_ += static_cast<uint64_t>((worker_->used() - before).count());
    std::optional<GlslOutcome> outcome = answer ? outcome_of(std::move(*answer)) : std::nullopt;
    if (outcome) return std::move(*outcome);
    if (worker_->end() == WorkerEnd::running) worker_->kill();
    Diagnostic fault = stopped(stage, source, time_ms);
    worker_.reset();
    return fault;
}

Diagnostic StageCompiler::stopped(ShaderStage stage, const SourceText& source, uint64_t time_ms) const {
    const auto fault = [&](const std::string& what, std::string help) {
        Diagnostic d = diagnostic_at({&source, 0, 0}, "W207",
                                     std::string("compiling the ") + stage_name(stage) + " stage " + what);
        d.help.push_back(std::move(help));
        return d;
    };
    switch (worker_->end()) {
        case WorkerEnd::out_of_memory:
            return fault("needs more than " + limit_bytes_text(limits_.worker_bytes) + " of memory",
                         "look for macros that expand to two copies of themselves, " +
                             raise_limit_text("shader.workerBytes"));
        case WorkerEnd::out_of_time:
            if (time_ms < limits_.stage_ms)
                return fault("stopped: all stages of the graph together need more than " +
                                 std::to_string(limits_.graph_ms) + " ms of processor time",
                             "split the graph, " + raise_limit_text("shader.graphMs"));
            return fault("needs more than " + std::to_string(limits_.stage_ms) + " ms of processor time",
                         "look for endless loops and for macros that expand to very long text, " +
                             raise_limit_text("shader.stageMs"));
        case WorkerEnd::protocol_error:
            return fault(
                "produces no SPIR-V, or more than " + limit_bytes_text(limits_.spirv_bytes) + " of SPIR-V",
                "make the shader smaller, " + raise_limit_text("shader.spirvBytes"));
        case WorkerEnd::crashed:
        case WorkerEnd::running:
            break;
    }
    const std::string signal =
        worker_->signal() == 0 ? "" : " (signal " + std::to_string(worker_->signal()) + ")";
    return fault("crashed the compiler" + signal, "look for very deeply nested expressions, blocks or types");
}

Result<CompiledStage> StageCompiler::compile(ShaderStage stage, const SourceText& source,
                                             SourceReader& reader) {
    const IncludeReader includes = rooted_includes(reader, limits_);
    Result<GlslOutcome> outcome = program_.empty() ? run_glslang(stage, source.name, source.text, includes)
                                                   : run_worker(stage, source, includes);
    if (!outcome) return outcome.take_errors();
    if (!outcome->good) return parse_glsl_log(outcome->log, reader, source);
    return CompiledStage{stage, &source, std::move(outcome->spirv), std::move(outcome->unplaced)};
}

}  // namespace weft::shader
