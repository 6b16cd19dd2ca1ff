/// Which files the program replaces, and which it leaves alone.
#include <sys/stat.h>
#include <unistd.h>

#include "verification/support/writing.hpp"

namespace rotor {
namespace {

class Replacing : public Writing {
 protected:
  /// Without a right that is an administrator's, with t.csv of that mode.
  void expect_refusal_without(const std::string& right, const std::string& mode,
                              const std::string& reason) const {
    const auto [status, output] = shell(
        "chmod " + mode + " t.csv; owner=; [ $(id -u) -ne 0 ] || owner='setpriv --inh-caps -" +
        right + " --bounding-set -" + right + "'; $owner $rotor " + short_run + " --trace t.csv");
    EXPECT_EQ(status, 1);
    EXPECT_EQ(output, "rotor: t.csv: cannot be written: " + reason + "\n");
    EXPECT_EQ(content("t.csv"), "precious");
  }
};

// A folder in memory among the devices has files like any other.
TEST_F(Replacing, TakesFilesInSharedMemoryForAnyOther) {
  if (!fs::is_directory("/dev/shm")) GTEST_SKIP() << "there is none";
  const std::string file = "/dev/shm/" + folder_.filename().string() + ".csv";
  write("long", std::string(1000000, 'x'));
  for (const bool exists : {false, true}) {
    if (exists) fs::copy_file(folder_ / "long", file, fs::copy_options::overwrite_existing);
    EXPECT_EQ(rotor(short_run + " --trace " + file).status, 0);
    EXPECT_LT(fs::file_size(file), 1000000U);
    fs::remove(file);
  }
  remove("long");
}

TEST_F(Replacing, FollowsLinksAndKeepsTheMode) {
  write("target", "old");
  ASSERT_EQ(::chmod((folder_ / "target").c_str(), 0600), 0);
  fs::create_symlink("target", folder_ / "link");
  EXPECT_EQ(rotor(short_run + " --trace link").status, 0);
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_GT(rows_of("target").size(), 10U);
  EXPECT_EQ(fs::status(folder_ / "target").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  // Even what others have no permission to by default.
  fs::permissions(folder_ / "target", fs::perms{0664});
  EXPECT_EQ(shell("umask 077; $rotor " + short_run + " --trace link").status, 0);
  EXPECT_EQ(fs::status(folder_ / "target").permissions(), fs::perms{0664});
  remove("link");
  remove("target");
  fs::create_symlink("not-yet", folder_ / "link");  // which leads nowhere so far
  EXPECT_EQ(shell("umask 027; $rotor " + short_run + " --trace link").status, 0);
  EXPECT_EQ(fs::status(folder_ / "not-yet").permissions(), fs::perms{0640});
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  remove("link");
  remove("not-yet");
}

TEST_F(Replacing, RefusesALinkThatLeadsToItself) {
  fs::create_symlink("loop", folder_ / "loop");
  expect_refusal(short_run + " --trace loop", "loop: cannot be written: ");
  EXPECT_TRUE(fs::is_symlink(folder_ / "loop"));
  remove("loop");
}

// A link leads on from where it stands, not from where the program was started.
TEST_F(Replacing, FollowsARelativeLinkInAnotherFolder) {
  fs::create_directory(folder_ / "other");
  fs::create_symlink("target", folder_ / "other/link");
  EXPECT_EQ(rotor(short_run + " --trace other/link").status, 0);
  EXPECT_GT(rows_of("other/target").size(), 10U);
  EXPECT_FALSE(fs::exists(folder_ / "target"));
  fs::remove_all(folder_ / "other");
}

// Whoever may write anywhere, as tests in containers do, does without that right for once.
TEST_F(Replacing, RefusesWhatItsOwnerMayNotWrite) {
  write("t.csv", "precious");
  expect_refusal_without("dac_override", "444", "Permission denied");
  remove("t.csv");
}

// Nobody but the administrator makes files for others.
TEST_F(Replacing, RefusesWhatIsSomebodyElses) {
  write("t.csv", "precious");
  if (::chown((folder_ / "t.csv").c_str(), 65534, 65534) != 0) {
    remove("t.csv");
    GTEST_SKIP() << "only an administrator can give files away";
  }
  expect_refusal_without("chown", "666",
                         "its owner and mode cannot be kept: Operation not permitted");
  remove("t.csv");
}

TEST_F(Replacing, SparesWhatItReads) {
  const std::string scene = "[parameters]\nuntil = 0.1\n";
  write("s.toml", scene);
  for (const char* outputs : {"run --scene s.toml --trace ./s.toml",
                              "run --scene s.toml --events s.toml", "plot s.toml --out s.toml"})
    EXPECT_NE(rotor(outputs).status, 0) << outputs;
  expect_refusal("run --scene s.toml --trace ./s.toml",
                 "./s.toml: cannot be written: it is what the runs are read from");
  const std::string sweep =
      "[parameters]\nuntil = 0.1\n[[axis]]\nquantity = \"mass\"\nvalues = [5]\n";
  write("w.toml", sweep);
  expect_refusal("sweep w.toml --out w.toml", "it is what the runs are read from");
  EXPECT_EQ(content("s.toml"), scene);
  EXPECT_EQ(content("w.toml"), sweep);
  remove("s.toml");
  remove("w.toml");
}

// Behind a link, two dots are the folder above where it leads.
TEST_F(Replacing, LeavesALinkedFolderUpwardsWhereItLeads) {
  ASSERT_EQ(shell("mkdir -p other/sub && ln -s other/sub link").status, 0);
  EXPECT_EQ(rotor(short_run + " --trace link/../t.csv").status, 0);
  EXPECT_GT(rows_of("other/t.csv").size(), 10U);
  EXPECT_FALSE(fs::exists(folder_ / "t.csv"));
  fs::remove_all(folder_ / "other");
  remove("link");
}

TEST_F(Replacing, CutsNoHardLink) {
  write("one", "precious");
  fs::create_hard_link(folder_ / "one", folder_ / "two");
  expect_refusal(short_run + " --trace one", "one: cannot be written: it has several hard links");
  write("s.toml", "[[axis]]\nquantity = \"friction\"\nvalues = [0.3]\n");
  expect_refusal("sweep s.toml --out one", "one: cannot be written: it has several hard links");
  EXPECT_FALSE(fs::exists(folder_ / "one.journal"));  // nothing has been computed
  remove("s.toml");
  EXPECT_EQ(content("two"), "precious");
  remove("one");
  remove("two");
}

}  // namespace
}  // namespace rotor
