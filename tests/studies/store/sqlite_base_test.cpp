// SPDX-License-Identifier: Apache-2.0
#include "studies/store/sqlite_base.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/test_data.h"

namespace hapticell::studies {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SqliteFile : public ::testing::Test {
 protected:
  SqliteFile() : base(SqliteBase::open(folder.path() / "a.db", SqliteBase::Mode::kCreate).value()) {
    EXPECT_TRUE(base.run("CREATE TABLE t (a REAL, b INTEGER, c TEXT)").has_value());
  }
  std::int64_t rows() {
    Statement count = base.prepare("SELECT COUNT(*) FROM t").value();
    std::int64_t found = -1;
    EXPECT_TRUE(base.forEach(count,
                             [&](const Statement& row) -> Expected<void> {
                               found = row.whole(0);
                               return {};
                             })
                    .has_value());
    return found;
  }
  test::TemporaryFolder folder;
  SqliteBase base;
};

TEST_F(SqliteFile, GivesBackWhatWasBoundToTheBit) {
  Statement insert = base.prepare("INSERT INTO t VALUES (?, ?, ?)").value();
  const std::string odd("it's \"odd\"\0 Ünïcode", 21);
  insert.bind(0, 0.1 + 0.2);
  insert.bind(1, std::numeric_limits<std::int64_t>::min());
  insert.bind(2, odd);
  ASSERT_TRUE(base.step(insert).has_value());
  insert.bindNull(0);
  insert.bind(1, std::int64_t{7});
  insert.bind(2, std::string());
  ASSERT_TRUE(base.step(insert).has_value());
  Statement select = base.prepare("SELECT a, b, c FROM t ORDER BY b").value();
  std::vector<std::int64_t> seen;
  ASSERT_TRUE(base.forEach(select,
                           [&](const Statement& row) -> Expected<void> {
                             seen.push_back(row.whole(1));
                             if (row.isNull(0)) return {};
                             EXPECT_EQ(row.number(0), 0.1 + 0.2);
                             EXPECT_EQ(row.text(2), odd);
                             return {};
                           })
                  .has_value());
  EXPECT_THAT(seen, ElementsAre(std::numeric_limits<std::int64_t>::min(), 7));
}

TEST_F(SqliteFile, WorkIsDoneAsAWholeOrNotAtAll) {
  ASSERT_TRUE(base.atOnce([&] { return base.run("INSERT INTO t VALUES (1, 1, 'x')"); }).has_value());
  EXPECT_EQ(rows(), 1);
  const auto failed = base.atOnce([&]() -> Expected<void> {
    HAPTICELL_TRY(base.run("INSERT INTO t VALUES (2, 2, 'y')"));
    return base.run("INSERT INTO nowhere VALUES (1)");
  });
  EXPECT_FALSE(failed.has_value());
  EXPECT_EQ(rows(), 1);
  EXPECT_TRUE(base.atOnce([&] { return base.run("INSERT INTO t VALUES (3, 3, 'z')"); }).has_value())
      << "it can be used again";
  EXPECT_EQ(rows(), 2);
}

TEST_F(SqliteFile, AnErrorOfTheVisitorEndsTheRows) {
  ASSERT_TRUE(base.run("INSERT INTO t VALUES (1, 1, 'x'), (2, 2, 'y'), (3, 3, 'z')").has_value());
  Statement select = base.prepare("SELECT b FROM t ORDER BY b").value();
  int seen = 0;
  const auto outcome = base.forEach(select, [&](const Statement& row) -> Expected<void> {
    ++seen;
    if (row.whole(0) == 2) return makeError({.found = "two"});
    return {};
  });
  ASSERT_FALSE(outcome.has_value());
  EXPECT_EQ(outcome.error().message(), Error{.found = "two"}.message());
  EXPECT_EQ(seen, 2);
}

TEST_F(SqliteFile, EveryErrorNamesTheFile) {
  const auto missing = SqliteBase::open(folder.path() / "none.db", SqliteBase::Mode::kWrite);
  ASSERT_FALSE(missing.has_value());
  EXPECT_THAT(missing.error().message(), HasSubstr("none.db"));
  const auto bad = base.prepare("SELEKT 1");
  ASSERT_FALSE(bad.has_value());
  EXPECT_THAT(bad.error().message(), HasSubstr("a.db"));
  auto letter =
      SqliteBase::open(folder.write("letter.db", "Dear Anna, ..." + std::string(5000, ' ')), SqliteBase::Mode::kRead);
  const auto read = letter ? letter->run("SELECT * FROM sqlite_master") : Expected<void>(makeError(letter.error()));
  ASSERT_FALSE(read.has_value());
  EXPECT_THAT(read.error().message(), HasSubstr("letter.db"));
  auto reader = SqliteBase::open(folder.path() / "a.db", SqliteBase::Mode::kRead);
  ASSERT_TRUE(reader.has_value());
  EXPECT_FALSE(reader->run("INSERT INTO t VALUES (1, 1, 'x')").has_value()) << "opened for reading";
}

TEST_F(SqliteFile, AnyNameCanBeAColumn) {
  for (const std::string& name :
       {std::string("plain"), std::string("a \"b\" c"), std::string("x\"; DROP TABLE t; --")}) {
    ASSERT_TRUE(base.run("ALTER TABLE t ADD COLUMN " + quotedColumn(name)).has_value()) << name;
    EXPECT_TRUE(base.prepare("SELECT " + quotedColumn(name) + " FROM t").has_value()) << name;
  }
  EXPECT_EQ(rows(), 0) << "the table is still there";
}

}  // namespace
}  // namespace hapticell::studies
