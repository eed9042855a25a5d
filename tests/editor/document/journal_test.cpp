// The journal: whole at every moment, and nobody takes that of a living program.
// SPDX-License-Identifier: MIT
#include "editor/document/journal.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "editor/document/document.h"
#include "io/file.h"
#include "io/kiri_writer.h"
#include "tests/support/model_text.h"
#include "tests/support/scratch_folder.h"

namespace kiri::test {
namespace {

namespace fs = std::filesystem;

class JournalFolder : public ScratchFolder {
 protected:
  Journal opened() const { return Journal::open(folder()).value(); }
};

Model small(const char* title = "boat") {
  Model model = modelOf("square 100; fold A valley 50,0 50,100 left; turn");
  model.title = title;
  return model;
}

TEST_F(JournalFolder, KeepsTheModelAndWhatWasUndone) {
  {
    Journal journal = opened();
    ASSERT_TRUE(journal.note(small(), 1, "/home/me/50% of\na boat.kiri").isOk());
    EXPECT_TRUE(leftoversIn(folder()).empty()) << "it is held";
  }
  const std::vector<Leftover> left = leftoversIn(folder());
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].title, "boat");
  EXPECT_EQ(left[0].steps, 2u);
  EXPECT_EQ(left[0].count, 1u);
  const Recovered recovered = recover(left[0]).value();
  EXPECT_EQ(writeKiri(recovered.model), writeKiri(small()));
  EXPECT_EQ(recovered.originalPath, "/home/me/50% of\na boat.kiri");
  Document document = Document::recovered(recovered.model, recovered.count).value();
  EXPECT_TRUE(document.isModified());
  EXPECT_TRUE(document.redo());
  discard(left[0]);
  EXPECT_EQ(fileCount(), 0u);
}

TEST_F(JournalFolder, IsEmptyAfterAnEndInOrder) {
  {
    Journal journal = opened();
    ASSERT_TRUE(journal.note(small(), 2, "").isOk());
    EXPECT_TRUE(journal.clear().isOk());
    EXPECT_TRUE(journal.clear().isOk()) << "nothing to clear is in order";
  }
  EXPECT_TRUE(leftoversIn(folder()).empty());
  EXPECT_EQ(fileCount(), 0u) << "not even a lock stays";
}

TEST_F(JournalFolder, ProgramsBesideEachOtherHaveTheirOwn) {
  Journal one = opened();
  Journal two = opened();
  EXPECT_NE(one.file(), two.file());
  ASSERT_TRUE(one.note(small("one"), 2, "").isOk());
  ASSERT_TRUE(two.note(small("two"), 2, "").isOk());
  EXPECT_TRUE(leftoversIn(folder()).empty());
  { const Journal gone = std::move(one); }
  ASSERT_EQ(leftoversIn(folder()).size(), 1u);
  const Journal three = opened();
  EXPECT_EQ(leftoversIn(folder()).size(), 1u) << "a new one leaves it alone";
}

TEST_F(JournalFolder, DamagedOnesAreLeftOutAndStay) {
  std::string text;
  {
    Journal journal = opened();
    ASSERT_TRUE(journal.note(small(), 2, "").isOk());
    text = readFile(journal.file()).value();
  }
  for (std::size_t size = 0; size < text.size(); ++size)
    ASSERT_FALSE(readJournal(text.substr(0, size), "cut").isOk()) << size;
  EXPECT_FALSE(readJournal(text + "x", "longer").isOk());
  EXPECT_TRUE(readJournal(text, "whole").isOk());
  put("7.journal", text.substr(0, text.size() / 2));
  EXPECT_EQ(leftoversIn(folder()).size(), 1u);
  EXPECT_TRUE(fs::exists(path("7.journal")));
  EXPECT_TRUE(leftoversIn(path("nowhere")).empty());
}

TEST_F(JournalFolder, WhereNothingCanBeWrittenSaysSo) {
  put("file", "x");
  const Result<Journal> refused = Journal::open(path("file"));
  ASSERT_FALSE(refused.isOk());
  EXPECT_EQ(refused.error().code, ErrorCode::Unwritable);
}

/// A model that is long to write and tells its number.
Model numbered(std::size_t number) {
  Model model = modelOf("square 100");
  model.title = "number " + std::to_string(number);
  model.steps.assign(300 + number, stepOf("rotate 30"));
  return model;
}

constexpr char kToken = 't';

/// Notes the next model for each token that comes, and says so.
[[noreturn]] void noteForEver(const std::string& folder, int tokens, int answers) {
  Result<Journal> journal = Journal::open(folder);
  if (!journal) ::_exit(1);
  char token = 0;
  for (std::size_t number = 1; ::read(tokens, &token, 1) == 1; ++number) {
    if (!journal->note(numbered(number), number, "")) ::_exit(2);
    if (::write(answers, &token, 1) != 1) ::_exit(3);
  }
  ::_exit(4);
}

/// A program that is killed while it writes number `noted` + 1, sooner or later by `delay` empty
/// system calls.
void killWhileNoting(const std::string& folder, std::size_t noted, int delay) {
  int tokens[2];
  int answers[2];
  ASSERT_EQ(::pipe(tokens), 0);
  ASSERT_EQ(::pipe(answers), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) noteForEver(folder, tokens[0], answers[1]);
  char answer = 0;
  for (std::size_t i = 0; i < noted; ++i) {
    ASSERT_EQ(::write(tokens[1], &kToken, 1), 1);
    ASSERT_EQ(::read(answers[0], &answer, 1), 1);
  }
  EXPECT_TRUE(leftoversIn(folder).empty()) << "it lives";
  ASSERT_EQ(::write(tokens[1], &kToken, 1), 1);
  for (int i = 0; i < delay; ++i) (void)::getppid();
  ::kill(child, SIGKILL);
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFSIGNALED(status));
  for (const int end : {tokens[0], tokens[1], answers[0], answers[1]}) ::close(end);
}

TEST_F(JournalFolder, AKillAtAnyMomentLosesAtMostTheLastStep) {
  std::size_t early = 0;
  constexpr int kKills = 50;
  for (int kill = 0; kill < kKills; ++kill) {
    const std::size_t noted = 1 + static_cast<std::size_t>(kill) % 3;
    killWhileNoting(folder(), noted, kill * kill * 20);
    const std::vector<Leftover> left = leftoversIn(folder());
    ASSERT_EQ(left.size(), 1u) << "kill " << kill;
    const Recovered content = recover(left[0]).value();
    EXPECT_TRUE(content.count == noted || content.count == noted + 1) << content.count;
    EXPECT_EQ(writeKiri(content.model), writeKiri(numbered(content.count)));
    early += content.count == noted ? 1 : 0;
    discard(left[0]);
    ASSERT_EQ(fileCount(), 0u) << "no half written file stays";
  }
  EXPECT_GT(early, 0u) << "some were killed before the end of writing";
}

}  // namespace
}  // namespace kiri::test
