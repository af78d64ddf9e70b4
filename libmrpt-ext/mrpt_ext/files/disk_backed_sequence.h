#pragma once

#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "mrpt_ext/files/byte_archive.h"
#include "mrpt_ext/files/temporary_file.h"

namespace mrpt_ext
{
/// Rows that are appended one after the other and read from the first to the last, as many as there may be: the first
/// some thousand stay in memory, the others go to a temporary file page by page, so that a log of many hours takes no
/// more memory than a short one. A value like a vector: copies share the pages, which never change.
/// `Row` as ArchivedRow. Readers on several threads are fine while nobody appends.
template <typename Row>
class DiskBackedSequence
{
 public:
  static constexpr std::size_t kRowsPerPage = 256, kPagesInMemory = 16;

  class const_iterator;

  DiskBackedSequence() = default;
  DiskBackedSequence(std::initializer_list<Row> rows) : DiskBackedSequence(std::vector<Row>(rows)) {}
  DiskBackedSequence(std::vector<Row> rows)
  {
    for (Row& row : rows) push_back(std::move(row));
  }

  void push_back(Row row)  // NOLINT(readability-identifier-naming): as in std::vector
  {
    if (tail_.size() == kRowsPerPage) turnPage();
    tail_.push_back(std::move(row));
    ++size_;
  }
  void clear() { *this = {}; }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const Row& front() const { return pages_.empty() ? tail_.front() : pages_.front()->front(); }
  [[nodiscard]] const Row& back() const { return tail_.back(); }
  [[nodiscard]] const_iterator begin() const { return {*this, 0}; }
  [[nodiscard]] const_iterator end() const { return {*this, size_}; }
  /// Rows that are kept in memory.
  [[nodiscard]] std::size_t rowsInMemory() const { return pages_.size() * kRowsPerPage + tail_.size(); }

 private:
  using Page = std::vector<Row>;

  void turnPage()
  {
    if (pages_.size() < kPagesInMemory)
      pages_.push_back(std::make_shared<const Page>(std::exchange(tail_, {})));
    else
    {
      if (!file_) file_ = std::make_shared<TemporaryFile>();
      ByteArchive archive;
      for (Row& row : tail_) archive(row);
      stored_.push_back(file_->append(archive.bytes()));
      tail_.clear();
    }
  }

  [[nodiscard]] std::shared_ptr<const Page> page(std::size_t number) const
  {
    if (number < pages_.size()) return pages_[number];
    const std::size_t stored = number - pages_.size();
    if (stored >= stored_.size()) return {std::shared_ptr<const Page>(), &tail_};
    ByteArchive archive(file_->read(stored_[stored]));
    Page page(kRowsPerPage);
    for (Row& row : page) archive(row);
    return std::make_shared<const Page>(std::move(page));
  }

  std::vector<std::shared_ptr<const Page>> pages_;  // the first ones
  std::vector<TemporaryFile::Block> stored_;        // those after them
  std::shared_ptr<TemporaryFile> file_;             // copies append to it side by side
  Page tail_;                                       // the last rows; empty only without any row
  std::size_t size_ = 0;
};

/// Goes forward only; a row is there until the iterator moves.
template <typename Row>
class DiskBackedSequence<Row>::const_iterator
{
 public:
  using iterator_category = std::input_iterator_tag;  // NOLINT(readability-identifier-naming)
  using value_type = Row;                             // NOLINT(readability-identifier-naming)
  using difference_type = std::ptrdiff_t;             // NOLINT(readability-identifier-naming)
  using pointer = const Row*;                         // NOLINT(readability-identifier-naming)
  using reference = const Row&;                       // NOLINT(readability-identifier-naming)

  const_iterator(const DiskBackedSequence& rows, std::size_t index) : rows_(&rows), index_(index) {}

  const Row& operator*() const
  {
    if (const std::size_t number = index_ / kRowsPerPage; number != page_number_)
    {
      page_ = rows_->page(number);
      page_number_ = number;
    }
    return (*page_)[index_ % kRowsPerPage];
  }
  const Row* operator->() const { return &**this; }
  const_iterator& operator++()
  {
    ++index_;
    return *this;
  }
  const_iterator operator++(int)
  {
    const_iterator before = *this;
    ++index_;
    return before;
  }
  bool operator==(const const_iterator& other) const { return index_ == other.index_; }

 private:
  const DiskBackedSequence* rows_;
  std::size_t index_;
  mutable std::shared_ptr<const Page> page_;
  mutable std::size_t page_number_ = std::numeric_limits<std::size_t>::max();
};
}  // namespace mrpt_ext
