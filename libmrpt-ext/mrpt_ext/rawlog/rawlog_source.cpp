#include "mrpt_ext/rawlog/rawlog_source.h"

#include <mrpt/obs/CObservation.h>

#include "mrpt_ext/files/number_format.h"
#include "mrpt_ext/geometry/input_error.h"
#include "mrpt_ext/geometry/physical_limits.h"
#include "mrpt_ext/observations/observation_conversions.h"
#include "mrpt_ext/rawlog/rawlog_reader.h"
#include "mrpt_ext/rawlog/rawlog_translator.h"
#include "mrpt_ext/rawlog/step_clock.h"

namespace mrpt_ext
{
RawlogSource::RawlogSource(const std::filesystem::path& path, double step, const ScanFilter& scans)
    : reader_(std::make_unique<RawlogReader>(path, translatedClasses(scans))),
      translator_(std::make_unique<RawlogTranslator>(StepClock(), scans)),
      queue_(kReorderWindow)
{
  const auto first = reader_->next();
  if (!first)
  {
    ended_ = true;
    queue_.close();
    return;
  }
  if (!dynamic_cast<const mrpt::obs::CObservation*>(first.get()))
  {
    has_sensory_frames_ = true;
    StepClock clock = stepClockOf(path, step);
    clock_note_ = clock.reason;
    translator_ = std::make_unique<RawlogTranslator>(std::move(clock), scans);
  }
  translate(*first);
}

RawlogSource::~RawlogSource() = default;

const std::string& RawlogSource::sha256() const { return reader_->file().sha256; }
const std::string& RawlogSource::comment() const { return reader_->comment(); }
const std::vector<double>& RawlogSource::stepTimes() const { return translator_->stepTimes(); }

const std::vector<double>& RawlogSource::frameTimes() const { return translator_->frameTimes(); }

std::optional<Record> RawlogSource::next()
{
  while (!ended_ && !queue_.canPop()) readEntry();
  if (!queue_.canPop()) return std::nullopt;
  LoggedRecord logged = queue_.pop();
  step_ = logged.step;
  const double time = timeOf(logged.record);
  if (last_time_) gaps_.add(*last_time_, time);
  last_time_ = time;
  if (!first_time_) first_time_ = last_time_;
  return std::move(logged.record);
}

void RawlogSource::readEntry()
{
  const auto entry = reader_->next();
  if (!entry)
  {
    for (auto& [record, step] : translator_->finish()) push(std::move(record), step);
    queue_.close();
    ended_ = true;
    return;
  }
  translate(*entry);
}

void RawlogSource::translate(const mrpt::serialization::CSerializable& entry)
{
  auto records = translator_->translate(entry);
  if (!records)
    throw dataError(reader_->where() + "a " + shortClassName(entry) +
                    ", expected an observation, a sensory frame or an action collection");
  for (auto& [record, step] : *records) push(std::move(record), step);
}

void RawlogSource::push(Record record, std::optional<std::size_t> step)
{
  const double time = timeOf(record);
  if (const std::string why = whyImpossible(record); !why.empty()) throw dataError(reader_->where() + why);
  if (time - queue_.newestTime() > kLongestGap && std::isfinite(queue_.newestTime()))
    throw dataError(reader_->where() + "its time " + fixedText(time, 3) + " s is " +
                    fixedText((time - queue_.newestTime()) / 86400, 1) +
                    " days after that of an earlier record, expected at most 30");
  if (queue_.isTooLate(time))
    throw dataError(reader_->where() + "its time " + fixedText(time, 3) + " s is " +
                    fixedText(queue_.newestTime() - time, 3) +
                    " s before that of an earlier record, expected records in the order of time");
  queue_.push({.record = std::move(record), .step = step});
}

RawlogStatistics RawlogSource::statistics() const
{
  RawlogStatistics statistics{.entries = reader_->entries(),
                              .observations = translator_->observations(),
                              .unusable = translator_->unusable(),
                              .first_time = first_time_.value_or(0),
                              .last_time = last_time_.value_or(0),
                              .gaps = gaps_};
  for (const auto& [skipped, number] : reader_->skipped())
  {
    const auto& [class_name, reason] = skipped;
    statistics.observations[class_name].total += number;
    statistics.observations[class_name].ignored += number;
    statistics.unusable[class_name + ": skipped (" + reason + ")"] += number;
  }
  return statistics;
}

void LogGaps::add(double from, double to)
{
  if (to - from <= kLong) return;
  ++count;
  if (to - from <= longest) return;
  longest = to - from;
  begin = from;
}

std::vector<Record> readAll(RawlogSource& source)
{
  std::vector<Record> records;
  while (auto record = source.next()) records.push_back(std::move(*record));
  return records;
}
}  // namespace mrpt_ext
