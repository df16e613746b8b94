#include "shader/worker/worker_process.h"
#include "graph/diagnostics/make_error.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
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
// The payload of a message may be this much larger than the limit for SPIR-V. `done` needs these bytes for
// names of variables, and `include` needs them for names of files.
constexpr uint64_t kFrameSlackBytes = 1 << 20;

Diagnostic cannot_start(const std::filesystem::path& program, const std::string& why) {
    return make_error(
        "X570", "the shader compiler \"" + program.string() + "\" cannot be started: " + why,
        {"build or install Weft again: the program weft-shader-worker belongs into the folder of weft"});
}

std::chrono::milliseconds milliseconds_of(const timeval& time) {
    return std::chrono::milliseconds(time.tv_sec * 1000 + time.tv_usec / 1000);
}

// Starts the worker. Returns 0 on success, or a value of errno. The new process has only the file descriptors
// 0 to 2: descriptor 0 is the socket, the others are /dev/null.
int spawn(const std::filesystem::path& program, const ShaderLimits& limits, int socket, pid_t& pid) {
    posix_spawn_file_actions_t actions;
    if (const int error = posix_spawn_file_actions_init(&actions); error != 0) return error;
    posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
    for (const int output : {STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);

    // Reset the signals, because the worker must not inherit the ignored or blocked signals of the caller.
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
    worker->allow(std::chrono::milliseconds(limits.stage_ms));
    const std::optional<Message> hello = worker->receive();
    if (!hello || hello->kind != MessageKind::hello || hello->texts.size() != 1)
        return cannot_start(program,
                            "the program does not answer; the limit shader.workerBytes may be too small");
    if (hello->texts[0] != version)
        return cannot_start(
            program, "the version of the program is \"" + hello->texts[0] + "\", wanted \"" + version + "\"");
    return worker;
}

WorkerProcess::~WorkerProcess() {
    kill_for(WorkerEnd::running);
}

void WorkerProcess::kill() {
    kill_for(WorkerEnd::protocol_error);
}

// Kills the worker and stores the reason of its end. If the worker has already ended because of its own
// memory limit or processor time limit, that reason is stored instead of the argument.
void WorkerProcess::kill_for(WorkerEnd reason) {
    if (pid_ < 0) return;
    close(socket_);
    ::kill(pid_, SIGKILL);
    int status = 0;
    rusage usage{};
    while (wait4(pid_, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    used_ = std::max(used_, milliseconds_of(usage.ru_utime) + milliseconds_of(usage.ru_stime));
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

bool WorkerProcess::observe() {
    std::array<char, 64> path{};
    std::snprintf(path.data(), path.size(), "/proc/%d/stat", static_cast<int>(pid_));
    const std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.data(), "re"), &std::fclose);
    std::array<char, 1024> line{};
    if (!file || std::fgets(line.data(), line.size(), file.get()) == nullptr) return false;
    // The second field of the line is the name of the program in brackets. It may contain any character, so
    // the search starts at the last bracket. The third field is the state of the process.
    const char* rest = std::strrchr(line.data(), ')');
    char state = 0;
    unsigned long long user = 0, system = 0;
    if (rest == nullptr || std::sscanf(rest + 1, " %c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %llu %llu",
                                       &state, &user, &system) != 3)
        return false;
    const auto ticks_per_s = static_cast<unsigned long long>(sysconf(_SC_CLK_TCK));
    used_ = std::chrono::milliseconds((user + system) * 1000 / ticks_per_s);
    return state == 'S';
}

void WorkerProcess::allow(std::chrono::milliseconds time) {
    most_used_ = used() + time;
    most_asleep_ = time;
    asleep_ = {};
}

std::chrono::milliseconds WorkerProcess::used() {
    if (pid_ >= 0) observe();
    return used_;
}

// Waits until one of `events` (POLLIN, POLLOUT) occurs on the socket. After every 20 ms without an event, the
// function compares the memory and time of the worker with their limits, and kills the worker if it exceeds
// one of them. Returns false if the worker has ended.
bool WorkerProcess::ready(short events) {
    while (pid_ >= 0) {
        pollfd socket{socket_, events, 0};
        const int found = poll(&socket, 1, static_cast<int>(kWatchEvery.count()));
        if (found > 0) return true;
        if (found < 0 && errno != EINTR) {
            kill_for(WorkerEnd::crashed);
        } else if (resident_bytes() > limits_.worker_bytes) {
            kill_for(WorkerEnd::out_of_memory);
        } else {
            if (observe()) asleep_ += kWatchEvery;
            if (used_ >= most_used_ || asleep_ >= most_asleep_) kill_for(WorkerEnd::out_of_time);
        }
    }
    return false;
}

bool WorkerProcess::send(const Message& message) {
    const std::string frame = to_frame(message);
    for (size_t at = 0; at < frame.size();) {
        if (!ready(POLLOUT)) return false;
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

// Waits for the exit of a worker that has closed its socket, so that kill_for() finds its exit status. The
// wait ends early after one second, or when the time limit of the worker has passed.
void WorkerProcess::wait_for_end() {
    constexpr std::chrono::milliseconds kStep{1}, kMostSleep{1000};
    std::chrono::milliseconds slept{0};
    siginfo_t info{};
    while (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == 0 && slept < kMostSleep && used_ < most_used_) {
        usleep(static_cast<useconds_t>(std::chrono::microseconds(kStep).count()));
        if (observe()) slept += kStep;
    }
}

bool WorkerProcess::read_exactly(char* to, size_t bytes) {
    while (bytes > 0) {
        if (!ready(POLLIN)) return false;
        const ssize_t got = recv(socket_, to, bytes, MSG_DONTWAIT);
        if (got < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (got <= 0) {
            wait_for_end();
            kill_for(WorkerEnd::crashed);
            return false;
        }
        to += got;
        bytes -= static_cast<size_t>(got);
    }
    return true;
}

std::optional<Message> WorkerProcess::receive() {
    std::string header(kFrameHeaderBytes, '\0');
    if (!read_exactly(header.data(), header.size())) return std::nullopt;
    const uint64_t bytes = payload_bytes(header);
    if (bytes > limits_.spirv_bytes + kFrameSlackBytes) {
        kill();
        return std::nullopt;
    }
    std::string payload(bytes, '\0');
    if (!read_exactly(payload.data(), payload.size())) return std::nullopt;
    std::optional<Message> message = parse_payload(payload);
    if (!message) kill();
    return message;
}

}  // namespace weft::shader
