#include "mrpt_ext/app/log_lines.h"

#include <ostream>

#include "mrpt_ext/app/exit_codes.h"
#include "mrpt_ext/app/live_messages.h"

namespace mrpt_ext
{
int writeLogLines(const Settings& settings, const LogWindow& window, std::ostream& out, std::ostream& err)
{
  std::size_t left_out = 0;
  const RecordStream records = loggedRecords(settings, window);
  while (const auto record = records())
  {
    if (const auto line = liveLineOf(*record))
      out << *line << '\n';
    else
      ++left_out;
  }
  out.flush();
  if (left_out > 0)
    err << "note: " << left_out << " records left out: --live reads no running fixes, headings and laser scans\n";
  return kExitDone;
}
}  // namespace mrpt_ext
