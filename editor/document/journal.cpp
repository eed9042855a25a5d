// SPDX-License-Identifier: MIT
#include "editor/document/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "io/file.h"

namespace kiri {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEnding = ".journal";
constexpr const char* kLockEnding = ".lock";

std::string lockOf(const std::string& journal) { return journal + kLockEnding; }

/// A locked file. The system lets go of it when the process ends, however that happens.
class Lock {
 public:
  enum class Outcome { Locked, HeldByOther, Failed };

  Lock() = default;
  Lock(Lock&& other) noexcept : handle_(std::exchange(other.handle_, -1)) {}
  Lock& operator=(Lock&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Lock() {
    if (handle_ >= 0) ::close(handle_);
  }

  /// `isMade`: the file is made where there is none.
  Outcome take(const std::string& path, bool isMade) {
    for (;;) {
      handle_ = ::open(path.c_str(), O_RDWR | O_CLOEXEC | (isMade ? O_CREAT : 0), 0600);
      if (handle_ < 0) return Outcome::Failed;
      if (::flock(handle_, LOCK_EX | LOCK_NB) != 0) {
        const bool isHeld = errno == EWOULDBLOCK;
        release();
        return isHeld ? Outcome::HeldByOther : Outcome::Failed;
      }
      // Whoever held it may have removed the file between our opening and locking it.
      struct stat ours = {};
      struct stat there = {};
      const bool isSame = ::fstat(handle_, &ours) == 0 && ::stat(path.c_str(), &there) == 0 &&
                          ours.st_ino == there.st_ino && ours.st_dev == there.st_dev;
      if (isSame) return Outcome::Locked;
      release();
      if (!isMade) return Outcome::Failed;
    }
  }

 private:
  void release() { ::close(std::exchange(handle_, -1)); }

  int handle_ = -1;
};

bool hasEnding(const std::string& name, const std::string& ending) {
  return name.size() >= ending.size() &&
         name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

/// Half written files that a killed process left beside a journal. Requires its lock.
void removeHalves(const std::string& journal) {
  std::error_code error;
  const fs::path path(journal);
  std::vector<fs::path> halves;
  for (const fs::directory_entry& entry : fs::directory_iterator(path.parent_path(), error)) {
    const std::string name = entry.path().filename().string();
    const bool isHalf = name.rfind(path.filename().string() + ".", 0) == 0;
    if (isHalf && !hasEnding(name, kLockEnding)) halves.push_back(entry.path());
  }
  for (const fs::path& half : halves) fs::remove(half, error);
}

/// Requires its lock.
void removeAll(const std::string& journal) {
  std::error_code error;
  fs::remove(journal, error);
  removeHalves(journal);
  fs::remove(lockOf(journal), error);
}

struct Aged {
  Leftover leftover;
  fs::file_time_type time;
};

/// None when a living process holds it, or it cannot be read.
std::optional<Aged> leftoverAt(const fs::path& path) {
  const std::string file = path.string();
  Lock lock;
  std::error_code error;
  const Lock::Outcome outcome = lock.take(lockOf(file), false);
  const bool isFree = outcome == Lock::Outcome::Locked || !fs::exists(lockOf(file), error);
  if (!isFree) return std::nullopt;
  const Result<Recovered> content = recover({file, {}, {}, 0, 0});
  const fs::file_time_type time = fs::last_write_time(path, error);
  if (!content || error) return std::nullopt;
  return Aged{{file, content->originalPath, content->model.title, content->model.steps.size(),
               content->count},
              time};
}

}  // namespace

struct Journal::Held {
  std::string file;
  Lock lock;
};

Journal::Journal(std::unique_ptr<Held> held) : held_(std::move(held)) {}
Journal::Journal(Journal&&) noexcept = default;
Journal& Journal::operator=(Journal&& other) noexcept {
  std::swap(held_, other.held_);
  return *this;
}

Journal::~Journal() {
  std::error_code error;
  if (held_ != nullptr && !fs::exists(held_->file, error)) removeAll(held_->file);
}

Result<Journal> Journal::open(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  constexpr int kMost = 10000;
  for (int number = 1; number <= kMost; ++number) {
    auto held = std::make_unique<Held>();
    held->file = (fs::path(folder) / (std::to_string(number) + kEnding)).string();
    const Lock::Outcome outcome = held->lock.take(lockOf(held->file), true);
    if (outcome == Lock::Outcome::Failed) break;
    if (outcome == Lock::Outcome::HeldByOther || fs::exists(held->file, error)) continue;
    removeHalves(held->file);
    return Journal(std::move(held));
  }
  return Error{ErrorCode::Unwritable,
               "what you do cannot be kept safe from crashes: no file can be made in " + folder +
                   "; see that there is room and that you may write there",
               {}};
}

Status Journal::note(const Model& model, std::size_t count, const std::string& originalPath) {
  return writeFile(held_->file, writeJournal({model, count, originalPath}));
}

Status Journal::clear() {
  std::error_code error;
  fs::remove(held_->file, error);
  if (!error) return std::monostate{};
  return Error{ErrorCode::Unwritable, "cannot remove " + held_->file + ": " + error.message(), {}};
}

const std::string& Journal::file() const { return held_->file; }

std::vector<Leftover> leftoversIn(const std::string& folder) {
  std::error_code error;
  std::vector<Aged> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (!hasEnding(entry.path().filename().string(), kEnding)) continue;
    if (std::optional<Aged> leftover = leftoverAt(entry.path()))
      found.push_back(std::move(*leftover));
  }
  std::sort(found.begin(), found.end(), [](const Aged& a, const Aged& b) {
    return a.time != b.time ? a.time > b.time : a.leftover.file > b.leftover.file;
  });
  std::vector<Leftover> leftovers;
  for (Aged& aged : found) leftovers.push_back(std::move(aged.leftover));
  return leftovers;
}

Result<Recovered> recover(const Leftover& leftover) {
  const Result<std::string> text = readFile(leftover.file);
  if (!text) return text.error();
  return readJournal(*text, leftover.file);
}

void discard(const Leftover& leftover) {
  Lock lock;
  if (lock.take(lockOf(leftover.file), true) != Lock::Outcome::Locked) return;
  removeAll(leftover.file);
}

}  // namespace kiri
