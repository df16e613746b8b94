#include "shader/worker/worker_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace weft::shader {
namespace {

constexpr std::chrono::milliseconds kWatchEvery{20};
// Beside the SPIR-V: names of variables, and frames of requests.
constexpr uint64_t kFrameSlackBytes = 1 << 20;

Diagnostic cannot_start(const std::filesystem::path& program, const std::string& why) {
    Diagnostic d;
    d.code = "X570";
    d.message = "the shader compiler \"" + program.string() + "\" can't be started: " + why;
    d.help = {
        "it is a program of its own, weft-shader-worker, and belongs beside weft: build or install it again"};
    return d;
}

// 0, or the error. Everything but descriptors 0 to 2 is closed, and of those only 0 leads anywhere.
int spawn(const std::filesystem::path& program, const ShaderLimits& limits, int socket, pid_t& pid) {
    posix_spawn_file_actions_t actions;
    if (const int error = posix_spawn_file_actions_init(&actions); error != 0) return error;
    posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);

    // The caller's ignored or blocked signals are its own affair.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

    std::array<std::string, 3> words{program.string(), std::to_string(limits.worker_bytes),
                                     std::to_string(limits.stage_ms)};
    std::array<char*, 4> arguments{words[0].data(), words[1].data(), words[2].data(), nullptr};
    std::array<char*, 1> environment{nullptr};
    const int error =
        posix_spawn(&pid, words[0].c_str(), &actions, &attributes, arguments.data(), environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return error;
}

}  // namespace

Result<std::unique_ptr<WorkerProcess>> WorkerProcess::start(const std::filesystem::path& program,
                                                            const ShaderLimits& limits,
                                                            const std::string& version) {
    std::array<int, 2> sockets{-1, -1};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0)
        return cannot_start(program, std::strerror(errno));
    pid_t pid = -1;
    const int error = spawn(program, limits, sockets[1], pid);
    close(sockets[1]);
    if (error != 0) {
        close(sockets[0]);
        return cannot_start(program, std::strerror(error));
    }
    std::unique_ptr<WorkerProcess> worker(new WorkerProcess(pid, sockets[0], limits));
    const auto deadline = WorkerClock::now() + std::chrono::milliseconds(limits.stage_ms);
    const std::optional<Message> hello = worker->receive(deadline);
    if (!hello || hello->kind != MessageKind::hello || hello->texts.size() != 1)
        return cannot_start(program, "it says nothing; shader.workerBytes may be too small for it");
    if (hello->texts[0] != version)
        return cannot_start(
            program, "it is of another version: \"" + hello->texts[0] + "\", wanted \"" + version + "\"");
    return worker;
}

WorkerProcess::~WorkerProcess() {
    kill_for(WorkerEnd::running);
}

void WorkerProcess::give_up_on() {
    kill_for(WorkerEnd::babbled);
}

// What became of it by itself says more than the reason to kill it.
void WorkerProcess::kill_for(WorkerEnd reason) {
    if (pid_ < 0) return;
    close(socket_);
    kill(pid_, SIGKILL);
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    end_ = reason;
    if (WIFSIGNALED(status)) signal_ = WTERMSIG(status);
    if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemoryExit) end_ = WorkerEnd::out_of_memory;
    if (signal_ == SIGXCPU) end_ = WorkerEnd::out_of_time;
}

uint64_t WorkerProcess::resident_bytes() const {
    std::array<char, 64> path{};
    std::snprintf(path.data(), path.size(), "/proc/%d/statm", static_cast<int>(pid_));
    const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.data(), "re"), &std::fclose);
    unsigned long long total = 0, resident = 0;
    if (!file || std::fscanf(file.get(), "%llu %llu", &total, &resident) != 2) return 0;
    return resident * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
}

// Waits in short steps, and looks at the worker's memory between them.
bool WorkerProcess::ready(short events, WorkerClock::time_point deadline) {
    while (pid_ >= 0) {
        pollfd socket{socket_, events, 0};
        const int found = poll(&socket, 1, static_cast<int>(kWatchEvery.count()));
        if (found > 0) return true;
        if (found < 0 && errno != EINTR) {
            kill_for(WorkerEnd::crashed);
        } else if (resident_bytes() > limits_.worker_bytes) {
            kill_for(WorkerEnd::out_of_memory);
        } else if (WorkerClock::now() >= deadline) {
            kill_for(WorkerEnd::out_of_time);
        }
    }
    return false;
}

bool WorkerProcess::send(const Message& message, WorkerClock::time_point deadline) {
    const std::string frame = to_frame(message);
    for (size_t at = 0; at < frame.size();) {
        if (!ready(POLLOUT, deadline)) return false;
        const ssize_t sent =
            ::send(socket_, frame.data() + at, frame.size() - at, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (sent <= 0) {
            kill_for(WorkerEnd::crashed);
            return false;
        }
        at += static_cast<size_t>(sent);
    }
    return true;
}

bool WorkerProcess::read_exactly(char* to, size_t bytes, WorkerClock::time_point deadline) {
    while (bytes > 0) {
        if (!ready(POLLIN, deadline)) return false;
        const ssize_t got = recv(socket_, to, bytes, MSG_DONTWAIT);
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (got <= 0) {
            // It has hung up, so it is leaving; how, is worth the wait, but not for ever.
            const auto soon = WorkerClock::now() + std::chrono::seconds(1);
            siginfo_t info{};
            while (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
                   info.si_pid == 0 && WorkerClock::now() < soon)
                usleep(1000);
            kill_for(WorkerEnd::crashed);
            return false;
        }
        to += got;
        bytes -= static_cast<size_t>(got);
    }
    return true;
}

std::optional<Message> WorkerProcess::receive(WorkerClock::time_point deadline) {
    std::string header(kFrameHeaderBytes, '\0');
    if (!read_exactly(header.data(), header.size(), deadline)) return std::nullopt;
    const uint64_t bytes = payload_bytes(header);
    if (bytes > limits_.spirv_bytes + kFrameSlackBytes) {
        give_up_on();
        return std::nullopt;
    }
    std::string payload(bytes, '\0');
    if (!read_exactly(payload.data(), payload.size(), deadline)) return std::nullopt;
    std::optional<Message> message = parse_payload(payload);
    if (!message) give_up_on();
    return message;
}

}  // namespace weft::shader
