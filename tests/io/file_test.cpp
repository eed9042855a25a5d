// Files are written whole or not at all.
// SPDX-License-Identifier: MIT
#include "io/file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "tests/support/scratch_folder.h"

namespace kiri {
namespace {

namespace fs = std::filesystem;

using File = test::ScratchFolder;

TEST_F(File, ReadsBackWhatItWrote) {
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(writeFile(path("a"), bytes).isOk());
  ASSERT_TRUE(writeFile(path("a"), bytes + "c").isOk());
  EXPECT_EQ(*readFile(path("a")), bytes + "c");
  EXPECT_EQ(fileCount(), 1u) << "no temporary file is left";
}

TEST_F(File, KeepsPermissionsAndLinks) {
  ASSERT_TRUE(writeFile(path("a"), "1").isOk());
  ASSERT_EQ(::chmod(path("a").c_str(), 0640), 0);
  fs::create_symlink(path("a"), path("link"));
  ASSERT_TRUE(writeFile(path("link"), "2").isOk());
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(*readFile(path("a")), "2");
  struct stat status = {};
  ASSERT_EQ(::stat(path("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST_F(File, WritesDirectlyToWhatIsNoOrdinaryFile) {
  EXPECT_TRUE(writeFile("/dev/null", "x").isOk());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(File, SaysWhatIsInTheWay) {
  EXPECT_EQ(readFile(path("none")).error().message,
            "cannot read " + path("none") + ": there is no such file");
  fs::create_directory(path("d"));
  EXPECT_NE(readFile(path("d")).error().message.find("it is a folder"), std::string::npos);
  const Status missing = writeFile(path("x/y"), "1");
  EXPECT_EQ(missing.error().code, ErrorCode::Unwritable);
  EXPECT_NE(missing.error().message.find("there is no folder " + path("x") + "; make it first"),
            std::string::npos);
  EXPECT_NE(writeFile(path("d"), "1").error().message.find("it is a folder; name a file in it"),
            std::string::npos);
  std::istringstream large(std::string(std::size_t{3} << 20, 'x'));
  EXPECT_NE(readStream(large, "input", std::size_t{2} << 20).error().message.find("more than 2 MB"),
            std::string::npos);
}

}  // namespace
}  // namespace kiri
