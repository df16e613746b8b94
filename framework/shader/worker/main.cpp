// weft-shader-worker MEMORY_BYTES STAGE_MS: compiles GLSL in a separate process, isolated from the program
// that starts it. The worker sets its own limits before it reads any input. It opens no file and gets all
// data through file descriptor 0. Exit codes: 0 if the connection to the caller has ended, 2 for wrong
// arguments or a wrong request, 86 if an allocation failed.
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <new>
#include <optional>
#include <string_view>

#include "shader/worker/glsl_run.h"
#include "shader/worker/protocol.h"

namespace weft::shader {
namespace {

// Largest accepted size in bytes of a message from the parent process. The worker ends if it receives a
// larger one.
constexpr uint64_t kMostFrameBytes = 1ull << 31;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
// Sanitizers reserve terabytes of address space, so the worker cannot limit its address space. The parent
// process watches the resident memory of the worker instead (WorkerProcess).
constexpr bool kCanLimitAddresses = false;
#else
constexpr bool kCanLimitAddresses = true;
#endif

struct WorkerLimits {
    uint64_t memory_bytes = 0;
    uint64_t stage_ms = 0;
};

std::optional<uint64_t> number_of(std::string_view text) {
    uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number == 0) return std::nullopt;
    return number;
}

bool set_limit(int resource, uint64_t soft, uint64_t hard) {
    const rlimit limit{static_cast<rlim_t>(soft), static_cast<rlim_t>(hard)};
    return setrlimit(static_cast<__rlimit_resource_t>(resource), &limit) == 0;
}

// Limits the processor time for the next stage. The limit is the time that the process has used so far, plus
// the time for one stage, plus 2 s, because the used time is rounded down. Only the soft limit is set,
// because a process can raise its soft limit again for the next stage, up to the hard limit.
bool limit_cpu_time(const WorkerLimits& limits) {
    rusage used{};
    rlimit limit{};
    if (getrusage(RUSAGE_SELF, &used) != 0 || getrlimit(RLIMIT_CPU, &limit) != 0) return false;
    const auto used_s = static_cast<uint64_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
    const rlim_t soft = used_s + limits.stage_ms / 1000 + 2;
    return set_limit(RLIMIT_CPU, std::min(soft, limit.rlim_max), limit.rlim_max);
}

// Restricts this process. The input may make the compiler misbehave, and this must not affect other
// processes.
bool lock_up(const WorkerLimits& limits) {
    std::set_new_handler([] { _exit(kOutOfMemoryExit); });
    const bool memory = !kCanLimitAddresses || set_limit(RLIMIT_AS, limits.memory_bytes, limits.memory_bytes);
    return memory && set_limit(RLIMIT_CORE, 0, 0) && set_limit(RLIMIT_FSIZE, 0, 0) &&
           set_limit(RLIMIT_NOFILE, 0, 0) && limit_cpu_time(limits);
}

// Reads exactly `bytes` bytes from the caller. Returns false if the caller has closed the connection.
bool receive(char* to, size_t bytes) {
    while (bytes > 0) {
        const ssize_t got = read(STDIN_FILENO, to, bytes);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        to += got;
        bytes -= static_cast<size_t>(got);
    }
    return true;
}

std::optional<Message> receive() {
    std::string header(kFrameHeaderBytes, '\0');
    if (!receive(header.data(), header.size())) return std::nullopt;
    const uint64_t bytes = payload_bytes(header);
    if (bytes > kMostFrameBytes) return std::nullopt;
    std::string payload(bytes, '\0');
    if (!receive(payload.data(), payload.size())) return std::nullopt;
    return parse_payload(payload);
}

bool send(const Message& message) {
    const std::string frame = to_frame(message);
    for (size_t at = 0; at < frame.size();) {
        const ssize_t sent = write(STDIN_FILENO, frame.data() + at, frame.size() - at);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        at += static_cast<size_t>(sent);
    }
    return true;
}

IncludeAnswer ask(const IncludeRequest& request) {
    const uint64_t number = 2 * request.depth + (request.beside ? 1 : 0);
    if (!send({MessageKind::include, number, {request.name, request.includer}})) _exit(0);
    std::optional<Message> answer = receive();
    if (!answer || answer->texts.empty()) _exit(0);
    if (answer->kind != MessageKind::source || answer->texts.size() != 2)
        return {false, {}, std::move(answer->texts[0])};
    return {true, std::move(answer->texts[0]), std::move(answer->texts[1])};
}

Message compiled(const Message& request) {
    const auto stage = static_cast<ShaderStage>(
        std::min<uint64_t>(request.number, static_cast<uint64_t>(ShaderStage::compute)));
    GlslOutcome outcome = run_glslang(stage, request.texts[0], request.texts[1], ask);
    if (!outcome.good) return {MessageKind::failed, 0, {outcome.log.substr(0, kMostLogBytes)}};
    Message answer{MessageKind::done, 0, {words_to_bytes(outcome.spirv)}};
    answer.texts.insert(answer.texts.end(), outcome.unplaced.begin(), outcome.unplaced.end());
    return answer;
}

int serve(const WorkerLimits& limits) {
    if (!send({MessageKind::hello, 0, {compiler_version()}})) return 0;
    while (const std::optional<Message> request = receive()) {
        if (request->kind != MessageKind::compile || request->texts.size() != 2) return 2;
        if (!limit_cpu_time(limits) || !send(compiled(*request))) return 0;
    }
    return 0;
}

}  // namespace
}  // namespace weft::shader

int main(int argc, char** argv) {
    using namespace weft::shader;
    if (argc != 3) {
        constexpr std::string_view kUsage =
            "weft-shader-worker compiles shaders; the program weft starts it automatically\n";
        return write(STDERR_FILENO, kUsage.data(), kUsage.size()) < 0 ? 1 : 2;
    }
    const auto memory_bytes = number_of(argv[1]);
    const auto stage_ms = number_of(argv[2]);
    if (!memory_bytes || !stage_ms || !lock_up({*memory_bytes, *stage_ms})) return 2;
    return serve({*memory_bytes, *stage_ms});
}
