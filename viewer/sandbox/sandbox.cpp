#include "viewer/sandbox/sandbox.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <set>

#include "file/file_target.h"
#include "viewer/output/output.h"
#include "viewer/output/report.h"
#include "viewer/sandbox/sandbox_needs.h"
#include "viewer/sandbox/sandbox_parts.h"

namespace weft::viewer {

Diagnostic no_sandbox(const std::string& why, const std::string& help) {
    Diagnostic d;
    d.code = "X595";
    d.message = "the sandbox is not available, so the command was not run: " + why;
    if (!help.empty()) d.help.push_back(help);
    d.help.emplace_back("for untrusted files, use a container; for trusted files, remove --sandbox");
    return d;
}

Status lock_this_process(const OpenRules& rules) {
    if (Status s = restrict_files(rules); !s) return s;
    return restrict_calls(landlock_version());
}

namespace {

namespace fs = std::filesystem;

// An output of the child process. The child writes a regular file into a temporary folder, which contains no
// other file. If the output is a pipe or a device, `folder` is empty and the child writes to `wanted`.
struct StagedFile {
    fs::path wanted, folder;
    [[nodiscard]] fs::path staged() const { return folder / wanted.filename(); }
};

// The temporary folders for the output files of the child process. move_all() moves the written files to the
// wanted paths. The destructor removes the folders.
class StagingFolders {
 public:
    StagingFolders() = default;
    ~StagingFolders() {
        std::error_code error;
        for (const StagedFile& file : files_) fs::remove_all(file.folder, error);
    }
    StagingFolders(const StagingFolders&) = delete;
    StagingFolders& operator=(const StagingFolders&) = delete;

    Status add(const std::string& output, OpenRules& rules) {
        const FileTarget target = find_target(output);
        if (target.kind != TargetKind::file) {
            if (target.descriptor >= 0) descriptors_.insert(target.descriptor);
            if (target.kind == TargetKind::stream) rules.devices.push_back(target.path);
            files_.push_back({target.path, {}});
            return Unit{};
        }
        const fs::path wanted = fs::absolute(target.path);
        std::string folder = (wanted.parent_path() / ".weft-XXXXXX").string();
        if (mkdtemp(folder.data()) == nullptr) {
            Diagnostic d;
            d.code = "X510";
            d.file = output;
            d.message = std::string("a temporary folder cannot be created beside the output file: ") +
                        std::strerror(errno);
            d.help = {"check that the folder of the output exists and can be written"};
            return d;
        }
        files_.push_back({wanted, folder});
        rules.write.emplace_back(folder);
        return Unit{};
    }

    // Replaces the path of each output file by its path in its temporary folder. Pipes and devices keep their
    // paths. `outputs` must have the same order as the calls of add().
    void rename(const std::vector<std::string*>& outputs) const {
        size_t next = 0;
        for (std::string* output : outputs) {
            if (output->empty()) continue;
            const StagedFile& file = files_[next++];
            if (!file.folder.empty()) *output = file.staged().string();
        }
    }

    [[nodiscard]] Diagnostics move_all() const {
        Diagnostics errors;
        for (const StagedFile& file : files_) {
            struct stat made {
            }, old{};
            if (file.folder.empty() || lstat(file.staged().c_str(), &made) != 0 || !S_ISREG(made.st_mode))
                continue;
            // A new file that replaces an old one gets the permissions of the old one.
            if (stat(file.wanted.c_str(), &old) == 0) (void)chmod(file.staged().c_str(), old.st_mode & 0777);
            if (::rename(file.staged().c_str(), file.wanted.c_str()) == 0) continue;
            Diagnostic d;
            d.code = "X510";
            d.file = file.wanted.string();
            d.message = std::string("the file cannot be written: ") + std::strerror(errno);
            d.help = {"check that the folder of the file exists and can be written"};
            errors.push_back(std::move(d));
        }
        return errors;
    }

    // Returns the file descriptors that the user named as outputs in the form /dev/fd/N.
    [[nodiscard]] const std::set<int>& descriptors() const { return descriptors_; }

    // The child process calls this, so that it does not remove the folders. The parent process removes them.
    void forget() { files_.clear(); }

 private:
    std::vector<StagedFile> files_;
    std::set<int> descriptors_;
};

// Closes all inherited file descriptors of the child process, except the standard streams and those in
// `kept`.
void close_others(const std::set<int>& kept) {
    unsigned from = STDERR_FILENO + 1;
    for (const int descriptor : kept) {
        const auto number = static_cast<unsigned>(descriptor);
        if (number > from) (void)close_range(from, number - 1, 0);
        from = std::max(from, number + 1);
    }
    (void)close_range(from, ~0u, 0);
}

constexpr int kForwarded[] = {SIGINT, SIGTERM, SIGHUP};

sigset_t awaited_signals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGCHLD);
    for (const int signal : kForwarded) sigaddset(&set, signal);
    return set;
}

// Waits until the child process has ended. Meanwhile, signals such as SIGINT that this process receives are
// sent on to the child.
void await(pid_t child, const sigset_t& signals) {
    for (;;) {
        siginfo_t ended{};
        if (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) != 0) return;
        if (ended.si_pid == child) return;
        int signal = 0;
        sigwait(&signals, &signal);
        if (signal != SIGCHLD) kill(child, signal);
    }
}

// Ends all processes that the child process started and that still run. They are all in the process group of
// the child, because the sandbox prevents them from leaving it. Returns the exit status of the child in the
// form of waitpid().
int end_group(pid_t child) {
    kill(-child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    while (waitpid(-child, nullptr, 0) > 0) {
    }
    return status;
}

ExitCode conclude(int status, const StagingFolders& stage) {
    if (WIFSIGNALED(status)) {
        Diagnostic d;
        d.code = "X596";
        d.message = std::string("a signal ended the process in the sandbox, and nothing was written: ") +
                    strsignal(WTERMSIG(status));
        d.help = {
            "look for a shader that crashes the Vulkan driver, or for a damaged file that crashes a library"};
        const bool asked = WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM;
        if (!asked) report({d});
        return ExitCode::failed;
    }
    if (const Diagnostics errors = stage.move_all(); !errors.empty()) {
        report(errors);
        return ExitCode::failed;
    }
    return static_cast<ExitCode>(WEXITSTATUS(status));
}

}  // namespace

std::optional<ExitCode> run_in_sandbox(const SandboxNeeds& needs) {
    OpenRules rules = rules_of_program(needs.device);
    for (const std::string& path : needs.read)
        if (!path.empty()) rules.read.emplace_back(path);
    StagingFolders stage;
    std::vector<std::string> outputs;
    for (const std::string* output : needs.outputs) outputs.push_back(*output);
    if (const ExitCode code = check_outputs(outputs, needs.inputs); code != ExitCode::ok) return code;
    for (const std::string* output : needs.outputs) {
        if (output->empty()) continue;
        if (Status s = stage.add(*output, rules); !s) {
            report(s.errors());
            return ExitCode::failed;
        }
    }
    std::fflush(nullptr);
    const sigset_t signals = awaited_signals();
    sigset_t before;
    pthread_sigmask(SIG_BLOCK, &signals, &before);
    const pid_t parent = getpid();
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    const pid_t child = fork();
    if (child < 0) {
        report({no_sandbox(std::string("a new process cannot be started: ") + std::strerror(errno), {})});
        return ExitCode::failed;
    }
    setpgid(child, child);  // Both parent and child make this call, because either may run first.
    if (child > 0) {
        await(child, signals);
        return conclude(end_group(child), stage);
    }

    // For the terminal, the process group of the child is in the background. The child ignores SIGTTOU, so
    // that it can write to the terminal nevertheless.
    std::signal(SIGTTOU, SIG_IGN);
    close_others(stage.descriptors());
    stage.rename(needs.outputs);
    stage.forget();
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);
    // Disable the shader caches of the drivers. They contain machine code that later runs execute, so a
    // process in the sandbox must not write it.
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    setenv("__GL_SHADER_DISK_CACHE", "0", 1);
    if (Status s = lock_this_process(rules); !s) {
        report(s.errors());
        std::fflush(nullptr);
        _exit(static_cast<int>(ExitCode::failed));
    }
    return std::nullopt;
}

}  // namespace weft::viewer
