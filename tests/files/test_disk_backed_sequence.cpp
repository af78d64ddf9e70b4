#include "mrpt_ext/files/disk_backed_sequence.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstdlib>
#include <thread>

#include "mrpt_ext/geometry/input_error.h"
#include "scratch_folder.h"

namespace mrpt_ext::test_disk_backed_sequence
{
namespace
{
struct Inner
{
  int a = 0;
  double b = 0;
};

struct Row
{
  std::size_t number = 0;
  std::string name;
  std::optional<double> perhaps;
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Inner inner;

  template <class Self, class Archive>
  static void archive(Self& row, Archive& fields)
  {
    fields(row.number, row.name, row.perhaps, row.matrix, row.inner);
  }
};

Row rowOf(std::size_t number)
{
  Row row{number, std::string(number % 40, 'x'), {}, Eigen::Matrix2d::Constant(0.1 * static_cast<double>(number)), {}};
  if (number % 3 > 0) row.perhaps = 1.0 / static_cast<double>(number);
  row.inner = {static_cast<int>(number) - 7, 0.5};
  return row;
}

void expectSame(const Row& a, const Row& b)
{
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.perhaps, b.perhaps);
  EXPECT_EQ(a.matrix, b.matrix);
  EXPECT_EQ(a.inner.a, b.inner.a);
  EXPECT_EQ(a.inner.b, b.inner.b);
}

constexpr std::size_t kPage = DiskBackedSequence<Row>::kRowsPerPage;
constexpr std::size_t kInMemory = kPage * DiskBackedSequence<Row>::kPagesInMemory;

DiskBackedSequence<Row> sequenceOf(std::size_t size)
{
  DiskBackedSequence<Row> rows;
  for (std::size_t i = 0; i < size; ++i) rows.push_back(rowOf(i));
  return rows;
}

void expectRows(const DiskBackedSequence<Row>& rows, std::size_t size)
{
  ASSERT_EQ(rows.size(), size);
  std::size_t i = 0;
  for (const Row& row : rows) expectSame(row, rowOf(i++));
  EXPECT_EQ(i, size);
}
}  // namespace

TEST(DiskBackedSequence, ReturnsAllRowsAtAnySize)
{
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kPage, kPage + 1, kInMemory, kInMemory + kPage,
                                 kInMemory + kPage + 1, 2 * kInMemory + 100})
  {
    const DiskBackedSequence<Row> rows = sequenceOf(size);
    expectRows(rows, size);
    if (size == 0) continue;
    expectSame(rows.front(), rowOf(0));
    expectSame(rows.back(), rowOf(size - 1));
  }
  EXPECT_TRUE(DiskBackedSequence<Row>().empty());
}

TEST(DiskBackedSequence, MemoryIsBounded)
{
  EXPECT_EQ(sequenceOf(100).rowsInMemory(), 100u);
  for (const std::size_t size : {2 * kInMemory, 5 * kInMemory, 5 * kInMemory + 17})
    EXPECT_LE(sequenceOf(size).rowsInMemory(), kInMemory + kPage);
}

TEST(DiskBackedSequence, CopiesAreIndependent)
{
  const DiskBackedSequence<Row> before = sequenceOf(kInMemory + 2 * kPage + 5);
  DiskBackedSequence<Row> one = before, other = before;
  for (std::size_t i = 0; i < 3 * kPage; ++i)
  {
    one.push_back(rowOf(before.size() + i));
    other.push_back(rowOf(i));
  }
  expectRows(before, kInMemory + 2 * kPage + 5);
  expectRows(one, kInMemory + 5 * kPage + 5);
  std::size_t i = 0;
  for (const Row& row : other)
  {
    expectSame(row, rowOf(i < before.size() ? i : i - before.size()));
    ++i;
  }
  one.clear();
  EXPECT_TRUE(one.empty());
  expectRows(one, 0);
}

TEST(DiskBackedSequence, MayBeReadByThreadsAtTheSameTime)
{
  const DiskBackedSequence<Row> rows = sequenceOf(kInMemory + 10 * kPage);
  std::size_t sums[2] = {0, 0};
  const auto add = [&rows](std::size_t& sum)
  {
    for (const Row& row : rows) sum += row.number;
  };
  std::thread other(add, std::ref(sums[1]));
  add(sums[0]);
  other.join();
  EXPECT_EQ(sums[0], rows.size() * (rows.size() - 1) / 2);
  EXPECT_EQ(sums[1], sums[0]);
}

TEST(DiskBackedSequence, LeavesNothingInTheFolderForTemporaryFiles)
{
  const testing::ScratchFolder folder;
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before ? before : "";
  setenv("TMPDIR", folder.path().c_str(), 1);
  {
    const DiskBackedSequence<Row> rows = sequenceOf(kInMemory + 2 * kPage);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    expectRows(rows, kInMemory + 2 * kPage);
  }
  const std::filesystem::path missing = folder.path() / "missing";
  setenv("TMPDIR", missing.c_str(), 1);
  const TemporaryFile elsewhere;  // where the system keeps such files when TMPDIR is no folder
  before ? setenv("TMPDIR", kept.c_str(), 1) : unsetenv("TMPDIR");
}
}  // namespace mrpt_ext::test_disk_backed_sequence
